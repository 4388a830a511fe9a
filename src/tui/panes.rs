//! What actions mean in the picture and in the schematic alone; going from pane to pane, and how large they are.

use super::effect::Effect;
use super::keys::{Action, Walk};
use super::model::drawing::Projection;
use super::model::layout::Layout;
use super::model::picture::MOST_ZOOM;
use super::model::schematic::Shown;
use super::model::{Model, Pane};
use super::{jumps, plane};
use std::cmp::Ordering;

/// Moves the focus to the n-th pane after the one that has it, of those on the screen.
pub(super) fn switch(model: &mut Model, by: isize) {
    let panes: Vec<Pane> =
        Pane::ALL.into_iter().filter(|pane| *pane != Pane::Picture || model.picture.is_some()).collect();
    let at = panes.iter().position(|pane| *pane == model.focus).unwrap_or(0) as isize;
    let next = (at + by).rem_euclid(panes.len() as isize) as usize;
    model.focus_on(panes[next]);
}

/// The tree's width, changed by this many steps to the right. What the screen has no room for is forgotten.
pub(super) fn shifted(model: &Model, steps: i64) -> i16 {
    const STEP: i64 = 4;
    let most = i64::from(model.size.0);
    (i64::from(model.shift) + steps * STEP).clamp(-most, most).clamp(i16::MIN.into(), i16::MAX.into()) as i16
}

/// Does in the picture what an action means there; `None` if it means the same as elsewhere.
pub(super) fn in_picture(model: &mut Model, action: Action, count: Option<u32>) -> Option<Effect> {
    if model.focus != Pane::Picture {
        return None;
    }
    let view = model.picture.as_mut()?;
    let times = i64::from(count.unwrap_or(1));
    match action {
        Action::Enter => model.focus_on(Pane::Tree),
        Action::ZoomIn => view.zoom = (view.zoom + 1).min(MOST_ZOOM),
        Action::ZoomOut => view.zoom = view.zoom.saturating_sub(1),
        Action::Brighter => view.expose(times),
        Action::Darker => view.expose(-times),
        Action::NextView => {
            view.next_layer();
            plane::hide(model);
        }
        Action::Walk(Walk::Faster) => return to_extreme(model, |a, b| b.total_cmp(a)),
        Action::Walk(Walk::Slower) => return to_extreme(model, f64::total_cmp),
        _ => return move_cursor(model, action, count),
    }
    Some(Effect::None)
}

/// Goes to the pixel whose value in the layer that is shown comes first in an order.
fn to_extreme(model: &mut Model, order: fn(&f64, &f64) -> Ordering) -> Option<Effect> {
    let view = model.picture.as_ref()?;
    let values = view.image.values(|dot| view.layer.rank(dot));
    // Of equal ones the first.
    let Some((pixel, _)) = values.min_by(|(_, a), (_, b)| order(a, b)) else { return Some(Effect::None) };
    jumps::remember(model);
    Some(Effect::Trace(pixel))
}

/// The pixels that a cell of the screen covers, along each axis.
fn cell(model: &Model) -> Option<[i64; 2]> {
    let dots = Layout::dots(model.layout(model.size).area(Pane::Picture));
    let (scale, _) = model.picture.as_ref()?.window([dots.width.into(), 2 * u32::from(dots.height)]);
    Some([scale, 2.0 * scale].map(|side| (side.round() as i64).max(1)))
}

/// Moves the cursor by an action for it.
fn move_cursor(model: &mut Model, action: Action, count: Option<u32>) -> Option<Effect> {
    let (page, times) = (model.page() as i64, i64::from(count.unwrap_or(1)));
    let view = model.picture.as_ref()?;
    let [across, down] = cell(model)?.map(|side| side * times);
    let by = match action {
        Action::CellLeft => [-across, 0],
        Action::NextSibling => [0, down],
        Action::PreviousSibling => [0, -down],
        Action::Walk(Walk::Stops) => [across, 0],
        Action::Down => [0, times],
        Action::Up => [0, -times],
        Action::Out => [-times, 0],
        Action::In if count.is_none() => [1, 0],
        Action::In => [times, 0],
        Action::HalfPageDown | Action::PageDown => [0, page * times],
        Action::HalfPageUp | Action::PageUp => [0, -page * times],
        Action::First => [i64::MIN / 2, 0],
        // With a count it is the step of this number, as everywhere.
        Action::Last if count.is_none() => [i64::MAX / 2, 0],
        _ => return None,
    };
    let moved = |at: u32, by: i64, size: u32| (i64::from(at) + by).clamp(0, i64::from(size) - 1) as u32;
    let target = [0, 1].map(|axis| moved(view.cursor[axis], by[axis], view.image.size[axis]));
    if target == view.cursor && model.log.header.subject == crate::log::Subject::Pixel(target) {
        model.say(model.texts().panes.picture.ends);
        return Some(Effect::None);
    }
    // The cursor goes there with the log, if there is one.
    Some(Effect::Trace(target))
}

/// Does in the schematic what an action means there; `None` if it means the same as elsewhere.
pub(super) fn in_schematic(model: &mut Model, action: Action) -> Option<Effect> {
    if model.focus != Pane::Schematic {
        return None;
    }
    let view = &mut model.schematic;
    match action {
        Action::NextView if view.shown == Shown::Vectors => model.say(model.texts().panes.schematic.own_plane),
        Action::NextView => {
            let next = model.side().next();
            let is_known = next != Projection::Camera || model.drawing.is_some();
            model.schematic.side = Some(if is_known { next } else { next.next() });
        }
        Action::ZoomIn => view.magnification = (view.magnification + 1).min(MOST_MAGNIFICATION),
        Action::ZoomOut => view.magnification = view.magnification.saturating_sub(1),
        _ => return None,
    }
    Some(Effect::None)
}

/// The most that the schematic is enlarged, in powers of two.
const MOST_MAGNIFICATION: u32 = 10;
