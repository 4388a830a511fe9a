//! What is seen of two logs: their rows side by side, and the current one in full below.

use super::Beside;
use crate::report::diff::Row;
use crate::report::language::Language;
use crate::report::words::plain;
use crate::tui::keys;
use crate::tui::text::{shown, width_of, wrap};
use crate::tui::theme::{Role, Theme};
use crate::tui::view::{clear, cut, draw_frame, draw_line, draw_rule, inner, put, put_all};
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
        let title = cut(&shown(title, theme), 0, usize::from(area.width), theme);
        put(buffer, area, Span::styled(title, theme.style(Role::Title)).into());
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
    if beside.has_help {
        draw_help(beside, theme, buffer);
    }
}

/// What is said where a key means nothing.
pub(super) const NO_KEY: &str = "no such key here; ? lists the keys";

/// What is said where nothing is looked for.
pub(super) const NO_SEARCH: &str = "nothing is searched; / begins";

/// What is said of a command that there isn't.
pub(super) const COMMANDS: &str = "expected a row, such as :12, or :help or :quit";

/// What is said where a search finds nothing.
pub(super) fn not_found(text: &str) -> String {
    format!("not found: {}", plain(text))
}

/// The keys, and what they do.
const KEYS: [(&str, &str); 10] = [
    ("n N", "to the next, previous difference"),
    ("j k", "a row down, up"),
    ("^d ^u PgDn PgUp", "half a page, a page"),
    ("g G", "to the first, last row; 12G to row 12"),
    ("/ ; ,", "find in both logs, next, previous"),
    ("< >", "scroll rows that are cut"),
    (":", "a command: :12 (a row), :help, :quit"),
    ("5j 3n", "a number repeats a key"),
    ("?", "these keys"),
    ("q Esc ^c", "quit"),
];

fn draw_help(beside: &Beside, theme: &Theme, buffer: &mut Buffer) {
    let screen = buffer.area;
    let (width, height) = (screen.width.min(62), screen.height.min(KEYS.len() as u16 + 2));
    let area = Rect { x: (screen.width - width) / 2, y: (screen.height - height) / 2, width, height };
    clear(area, buffer);
    draw_frame("Keys", "any key closes", theme, area, buffer);
    let body = inner(area, 1);
    let lines = KEYS.iter().map(|(keys, help)| {
        let keys = keys::hint(&beside.bindings, keys);
        let text = cut(&format!("{keys:<17}{help}"), 0, usize::from(body.width), theme);
        Line::styled(text, theme.style(Role::Text))
    });
    put_all(buffer, body, lines);
}

/// The columns by which the widest row that is shown can be scrolled at most.
pub(super) fn widest(beside: &Beside) -> usize {
    let rows = beside.rows.rows();
    let from = beside.cursor.saturating_sub(beside.height);
    let shown = rows.iter().skip(from).take(2 * beside.height);
    let cells = shown.flat_map(|row| beside.rows.cells(row)).flatten();
    cells.map(|cell| width_of(&cell)).max().unwrap_or(0)
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
        let room = usize::from(area.width).saturating_sub(indent.len());
        let text = cut(&shown(&text, theme), beside.shift, room, theme);
        put(buffer, area, Line::from(vec![Span::raw(indent.clone()), Span::styled(text, style)]));
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
    if let Some(prompt) = &beside.prompt {
        return draw_line(prompt, &Language::default().texts().viewer, theme, bottom, buffer);
    }
    let hints = [
        "n next difference  N previous  j k move  / find  ? keys  q quit",
        "n next  N previous  ? keys  q quit",
        "? keys",
    ];
    let count = beside.pending.count.map(|count| count.to_string());
    let said = beside.message.clone().or(count).map_or_else(|| hints.map(str::to_owned).to_vec(), |said| vec![said]);
    let room = usize::from(bottom.width).saturating_sub(usize::from(used) + 2);
    if let Some(hint) = said.into_iter().find(|hint| width_of(hint) <= room) {
        let width = width_of(&hint) as u16;
        let place = Rect { x: bottom.right() - width, width, ..bottom };
        put(buffer, place, Line::styled(shown(&hint, theme), faint));
    }
}
