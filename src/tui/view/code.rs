//! The algorithm of the source text with the current line marked, and the calls that it is in (figure 9).

use super::{put_all, title, title_rule};
use crate::report::pseudocode::{current_line, lines, stack};
use crate::report::words;
use crate::tui::model::layout::Layout;
use crate::tui::model::{Model, Pane};
use crate::tui::text::{shown, wrap};
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

/// The most rows of the stack: its innermost calls.
const MOST_CALLS: usize = 8;

/// Draws the algorithm with a title, and the calls below it.
pub(in crate::tui) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let texts = &model.texts().panes;
    let calls = stack(model.language, &model.log, &model.tree, model.event);
    let rows = calls.len().min(MOST_CALLS).min(usize::from(area.height / 3)) as u16;
    let below = if rows == 0 { 0 } else { rows + 1 };
    let code = Rect { height: area.height - below, ..area };
    let name = shown(&(texts.algorithm)(&words::plain(&model.log.header.tracing.algorithm)), theme);
    title(model, Pane::Code, name, "", theme, code, buffer);
    let body = Layout::body(code);
    put_all(buffer, body, code_lines(model, theme, usize::from(body.width), usize::from(body.height)));
    if below == 0 {
        return;
    }
    let place = Rect { y: code.bottom(), height: below, ..area };
    title_rule(texts.calls, theme, place, buffer);
    let lines_of = lines(&model.log.header);
    let from = calls.len() - usize::from(rows);
    let shown_calls = calls.iter().enumerate().skip(from).map(|(level, call)| {
        let before = if level == from && from > 0 { theme.glyphs.more } else { "" };
        let indent = " ".repeat((level - from) * 2);
        Line::from(vec![
            Span::styled(shown(&format!("{indent}{before}{}", call.text), theme), theme.style(Role::Text)),
            Span::styled(
                shown(&format!("  {}", lines_of[call.line].text(model.language).trim()), theme),
                theme.style(Role::Faint),
            ),
        ])
    });
    put_all(buffer, Layout::body(place), shown_calls.collect::<Vec<_>>());
}

/// The lines around the current one, as many as there is room for.
fn code_lines(model: &Model, theme: &Theme, width: usize, height: usize) -> Vec<Line<'static>> {
    let current = current_line(&model.log, &model.tree, model.event);
    let mut drawn = Vec::new();
    let mut marked = 0;
    for (number, line) in lines(&model.log.header).iter().enumerate() {
        let is_current = number == current;
        let (mark, role) = if is_current { (theme.glyphs.current, Role::Current) } else { (" ", Role::Text) };
        let indent = usize::from(line.indent) * 2 + 2;
        let before = format!("{mark}{}", " ".repeat(indent - 1));
        if is_current {
            marked = drawn.len();
        }
        let pieces = [(before, theme.style(role)), (shown(line.text(model.language), theme), theme.style(role))];
        drawn.extend(wrap(&pieces, width, indent + 2));
    }
    let skipped = marked.saturating_sub(height / 2).min(drawn.len().saturating_sub(height));
    drawn.into_iter().skip(skipped).take(height).collect()
}
