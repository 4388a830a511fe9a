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
use super::{address, breakpoints, run};
use crate::report::language::viewer::{Hints, List};

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
        Kind::Breakpoints => Listing::of(&texts.breakpoints, texts.breakpoints_title, &[], breakpoints::entries(model)),
        Kind::Stops => Listing::of(&texts.stops, texts.stops_title, &[0], run::entries(model)),
        Kind::Bookmarks => Listing::of(&texts.bookmarks, texts.bookmarks_title, &[], address::entries(model)),
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
    match (action, kind) {
        (Action::In | Action::Enter, Kind::Breakpoints) => breakpoints::go_to_next(model, selected),
        (Action::Toggle, Kind::Breakpoints) => breakpoints::turn(model, selected),
        (Action::Walk(Walk::Delete), Kind::Breakpoints) => breakpoints::delete(model, selected),
        (Action::In | Action::Enter, Kind::Stops) => return run::go_to(model, selected),
        (Action::In | Action::Enter, _) => {
            if let Some(target) = listing.entries.get(selected).and_then(|entry| entry.target) {
                model.overlay = None;
                guide::jump(model, target);
            }
        }
        (Action::Close | Action::Quit | Action::Out, _) => model.overlay = None,
        (Action::Interrupt, _) => return Effect::Leave(Exit::Interrupted),
        (Action::Suspend, _) => return Effect::Suspend,
        (Action::Wider, _) => {
            let shift = shift.saturating_add(STRIDE * times).min(view::last_shift(model, &listing, kind));
            model.overlay = Some(Overlay::List { kind, selected, shift });
        }
        (Action::Narrower, _) => {
            let shift = shift.saturating_sub(STRIDE * times);
            model.overlay = Some(Overlay::List { kind, selected, shift });
        }
        _ => {
            let (page, last) = (usize::from(model.size.1 / 2).max(1), listing.entries.len().saturating_sub(1));
            let row = moved(action, selected, times, [page; 2], last).unwrap_or(selected);
            let selected = off_headings(&listing.entries, row, row < selected || action == Action::Last);
            model.overlay = Some(Overlay::List { kind, selected, shift });
        }
    }
    Effect::None
}

/// The row to which an action moves from another one, by `times` rows, by half a page or a page, or to an end; `None` for other actions.
pub(super) fn moved(
    action: Action,
    from: usize,
    times: usize,
    [half_page, page]: [usize; 2],
    last: usize,
) -> Option<usize> {
    let row = match action {
        Action::Down => from.saturating_add(times),
        Action::Up => from.saturating_sub(times),
        Action::HalfPageDown => from.saturating_add(half_page),
        Action::HalfPageUp => from.saturating_sub(half_page),
        Action::PageDown => from.saturating_add(page),
        Action::PageUp => from.saturating_sub(page),
        Action::First => 0,
        Action::Last => last,
        _ => return None,
    };
    Some(row.min(last))
}

/// The entry that is selected instead of a heading: the next one, or the one before when moving backward; else the nearest other.
fn off_headings(entries: &[Entry], wanted: usize, backward: bool) -> usize {
    let is_one = |at: &usize| entries.get(*at).is_some_and(|entry| !entry.is_heading);
    let after = (wanted..entries.len()).find(is_one);
    let before = (0..=wanted).rev().find(is_one);
    if backward { before.or(after) } else { after.or(before) }.unwrap_or(wanted)
}
