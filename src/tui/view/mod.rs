//! What is seen of the model: one file a pane. Drawing touches only what is on the screen, changes nothing, and never
//! panics, however small the screen is.

// The panes that are laid out take it in.
#[allow(dead_code)]
pub(super) mod code;
mod computation;
pub(super) mod help;
mod label;
mod list;
mod pattern;
mod status;
mod text;
mod tree;

use super::layout::Layout;
use super::model::{Model, Overlay, Pane};
use super::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

/// Draws the whole screen.
pub fn draw(model: &Model, theme: &Theme, buffer: &mut Buffer) {
    let screen = buffer.area;
    let layout = Layout::of((screen.width, screen.height), model.focus, model.message.is_some());
    if layout.is_too_small {
        return too_small(screen, buffer);
    }
    tree::draw(model, theme, layout.tree, buffer);
    if let Some(divider) = layout.divider {
        for y in divider.top()..divider.bottom() {
            let glyph = if y == divider.y { theme.glyphs.tee } else { theme.glyphs.vertical };
            put(buffer, Rect { y, height: 1, ..divider }, Span::styled(glyph, theme.style(Role::Faint)).into());
        }
    }
    let (computation, pattern) = pattern::split(model, layout.computation);
    computation::draw(model, theme, computation, buffer);
    pattern::draw(model, theme, pattern, buffer);
    status::draw(model, theme, &layout, buffer);
    match model.overlay {
        Some(Overlay::Help { top }) => help::draw(top, theme, buffer),
        Some(Overlay::List { kind, selected }) => list::draw(model, kind, selected, theme, buffer),
        None => {}
    }
}

/// Writes a line into the first row of an area, as far as it fits.
fn put(buffer: &mut Buffer, area: Rect, line: Line) {
    let area = area.intersection(buffer.area);
    if !area.is_empty() {
        // What was there leaves no style behind.
        let width = area.width.min(line.width() as u16);
        buffer.set_style(Rect { width, height: 1, ..area }, Style::reset());
        buffer.set_line(area.x, area.y, &line, area.width);
    }
}

/// Writes lines into an area, one a row, as far as they fit.
fn put_all(buffer: &mut Buffer, area: Rect, lines: impl IntoIterator<Item = Line<'static>>) {
    for (y, line) in (area.top()..area.bottom()).zip(lines) {
        put(buffer, Rect { y, height: 1, ..area }, line);
    }
}

/// The title above a pane: its name in a rule, with a mark when the keys move in it, and a remark at the right.
fn title(model: &Model, pane: Pane, name: String, remark: &str, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let faint = theme.style(Role::Faint);
    let rule = theme.glyphs.horizontal;
    put(buffer, area, Span::styled(rule.repeat(usize::from(area.width)), faint).into());
    let has_focus = model.focus == pane;
    let mark = if has_focus { theme.glyphs.current } else { rule };
    let style = if has_focus { theme.style(Role::Title) } else { faint };
    let heading = Line::from(vec![Span::styled(mark, style), Span::styled(format!(" {name} "), style)]);
    let used = heading.width() as u16;
    put(buffer, area, heading);
    let remark = Line::styled(format!(" {remark} "), faint);
    let width = remark.width() as u16;
    if remark.width() > 2 && used.saturating_add(width) < area.width {
        put(buffer, Rect { x: area.right() - width - 1, width, ..area }, remark);
    }
}

/// The title above a part of a pane: its name in a rule.
fn title_rule(name: &str, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let faint = theme.style(Role::Faint);
    let rule = theme.glyphs.horizontal;
    put(buffer, area, Span::styled(rule.repeat(usize::from(area.width)), faint).into());
    put(buffer, area, Span::styled(format!("{rule} {name} "), faint).into());
}

fn too_small(screen: Rect, buffer: &mut Buffer) {
    let words = ["too small:", "needs 20x6", "(q quits)"];
    put_all(buffer, screen, words.map(Line::from));
}
