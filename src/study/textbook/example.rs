//! Which worked examples there are, and what a person gets for each of their quantities.
//!
//! The first is that of the source text (Ramos, section 1.3). The second is in its manner and has what that lacks: refraction into and out of a
//! glass ball, a total reflection in it, an attenuated shadow, and the transmitted term of the local model. Its values were computed without
//! this program, in decimal arithmetic, and are in `scenes/refraction.csv`.

use super::follow::Place;
use super::{CALLED, DIGITS};
use crate::probe::{Printed, PrintedValue};
use std::sync::LazyLock;

/// A worked example.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Example {
    /// The numeric example of the source text.
    #[default]
    Textbook,
    /// Refraction in and out, total reflection, an attenuated shadow, H′.
    Refraction,
}

/// The pixel of every example.
const MIDDLE: [u32; 2] = [160, 120];

/// A quantity of an example.
#[derive(Clone, Debug)]
pub(super) struct Line {
    /// What it is called there.
    pub called: &'static str,
    /// Which of several with its key on its path, from 0.
    pub nth: usize,
    /// Its value.
    pub printed: PrintedValue,
}

impl Line {
    /// Where it is in the walk.
    pub(super) fn place(&self) -> Place {
        Place { path: self.printed.path.to_owned(), key: self.printed.key, nth: self.nth }
    }
}

impl Example {
    /// Every example.
    pub const ALL: [Example; 2] = [Example::Textbook, Example::Refraction];

    /// The built-in scene that it is of; its middle pixel is the example.
    pub fn scene(self) -> &'static str {
        match self {
            Example::Textbook => "textbook",
            Example::Refraction => "refraction",
        }
    }

    /// The call that traces it by hand with the products of dot products rounded too.
    pub(super) fn call_with_rounded_products(self) -> String {
        let [column, row] = MIDDLE;
        format!("raywalk trace {} --pixel {column},{row} --arithmetic decimal:{DIGITS} --round-products", self.scene())
    }

    /// Its quantities, in its order.
    pub(super) fn lines(self) -> &'static [Line] {
        static TEXTBOOK: LazyLock<Vec<Line>> = LazyLock::new(|| {
            let line =
                |(printed, called): (&PrintedValue, &&'static str)| Line { called, nth: 0, printed: printed.clone() };
            Printed::all().iter().zip(CALLED).map(line).collect()
        });
        static REFRACTION: LazyLock<Vec<Line>> = LazyLock::new(|| of_sheet(SHEET));
        match self {
            Example::Textbook => &TEXTBOOK,
            Example::Refraction => &REFRACTION,
        }
    }
}

/// The sheet of the second example: `quantity,printed,path,step,called`. A row without a value is a computation that a person leaves out, such as
/// the test with a sphere that the ray has just left.
const SHEET: &str = include_str!("../../../scenes/refraction.csv");

/// The rows of a sheet below its heads.
fn of_sheet(sheet: &'static str) -> Vec<Line> {
    let rows: Vec<_> = sheet.lines().skip(1).filter_map(row).collect();
    let is_same = |a: &Line, b: &Line| a.printed.key == b.printed.key && a.printed.path == b.printed.path;
    let count = |at: usize| rows[..at].iter().filter(|row| is_same(row, &rows[at])).count();
    let counted = (0..rows.len()).map(|at| Line { nth: count(at), ..rows[at].clone() });
    counted.filter(|line| !line.printed.components.is_empty()).collect()
}

fn row(text: &'static str) -> Option<Line> {
    let (key, rest) = text.split_once(',')?;
    // Triples are quoted, as they have commas.
    let (text, rest) = match rest.strip_prefix('"') {
        Some(quoted) => quoted.split_once("\",")?,
        None => rest.split_once(',')?,
    };
    let mut cells = rest.splitn(3, ',');
    let (path, step, called) = (cells.next()?, cells.next()?, cells.next()?);
    let numbers = text.trim_matches(['(', ')']).split(", ");
    let components = numbers.filter_map(|number| number.parse().ok()).collect();
    Some(Line { called, nth: 0, printed: PrintedValue { path, key, step, text, components } })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::Name;

    #[test]
    fn every_row_of_the_sheet_is_read() {
        let lines = Example::Refraction.lines();
        let written = SHEET.lines().skip(1).filter(|row| !row.contains(",,")).count();
        assert_eq!(lines.len(), written);
        for Line { printed, .. } in lines {
            assert!(Name::all().any(|name| name.key() == printed.key), "{printed:?}");
            assert!(matches!(printed.components.len(), 1 | 3), "{printed:?}");
        }
    }
}
