//! The mouse: off until it is asked for, because a terminal can't select text while the viewer has it.

use super::effect::Effect;
use super::jumps;
use super::keys::{Action, Walk};
use super::model::layout::Layout;
use super::model::{Model, Pane};
use crate::log::tree::Item;
use crossterm::event::{MouseButton, MouseEvent, MouseEventKind};
use ratatui::layout::Position;

/// How many rows a notch of the wheel moves.
const NOTCH: i16 = 3;

/// What the mouse means in the viewer as it is now.
pub(super) fn meant(model: &Model, event: MouseEvent) -> Option<Action> {
    if model.prompt.is_some() {
        return None;
    }
    let is_covered = model.overlay.is_some();
    match event.kind {
        MouseEventKind::ScrollDown if is_covered => Some(Action::Down),
        MouseEventKind::ScrollUp if is_covered => Some(Action::Up),
        MouseEventKind::ScrollDown => Some(Action::Walk(Walk::Wheel(NOTCH, event.column, event.row))),
        MouseEventKind::ScrollUp => Some(Action::Walk(Walk::Wheel(-NOTCH, event.column, event.row))),
        MouseEventKind::Down(MouseButton::Left) => Some(Action::Walk(Walk::Click(event.column, event.row))),
        _ => None,
    }
}

/// Takes the mouse, or gives it back.
pub(super) fn toggle(model: &mut Model) {
    model.guide.has_mouse = !model.guide.has_mouse;
    let messages = &model.texts().messages;
    let now = if model.guide.has_mouse { messages.mouse_is_ours } else { messages.mouse_is_the_terminals };
    model.say(now);
}

/// Selects the row of the tree that was clicked, what of the computation is there, the pixel of the picture, or the pane.
pub(super) fn click(model: &mut Model, at: Position, computed: Option<Item>) -> Effect {
    let layout = model.layout(model.size);
    focus(model, at);
    let body = Layout::body(layout.area(Pane::Tree));
    if body.contains(at) {
        let below = usize::from(at.y - body.y);
        let (row, count) = model.fold.down(&model.tree, model.top, below);
        // Below the last row there is nothing to select.
        if count == below {
            model.go_to_node(row);
        }
    }
    match computed {
        Some(Item::Event(event)) => model.event = event,
        Some(Item::Node(node)) => model.go_to_node(node),
        None => {}
    }
    let Some(pixel) = pixel_at(model, &layout, at) else { return Effect::None };
    jumps::remember(model);
    Effect::Trace(pixel)
}

/// The pixel of the picture at a place on the screen.
fn pixel_at(model: &Model, layout: &Layout, at: Position) -> Option<[u32; 2]> {
    let view = model.picture.as_ref()?;
    let dots = Layout::dots(layout.area(Pane::Picture));
    if !dots.contains(at) {
        return None;
    }
    let screen = [dots.width.into(), 2 * u32::from(dots.height)];
    view.pixel_under(screen, [u32::from(at.x - dots.x), 2 * u32::from(at.y - dots.y)])
}

/// What the wheel means in the pane under the mouse: it moves by rows, and zooms where there is a picture.
pub(super) fn wheel(model: &mut Model, rows: i16, x: u16, y: u16) -> Action {
    focus(model, Position { x, y });
    match (model.focus, rows > 0) {
        (Pane::Picture | Pane::Schematic, true) => Action::ZoomOut,
        (Pane::Picture | Pane::Schematic, false) => Action::ZoomIn,
        (_, true) => Action::Down,
        (_, false) => Action::Up,
    }
}

/// Lets the keys move in the pane under the mouse.
fn focus(model: &mut Model, at: Position) {
    let layout = model.layout(model.size);
    if let Some(pane) = Pane::ALL.into_iter().find(|pane| layout.area(*pane).contains(at)) {
        model.focus_on(pane);
    }
}
