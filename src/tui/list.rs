//! Lists that lie over the panes: places to go to, and figures.
//!
//! A kind of list is one function that makes its [`Listing`] from the model. Moving in it, going to the place of an entry and
//! closing it are the same for all.

use super::guide::{self, Walk};
use super::keys::Action;
use super::model::{Model, Overlay};
use super::theme::Role;
use super::understanding;
use super::update::{Effect, Exit};
use super::view;
use super::{bookmarks, breakpoints, run};
use crate::report::language::viewer::Hints;

/// What a list is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Where runs stop.
    Breakpoints,
    /// Where they have stopped.
    Stops,
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
}

impl Kind {
    /// What the keys do in it, if that is more than in every list; from the longest way to say it to the shortest.
    pub fn hints(self, hints: &'static Hints) -> &'static [&'static str] {
        match self {
            Kind::Breakpoints => &hints.breakpoints,
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

impl Column {
    /// Columns with these titles; those with these numbers, from 0, are columns of numbers.
    pub fn all(titles: &[&'static str], numbers: &[usize]) -> Vec<Column> {
        let column = |(at, title): (usize, &&'static str)| Column { title, is_number: numbers.contains(&at) };
        titles.iter().enumerate().map(column).collect()
    }
}

/// What is between two cells in the text of an entry.
pub const CELL_END: char = '\t';

/// An entry of a list.
#[derive(Clone, Debug)]
pub struct Entry {
    /// What it says: a line, or in a list with columns its cells with a tab between them.
    pub text: String,
    /// How it looks.
    pub role: Role,
    /// The event that `Enter` goes to; that of a stop may be of another pixel.
    pub target: Option<usize>,
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
        Entry { text, role, target: None, is_heading: false }
    }

    /// A heading of the entries below.
    pub fn heading(text: String) -> Entry {
        Entry { is_heading: true, ..Entry::plain(text, Role::Title) }
    }

    /// Whether it is laid out in the columns of its list, not across them.
    pub fn has_cells(&self) -> bool {
        self.text.contains(CELL_END)
    }
}

/// The list of this kind.
pub fn listing(model: &Model, kind: Kind) -> Listing {
    let texts = &model.texts().lists;
    match kind {
        Kind::Breakpoints => Listing {
            title: texts.breakpoints.title.to_owned(),
            columns: Column::all(&texts.breakpoints.columns, &[]),
            entries: breakpoints::entries(model),
            nothing: texts.breakpoints.nothing,
        },
        Kind::Stops => Listing {
            title: texts.stops.title.to_owned(),
            columns: Column::all(&texts.stops.columns, &[0]),
            entries: run::entries(model),
            nothing: texts.stops.nothing,
        },
        Kind::Bookmarks => Listing {
            title: texts.bookmarks.title.to_owned(),
            columns: Column::all(&texts.bookmarks.columns, &[]),
            entries: bookmarks::entries(model),
            nothing: texts.bookmarks.nothing,
        },
        Kind::Operands | Kind::Uses | Kind::Contributions | Kind::Arithmetics => understanding::listing(model, kind),
    }
}

/// Opens a list.
pub(super) fn open(model: &mut Model, kind: Kind) {
    let entries = listing(model, kind).entries;
    let selected = entries.iter().position(|entry| entry.target.is_some());
    let selected = selected.unwrap_or_else(|| off_headings(&entries, 0, false));
    model.overlay = Some(Overlay::List { kind, selected, shift: 0 });
}

/// How many columns of the screen a list is scrolled at once.
const STRIDE: usize = 8;

/// The row that an action leads to from one, in what has this last row; `None` if it is no movement.
pub(super) fn moved(action: Action, row: usize, times: usize, page: usize, last: usize) -> Option<usize> {
    Some(match action {
        Action::Down => row.saturating_add(times),
        Action::Up => row.saturating_sub(times),
        Action::HalfPageDown | Action::PageDown => row.saturating_add(page),
        Action::HalfPageUp | Action::PageUp => row.saturating_sub(page),
        Action::First => 0,
        Action::Last => last,
        _ => return None,
    })
}

/// Moves in a list, goes to the place of its selected entry, or closes it.
pub(super) fn update(
    model: &mut Model,
    action: Action,
    kind: Kind,
    (selected, shift): (usize, usize),
    count: Option<u32>,
) -> Effect {
    let listing = listing(model, kind);
    let times = count.unwrap_or(1) as usize;
    let page = usize::from(model.size.1 / 2).max(1);
    let last = listing.entries.len().saturating_sub(1);
    let mut aside = shift;
    let moved = match action {
        Action::Wider => {
            aside = shift.saturating_add(STRIDE * times).min(view::last_shift(model, &listing, kind));
            selected
        }
        Action::Narrower => {
            aside = shift.saturating_sub(STRIDE * times);
            selected
        }
        Action::In | Action::Enter if kind == Kind::Breakpoints => {
            breakpoints::go_to_next(model, selected);
            return Effect::None;
        }
        Action::Toggle if kind == Kind::Breakpoints => {
            breakpoints::turn(model, selected);
            return Effect::None;
        }
        Action::Walk(Walk::Delete) if kind == Kind::Breakpoints => {
            breakpoints::delete(model, selected);
            return Effect::None;
        }
        Action::In | Action::Enter if kind == Kind::Stops => return run::go_to(model, selected),
        Action::In | Action::Enter => {
            if let Some(target) = listing.entries.get(selected).and_then(|entry| entry.target) {
                model.overlay = None;
                guide::jump(model, target);
            }
            return Effect::None;
        }
        Action::Close | Action::Quit | Action::Out => {
            model.overlay = None;
            return Effect::None;
        }
        Action::Interrupt => return Effect::Leave(Exit::Interrupted),
        Action::Suspend => return Effect::Suspend,
        action => self::moved(action, selected, times, page, last).unwrap_or(selected),
    };
    let selected = off_headings(&listing.entries, moved.min(last), moved < selected || action == Action::Last);
    model.overlay = Some(Overlay::List { kind, selected, shift: aside });
    Effect::None
}

/// The entry that is selected instead of a heading: the next one, or the one before when moving backward; else the nearest other.
fn off_headings(entries: &[Entry], wanted: usize, backward: bool) -> usize {
    let is_one = |at: &usize| entries.get(*at).is_some_and(|entry| !entry.is_heading);
    let after = (wanted..entries.len()).find(is_one);
    let before = (0..=wanted).rev().find(is_one);
    if backward { before.or(after) } else { after.or(before) }.unwrap_or(wanted)
}
