//! A frame as text, with its styles below: what snapshot tests keep, because the text alone has no colours.

use crate::files::escape::width;
use ratatui::buffer::{Buffer, Cell};
use ratatui::style::Style;
use std::fmt::Write;

/// The text of a frame, then a line for each run of cells with a style of its own: `row: first-last style`.
pub fn dump(buffer: &Buffer) -> String {
    let mut text = text(buffer);
    text.push_str("styles:\n");
    for (number, row) in rows(buffer).enumerate() {
        let mut first = 0;
        for run in row.chunk_by(|a, b| a.style() == b.style()) {
            let style = words(run[0].style());
            if !style.is_empty() {
                let _ = writeln!(text, "{number}: {first}-{} {style}", first + run.len() - 1);
            }
            first += run.len();
        }
    }
    text
}

/// The text of a frame.
pub fn text(buffer: &Buffer) -> String {
    let mut text = String::new();
    for row in rows(buffer) {
        let line: String = row.iter().map(Cell::symbol).collect();
        let _ = writeln!(text, "{}", line.trim_end());
    }
    text
}

/// The rows of a frame, from the top. A cell under the second half of a wide letter has its style, and no text.
pub(super) fn rows(buffer: &Buffer) -> impl Iterator<Item = Vec<Cell>> {
    buffer.content().chunks(usize::from(buffer.area.width).max(1)).map(|row| {
        let mut row = row.to_vec();
        for at in 0..row.len() {
            let covered = width(row[at].symbol()).saturating_sub(1);
            for next in at + 1..row.len().min(at + 1 + covered) {
                row[next] = row[at].clone();
                row[next].set_symbol("");
            }
        }
        row
    })
}

fn words(style: Style) -> String {
    let mut words = Vec::new();
    words.extend(style.fg.filter(|color| *color != ratatui::style::Color::Reset).map(|color| color.to_string()));
    words.extend(style.bg.filter(|color| *color != ratatui::style::Color::Reset).map(|color| format!("on {color}")));
    words.extend(style.add_modifier.iter_names().map(|(name, _)| name.to_lowercase()));
    words.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use ratatui::layout::Rect;
    use ratatui::style::{Color, Stylize};

    #[test]
    fn text_and_runs_of_styles() {
        let mut buffer = Buffer::empty(Rect::new(0, 0, 6, 2));
        buffer.set_span(0, 0, &"ab".bold(), 6);
        buffer.set_span(3, 1, &"c".fg(Color::Indexed(74)), 6);
        assert_eq!(dump(&buffer), "ab\n   c\nstyles:\n0: 0-1 bold\n1: 3-3 74\n");
    }

    #[test]
    fn wide_letters_are_one_with_what_they_cover() {
        let mut buffer = Buffer::empty(Rect::new(0, 0, 8, 1));
        buffer.set_span(0, 0, &"球क्‍षه‌ی".bold(), 8);
        assert_eq!(dump(&buffer), "球क्‍षه‌ی\nstyles:\n0: 0-5 bold\n");
    }

    #[test]
    fn nothing_has_no_rows() {
        assert_eq!(dump(&Buffer::empty(Rect::default())), "styles:\n");
    }
}
