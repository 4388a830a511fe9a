//! What is seen of two logs: their rows side by side, and the current one in full below.

use super::Beside;
use crate::report::diff::Row;
use crate::tui::text::{shown, wrap};
use crate::tui::theme::{Role, Theme};
use crate::tui::view::{clear, draw_rule, put, put_all};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};

/// How many rows the part below has: the computations of both, wrapped.
const EXPLANATION: u16 = 8;

/// How many rows of the table there are on a screen of this height, without the titles, the rule and the bottom line.
pub(super) fn rows_of_table(height: u16) -> usize {
    usize::from(height.saturating_sub(3 + explanation_height(height))).max(1)
}

/// The part below takes no more than a third of the screen.
fn explanation_height(height: u16) -> u16 {
    EXPLANATION.min(height / 3)
}

pub(super) fn draw(beside: &Beside, theme: &Theme, buffer: &mut Buffer) {
    let screen = buffer.area;
    clear(screen, buffer);
    let height = rows_of_table(screen.height);
    // Two columns between the halves hold the mark of what differs.
    let half = screen.width.saturating_sub(3) / 2;
    let left = Rect { width: half, height: 1, ..screen };
    let right = Rect { x: half + 3, ..left };
    for (area, title) in [(left, &beside.titles[0]), (right, &beside.titles[1])] {
        put(buffer, area, Span::styled(shown(title, theme), theme.style(Role::Title)).into());
    }
    let rows = beside.rows.rows();
    // The current row stays in the middle as far as there are rows around it.
    let top = beside.cursor.saturating_sub(height / 2).min(rows.len().saturating_sub(height));
    for (y, number) in (1..).zip(top..rows.len().min(top + height)) {
        let [left, right] = [left, right].map(|area| Rect { y, ..area });
        draw_row(beside, &rows[number], theme, [left, right], buffer);
        if number == beside.cursor {
            let whole = Rect { y, height: 1, ..screen };
            buffer.set_style(whole.intersection(buffer.area), Style::reset().add_modifier(Modifier::REVERSED));
        }
    }
    draw_below(beside, theme, Rect { y: height as u16 + 1, ..screen }, buffer);
}

fn draw_row(beside: &Beside, row: &Row, theme: &Theme, [left, right]: [Rect; 2], buffer: &mut Buffer) {
    let [a, b] = beside.rows.cells(row);
    let mark = match (row.differs, &a, &b) {
        (false, ..) => " ",
        (true, Some(_), None) => "<",
        (true, None, Some(_)) => ">",
        (true, ..) => theme.glyphs.differs,
    };
    let step = beside.rows.step(row);
    let (glyph, role) = step.map_or(("", Role::Text), |step| theme.of_step(Some(step)));
    let style = if row.differs { theme.style(Role::Warning) } else { theme.style(role) };
    // Deep nodes stay in sight.
    let indent = " ".repeat((row.level.saturating_sub(1) * 2).min(usize::from(left.width) / 2));
    for (area, text) in [(left, a), (right, b)] {
        let Some(text) = text else { continue };
        let text = if glyph.is_empty() { text } else { format!("{glyph} {text}") };
        put(buffer, area, Line::from(vec![Span::raw(indent.clone()), Span::styled(shown(&text, theme), style)]));
    }
    let between = Rect { x: left.right() + 1, width: 1, ..left };
    put(buffer, between, Span::styled(mark, theme.style(Role::Warning)).into());
}

/// The rule, the current row in full, and the bottom line.
fn draw_below(beside: &Beside, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let faint = theme.style(Role::Faint);
    draw_rule(theme, Rect { height: 1, ..area }, buffer);
    let body = Rect { y: area.y + 1, height: explanation_height(buffer.area.height), ..area };
    let rows = beside.rows.rows();
    let lines = rows.get(beside.cursor).map_or_else(Vec::new, |row| beside.rows.explanation(row));
    let lines = lines
        .iter()
        .flat_map(|line| wrap(&[(shown(line, theme), theme.style(Role::Text))], usize::from(area.width), 4));
    put_all(buffer, body, lines);
    let bottom = Rect { y: buffer.area.bottom().saturating_sub(1), height: 1, ..buffer.area };
    let before = beside.differing.partition_point(|row| *row < beside.cursor);
    let is_at_one = beside.differing.get(before) == Some(&beside.cursor);
    let which = if is_at_one { format!("{} of ", before + 1) } else { String::new() };
    let position = format!("row {}/{}  {which}{} differences", beside.cursor + 1, rows.len(), beside.differing.len());
    let used = position.chars().count() as u16;
    put(buffer, bottom, Span::styled(position, theme.style(Role::Title)).into());
    let hint = beside.message.unwrap_or("n next difference  N previous  j k move  q quit");
    let width = hint.len() as u16;
    if used + width + 2 <= bottom.width {
        let place = Rect { x: bottom.right() - width, width, ..bottom };
        put(buffer, place, Line::styled(hint, faint));
    }
}
