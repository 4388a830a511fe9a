//! A close-up as text: its table.

use super::CloseUp;
use crate::files::escape::escape_hidden;
use crate::log::table::aligned;

/// Title, table and note as plain text.
pub fn text(close_up: &CloseUp) -> String {
    let lines = aligned(std::iter::once(&close_up.columns).chain(&close_up.rows), |_| false);
    let mut out = format!("{}\n{}\n", escape_hidden(&close_up.title), lines.join("\n"));
    for sheet in &close_up.sheets {
        out.push_str(&format!("{}\n", escape_hidden(&sheet.caption)));
    }
    out + &format!("{}\n", escape_hidden(&close_up.note))
}
