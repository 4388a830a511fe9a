//! Running to the next breakpoint, and the log of where that stopped.

use super::effect::Effect;
use super::jumps;
use super::model::breakpoint::Breakpoint;
use super::model::guide::Stopped;
use super::model::list::{Entry, Kind};
use super::model::{Model, Overlay};
use crate::report::words::plain;
use std::ops::Range;

/// The most stops that are remembered.
const MOST: usize = 1000;

/// Runs on, or back, to the next event that a breakpoint stops at, this many times.
pub(super) fn run(model: &mut Model, is_forward: bool, times: usize) {
    if model.guide.breakpoints.iter().all(|breakpoint| !breakpoint.is_on) {
        let has_some = !model.guide.breakpoints.is_empty();
        let texts = &model.texts().breakpoints;
        return model.say(if has_some { texts.all_off } else { texts.none });
    }
    for done in 0..times {
        let (here, count) = (model.event, model.log.events.len());
        let found = match is_forward {
            true => first_stop(model, here + 1..count),
            false => last_stop(model, 0..here),
        };
        match found {
            Some(event) => stop(model, event),
            None => return say_no_more(model, is_forward, (done, times)),
        }
    }
}

/// Says that no breakpoint stops any more, after `done` of `times` stops.
fn say_no_more(model: &mut Model, is_forward: bool, (done, times): (usize, usize)) {
    let texts = &model.texts().breakpoints;
    let hides = |one: &Breakpoint| one.is_on && is_hidden(model, one);
    if done == 0 && is_forward && model.guide.breakpoints.iter().any(hides) {
        model.say(texts.hidden);
    } else {
        model.say(&(texts.no_more)(done, times, is_forward));
    }
}

/// Whether a breakpoint stops at an event. In a quiz it doesn't where that would tell what is hidden.
pub(super) fn stops_at(model: &Model, breakpoint: &Breakpoint, event: usize) -> bool {
    breakpoint.places.has(event) && !tells(model, breakpoint, event)
}

/// Whether that a breakpoint stops at an event would tell what a quiz hides. One of several terms may be about values before the event, too.
fn tells(model: &Model, breakpoint: &Breakpoint, event: usize) -> bool {
    let is_hidden = || match breakpoint.condition.is_compound() {
        true => model.understanding.quiz.is_some() && event >= model.event,
        false => model.hides(event),
    };
    is_hidden() && breakpoint.condition.tells(&model.log.events[event].what)
}

/// Whether a quiz may keep a breakpoint from stopping somewhere, whatever the log holds.
pub(super) fn is_hidden(model: &Model, breakpoint: &Breakpoint) -> bool {
    model.understanding.quiz.is_some() && breakpoint.condition.may_tell()
}

/// The breakpoints that are on.
fn on(model: &Model) -> impl Iterator<Item = &Breakpoint> {
    model.guide.breakpoints.iter().filter(|breakpoint| breakpoint.is_on)
}

/// The first of these events that a breakpoint stops at.
pub(super) fn first_stop(model: &Model, events: Range<usize>) -> Option<usize> {
    let first = |one: &Breakpoint| one.places.among(events.clone()).find(|event| !tells(model, one, *event));
    on(model).filter_map(first).min()
}

/// The last of them.
fn last_stop(model: &Model, events: Range<usize>) -> Option<usize> {
    let last = |one: &Breakpoint| one.places.among(events.clone()).rev().find(|event| !tells(model, one, *event));
    on(model).filter_map(last).max()
}

/// Whether a breakpoint that is on stops at an event, as far as that may be shown.
pub(super) fn marks_event(model: &Model, event: usize) -> bool {
    model.guide.is_known(event) && on(model).any(|one| stops_at(model, one, event))
}

/// Whether there are marks of breakpoints beside rows at all.
pub(super) fn has_gutter(model: &Model) -> bool {
    on(model).next().is_some()
}

