//! Going far, and back to where one has been, also from another pixel.

use super::effect::Effect;
use super::model::Model;
use super::model::jumps::Spot;

/// Remembers the current step, before a jump.
pub(super) fn remember(model: &mut Model) {
    let here = model.spot(model.event);
    model.guide.jumps.remember(here);
}

/// Goes far, to an event that `''` and `^o` come back from.
pub(super) fn to_event(model: &mut Model, event: usize) {
    remember(model);
    model.go_to_event(event);
}

/// Goes back to where the last jump began, then to where the one before it did.
pub(super) fn back(model: &mut Model) -> Effect {
    let here = model.spot(model.event);
    match model.guide.jumps.back(here) {
        Some(spot) => go(model, spot),
        None => {
            model.say(model.texts().messages.nowhere_back);
            Effect::None
        }
    }
}

/// Goes back to before the last jump, as a jump, so that the next one leads here again.
pub(super) fn over(model: &mut Model) -> Effect {
    match model.guide.jumps.turned(&model.spot(model.event)) {
        Some(spot) => to(model, spot),
        None => {
            model.say(model.texts().messages.no_jump);
            Effect::None
        }
    }
}

/// Goes to a step, or has its pixel traced first.
pub(super) fn go(model: &mut Model, spot: Spot) -> Effect {
    match spot.pixel {
        _ if spot.pixel == model.pixel() => arrive(model, &spot),
        Some(pixel) => return Effect::Revisit(pixel, spot),
        None => model.say(model.texts().messages.not_traced_again),
    }
    Effect::None
}

/// Goes to a step of the pixel that is shown, or to the nearest that it has.
pub(super) fn arrive(model: &mut Model, spot: &Spot) {
    let found = spot.place.find(&model.log, &model.tree);
    let (Ok(event) | Err(event)) = found;
    model.go_to_event(event);
    if found.is_err() {
        model.say(model.texts().messages.nearest_step);
    }
}

/// Jumps to a step, perhaps of another pixel.
pub(super) fn to(model: &mut Model, spot: Spot) -> Effect {
    remember(model);
    go(model, spot)
}
