//! A log in readable forms: one file per format, on common words, numbers and computations.
//!
//! Reports use only what a log holds; they need no scene.

pub mod answer;
pub mod causes;
pub mod close_up;
pub mod computation;
pub mod contributions;
pub mod decided;
pub mod diff;
pub mod digits;
pub mod escape;
pub mod evaluate;
pub mod expression;
pub mod forms;
pub mod language;
pub mod lines;
pub mod notation;
pub mod number;
pub mod outline;
pub mod paper;
mod part;
pub mod path_class;
pub mod provenance;
pub mod pseudocode;
pub mod ray_group;
pub mod ray_tree;
pub mod schematic;
pub mod segments;
pub mod side_by_side;
pub mod solution;
mod svg;
pub mod tag;
pub mod text;
pub mod words;

pub use computation::{Computation, computation};
pub use language::Language;

use crate::log::Header;

/// How numbers are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Style {
    /// Decimals, 3 as in the source text unless asked otherwise.
    pub digits: u32,
    /// Whether a number below 1 that loses digits keeps as many significant ones, 3 at most: `0.00208`, not `0.002`.
    pub keeps_small: bool,
}

impl Style {
    /// That of a log with this header. By hand a number is what its decimals say.
    pub fn of(header: &Header, digits: u32) -> Style {
        let is_by_hand = header.arithmetic == "printed" || header.arithmetic.starts_with("decimal:");
        Style { digits, keeps_small: !is_by_hand }
    }

    /// The same with this many decimals.
    pub fn with(self, digits: u32) -> Style {
        Style { digits, ..self }
    }

    /// With this many decimals, or more where it has more.
    fn at_least(self, digits: u32) -> Style {
        self.with(self.digits.max(digits))
    }
}

impl Default for Style {
    fn default() -> Self {
        Style { digits: 3, keeps_small: true }
    }
}
