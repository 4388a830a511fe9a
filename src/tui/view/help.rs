//! The help: the table of keys, over everything else.

use super::{clear, draw_frame, inner, put_all};
use crate::report::language::viewer::Help;
use crate::report::words::plain;
use crate::tui::model::Model;
use crate::tui::model::prompt::{Prompt, Purpose};
use crate::tui::model::search::Pattern;
use crate::tui::text::{shown, width_of, wrap};
use crate::tui::theme::{Palette, Role, Theme};
use crate::tui::{command, keys};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};

/// Draws the help from line `top` on.
pub(super) fn draw(model: &Model, top: usize, theme: &Theme, buffer: &mut Buffer) {
    let (filter, texts) = (&filter(model), model.texts());
    let area = area(filter, model, (buffer.area.width, buffer.area.height)).intersection(buffer.area);
    clear(area, buffer);
    let is_whole = last(filter, model, (buffer.area.width, buffer.area.height)) == 0;
    let hint = if is_whole { texts.help.finds } else { texts.help.scrolls };
    draw_frame(texts.help.title, hint, theme, area, buffer);
    let body = inner(area, 1);
    put_all(buffer, body, lines(filter, model, usize::from(body.width), theme).into_iter().skip(top));
}

/// The largest `top` that has something to show for it.
pub fn last_top(model: &Model) -> usize {
    last(&filter(model), model, model.size)
}

fn last(filter: &Pattern, model: &Model, size: (u16, u16)) -> usize {
    let body = inner(area(filter, model, size), 1);
    let count = lines(filter, model, usize::from(body.width), &Theme::new(Palette::None, true)).len();
    count.saturating_sub(usize::from(body.height))
}

/// What the rows must contain: already while it is being typed.
fn filter(model: &Model) -> Pattern {
    match &model.prompt {
        Some(Prompt { purpose: Purpose::Help, line, .. }) => Pattern::of(line.value()),
        _ => Pattern::of(&model.guide.help),
    }
}

/// Where the help lies: in the middle, as large as it need be.
fn area(filter: &Pattern, model: &Model, (width, height): (u16, u16)) -> Rect {
    const WIDEST: u16 = 80;
    let wide = width.min(WIDEST);
    let count =
        lines(filter, model, usize::from(wide.saturating_sub(4)), &Theme::new(Palette::None, true)).len() as u16;
    let high = height.min(count.saturating_add(2));
    Rect { x: (width - wide) / 2, y: (height - high) / 2, width: wide, height: high }
}

/// The rows in which a key or the words for it match, under their headings.
fn lines(filter: &Pattern, model: &Model, width: usize, theme: &Theme) -> Vec<Line<'static>> {
    let texts = model.texts();
    let help = &texts.help;
    let bindings = &model.guide.bindings;
    let column = keys::rows().map(|row| width_of(&names(&keys::in_force(bindings, row), help))).max().unwrap_or(0) + 2;
    let mut lines = Vec::new();
    let mut group = None;
    for row in keys::rows() {
        let now = keys::in_force(bindings, row);
        let (keys, said, title) = (names(&now, help), (row.help)(&help.keys), (row.group)(&help.groups));
        if now.is_empty() || !(filter.is_in(&keys) || filter.is_in(said) || filter.is_in(title)) {
            continue;
        }
        if group.replace(title) != Some(title) {
            lines.push(Line::from(Span::styled(shown(title, theme), theme.style(Role::Title))));
        }
        let keys = format!("{keys:column$}");
        let pieces = [(keys, theme.style(Role::Camera)), (shown(said, theme), Style::new())];
        lines.extend(wrap(&pieces, width, column));
    }
    let own = bindings.lines().map(|(chord, line)| (plain(&chord.text()), plain(&format!(":{line}"))));
    let own = own.filter(|(key, line)| filter.is_in(key) || filter.is_in(line) || filter.is_in(help.groups.own));
    for (number, (key, line)) in own.enumerate() {
        if number == 0 {
            lines.push(Line::from(Span::styled(shown(help.groups.own, theme), theme.style(Role::Title))));
        }
        let pieces = [(format!("{key:column$}"), theme.style(Role::Camera)), (shown(&line, theme), Style::new())];
        lines.extend(wrap(&pieces, width, column));
    }
    let commands = (help.commands)(&command::usage(&texts.commands));
    for remark in [help.counts, &commands, help.other_language] {
        if filter.is_in(remark) {
            lines.extend(wrap(&[(shown(remark, theme), theme.style(Role::Faint))], width, 0));
        }
    }
    if lines.is_empty() {
        lines.push(Line::styled(shown(help.nothing, theme), theme.style(Role::Faint)));
    }
    lines
}

/// The keys of a row beside each other.
fn names(keys: &[String], help: &Help) -> String {
    let name = |key: &String| match key.strip_suffix(keys::ANY_LETTER) {
        Some(first) => format!("{first}+{}", help.letter),
        None => plain(key),
    };
    keys.iter().map(name).collect::<Vec<_>>().join(" ")
}
