//! A list as lines: its cells in columns under their titles, and lines that are longer than their place.

use crate::files::escape::cells;
use crate::tui::model::list::{CELL_END, Listing};
use crate::tui::text::{shown, width_of};
use crate::tui::theme::Theme;

/// The lines of a list.
pub(super) struct Table {
    /// The titles of the columns; empty in a list without.
    pub head: String,
    /// A line an entry.
    pub rows: Vec<String>,
    /// The columns of the screen that the first column takes, which stays where it is.
    pub fixed: usize,
}

/// What is between two columns.
const GAP: &str = "  ";

impl Table {
    /// The lines of a list, each column as wide as it need be. An empty column has no title either.
    pub(super) fn of(listing: &Listing, theme: &Theme) -> Table {
        let cells = |text: &str| text.split(CELL_END).map(|cell| shown(cell, theme)).collect::<Vec<_>>();
        let rows: Vec<_> = listing.entries.iter().map(|entry| cells(&entry.text)).collect();
        let titles: Vec<_> = listing.columns.iter().map(|column| shown(column.title, theme)).collect();
        let widths: Vec<_> = (0..titles.len())
            .map(|at| {
                // A line without columns goes across all of them.
                let in_column = rows.iter().filter(|row| row.len() > 1).filter_map(|row| row.get(at));
                let widest = in_column.map(|cell| width_of(cell)).max().unwrap_or(0);
                if widest == 0 { 0 } else { widest.max(width_of(&titles[at])) }
            })
            .collect();
        let line = |cells: &[String]| match cells {
            [whole] => whole.clone(),
            _ => {
                let places = cells.iter().zip(&widths).zip(&listing.columns).filter(|((_, width), _)| **width > 0);
                let texts = places.map(|((cell, width), column)| {
                    let blank = " ".repeat(width.saturating_sub(width_of(cell)));
                    if column.is_number { blank + cell } else { cell.clone() + &blank }
                });
                texts.collect::<Vec<_>>().join(GAP).trim_end().to_owned()
            }
        };
        let fixed = widths.first().filter(|width| **width > 0).map_or(0, |width| width + GAP.len());
        Table { head: line(&titles), rows: rows.iter().map(|row| line(row)).collect(), fixed }
    }

    /// The width of the widest line.
    pub(super) fn width(&self) -> usize {
        self.rows.iter().chain([&self.head]).map(|line| width_of(line)).max().unwrap_or(0)
    }
}

/// What of a text is seen through `room` columns that are `shift` columns further on, with a mark at each side where more of it is.
pub(in crate::tui) fn cut(text: &str, shift: usize, room: usize, theme: &Theme) -> String {
    if shift == 0 && width_of(text) <= room {
        return text.to_owned();
    }
    let glyphs = theme.glyphs;
    let before = if shift > 0 && !text.is_empty() { glyphs.cut_left } else { "" };
    // A mark takes the place of a column of the text.
    let begin = shift + width_of(before);
    let rest = columns_of(text, begin, usize::MAX);
    let room = room.saturating_sub(width_of(before));
    if width_of(&rest) <= room {
        return format!("{before}{rest}");
    }
    format!("{before}{}{}", columns_of(text, begin, room.saturating_sub(1)), glyphs.cut_right)
}

/// The characters of a text that lie completely within `count` columns from `begin` on.
fn columns_of(text: &str, begin: usize, count: usize) -> String {
    let end = begin.saturating_add(count);
    let mut column = 0;
    let inside = cells(text).filter(|(_, width)| {
        let from = column;
        column += width;
        from >= begin && column <= end
    });
    inside.map(|(cell, _)| cell).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::language::viewer::List;
    use crate::tui::model::list::Entry;
    use crate::tui::theme::{Palette, Role};

    #[track_caller]
    fn is_cut(text: &str, shift: usize, room: usize, expected: &str, in_ascii: &str) {
        let cut = |ascii: bool| cut(text, shift, room, &Theme::new(Palette::None, ascii));
        assert_eq!((cut(false).as_str(), cut(true).as_str()), (expected, in_ascii), "{text} from {shift} in {room}");
    }

    #[test]
    fn what_is_cut_has_a_mark() {
        is_cut("abcdef", 0, 6, "abcdef", "abcdef");
        is_cut("abcdef", 0, 5, "abcd…", "abcd>");
        is_cut("abcdef", 1, 5, "…cdef", "<cdef");
        is_cut("abcdef", 1, 4, "…cd…", "<cd>");
        is_cut("abcdef", 9, 4, "…", "<");
        is_cut("", 3, 4, "", "");
    }

    #[test]
    fn joined_letters_are_cut_whole() {
        is_cut("क्‍षक्‍षabc", 2, 4, "…abc", "<abc");
        is_cut("کره‌ی قرمز", 0, 5, "کره‌ی…", "کره‌ی>");
    }

    #[test]
    fn columns_are_under_their_titles_in_any_characters() {
        let entries = vec![
            Entry::to(0, "9 %\t\t10⁻⁵".to_owned()),
            Entry::heading("Others, of which there are some:".to_owned()),
            Entry::plain("10 %\t\t1".to_owned(), Role::Text),
        ];
        let texts = List { columns: ["share", "none", "value"], nothing: "" };
        let listing = Listing::of(&texts, "", &[0], entries);
        let table = Table::of(&listing, &Theme::new(Palette::None, true));
        assert_eq!(table.head, "share  value");
        assert_eq!(table.rows, ["  9 %  10^-5", "Others, of which there are some:", " 10 %  1"]);
        assert_eq!((table.fixed, table.width()), (7, 32));
    }
}
