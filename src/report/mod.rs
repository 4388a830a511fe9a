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
pub(crate) mod ray_group;
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
    /// Whether a number below 1 has at least as many significant digits, or 3 if those are fewer: `0.00208`, not `0.002`.
    pub keeps_small: bool,
}

impl Style {
    /// The most decimals that somebody can ask for.
    pub const MOST_DIGITS: u32 = 15;

    /// How people see the numbers of a log with this header. By hand a number is what its decimals say.
    pub fn of(header: &Header, digits: u32) -> Style {
        let is_by_hand = header.arithmetic == "printed" || header.arithmetic.starts_with("decimal:");
        Style { digits, keeps_small: !is_by_hand }
    }

    /// The same for a value of a log with this header: by hand it has no more decimals than it was rounded to.
    pub fn within(self, header: &Header) -> Style {
        let by_hand = match header.arithmetic.as_str() {
            "printed" => Some(Style::default().digits),
            arithmetic => arithmetic.strip_prefix("decimal:").and_then(|digits| digits.parse().ok()),
        };
        by_hand.map_or(self, |most| Style { digits: self.digits.min(most), keeps_small: false })
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
        Style { digits: 3, keeps_small: false }
    }
}
