//! The help: the table of keys, over everything else.

use super::text::{width_of, wrap};
use super::{clear, inner, put, put_all};
use crate::tui::model::Model;
use crate::tui::prompt::{Prompt, Purpose};
use crate::tui::search::Pattern;
use crate::tui::theme::{Palette, Role, Theme};
use crate::tui::{command, keys};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

/// Draws the help from line `top` on.
pub(super) fn draw(model: &Model, top: u16, theme: &Theme, buffer: &mut Buffer) {
    let filter = &filter(model);
    let area = area(filter, (buffer.area.width, buffer.area.height)).intersection(buffer.area);
    clear(area, buffer);
    let faint = theme.style(Role::Faint);
    let rule = theme.glyphs.horizontal;
    put(buffer, area, Line::styled(rule.repeat(usize::from(area.width)), faint));
    put(buffer, inner(area, 0), Line::styled(" Keys ", theme.style(Role::Title)));
    let bottom = Rect { y: area.bottom().saturating_sub(1), height: 1, ..area };
    put(buffer, bottom, Line::styled(rule.repeat(usize::from(area.width)), faint));
    let is_whole = last(filter, (buffer.area.width, buffer.area.height)) == 0;
    let hint = if is_whole { " / finds, Esc closes " } else { " j k scroll, / finds, Esc closes " };
    put(buffer, inner(bottom, 0), Line::styled(hint, faint));
    let body = inner(area, 1);
    put_all(buffer, body, lines(filter, usize::from(body.width), theme).into_iter().skip(usize::from(top)));
}

/// The largest `top` that has something to show for it.
pub fn last_top(model: &Model) -> u16 {
    last(&filter(model), model.size)
}

fn last(filter: &Pattern, size: (u16, u16)) -> u16 {
    let body = inner(area(filter, size), 1);
    let count = lines(filter, usize::from(body.width), &Theme::new(Palette::None, true)).len();
    (count as u16).saturating_sub(body.height)
}

/// What the rows must contain: already while it is being typed.
fn filter(model: &Model) -> Pattern {
    match &model.prompt {
        Some(Prompt { purpose: Purpose::Help, line, .. }) => Pattern::of(line.value()),
        _ => Pattern::of(&model.guide.help),
    }
}

/// Where the help lies: in the middle, as large as it need be.
fn area(filter: &Pattern, (width, height): (u16, u16)) -> Rect {
    const WIDEST: u16 = 80;
    let wide = width.min(WIDEST);
    let count = lines(filter, usize::from(wide.saturating_sub(4)), &Theme::new(Palette::None, true)).len() as u16;
    let high = height.min(count.saturating_add(2));
    Rect { x: (width - wide) / 2, y: (height - high) / 2, width: wide, height: high }
}

/// The rows in which a key or the words for it match, under their headings.
fn lines(filter: &Pattern, width: usize, theme: &Theme) -> Vec<Line<'static>> {
    let names = |keys: &[&str]| keys.join(" ");
    let column = keys::rows().map(|row| width_of(&names(row.keys))).max().unwrap_or(0) + 2;
    let mut lines = Vec::new();
    let mut group = "";
    let is_asked =
        |row: &&keys::Row| filter.is_in(&names(row.keys)) || filter.is_in(row.help) || filter.is_in(row.group);
    for row in keys::rows().filter(is_asked) {
        if row.group != group {
            group = row.group;
            lines.push(Line::from(Span::styled(group, theme.style(Role::Title))));
        }
        let keys = format!("{:column$}", names(row.keys));
        lines.extend(wrap(&[(keys, theme.style(Role::Camera)), (row.help.to_owned(), Style::new())], width, column));
    }
    let commands = format!("Commands: {}.", command::usage());
    for remark in ["A number before a key repeats it: 5j, 10n.", &commands] {
        if filter.is_in(remark) {
            lines.extend(wrap(&[(remark.to_owned(), theme.style(Role::Faint))], width, 0));
        }
    }
    if lines.is_empty() {
        lines.push(Line::styled("no key does that", theme.style(Role::Faint)));
    }
    lines
}
