//! Worked examples on paper: what is printed of each quantity, and what it comes to.

use crate::probe::PrintedValue;

/// A worked example.
#[derive(Clone, Debug, PartialEq)]
pub struct Paper {
    /// The built-in scene that it is of.
    pub scene: &'static str,
    /// Its quantities in its own order.
    pub rows: Vec<Row>,
}

/// A quantity of the example.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The step of the book's calculation, such as `5d`.
    pub step: &'static str,
    /// What the book calls the quantity, such as `T_2Ai`.
    pub called: &'static str,
    /// The key of the quantity, such as `sphere.t2_a`.
    pub quantity: &'static str,
    /// Which of several with its key on its path, from 0.
    pub number: usize,
    /// What the book prints.
    pub printed: &'static PrintedValue,
    /// The book followed: from the printed values before it, rounded.
    pub recomputed: Vec<f64>,
    /// By hand from the start, without looking at the book.
    pub strict: Vec<f64>,
    /// The same, with the products of dot products rounded before they are added, as the book does in step 7.
    pub strict_products: Vec<f64>,
    /// In f64.
    pub exact: Vec<f64>,
    /// Whether the book keeps its own rules.
    pub verdict: Verdict,
}

/// Whether a printed value follows from those before it by the book's own rules.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It does.
    Agrees,
    /// It does, printed with other digits.
    Format,
    /// It doesn't.
    Departs {
        /// Why not.
        why: &'static str,
    },
}

impl Verdict {
    /// The word in the table.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Agrees => "agrees",
            Verdict::Format => "format",
            Verdict::Departs { .. } => "departs",
        }
    }
}
