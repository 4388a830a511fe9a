//! Where one has been: the steps that jumps began at, and the way back to them, also from another pixel.

use super::model::Model;
use super::update::Effect;
use crate::log::tree::Place;

/// A step that can be gone back to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spot {
    /// Its pixel; none in the log of a ray or a region.
    pub pixel: Option<[u32; 2]>,
    /// Its event in the log of that pixel.
    pub event: usize,
    place: Place,
}

/// The steps that jumps began at.
#[derive(Clone, Debug, Default)]
pub struct Jumps {
    /// All that one can go back to, the latest last.
    list: Vec<Spot>,
    /// The latest, to which one can go over and back.
    last: Option<Spot>,
    /// The one before it that isn't the same: where the latest jump doesn't move, it is this that one comes back to.
    other: Option<Spot>,
}

/// So many are remembered.
const MOST: usize = 1000;

impl Spot {
    /// An event of the log that is shown.
    pub fn of(model: &Model, event: usize) -> Spot {
        Spot { pixel: model.pixel(), event, place: Place::of(&model.log, &model.tree, event) }
    }

    /// Whether it is a step of the pixel that is shown.
    pub fn is_shown(&self, model: &Model) -> bool {
        self.pixel == model.pixel()
    }
}

impl Jumps {
    /// The next jump begins here. Whether it moves isn't known yet.
    fn turn_at(&mut self, here: Spot) {
        if self.last.as_ref() != Some(&here) {
            self.other = self.last.replace(here);
        }
    }
}

/// Remembers the current step, before a jump.
pub(super) fn remember(model: &mut Model) {
    let here = Spot::of(model, model.event);
    let jumps = &mut model.guide.jumps;
    if jumps.list.len() == MOST {
        jumps.list.remove(0);
    }
    jumps.list.push(here.clone());
    jumps.turn_at(here);
}

/// Goes back to where the last jump began, then to where the one before it did.
pub(super) fn back(model: &mut Model) -> Effect {
    let here = Spot::of(model, model.event);
    // A jump that led nowhere, such as to a pixel that can't be traced, isn't a way back.
    while let Some(spot) = model.guide.jumps.list.pop() {
        if spot != here {
            model.guide.jumps.turn_at(here);
            return go(model, spot);
        }
    }
    model.say(model.texts().messages.nowhere_back);
    Effect::None
}

/// Goes back to before the last jump, as a jump, so that the next one leads here again.
pub(super) fn over(model: &mut Model) -> Effect {
    let here = Spot::of(model, model.event);
    let jumps = &model.guide.jumps;
    // A jump that doesn't move, such as to the step where one is, hides none that did.
    let turned = [&jumps.last, &jumps.other].into_iter().flatten().find(|spot| **spot != here).cloned();
    match turned {
        Some(spot) => {
            remember(model);
            go(model, spot)
        }
        None => {
            model.say(model.texts().messages.no_jump);
            Effect::None
        }
    }
}

/// Goes to a step, or has its pixel traced first.
pub(super) fn go(model: &mut Model, spot: Spot) -> Effect {
    match spot.pixel {
        _ if spot.is_shown(model) => arrive(model, &spot),
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
