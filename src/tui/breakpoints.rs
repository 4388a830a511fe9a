//! Setting and deleting breakpoints, and their list.

use super::model::breakpoint::{Breakpoint, Condition, kind, parse};
use super::model::list::Entry;
use super::model::{Model, Overlay};
use super::run;
use super::theme::Role;
use crate::log::What;

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
        None => model.guide.breakpoints.push(Breakpoint { condition, text: text.to_owned(), is_on: true }),
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

/// The list of all.
pub(super) fn entries(model: &Model) -> Vec<Entry> {
    let lists = &model.texts().lists;
    let entry = |breakpoint: &Breakpoint| {
        let (state, role) = if breakpoint.is_on { (lists.on, Role::Text) } else { (lists.off, Role::Faint) };
        Entry::plain(format!("{state}\t{}", crate::report::words::plain(&breakpoint.text)), role)
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
    let (text, is_hidden) = (breakpoint.text.clone(), run::is_hidden(model, breakpoint));
    // Beyond the end it goes on at the beginning.
    let (count, here) = (model.log.events.len(), model.event);
    match (here + 1..count).chain(0..count.min(here + 1)).find(holds) {
        Some(event) => {
            model.overlay = None;
            run::stop(model, event, text);
        }
        None if is_hidden => model.say(model.texts().breakpoints.hidden),
        None => model.say(&(model.texts().breakpoints.nowhere)(&text)),
    }
}
