//! A close-up as text: its table.

use super::CloseUp;
use crate::files::escape::{escape_hidden, width};

/// Title, table and note as plain text.
pub fn text(close_up: &CloseUp) -> String {
    let lines: Vec<&Vec<String>> = std::iter::once(&close_up.columns).chain(&close_up.rows).collect();
    let widest = |column: usize| lines.iter().map(|cells| width(&cells[column])).max().unwrap_or(0);
    let widths: Vec<usize> = (0..close_up.columns.len()).map(widest).collect();
    let mut out = format!("{}\n", escape_hidden(&close_up.title));
    for cells in lines {
        let padded: Vec<String> =
            cells.iter().zip(&widths).map(|(cell, wide)| format!("{cell}{}", " ".repeat(wide - width(cell)))).collect();
        out.push_str(padded.join("  ").trim_end());
        out.push('\n');
    }
    for sheet in &close_up.sheets {
        out.push_str(&format!("{}\n", escape_hidden(&sheet.caption)));
    }
    out + &format!("{}\n", escape_hidden(&close_up.note))
}
