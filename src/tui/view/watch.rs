//! The quantities that are watched, with their values at the current step, below the computation.

use super::{cut, put, title_rule};
use crate::tui::model::Model;
use crate::tui::model::watch::Watched;
use crate::tui::text::{counted, shown, width_of};
use crate::tui::theme::{Role, Theme};
use crate::tui::watch;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

/// The most rows, without the title: the others are in the list.
const MOST_ROWS: u16 = 5;

/// What the computation keeps at least.
const ROWS_OF_COMPUTATION: u16 = 8;

/// What of a pane is left to the computation, and what goes to what is watched.
pub(super) fn split(model: &Model, area: Rect) -> (Rect, Rect) {
    let wanted = model.guide.watches.pinned.len().min(usize::from(MOST_ROWS)) as u16;
    let rows = wanted.min(area.height / 4) + 1;
    if rows < 2 || area.height < rows + ROWS_OF_COMPUTATION {
        return (area, Rect::default());
    }
    let above = Rect { height: area.height - rows, ..area };
    (above, Rect { y: above.bottom(), height: rows, ..area })
}

/// Draws them with a title above.
pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.height < 2 {
        return;
    }
    let texts = &model.texts().watch;
    title_rule(&shown(texts.title, theme), theme, area, buffer);
    let pinned = &model.guide.watches.pinned;
    let room = usize::from(area.height - 1);
    // The last row says how many more there are.
    let fitting = if pinned.len() > room { room - 1 } else { room };
    let lines = pinned.iter().take(fitting).map(|watched| line(model, watched, theme, usize::from(area.width)));
    let others = (texts.others)(pinned.len().saturating_sub(fitting));
    let others =
        (pinned.len() > room).then(|| Line::styled(format!("  {}", shown(&others, theme)), theme.style(Role::Faint)));
    for (y, line) in (area.y + 1..area.bottom()).zip(lines.chain(others)) {
        put(buffer, Rect { y, height: 1, ..area }, line);
    }
}

/// `N·L = 0.800  C R S1`
fn line(model: &Model, watched: &Watched, theme: &Theme, width: usize) -> Line<'static> {
    let room = width.saturating_sub(2);
    let faint = theme.style(Role::Faint);
    let Some(here) = watch::here(model, watched) else {
        let text = shown(&(model.texts().watch.not_here)(&watched.shown()), theme);
        return Line::from(vec![Span::raw("  "), Span::styled(cut(&text, 0, room, theme), faint)]);
    };
    let is_changed = model.changed.events.contains(&here.event);
    let mark = if is_changed { theme.glyphs.differs } else { " " };
    let text = shown(&format!("{} = {}", watched.shown(), model.value(&here.value)), theme);
    let role = if here.event == model.event { Role::Value } else { Role::Text };
    // Where it was computed, if that is another node and there is room for it.
    let node = model.tree.owner(here.event);
    let from = if node == model.tree.owner(model.event) { String::new() } else { model.tree.shown_path(node) };
    let from = shown(&format!("  {}", counted(&from)), theme);
    let from = if width_of(&text) + width_of(&from) <= room { from } else { String::new() };
    Line::from(vec![
        Span::styled(format!("{mark} "), theme.style(Role::Warning)),
        Span::styled(cut(&text, 0, room, theme), theme.style(role)),
        Span::styled(from, faint),
    ])
}
