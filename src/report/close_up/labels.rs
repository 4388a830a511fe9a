//! The places of texts on a sheet: where two would cover each other, the later one moves.

use super::{Piece, Point, Sheet};
use crate::files::escape::width;

/// Half of the room of a letter, and of a line of text.
const HALF_LETTER: f64 = 3.6;
const HALF_LINE: f64 = 6.5;

/// How far a text moves at a time, and how often at most.
const STEP: f64 = 6.0;
const STEPS: i32 = 9;

/// With more texts than these they stay where they are: there is no room for them, and each is compared with all others.
const MOST: usize = 500;

impl Sheet {
    /// A figure whose texts don't cover each other; where one would, it moves away from the middle.
    pub(super) fn new(caption: String, size: [f64; 2], middle: Point, mut pieces: Vec<Piece>) -> Sheet {
        apart(&mut pieces, size, middle);
        Sheet { caption, size, pieces }
    }
}

/// Moves texts apart that cover each other: in the order of the pieces each takes the nearest free place, outward from `middle` or to a
/// side, on the sheet and, if it moves, on no dot. Where there is none, it stays.
fn apart(pieces: &mut [Piece], size: [f64; 2], middle: Point) {
    let is_text = |piece: &&Piece| matches!(piece, Piece::Text { .. });
    if pieces.iter().filter(is_text).count() > MOST {
        return;
    }
    let dots: Vec<Label> = pieces.iter().filter_map(dot).collect();
    let mut taken: Vec<Label> = Vec::new();
    for piece in pieces {
        let Piece::Text { at, text, .. } = piece else { continue };
        let half = [HALF_LETTER * width(text) as f64 + 1.0, HALF_LINE];
        let is_free = |label: &Label| !taken.iter().any(|other| other.covers(label));
        let may_move_to =
            |label: &Label| label.is_on(size) && is_free(label) && !dots.iter().any(|dot| dot.covers(label));
        let label = Label { at: *at, half };
        let label = if is_free(&label) {
            label
        } else {
            // Of two as near the one that is farther from the other texts: it is rather on its own side of them.
            let room = |label: &Label| taken.iter().map(|other| other.distance(label)).fold(f64::INFINITY, f64::min);
            let others = places(*at, middle).map(|(steps, at)| (steps, Label { at, half }));
            let free = others.filter(|(_, label)| may_move_to(label));
            let nearest = free.min_by(|(steps, label), (other_steps, other)| {
                steps.cmp(other_steps).then(room(other).total_cmp(&room(label)))
            });
            nearest.map_or(label, |(_, label)| label)
        };
        *at = label.at;
        taken.push(label);
    }
}

/// The places around one, outward and to the sides, with the square of their distance in steps.
fn places(at: Point, middle: Point) -> impl Iterator<Item = (i32, Point)> {
    let out = [at[0] - middle[0], at[1] - middle[1]];
    let length = libm::hypot(out[0], out[1]);
    let out = if length > 0.0 { out.map(|part| part / length) } else { [1.0, 0.0] };
    let moves = (0..=STEPS).flat_map(|outward| (-STEPS..=STEPS).map(move |aside| [outward, aside]));
    moves.map(move |moved| {
        let [outward, aside] = moved.map(|steps| f64::from(steps) * STEP);
        let place = [at[0] + outward * out[0] - aside * out[1], at[1] + outward * out[1] + aside * out[0]];
        (moved.iter().map(|steps| steps * steps).sum(), place)
    })
}

/// The room of a text.
struct Label {
    at: Point,
    /// Half of its width and height.
    half: [f64; 2],
}

impl Label {
    fn covers(&self, other: &Label) -> bool {
        [0, 1].iter().all(|&axis| (self.at[axis] - other.at[axis]).abs() < self.half[axis] + other.half[axis])
    }

    fn distance(&self, other: &Label) -> f64 {
        libm::hypot(self.at[0] - other.at[0], self.at[1] - other.at[1])
    }

    fn is_on(&self, size: [f64; 2]) -> bool {
        [0, 1].iter().all(|&axis| self.at[axis] >= self.half[axis] && self.at[axis] <= size[axis] - self.half[axis])
    }
}

fn dot(piece: &Piece) -> Option<Label> {
    match piece {
        Piece::Dot { at, radius, .. } => Some(Label { at: *at, half: [*radius; 2] }),
        _ => None,
    }
}
