//! What the user has set to find the way: breakpoints, bookmarks, a search, the pace of playing.

use super::bindings::Bindings;
use super::breakpoint::Breakpoint;
use super::fold::Folds;
use super::history::History;
use super::jumps::{Jumps, Spot};
use super::search::Search;
use super::watch::Watches;
use crate::log::tree::Place;

/// What the user has set to find the way.
#[derive(Clone, Debug, Default)]
pub struct Guide {
    /// The keys that the user has bound.
    pub bindings: Bindings,
    /// Where to stop.
    pub breakpoints: Vec<Breakpoint>,
    /// Where runs have stopped, the latest last.
    pub stops: Vec<Stopped>,
    /// Which quantities are watched.
    pub watches: Watches,
    /// How fast it plays, and whether.
    pub pace: Pace,
    /// While the tree grows: the event up to which it has.
    pub grown: Option<usize>,
    /// What is searched.
    pub search: Option<Search>,
    /// What the rows of the tree must match.
    pub filter: Option<String>,
    /// Whether the tree is shown without intersection tests.
    pub hides_tests: bool,
    /// The places to come back to.
    pub bookmarks: Vec<Bookmark>,
    /// Where jumps began.
    pub jumps: Jumps,
    /// What was open in the trees of other pixels.
    pub folds: Folds,
    /// The lines that were typed.
    pub history: History,
    /// Whether the mouse selects and scrolls.
    pub has_mouse: bool,
    /// What the rows of the help must contain.
    pub help: String,
}

impl Guide {
    /// Whether an event has happened, as far as one may see.
    pub fn is_known(&self, event: usize) -> bool {
        self.grown.is_none_or(|grown| event <= grown)
    }
}

/// A place where a run stopped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Stopped {
    /// The step.
    pub spot: Spot,
    /// What was there.
    pub what: String,
    /// The breakpoint that stopped it, as it was typed.
    pub breakpoint: String,
}

/// A place to come back to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bookmark {
    /// The letter that it is called by.
    pub letter: char,
    /// Where it is, in any log; unknown of one from a file that this log doesn't have.
    pub place: Option<Place>,
    /// The same in words.
    pub address: String,
    /// Where it is in this log, if it is there.
    pub event: Option<usize>,
    /// What is noted there.
    pub note: String,
    /// Of one from a file that this log doesn't have: how the file knows its place.
    pub kept: Option<Spelt>,
}

/// How a file knows the place of a bookmark with this address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spelt {
    /// How many places before it have the same address.
    pub number: usize,
    /// The step, from 1: as long as the log is the same.
    pub step: usize,
}

/// A bookmark with a note, as a file keeps it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// The letter of the bookmark.
    pub letter: char,
    /// Its place in words.
    pub address: String,
    /// Which of the places with that address, and the step.
    pub spelt: Spelt,
    /// What is noted.
    pub text: String,
}

/// The notes in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notes {
    /// The notes.
    pub notes: Vec<Note>,
    /// Whether the log is still the same as when they were kept.
    pub is_same_log: bool,
    /// The name of the file.
    pub file: String,
}

/// The most bookmarks with notes.
pub const MAX_NOTES: usize = 200;

/// The most characters of a note.
pub const MAX_NOTE_LENGTH: usize = 1000;

/// Whether it plays, and how fast.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Pace {
    /// Whether it plays.
    pub is_playing: bool,
    /// How often one step a second is doubled.
    doublings: u32,
}

impl Pace {
    /// Steps a second: 1, 2, 4, up to 32.
    pub fn rate(self) -> u32 {
        1 << self.doublings
    }

    /// Changes the rate, within what the eye can follow.
    pub fn change(&mut self, to: fn(u32) -> u32) {
        self.doublings = to(self.rate()).clamp(1, 32).ilog2();
    }
}
