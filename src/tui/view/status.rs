//! The bottom line: where one is, and the keys to begin with. Above it, when there is one, the message.

use super::put;
use super::text::{shown, width_of};
use crate::log::What;
use crate::tui::layout::Layout;
use crate::tui::model::{Model, Pane};
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

pub(super) fn draw(model: &Model, theme: &Theme, layout: &Layout, buffer: &mut Buffer) {
    if let Some(message) = &model.message {
        let style = theme.style(if message.is_warning { Role::Warning } else { Role::Text });
        let before = if message.is_warning { "warning: " } else { "" };
        put(buffer, layout.message, Line::styled(shown(&format!("{before}{}", message.text), theme), style));
    }
    let area = layout.status;
    let position = Line::from(vec![
        Span::styled(format!("step {}/{}", model.step(), model.log.events.len()), theme.style(Role::Title)),
        Span::raw(shown(&place(model), theme)),
    ]);
    let used = position.width();
    put(buffer, area, position);

    let room = usize::from(area.width).saturating_sub(used + 2);
    if let Some(hint) = hints(model).into_iter().find(|hint| width_of(hint) <= room) {
        let width = width_of(&hint) as u16;
        let place = Rect { x: area.right() - width, width, ..area };
        put(buffer, place, Line::styled(hint, theme.style(Role::Faint)));
    }
}

/// The path of the ray, and which quantity of the source text the current step computes.
fn place(model: &Model) -> String {
    let mut place = String::new();
    let path = model.tree.path(model.cursor);
    if !path.is_empty() {
        place.push_str(&format!("  {path}"));
    }
    if let Some(What::Note { name, .. }) = model.log.events.get(model.event).map(|event| &event.what) {
        place.push_str(&format!("  {}  section {}", name.key(), name.section()));
    }
    place
}

/// What to say about keys, from the longest to the shortest.
fn hints(model: &Model) -> Vec<String> {
    let pending = model.pending;
    if pending.count.is_some() || pending.prefix.is_some() {
        let count = pending.count.map(|count| count.to_string()).unwrap_or_default();
        return vec![format!("{count}{}", pending.prefix.map(String::from).unwrap_or_default())];
    }
    let move_keys = if model.focus == Pane::Tree { "j k move  Space fold" } else { "j k move  Tab tree" };
    vec![
        format!("n next value  p previous  {move_keys}  ? help  q quit"),
        "n next value  p previous  ? help  q quit".to_owned(),
        "n next  ? help  q quit".to_owned(),
        "? help".to_owned(),
    ]
}
