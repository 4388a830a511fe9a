//! Setting and deleting breakpoints, and their list.

use super::model::breakpoint::{Breakpoint, Condition, kind, parse};
use super::model::list::{Entry, cells};
use super::model::{Model, Overlay};
use super::run;
use super::theme::Role;
use crate::log::What;
use crate::report::side_by_side::Run;
use crate::report::words::plain;

/// Sets the breakpoint that a text asks for, or says what is wrong with it.
pub(super) fn add(model: &mut Model, text: &str) -> Result<(), String> {
    let condition = parse(text, &model.log, &model.texts().breakpoints)?;
    set(model, condition, text.trim());
    Ok(())
}

fn set(model: &mut Model, condition: Condition, text: &str) {
    let known = model.guide.breakpoints.iter_mut().find(|known| known.condition == condition);
    match known {
        Some(known) => known.is_on = true,
        None => {
            let mut new = Breakpoint::new(condition, text);
            new.find(Run { log: &model.log, tree: &model.tree }, model.numbers);
            model.guide.breakpoints.push(new);
        }
    }
    model.say(&(model.texts().breakpoints.set)(text));
}

/// Sets a breakpoint on every event of the kind of the current one (a value of that quantity, that decision, such a
/// node), or deletes it if there is one.
pub(super) fn toggle_here(model: &mut Model) {
    let Some(event) = model.log.events.get(model.event) else { return };
    if model.hides_name(model.event) {
        return model.say(model.texts().quiz.tells_decision);
    }
    // The end of a node stands for the node.
    let begins = model.tree.nodes()[model.tree.owner(model.event)].events.start;
    let event = if event.what == What::Leave { &model.log.events[begins] } else { event };
    let (condition, text) = match &event.what {
        What::Note { name, .. } => (Condition::of_quantity(name.key()), name.key()),
        what => match kind::of(what).last() {
            Some(kind) => (Condition::Kind(kind), *kind),
            None => return model.say(model.texts().breakpoints.nothing_here),
        },
    };
    let breakpoints = &mut model.guide.breakpoints;
    match breakpoints.iter().position(|known| known.condition == condition) {
        Some(known) => {
            breakpoints.remove(known);
            model.say(&(model.texts().breakpoints.deleted)(text));
        }
        None => set(model, condition, text),
    }
}

/// Looks for the places of all, in another log or where numbers are shown otherwise.
pub(super) fn renew(model: &mut Model) {
    let run = Run { log: &model.log, tree: &model.tree };
    model.guide.breakpoints.iter_mut().for_each(|breakpoint| breakpoint.find(run, model.numbers));
}

/// The list of all, with how often each has stopped a run, and at how many places it does in this log.
pub(super) fn entries(model: &Model) -> Vec<Entry> {
    let lists = &model.texts().lists;
    let entry = |breakpoint: &Breakpoint| {
        let (state, role) = if breakpoint.is_on { (lists.on, Role::Text) } else { (lists.off, Role::Faint) };
        // How many there are tells of what a quiz or a growing tree doesn't show yet.
        let is_told = !run::is_hidden(model, breakpoint) && model.guide.grown.is_none();
        let places = if is_told { breakpoint.places.count().to_string() } else { "?".to_owned() };
        let (hits, text) = (breakpoint.hits.to_string(), plain(&breakpoint.text));
        Entry::plain(cells([state.to_owned(), hits, places, text]), role)
    };
    model.guide.breakpoints.iter().map(entry).collect()
}

/// Turns the breakpoint in this row of the list on or off.
pub(super) fn turn(model: &mut Model, selected: usize) {
    if let Some(breakpoint) = model.guide.breakpoints.get_mut(selected) {
        breakpoint.is_on = !breakpoint.is_on;
    }
}

/// Deletes the breakpoint in this row of the list.
pub(super) fn delete(model: &mut Model, selected: usize) {
    let breakpoints = &mut model.guide.breakpoints;
    if selected < breakpoints.len() {
        breakpoints.remove(selected);
    }
    let last = breakpoints.len().saturating_sub(1);
    if let Some(Overlay::List { selected, .. }) = &mut model.overlay {
        *selected = (*selected).min(last);
    }
}

/// Goes to the next place of the breakpoint in this row of the list, whether it is on or off.
pub(super) fn go_to_next(model: &mut Model, selected: usize) {
    let Some(breakpoint) = model.guide.breakpoints.get(selected) else { return };
    let holds = |event: &usize| run::stops_at(model, breakpoint, *event);
    let places = &breakpoint.places;
    let (text, is_hidden) = (breakpoint.text.clone(), run::is_hidden(model, breakpoint));
    // Beyond the end it goes on at the beginning.
    let (count, here) = (model.log.events.len(), model.event);
    let found = places.among(here + 1..count).chain(places.among(0..count.min(here + 1))).find(holds);
    match found {
        Some(event) => {
            model.overlay = None;
            run::arrive(model, event, text);
        }
        None if is_hidden => model.say(model.texts().breakpoints.hidden),
        None => model.say(&(model.texts().breakpoints.nowhere)(&text)),
    }
}
