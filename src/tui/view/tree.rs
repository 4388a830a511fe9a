//! The ray tree: one row a node, as far as nodes are open.

use super::{highlight, label};
use super::{put, title};
use crate::report::words;
use crate::tui::model::fold::has_children;
use crate::tui::model::layout::Layout;
use crate::tui::model::{Model, Pane};
use crate::tui::text::shown;
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};

pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let header = &model.log.header;
    let frame = words::frame(model.language, header).map_or(String::new(), |frame| format!(" {frame}"));
    let name = format!("{}{frame} - {}", words::plain(&header.scene.name), words::arithmetic(header));
    let remark = format!("{}/{}", model.cursor + 1, model.tree.nodes().len());
    title(model, Pane::Tree, shown(&name, theme), &remark, theme, area, buffer);

    let body = Layout::body(area);
    let top = model.fold.scrolled(&model.tree, model.top, model.cursor, usize::from(body.height));
    let rows = std::iter::successors(Some(top), |row| model.fold.below(&model.tree, *row));
    for (y, node) in (body.top()..body.bottom()).zip(rows) {
        let place = Rect { y, height: 1, ..body };
        put(buffer, place, row(model, node, theme, usize::from(body.width)));
        highlight::draw(model, place, buffer);
        if node == model.cursor {
            let mark = if model.focus == Pane::Tree { Modifier::REVERSED } else { Modifier::UNDERLINED };
            buffer.set_style(place.intersection(buffer.area), Style::reset().add_modifier(mark));
        }
    }
}

fn row(model: &Model, node: usize, theme: &Theme, width: usize) -> Line<'static> {
    let glyphs = theme.glyphs;
    let fold = if !has_children(&model.tree, node) {
        glyphs.leaf
    } else if model.fold.is_open(&model.tree, node) {
        glyphs.open
    } else {
        glyphs.closed
    };
    let mut line = Line::from(Span::styled(guides(model, node, theme, width / 2), theme.style(Role::Faint)));
    line.push_span(Span::styled(fold, theme.style(Role::Faint)));
    if model.changed.nodes.contains(&node) {
        line.push_span(Span::styled(theme.glyphs.differs, theme.style(Role::Warning)));
    }
    let room = width.saturating_sub(line.width());
    for (text, style) in label::row(model, node, theme, room) {
        line.push_span(Span::styled(text, style));
    }
    line
}

/// The lines of the tree before a node: a trunk for each node around it that goes on below. Where the tree is deeper than
/// there is room for, its innermost levels are drawn, behind a sign that there are more.
fn guides(model: &Model, node: usize, theme: &Theme, room: usize) -> String {
    let glyphs = theme.glyphs;
    let mut guides = Vec::new();
    let mut at = node;
    while at != 0 && guides.len() < room {
        let goes_on = model.fold.next_sibling(&model.tree, at).is_some();
        guides.push(match (at == node, goes_on) {
            (true, true) => glyphs.branch,
            (true, false) => glyphs.last_branch,
            (false, true) => glyphs.trunk,
            (false, false) => " ",
        });
        at = model.tree.nodes()[at].parent;
    }
    if at != 0
        && let Some(outermost) = guides.last_mut()
    {
        *outermost = glyphs.more;
    }
    guides.into_iter().rev().collect()
}
