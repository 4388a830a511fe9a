//! Tables as text, their columns below each other.

use crate::log::escape::width;

/// Columns are no wider than this for the sake of one cell: every other row would be filled up with spaces.
const MOST_COLUMNS: usize = 120;

/// The lines of a table. Each column is as wide as its widest cell, and an empty one is left out; columns of numbers end below each
/// other, the others begin so.
pub fn aligned<R: AsRef<[String]>>(
    rows: impl IntoIterator<Item = R>,
    is_number: impl Fn(usize) -> bool,
) -> Vec<String> {
    let rows: Vec<R> = rows.into_iter().collect();
    let widest = |column: usize| {
        let widths = rows.iter().filter_map(|row| row.as_ref().get(column)).map(|cell| width(cell));
        widths.max().unwrap_or(0).min(MOST_COLUMNS)
    };
    let widths: Vec<usize> = (0..rows.first().map_or(0, |row| row.as_ref().len())).map(widest).collect();
    let line = |row: &R| {
        let cells = row.as_ref().iter().zip(&widths).enumerate().filter(|(_, (_, widest))| **widest > 0);
        let padded = cells.map(|(column, (cell, widest))| {
            let blank = " ".repeat(widest.saturating_sub(width(cell)));
            if is_number(column) { blank + cell } else { cell.clone() + &blank }
        });
        padded.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    rows.iter().map(line).collect()
}
