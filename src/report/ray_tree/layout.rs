//! Where the nodes of a ray tree are: each above the middle of its children, subtrees as close as they come (Reingold and
//! Tilford, "Tidier drawings of trees", 1981).

use super::{Branch, Figure};
use crate::files::escape::width;

/// The place of a ray's end.
pub(super) struct Spot<'f> {
    /// The ray; `None` for the eye.
    pub branch: Option<&'f Branch>,
    /// The text there.
    pub text: String,
    /// The place where the ray begins, by its number.
    pub parent: usize,
    /// Its middle, from the left.
    pub x: f64,
    /// How many rays lie between it and the eye.
    pub level: usize,
}

/// How far along a line its letter is.
pub(super) const LETTER_AT: f64 = 0.64;

/// The gap between two nodes of a level, in characters.
const GAP: f64 = 1.2;

/// The places of all ends, the eye first, parents before children; x from 0 in widths of a character, and how wide all is.
pub(super) fn spots<'f>(figure: &Figure<'f>) -> (Vec<Spot<'f>>, f64) {
    let eye = Subtree::of(figure, None, figure.branches);
    let left = eye.contour.iter().map(|(left, _)| *left).fold(0.0, f64::min);
    let right = eye.contour.iter().map(|(_, right)| *right).fold(0.0, f64::max);
    let mut spots = Vec::new();
    eye.spread(-left, 0, 0, &mut spots);
    (spots, right - left)
}

/// What the end with this number, in that order, is called in languages that lay out trees themselves.
pub(super) fn name_of(number: usize) -> String {
    if number == 0 { "eye".to_owned() } else { format!("n{number}") }
}

/// A laid out part of the tree; places are from its root's.
struct Subtree<'f> {
    branch: Option<&'f Branch>,
    text: String,
    children: Vec<(f64, Subtree<'f>)>,
    /// The leftmost and rightmost place of each level.
    contour: Vec<(f64, f64)>,
}

impl<'f> Subtree<'f> {
    fn of(figure: &Figure, branch: Option<&'f Branch>, children: &'f [Branch]) -> Subtree<'f> {
        let text = branch.map_or(figure.language.texts().figure.eye.to_owned(), |branch| figure.end(branch));
        let label = branch.map_or(0, |branch| width(&branch.label));
        // Letters are before the ends of their lines, where these are closer together.
        let half = (width(&text) as f64 / 2.0 + 0.8).max((label as f64 / 2.0 + 0.3) / LETTER_AT);
        let mut placed: Vec<(f64, Subtree)> = Vec::new();
        let mut contour: Vec<(f64, f64)> = Vec::new();
        for child in children {
            let child = Subtree::of(figure, Some(child), &child.children);
            let apart = contour.iter().zip(&child.contour).map(|((_, right), (left, _))| right - left + GAP);
            let x = if placed.is_empty() { 0.0 } else { apart.fold(f64::NEG_INFINITY, f64::max) };
            for (level, (left, right)) in child.contour.iter().enumerate() {
                match contour.get_mut(level) {
                    Some(there) => there.1 = there.1.max(x + right),
                    None => contour.push((x + left, x + right)),
                }
            }
            placed.push((x, child));
        }
        let middle = match (placed.first(), placed.last()) {
            (Some((first, _)), Some((last, _))) => (first + last) / 2.0,
            _ => 0.0,
        };
        placed.iter_mut().for_each(|(x, _)| *x -= middle);
        let below = contour.into_iter().map(|(left, right)| (left - middle, right - middle));
        let contour = std::iter::once((-half, half)).chain(below).collect();
        Subtree { branch, text, children: placed, contour }
    }

    fn spread(self, x: f64, level: usize, parent: usize, spots: &mut Vec<Spot<'f>>) {
        let own = spots.len();
        spots.push(Spot { branch: self.branch, text: self.text, parent, x, level });
        for (offset, child) in self.children {
            child.spread(x + offset, level + 1, own, spots);
        }
    }
}
