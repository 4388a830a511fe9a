//! Bookmarks: places that outlive the tracing of another pixel. In words a place is an address: the path of its node, and the quantity or
//! decision.

use super::effect::Effect;
use super::jumps;
use super::model::breakpoint::kind;
use super::model::guide::{Bookmark, MAX_NOTE_LENGTH, MAX_NOTES, Note, Notes, Spelt};
use super::model::list::{Entry, Kind};
use super::model::{Model, Overlay};
use super::theme::Role;
use crate::log::tree::Place;
use crate::log::{Log, Tree, What};
use crate::report::words::plain;
use std::collections::{HashMap, HashSet};

/// What is left to do, or why nothing was done.
type Done = Result<Effect, String>;

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

/// Sets a bookmark at the current step, with a note unless that is empty. One that is there already keeps its note.
pub(super) fn set(model: &mut Model, letter: char, note: &str) -> Done {
    let messages = &model.texts().messages;
    if model.log.events.is_empty() {
        return Err(messages.no_step_to_remember.to_owned());
    }
    if note.chars().nth(MAX_NOTE_LENGTH).is_some() {
        return Err((messages.note_too_long)(MAX_NOTE_LENGTH));
    }
    let old = model.guide.bookmarks.iter().find(|known| known.letter == letter);
    let kept = old.filter(|old| old.event == Some(model.event)).map(|old| old.note.clone());
    let has_had = old.is_some_and(|old| !old.note.is_empty());
    let note = if note.is_empty() { kept.clone().unwrap_or_default() } else { note.to_owned() };
    let count = model.guide.bookmarks.iter().filter(|one| !one.note.is_empty()).count();
    if !note.is_empty() && !has_had && count >= MAX_NOTES {
        return Err((messages.too_many_notes)(MAX_NOTES));
    }
    let is_news = kept.as_deref() != Some(note.as_str()) && (has_had || !note.is_empty());
    let (place, address) =
        (Place::of(&model.log, &model.tree, model.event), address(&model.log, &model.tree, model.event));
    let text = if model.hides_name(model.event) { model.describe(model.event) } else { address.clone() };
    let said =
        if note.is_empty() { (messages.bookmark)(letter, &text) } else { (messages.noted)(letter, &plain(&note)) };
    model.say(&said);
    let bookmarks = &mut model.guide.bookmarks;
    bookmarks.retain(|known| known.letter != letter);
    bookmarks.push(Bookmark { letter, place: Some(place), address, event: Some(model.event), note, kept: None });
    bookmarks.sort_by_key(|bookmark| bookmark.letter);
    Ok(if is_news { Effect::Keep } else { Effect::None })
}

/// Notes something at the current step: at the bookmark that is there, or else at one with the next free letter.
pub(super) fn note(model: &mut Model, text: &str) -> Done {
    let bookmarks = &model.guide.bookmarks;
    let here = bookmarks.iter().find(|bookmark| bookmark.event == Some(model.event)).map(|bookmark| bookmark.letter);
    let free = ('a'..='z').find(|letter| bookmarks.iter().all(|bookmark| bookmark.letter != *letter));
    match here.or(free) {
        Some(letter) => set(model, letter, text),
        None => Err(model.texts().messages.no_letter.to_owned()),
    }
}

/// Deletes the bookmark in this row of the list.
pub(super) fn delete(model: &mut Model, selected: usize) -> Effect {
    if selected >= model.guide.bookmarks.len() {
        return Effect::None;
    }
    let Bookmark { letter, note, .. } = model.guide.bookmarks.remove(selected);
    let last = model.guide.bookmarks.len().saturating_sub(1);
    model.overlay = Some(Overlay::List { kind: Kind::Bookmarks, selected: selected.min(last), shift: 0 });
    model.say(&(model.texts().messages.bookmark_deleted)(letter));
    if note.is_empty() { Effect::None } else { Effect::Keep }
}

/// Goes to a bookmark.
pub(super) fn go(model: &mut Model, letter: char) {
    let Some(bookmark) = model.guide.bookmarks.iter().find(|bookmark| bookmark.letter == letter) else {
        return model.say(&(model.texts().messages.no_bookmark)(letter));
    };
    let (event, note, address) = (bookmark.event, plain(&bookmark.note), plain(&bookmark.address));
    let messages = &model.texts().messages;
    match event {
        Some(event) => {
            jumps::to_event(model, event);
            if !note.is_empty() {
                model.say(&(messages.noted)(letter, &note));
            }
        }
        None => model.say(&(messages.bookmark_elsewhere)(letter, &address)),
    }
}

/// Whether something is noted at a bookmark.
pub(super) fn has_notes(model: &Model) -> bool {
    model.guide.bookmarks.iter().any(|bookmark| !bookmark.note.is_empty())
}

/// Adds to what was said of a note which file keeps it, or why none does.
pub(super) fn kept(model: &mut Model, kept: Result<String, String>) {
    let done = model.message.take().map(|message| message.text).unwrap_or_default();
    let messages = &model.texts().messages;
    model.say(&match kept {
        Ok(file) if !has_notes(model) => (messages.kept_no_longer)(&done, &plain(&file)),
        Ok(file) => (messages.kept_in)(&done, &plain(&file)),
        Err(why) => (messages.not_kept)(&done, &plain(&why)),
    });
}

