//! What is seen of the model: one file a pane. Drawing touches only what is on the screen, changes nothing, and never
//! panics, however small the screen is.

pub(super) mod code;
mod computation;
pub(super) mod help;
mod highlight;
mod label;
mod labels;
mod list;
mod message;
mod over_picture;
mod pattern;
mod picture;
mod schematic;
mod status;
mod table;
mod tree;
mod watch;

pub(super) use computation::item_at;
pub(super) use list::{entry_at, last_shift};
pub(super) use status::draw_line;
pub(super) use table::cut;

use super::model::{Model, Overlay, Pane};
use super::text::shown;
use super::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

/// Draws the whole screen.
pub fn draw(model: &Model, theme: &Theme, buffer: &mut Buffer) {
    let screen = buffer.area;
    let layout = model.layout((screen.width, screen.height));
    if layout.is_too_small {
        return too_small(model, theme, screen, buffer);
    }
    tree::draw(model, theme, layout.area(Pane::Tree), buffer);
    layout.dividers.iter().for_each(|divider| draw_divider(*divider, theme, buffer));
    let (computation, pattern) = pattern::split(model, layout.area(Pane::Computation));
    let (computation, watched) = watch::split(model, computation);
    watch::draw(model, theme, watched, buffer);
    computation::draw(model, theme, computation, buffer);
    pattern::draw(model, theme, pattern, buffer);
    picture::draw(model, theme, layout.area(Pane::Picture), buffer);
    schematic::draw(model, theme, layout.area(Pane::Schematic), buffer);
    code::draw(model, theme, layout.area(Pane::Code), buffer);
    status::draw(model, theme, layout.status, buffer);
    match model.overlay {
        Some(Overlay::Help { top }) => help::draw(model, top, theme, buffer),
        Some(Overlay::List { kind, selected, shift }) => list::draw(model, kind, (selected, shift), theme, buffer),
        None => {}
    }
    // What lies over the panes may reach down to the bottom line.
    message::draw(model, theme, layout.status, buffer);
    status::draw_prompt(model, theme, layout.status, buffer);
}

fn draw_divider(divider: Rect, theme: &Theme, buffer: &mut Buffer) {
    for y in divider.top()..divider.bottom() {
        let glyph = if y == divider.y { theme.glyphs.tee } else { theme.glyphs.vertical };
        put(buffer, Rect { y, height: 1, ..divider }, Span::styled(glyph, theme.style(Role::Faint)).into());
    }
}

/// Writes a line into the first row of an area, as far as it fits.
pub(super) fn put(buffer: &mut Buffer, area: Rect, line: Line) {
    let area = area.intersection(buffer.area);
    if !area.is_empty() {
        // What was there leaves no style behind.
        let width = area.width.min(line.width() as u16);
        buffer.set_style(Rect { width, height: 1, ..area }, Style::reset());
        buffer.set_line(area.x, area.y, &line, area.width);
    }
}

/// Writes lines into an area, one a row, as far as they fit.
pub(super) fn put_all(buffer: &mut Buffer, area: Rect, lines: impl IntoIterator<Item = Line<'static>>) {
    for (y, line) in (area.top()..area.bottom()).zip(lines) {
        put(buffer, Rect { y, height: 1, ..area }, line);
    }
}

/// Makes room for what lies over the panes.
pub(super) fn clear(area: Rect, buffer: &mut Buffer) {
    for position in area.intersection(buffer.area).positions() {
        if let Some(cell) = buffer.cell_mut(position) {
            cell.reset();
        }
    }
}

/// Makes the dots of a canvas ASCII: the library's plainest dot isn't.
fn only_ascii(area: Rect, buffer: &mut Buffer) {
    for place in area.positions() {
        if let Some(cell) = buffer.cell_mut(place).filter(|cell| cell.symbol() != " ") {
            cell.set_symbol(".");
        }
    }
}

/// An area without `rows` rows above and below, and without two columns at each side.
pub(super) fn inner(area: Rect, rows: u16) -> Rect {
    Rect {
        x: area.x.saturating_add(2),
        y: area.y.saturating_add(rows),
        width: area.width.saturating_sub(4),
        height: area.height.saturating_sub(2 * rows),
    }
}

/// A rule from side to side, in the first row of an area.
pub(super) fn draw_rule(theme: &Theme, area: Rect, buffer: &mut Buffer) {
    put(buffer, area, Line::styled(theme.glyphs.horizontal.repeat(usize::from(area.width)), theme.style(Role::Faint)));
}

/// The rules above and below, with the title and what the keys do.
pub(super) fn draw_frame(title: &str, hint: &str, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let faint = theme.style(Role::Faint);
    let bottom = Rect { y: area.bottom().saturating_sub(1), height: 1, ..area };
    draw_rule(theme, area, buffer);
    let title = table::cut(&shown(title, theme), 0, usize::from(inner(area, 0).width).saturating_sub(2), theme);
    put(buffer, inner(area, 0), Line::styled(format!(" {title} "), theme.style(Role::Title)));
    draw_rule(theme, bottom, buffer);
    put(buffer, inner(bottom, 0), Line::styled(format!(" {} ", shown(hint, theme)), faint));
}

/// The title above a pane: its name in a rule, with a mark when the keys move in it, and a remark at the right.
fn title(model: &Model, pane: Pane, name: String, remark: &str, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let faint = theme.style(Role::Faint);
    draw_rule(theme, area, buffer);
    let has_focus = model.focus == pane;
    let mark = if has_focus { theme.glyphs.current } else { theme.glyphs.horizontal };
    let style = if has_focus { theme.style(Role::Title) } else { faint };
    let name = table::cut(&name, 0, usize::from(area.width).saturating_sub(3), theme);
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
    draw_rule(theme, area, buffer);
    let name = format!("{} {name} ", theme.glyphs.horizontal);
    put(buffer, area, Span::styled(name, theme.style(Role::Faint)).into());
}

fn too_small(model: &Model, theme: &Theme, screen: Rect, buffer: &mut Buffer) {
    put_all(buffer, screen, model.texts().status.too_small.map(|words| Line::from(shown(words, theme))));
}
