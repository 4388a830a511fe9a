//! Tables as text, their columns below each other.

use crate::files::escape::width;

/// A cell that is wider pushes no other row aside: they would be filled up with spaces.
const WIDEST: usize = 90;

/// The lines of a table. Each column is as wide as its widest cell, and one without any is left out; columns of numbers end below each
/// other, the others begin so.
pub fn aligned<R: AsRef<[String]>>(
    rows: impl IntoIterator<Item = R>,
    is_number: impl Fn(usize) -> bool,
) -> Vec<String> {
    let rows: Vec<R> = rows.into_iter().collect();
    let widest = |column: usize| {
        let widths = rows.iter().filter_map(|row| row.as_ref().get(column)).map(|cell| width(cell));
        widths.filter(|width| *width <= WIDEST).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..rows.first().map_or(0, |row| row.as_ref().len())).map(widest).collect();
    let line = |row: &R| {
        let cells = row.as_ref().iter().zip(&widths).enumerate();
        let cells = cells.filter(|(_, (cell, widest))| **widest > 0 || !cell.is_empty());
        let padded = cells.map(|(column, (cell, widest))| {
            let blank = " ".repeat(widest.saturating_sub(width(cell)));
            if is_number(column) { blank + cell } else { cell.clone() + &blank }
        });
        padded.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}
