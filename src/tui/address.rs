//! Where an event is in words that another log understands: the path of its node, what the node is, and which quantity or
//! decision of it. Bookmarks are kept by it, so that they outlive the tracing of another pixel.

use super::breakpoints::kind;
use super::describe;
use super::guide;
use super::list::Entry;
use super::model::Model;
use super::theme::Role;
use crate::log::{Log, Step, Tree, What};

/// A place that can be looked for in another log.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Address {
    path: String,
    step: Option<Step>,
    what: &'static str,
    /// How many events before it have the same path, node and name.
    occurrence: usize,
}

impl Address {
    /// The address of an event.
    pub fn of(log: &Log, tree: &Tree, event: usize) -> Address {
        let node = tree.owner(event);
        let mut address = Address {
            path: tree.path(node),
            step: tree.nodes()[node].step,
            what: word(&log.events[event].what),
            occurrence: 0,
        };
        address.occurrence = (0..event).filter(|earlier| address.is_like(log, tree, *earlier)).count();
        address
    }

    /// The event with this address, if the log has one.
    pub fn find(&self, log: &Log, tree: &Tree) -> Option<usize> {
        (0..log.events.len()).filter(|event| self.is_like(log, tree, *event)).nth(self.occurrence)
    }

    fn is_like(&self, log: &Log, tree: &Tree, event: usize) -> bool {
        let node = tree.owner(event);
        tree.nodes()[node].step == self.step
            && word(&log.events[event].what) == self.what
            && tree.path(node) == self.path
    }

    /// How it is written: `C R T S1 shade.local`.
    pub fn text(&self) -> String {
        let gap = if self.path.is_empty() || self.what.is_empty() { "" } else { " " };
        format!("{}{gap}{}", self.path, self.what)
    }
}

/// The name of what an event says: the key of a quantity, or the kind.
fn word(what: &What) -> &'static str {
    match what {
        What::Note { name, .. } => name.key(),
        What::Leave => "end",
        what => kind::of(what).last().copied().unwrap_or_default(),
    }
}

/// A place to come back to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bookmark {
    /// The letter that it is called by.
    pub letter: char,
    address: Address,
    /// Where it is in this log, if it is there.
    event: Option<usize>,
}

/// Sets a bookmark at the current step.
pub(super) fn set(model: &mut Model, letter: char) {
    if model.log.events.is_empty() {
        return model.say(model.texts().messages.no_step_to_remember);
    }
    let address = Address::of(&model.log, &model.tree, model.event);
    let text = if model.hides_name(model.event) { describe::event(model, model.event) } else { address.text() };
    model.say(&(model.texts().messages.bookmark)(letter, &text));
    let bookmarks = &mut model.guide.bookmarks;
    bookmarks.retain(|known| known.letter != letter);
    bookmarks.push(Bookmark { letter, address, event: Some(model.event) });
    bookmarks.sort_by_key(|bookmark| bookmark.letter);
}

/// Goes to a bookmark.
pub(super) fn go(model: &mut Model, letter: char) {
    match model.guide.bookmarks.iter().find(|bookmark| bookmark.letter == letter) {
        None => model.say(&(model.texts().messages.no_bookmark)(letter)),
        Some(Bookmark { event: Some(event), .. }) => {
            let event = *event;
            guide::jump(model, event);
        }
        Some(bookmark) => {
            let text = (model.texts().messages.bookmark_elsewhere)(letter, &bookmark.address.text());
            model.say(&text);
        }
    }
}

/// Looks for the bookmarks in another log.
pub(super) fn renew(model: &mut Model) {
    for bookmark in &mut model.guide.bookmarks {
        bookmark.event = bookmark.address.find(&model.log, &model.tree);
    }
}

/// The list of the bookmarks.
pub(super) fn entries(model: &Model) -> Vec<Entry> {
    let lists = &model.texts().lists;
    let entry = |bookmark: &Bookmark| {
        let text = format!("{}\t{}", bookmark.letter, bookmark.address.text());
        let place = |event: usize| match model.pixel_of(event) {
            Some(pixel) => (lists.in_pixel)(pixel, &describe::event(model, event)),
            None => describe::event(model, event),
        };
        match bookmark.event {
            Some(event) if model.hides_name(event) => {
                Entry::to(event, format!("{}\t\t{}", bookmark.letter, place(event)))
            }
            Some(event) => Entry::to(event, format!("{text}\t{}", place(event))),
            None => Entry::plain(format!("{text}\t{}", lists.not_in_this_log), Role::Faint),
        }
    };
    model.guide.bookmarks.iter().map(entry).collect()
}
