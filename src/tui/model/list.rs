//! A list that lies over the panes: places to go to, and figures.

use crate::report::language::viewer::{Hints, List};
use crate::tui::theme::Role;

/// What a list is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Where runs stop.
    Breakpoints,
    /// Where they have stopped.
    Stops,
    /// The quantities that are watched.
    Watches,
    /// All values of a quantity.
    History,
    /// The bookmarks.
    Bookmarks,
    /// What the value at the current step is made of.
    Operands,
    /// The steps that take it.
    Uses,
    /// Why the pixel has its colour.
    Contributions,
    /// The selected node's values in several arithmetics.
    Arithmetics,
    /// Which rounding caused the error of the result.
    Causes,
    /// The worked example that the log is of.
    Book,
    /// What the symbols mean.
    Glossary,
    /// The pixels that single precision misses most.
    Worst,
}

impl Kind {
    /// What the keys do in it, if that is more than in every list; from the longest way to say it to the shortest.
    pub fn hints(self, hints: &'static Hints) -> &'static [&'static str] {
        match self {
            Kind::Breakpoints => &hints.breakpoints,
            Kind::Bookmarks => &hints.bookmarks,
            Kind::Watches => &hints.watches,
            _ => &[],
        }
    }
}

/// A list.
#[derive(Clone, Debug, Default)]
pub struct Listing {
    /// What it is of.
    pub title: String,
    /// What is in the cells of its entries, if they have any.
    pub columns: Vec<Column>,
    /// Its entries.
    pub entries: Vec<Entry>,
    /// What is said where it has none.
    pub nothing: &'static str,
}

/// A column of a list.
#[derive(Clone, Copy, Debug)]
pub struct Column {
    /// What is in it.
    pub title: &'static str,
    /// Whether that is numbers, which end below each other.
    pub is_number: bool,
}

impl Listing {
    /// A list with these texts. The columns with these numbers, from 0, are columns of numbers.
    pub fn of<const N: usize>(
        texts: &List<N>,
        title: impl Into<String>,
        numbers: &[usize],
        entries: Vec<Entry>,
    ) -> Listing {
        let column = |(at, title)| Column { title, is_number: numbers.contains(&at) };
        let columns = texts.columns.into_iter().enumerate().map(column).collect();
        Listing { title: title.into(), columns, entries, nothing: texts.nothing }
    }

    /// The entry that is selected instead of a heading: the next one, or the one before when moving backward; else the nearest other.
    pub fn off_headings(&self, wanted: usize, backward: bool) -> usize {
        let is_one = |at: &usize| self.entries.get(*at).is_some_and(|entry| !entry.is_heading);
        let after = (wanted..self.entries.len()).find(is_one);
        let before = (0..=wanted).rev().find(is_one);
        if backward { before.or(after) } else { after.or(before) }.unwrap_or(wanted)
    }
}

/// The most entries of a list: nobody reads more, and a frame must not wait for them.
pub const MOST: usize = 500;

/// What is between two cells in the text of an entry.
pub const CELL_END: char = '\t';

/// The text of an entry with these cells.
pub fn cells<const N: usize>(cells: [String; N]) -> String {
    cells.join(CELL_END.encode_utf8(&mut [0; 4]))
}

/// An entry of a list.
#[derive(Clone, Debug)]
pub struct Entry {
    /// What it says: a line, or in a list with columns its cells with a tab between them.
    pub text: String,
    /// How it looks.
    pub role: Role,
    /// The event that `Enter` goes to; that of a stop may be of another pixel.
    pub target: Option<usize>,
    /// The pixel that it goes to instead.
    pub pixel: Option<[u32; 2]>,
    /// Whether it is only a heading of those below, which can't be selected.
    pub is_heading: bool,
}

impl Entry {
    /// An entry in plain text that leads to an event.
    pub fn to(target: usize, text: String) -> Entry {
        Entry { target: Some(target), ..Entry::plain(text, Role::Text) }
    }

    /// An entry that leads nowhere.
    pub fn plain(text: String, role: Role) -> Entry {
        Entry { text, role, target: None, pixel: None, is_heading: false }
    }

    /// A heading of the entries below.
    pub fn heading(text: String) -> Entry {
        Entry { is_heading: true, ..Entry::plain(text, Role::Title) }
    }

    /// Whether it leads anywhere.
    pub fn leads(&self) -> bool {
        self.target.is_some() || self.pixel.is_some()
    }

    /// Whether it is laid out in the columns of its list, not across them.
    pub fn has_cells(&self) -> bool {
        self.text.contains(CELL_END)
    }
}