/// The bookmarks with notes, as they are kept.
pub(super) fn notes(model: &Model) -> Vec<Note> {
    let noted = model.guide.bookmarks.iter().filter(|bookmark| !bookmark.note.is_empty());
    let wanted: Vec<_> = noted.clone().filter_map(|bookmark| bookmark.event).collect();
    let numbers = numbers(&model.log, &model.tree, &wanted);
    let note = |bookmark: &Bookmark| {
        let here = bookmark.event.map(|event| Spelt { number: numbers[&event], step: event + 1 });
        Some(Note {
            letter: bookmark.letter,
            address: bookmark.address.clone(),
            spelt: here.or(bookmark.kept)?,
            text: bookmark.note.clone(),
        })
    };
    noted.filter_map(note).collect()
}

/// Takes the notes that are kept for the log, and says so.
pub(super) fn take(model: &mut Model, Notes { notes, is_same_log, file }: Notes) {
    let events = events(&model.log, &model.tree, &notes, is_same_log);
    for (note, event) in notes.into_iter().zip(&events) {
        model.guide.bookmarks.push(Bookmark {
            letter: note.letter,
            place: event.map(|event| Place::of(&model.log, &model.tree, event)),
            address: note.address,
            event: *event,
            note: note.text,
            kept: Some(note.spelt),
        });
    }
    model.guide.bookmarks.sort_by_key(|bookmark| bookmark.letter);
    let (file, messages) = (plain(&file), &model.texts().messages);
    let found = events.iter().flatten().count();
    model.say(&match found == events.len() && is_same_log {
        true => (messages.notes_found)(found, &file),
        false => (messages.notes_of_another)(found, events.len(), &file),
    });
}

/// Of each of these events, how many before it have the same address.
fn numbers(log: &Log, tree: &Tree, wanted: &[usize]) -> HashMap<usize, usize> {
    let addresses: Vec<_> = wanted.iter().map(|event| address(log, tree, *event)).collect();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    let mut numbers = HashMap::new();
    each_of(log, tree, &addresses, |event, found| {
        let count = counts.entry(&addresses[found]).or_default();
        if wanted.contains(&event) {
            numbers.insert(event, *count);
        }
        *count += 1;
    });
    numbers
}

/// The events at which notes are, as far as the log has them.
fn events(log: &Log, tree: &Tree, notes: &[Note], is_same_log: bool) -> Vec<Option<usize>> {
    let by_step = |note: &Note| {
        let event = note.spelt.step.checked_sub(1).filter(|event| is_same_log && *event < log.events.len())?;
        (address(log, tree, event) == note.address).then_some(event)
    };
    let mut events: Vec<_> = notes.iter().map(by_step).collect();
    if events.iter().all(Option::is_some) {
        return events;
    }
    let addresses: Vec<_> = notes.iter().map(|note| note.address.clone()).collect();
    let mut counts: HashMap<&str, usize> = HashMap::new();
    each_of(log, tree, &addresses, |event, found| {
        let count = counts.entry(&addresses[found]).or_default();
        for (note, known) in notes.iter().zip(&mut events) {
            if known.is_none() && note.address == addresses[found] && note.spelt.number == *count {
                *known = Some(event);
            }
        }
        *count += 1;
    });
    events
}

/// Calls for every event that has one of these addresses, in order, with the number of the first such address.
fn each_of(log: &Log, tree: &Tree, addresses: &[String], mut found: impl FnMut(usize, usize)) {
    let known: HashMap<&str, usize> =
        addresses.iter().enumerate().rev().map(|(number, address)| (address.as_str(), number)).collect();
    let words: HashSet<&str> = known.keys().map(|address| address.rsplit(' ').next().unwrap_or_default()).collect();
    for (event, one) in log.events.iter().enumerate() {
        // Most events are told apart by their word alone; a place without one is known by its path, which ends otherwise.
        let word = word(&one.what);
        if !word.is_empty() && !words.contains(word) {
            continue;
        }
        if let Some(number) = known.get(address(log, tree, event).as_str()) {
            found(event, *number);
        }
    }
}

/// Looks for the bookmarks in another log.
pub(super) fn renew(model: &mut Model) {
    for bookmark in &mut model.guide.bookmarks {
        bookmark.event = bookmark.place.as_ref().and_then(|place| place.find_on_any_object(&model.log, &model.tree));
    }
}

/// The list of the bookmarks.
pub(super) fn entries(model: &Model) -> Vec<Entry> {
    let (lists, has_notes) = (&model.texts().lists, has_notes(model));
    let entry = |bookmark: &Bookmark| {
        let text = format!("{}\t{}", bookmark.letter, plain(&bookmark.address));
        let note = if has_notes { format!("\t{}", plain(&bookmark.note)) } else { String::new() };
        let place = |event: usize| match model.pixel_of(event) {
            Some(pixel) => (lists.in_pixel)(pixel, &model.describe(event)),
            None => model.describe(event),
        };
        match bookmark.event {
            Some(event) if model.hides_name(event) => {
                Entry::to(event, format!("{}\t\t{}{note}", bookmark.letter, place(event)))
            }
            Some(event) => Entry::to(event, format!("{text}\t{}{note}", place(event))),
            None => Entry::plain(format!("{text}\t{}{note}", lists.not_in_this_log), Role::Faint),
        }
    };
    model.guide.bookmarks.iter().map(entry).collect()
}
