//! The message: on the bottom line, in place of where one is and of the hints, so that no pane moves for it. What doesn't fit
//! there lies over the lowest rows of the panes.

use super::status::positions;
use super::table::cut;
use super::{clear, put, put_all};
use crate::tui::model::Model;
use crate::tui::text::{shown, width_of, wrap};
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

/// The most rows of a message.
const MOST_ROWS: usize = 3;

/// Draws the message, if there is one: behind the step where both have room.
pub(super) fn draw(model: &Model, theme: &Theme, status: Rect, buffer: &mut Buffer) {
    let Some(message) = model.message.as_ref().or(model.warning.as_ref()) else { return };
    let style = theme.style(if message.is_warning { Role::Warning } else { Role::Text });
    let before = if message.is_warning { model.texts().status.warning } else { "" };
    let text = shown(&format!("{before}{}", message.text), theme);
    let width = usize::from(status.width);
    // The line that is being typed stays where it is.
    let bottom = if model.prompt.is_some() { status.y } else { status.bottom() };
    let is_beside = |position: &String| model.prompt.is_none() && width_of(position) + 2 + width_of(&text) <= width;
    if let Some(position) = positions(model, theme).into_iter().find(is_beside) {
        clear(status, buffer);
        let spans = [Span::styled(position, theme.style(Role::Title)), Span::raw("  "), Span::styled(text, style)];
        return put(buffer, status, Line::from_iter(spans));
    }
    let mut lines = wrap(&[(text, style)], width, 0);
    if lines.len() > MOST_ROWS {
        let rest: Vec<_> = lines.drain(MOST_ROWS - 1..).map(|line| line.to_string().trim_end().to_owned()).collect();
        lines.push(Line::styled(cut(&rest.join(" "), 0, width, theme), style));
    }
    let height = lines.len() as u16;
    let area = Rect { y: bottom.saturating_sub(height), height, ..status };
    clear(area, buffer);
    put_all(buffer, area, lines);
}
