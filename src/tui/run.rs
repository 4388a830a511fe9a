//! Running to the next breakpoint, and the log of where that stopped.

use super::effect::Effect;
use super::jumps;
use super::model::breakpoint::Breakpoint;
use super::model::guide::Stopped;
use super::model::list::{Entry, Kind};
use super::model::{Model, Overlay};
use crate::report::words::plain;

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
            false => first_stop(model, (0..here).rev()),
        };
        match found {
            Some((event, text)) => stop(model, event, text),
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
    let found = &model.log.events[event];
    let tells = || model.hides(event) && breakpoint.condition.tells(&found.what);
    breakpoint.condition.holds(found, model.numbers) && !tells()
}

/// Whether a quiz may keep a breakpoint from stopping somewhere, whatever the log holds.
pub(super) fn is_hidden(model: &Model, breakpoint: &Breakpoint) -> bool {
    model.understanding.quiz.is_some() && breakpoint.condition.may_tell()
}

/// The first of these events that a breakpoint stops at, and that breakpoint.
pub(super) fn first_stop(model: &Model, mut events: impl Iterator<Item = usize>) -> Option<(usize, String)> {
    let on: Vec<_> = model.guide.breakpoints.iter().filter(|breakpoint| breakpoint.is_on).collect();
    if on.is_empty() {
        return None;
    }
    events.find_map(|event| {
        let stops = on.iter().find(|one| stops_at(model, one, event))?;
        Some((event, stops.text.clone()))
    })
}

/// Stops at an event, and remembers it.
pub(super) fn stop(model: &mut Model, event: usize, breakpoint: String) {
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
