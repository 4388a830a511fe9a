//! Playing: stepping from value to value by itself, at a pace that can be changed.

use super::model::Model;
use super::run;
use super::steps::{self, Stop};
use std::time::Duration;

/// The time between two steps while it plays. It waits for what lies over the panes, and for what is being typed.
pub(super) fn interval(model: &Model) -> Option<Duration> {
    let plays = model.guide.pace.is_playing && model.prompt.is_none() && model.overlay.is_none();
    plays.then(|| Duration::from_secs(1) / model.guide.pace.rate())
}

/// Starts and stops playing.
pub(super) fn toggle(model: &mut Model) {
    let is_end = steps::after(&model.log.events, model.event, Stop::Value, 1).is_none();
    if !model.guide.pace.is_playing && is_end {
        return model.say(model.texts().messages.nothing_to_play);
    }
    model.guide.pace.is_playing = !model.guide.pace.is_playing;
}

/// Changes the pace.
pub(super) fn change(model: &mut Model, to: fn(u32) -> u32) {
    model.guide.pace.change(to);
    model.say(&(model.texts().messages.rate)(model.guide.pace.rate(), model.guide.pace.is_playing));
}

/// The next step. A breakpoint on the way stops the play.
pub(super) fn tick(model: &mut Model) {
    // What stopped in the meantime, such as for a list, isn't played.
    if interval(model).is_none() {
        return;
    }
    let here = model.event;
    let next = steps::after(&model.log.events, here, Stop::Value, 1);
    let until = next.map_or(model.log.events.len(), |next| next + 1);
    if let Some(event) = run::first_stop(model, here + 1..until) {
        model.guide.pace.is_playing = false;
        return run::stop(model, event);
    }
    match next {
        Some(next) => model.go_to_event(next),
        None => {
            model.guide.pace.is_playing = false;
            model.say(model.texts().messages.played);
        }
    }
}
