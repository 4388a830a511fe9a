//! Bookmarks: places that outlive the tracing of another pixel. In words a place is an address: the path of its node, and the quantity or
//! decision.

use super::jumps;
use super::model::Model;
use super::model::breakpoint::kind;
use super::model::guide::Bookmark;
use super::model::list::Entry;
use super::theme::Role;
use crate::log::tree::Place;
use crate::log::{Log, Tree, What};

/// Where an event is, in words: `C R T S1 shade.local`.
pub(super) fn address(log: &Log, tree: &Tree, event: usize) -> String {
    let (path, what) = (tree.path(tree.owner(event)), word(&log.events[event].what));
    let gap = if path.is_empty() || what.is_empty() { "" } else { " " };
    format!("{path}{gap}{what}")
}

/// The name of what an event says: the key of a quantity, or the kind.
fn word(what: &What) -> &'static str {
    match what {
        What::Note { name, .. } => name.key(),
        What::Leave => "end",
        what => kind::of(what).last().copied().unwrap_or_default(),
    }
}

/// Sets a bookmark at the current step.
pub(super) fn set(model: &mut Model, letter: char) {
    if model.log.events.is_empty() {
        return model.say(model.texts().messages.no_step_to_remember);
    }
    let (place, address) =
        (Place::of(&model.log, &model.tree, model.event), address(&model.log, &model.tree, model.event));
    let text = if model.hides_name(model.event) { model.describe(model.event) } else { address.clone() };
    model.say(&(model.texts().messages.bookmark)(letter, &text));
    let bookmarks = &mut model.guide.bookmarks;
    bookmarks.retain(|known| known.letter != letter);
    bookmarks.push(Bookmark { letter, place, address, event: Some(model.event) });
    bookmarks.sort_by_key(|bookmark| bookmark.letter);
}

/// Goes to a bookmark.
pub(super) fn go(model: &mut Model, letter: char) {
    match model.guide.bookmarks.iter().find(|bookmark| bookmark.letter == letter) {
        None => model.say(&(model.texts().messages.no_bookmark)(letter)),
        Some(Bookmark { event: Some(event), .. }) => {
            let event = *event;
            jumps::to_event(model, event);
        }
        Some(bookmark) => {
            let text = (model.texts().messages.bookmark_elsewhere)(letter, &bookmark.address);
            model.say(&text);
        }
    }
}

/// Looks for the bookmarks in another log.
pub(super) fn renew(model: &mut Model) {
    for bookmark in &mut model.guide.bookmarks {
        bookmark.event = bookmark.place.find_on_any_object(&model.log, &model.tree);
    }
}

/// The list of the bookmarks.
pub(super) fn entries(model: &Model) -> Vec<Entry> {
    let lists = &model.texts().lists;
    let entry = |bookmark: &Bookmark| {
        let text = format!("{}\t{}", bookmark.letter, bookmark.address);
        let place = |event: usize| match model.pixel_of(event) {
            Some(pixel) => (lists.in_pixel)(pixel, &model.describe(event)),
            None => model.describe(event),
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