/// Whether a row of the tree has a mark: for one of the node's own events, or, where it is closed, for one inside it.
pub(super) fn marks_node(model: &Model, node: usize) -> bool {
    if !model.fold.is_open(&model.tree, node) {
        return marks_inside(model, node);
    }
    let is_own = |event: usize| model.tree.owner(event) == node;
    on(model).any(|one| one.places.are_in(node) && (!may_be_hidden(model, one) || is_seen(model, one, node, is_own)))
}

/// Whether one stops anywhere in a node.
pub(super) fn marks_inside(model: &Model, node: usize) -> bool {
    let has_some = |one: &Breakpoint| one.places.among(model.tree.nodes()[node].events.clone()).next().is_some();
    on(model).any(|one| has_some(one) && (!may_be_hidden(model, one) || is_seen(model, one, node, |_| true)))
}

/// Whether some places of a breakpoint may not be shown: a quiz or a tree that grows hides them.
fn may_be_hidden(model: &Model, breakpoint: &Breakpoint) -> bool {
    model.guide.grown.is_some() || is_hidden(model, breakpoint)
}

/// Whether one of the places of a breakpoint in a node may be shown.
fn is_seen(model: &Model, breakpoint: &Breakpoint, node: usize, is_it: impl Fn(usize) -> bool) -> bool {
    /// The most that are looked at, which is done for each row of a frame.
    const MOST: usize = 1000;
    let places = breakpoint.places.among(model.tree.nodes()[node].events.clone()).take(MOST);
    places.into_iter().any(|event| is_it(event) && model.guide.is_known(event) && !tells(model, breakpoint, event))
}

/// Stops at an event, counts that for each breakpoint that stops there, and remembers it.
pub(super) fn stop(model: &mut Model, event: usize) {
    let stopping = |one: &&Breakpoint| one.is_on && stops_at(model, one, event);
    let breakpoint = model.guide.breakpoints.iter().find(stopping).map(|one| one.text.clone()).unwrap_or_default();
    let stops: Vec<_> = model.guide.breakpoints.iter().map(|one| stopping(&one)).collect();
    for (one, _) in model.guide.breakpoints.iter_mut().zip(stops).filter(|(_, stops)| *stops) {
        one.hits = one.hits.saturating_add(1);
    }
    arrive(model, event, breakpoint);
}

/// Goes where a breakpoint stops, and remembers it.
pub(super) fn arrive(model: &mut Model, event: usize, breakpoint: String) {
    jumps::to_event(model, event);
    let what = model.describe(event);
    model.say(&(model.texts().breakpoints.stopped)(&plain(&breakpoint), &what));
    model.guide.stops.push(Stopped { spot: model.spot(event), what, breakpoint });
    let excess = model.guide.stops.len().saturating_sub(MOST);
    model.guide.stops.drain(..excess);
}

/// Opens the list of the stops at the latest one.
pub(super) fn open(model: &mut Model) {
    let selected = model.guide.stops.len().saturating_sub(1);
    model.overlay = Some(Overlay::List { kind: Kind::Stops, selected, shift: 0 });
}

/// The list of the stops, with the pixels of those in a region and in pixels that aren't the one that is shown.
pub(super) fn entries(model: &Model) -> Vec<Entry> {
    let entry = |Stopped { spot, what, breakpoint }: &Stopped| {
        let is_shown = spot.pixel == model.pixel();
        let pixel = if is_shown { model.pixel_of(spot.event) } else { spot.pixel };
        let pixel = pixel.map_or(String::new(), |[x, y]| format!("{x},{y}"));
        // What a quiz hid then may be known now.
        let what = if is_shown { model.describe(spot.event) } else { what.clone() };
        Entry::to(spot.event, format!("{}\t{pixel}\t{}\t{what}", spot.event + 1, plain(breakpoint)))
    };
    model.guide.stops.iter().map(entry).collect()
}

/// Goes to the stop in this row of the list.
pub(super) fn go_to(model: &mut Model, selected: usize) -> Effect {
    let Some(stop) = model.guide.stops.get(selected) else { return Effect::None };
    let spot = stop.spot.clone();
    model.overlay = None;
    jumps::to(model, spot)
}
