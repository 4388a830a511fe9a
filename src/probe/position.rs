//! Where in the tree of a computation a quantity is noted, as a number: the same in every run, whatever comes before it.

use crate::log::{Name, RayKind, Step};
use crate::random::{GOLDEN, mix};
use std::sync::LazyLock;

/// The place that a computation has come to.
///
/// A quantity's key is made of the nodes around it, its name and its number among those of that name in its node. So
/// tests of other objects, or rays that are left out, change no key but their own.
#[derive(Clone, Debug)]
pub struct Position {
    open: Vec<Frame>,
}

/// A node that isn't left yet.
#[derive(Clone, Debug)]
struct Frame {
    key: u64,
    /// How often each name was noted.
    notes: Vec<(Name, u64)>,
    /// How often each step other than a test was entered; an object is tested once a ray.
    entered: Vec<(Step, u64)>,
}

impl Position {
    /// Outside every node; `root` distinguishes computations.
    pub fn new(root: u64) -> Position {
        Position { open: vec![Frame::new(root)] }
    }

    /// A node begins.
    pub fn enter(&mut self, step: Step) {
        let mut key = 0;
        if let Some(frame) = self.open.last_mut() {
            let number = if matches!(step, Step::Test { .. }) { 0 } else { count(&mut frame.entered, step) };
            key = words(step).into_iter().chain([number]).fold(frame.key, mixed_with);
        }
        self.enter_at(key);
    }

    /// A node begins that has this key wherever it is.
    pub fn enter_at(&mut self, key: u64) {
        self.open.push(Frame::new(key));
    }

    /// The latest node ends.
    pub fn leave(&mut self) {
        self.open.pop();
    }

    /// The key of the next quantity of this name.
    pub fn next(&mut self, name: Name) -> u64 {
        let Some(frame) = self.open.last_mut() else { return 0 };
        let number = count(&mut frame.notes, name);
        mixed_with(mixed_with(frame.key, word_of(name)), number)
    }
}

impl Frame {
    fn new(key: u64) -> Frame {
        Frame { key, notes: Vec::new(), entered: Vec::new() }
    }
}

/// How often this was counted before.
fn count<T: PartialEq>(counts: &mut Vec<(T, u64)>, what: T) -> u64 {
    match counts.iter_mut().find(|(counted, _)| *counted == what) {
        Some((_, count)) => {
            *count += 1;
            *count
        }
        None => {
            counts.push((what, 0));
            0
        }
    }
}

/// A name as a number that stays when others are added: of its key and form (FNV-1a).
fn word_of(name: Name) -> u64 {
    static WORDS: LazyLock<Vec<u64>> = LazyLock::new(|| Name::all().map(spelt).collect());
    WORDS.get(name as usize).copied().unwrap_or_default()
}

fn spelt(name: Name) -> u64 {
    let letters = name.key().bytes().chain([0]).chain(name.form().bytes());
    letters.fold(0xcbf2_9ce4_8422_2325, |word, letter| (word ^ u64::from(letter)).wrapping_mul(0x0100_0000_01b3))
}

/// A step as numbers.
pub(super) fn words(step: Step) -> [u64; 3] {
    match step {
        Step::Pixel([x, y]) => [1, x.into(), y.into()],
        Step::Sample { number } => [2, number.into(), 0],
        Step::Ray { kind: RayKind::Camera, depth, split } => [3, depth.into(), split.into()],
        Step::Ray { kind: RayKind::Shadow { light }, depth, split } => [4, depth.into(), pair(light, split)],
        Step::Ray { kind: RayKind::Reflected, depth, split } => [5, depth.into(), split.into()],
        Step::Ray { kind: RayKind::Transmitted, depth, split } => [6, depth.into(), split.into()],
        Step::Test { object, triangle } => [7, object.into(), triangle.map_or(0, |triangle| u64::from(triangle) + 1)],
        Step::Shade { object } => [8, object.into(), 0],
        Step::Light { light, split } => [9, light.into(), split.into()],
        Step::Combine => [10, 0, 0],
        Step::Motion { object } => [11, object.into(), 0],
        Step::Zone { what, number } => [12, what as u64, number.into()],
    }
}

fn pair(one: u32, other: u32) -> u64 {
    u64::from(one) << 32 | u64::from(other)
}

/// A number that looks random, made of two: the same on every machine, for the same two.
pub fn mixed_with(key: u64, word: u64) -> u64 {
    mix(key.wrapping_add(GOLDEN) ^ mix(word))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CAMERA: Step = Step::Ray { kind: RayKind::Camera, depth: 0, split: 0 };
    const MIRRORED: Step = Step::Ray { kind: RayKind::Reflected, depth: 1, split: 0 };

    /// The key of the first `PlaneT` in these nodes, after other tests.
    fn key_of(path: &[Step], tests_before: u32) -> u64 {
        let mut position = Position::new(7);
        for step in path {
            for object in 0..tests_before {
                position.enter(Step::Test { object: object + 9, triangle: None });
                position.next(Name::PlaneT);
                position.leave();
            }
            position.enter(*step);
        }
        position.next(Name::PlaneT)
    }

    #[test]
    fn tests_of_other_objects_change_nothing() {
        assert_eq!(key_of(&[CAMERA, MIRRORED], 0), key_of(&[CAMERA, MIRRORED], 5));
        assert_ne!(key_of(&[CAMERA, MIRRORED], 0), key_of(&[CAMERA], 0));
    }

    #[test]
    fn no_two_names_have_the_same_word() {
        let mut words: Vec<_> = Name::all().map(word_of).collect();
        words.sort_unstable();
        assert!(words.windows(2).all(|pair| pair[0] != pair[1]));
    }

    #[test]
    fn equal_names_and_equal_nodes_are_distinguished() {
        let mut position = Position::new(7);
        let first = position.next(Name::PlaneT);
        assert_ne!(first, position.next(Name::PlaneT));
        position.enter(MIRRORED);
        let inside = position.next(Name::PlaneT);
        position.leave();
        position.enter(MIRRORED);
        assert_ne!(inside, position.next(Name::PlaneT));
    }
}
