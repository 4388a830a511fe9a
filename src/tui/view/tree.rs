//! The ray tree: one row a node, as far as nodes are open.

use super::{highlight, label};
use super::{put, title};
use crate::report::words;
use crate::tui::model::layout::Layout;
use crate::tui::model::{Model, Pane};
use crate::tui::run;
use crate::tui::text::{shown, width_of};
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};

pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let header = &model.log.header;
    let frame = words::frame(model.language, header).map_or(String::new(), |frame| format!(" {frame}"));
    let scene = format!("{}{frame}", words::plain(&header.scene.name));
    let remark = format!("{}/{}", model.cursor + 1, model.tree.nodes().len());
    // The mark, the rule's end and blanks are around them.
    let room = usize::from(area.width).saturating_sub(width_of(&remark) + 7);
    title(model, Pane::Tree, shown(&name(model, &scene, room), theme), &remark, theme, area, buffer);

    let body = Layout::body(area);
    let top = model.fold.scrolled(&model.tree, model.top, model.cursor, usize::from(body.height));
    let rows = std::iter::successors(Some(top), |row| model.fold.below(&model.tree, *row));
    for (y, node) in (body.top()..body.bottom()).zip(rows) {
        let place = Rect { y, height: 1, ..body };
        let gutter = Rect { width: u16::from(run::has_gutter(model)), ..place };
        let beside = Rect { x: place.x + gutter.width, width: place.width - gutter.width.min(place.width), ..place };
        if !gutter.is_empty() && run::marks_node(model, node) {
            put(buffer, gutter, Span::styled(theme.glyphs.breakpoint, theme.style(Role::Blocked)).into());
        }
        put(buffer, beside, row(model, node, theme, usize::from(beside.width)));
        highlight::draw(model, place, buffer);
        if node == model.cursor {
            let mark = if model.focus == Pane::Tree { Modifier::REVERSED } else { Modifier::UNDERLINED };
            buffer.set_style(place.intersection(buffer.area), Style::reset().add_modifier(mark));
        }
    }
}

/// What is shown, in which arithmetic; as much of it as fits.
fn name(model: &Model, scene: &str, room: usize) -> String {
    let header = &model.log.header;
    let (subject, texts) = (words::subject(model.language, header), &model.texts().panes);
    let whole = (texts.what)(&subject, scene, model.log.events.len());
    let briefly = (texts.what_briefly)(&subject, scene);
    let names = [whole, (texts.program)(&briefly), briefly, (texts.program)(scene), scene.to_owned()];
    let mut names = names.map(|name| format!("{name} - {}", words::arithmetic(header))).into_iter();
    names.find(|name| width_of(name) <= room).unwrap_or_else(|| scene.to_owned())
}

fn row(model: &Model, node: usize, theme: &Theme, width: usize) -> Line<'static> {
    let glyphs = theme.glyphs;
    let fold = if model.fold.first_inside(&model.tree, node).is_none() {
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

/// The most columns that the lines of the tree take.
const DEEPEST: usize = 16;

/// The lines of the tree before a node: a trunk for each node around it that goes on below. Where the tree is deeper than
/// there is room for, its innermost levels are drawn, behind the level of the node and a sign that there are more.
fn guides(model: &Model, node: usize, theme: &Theme, room: usize) -> String {
    let glyphs = theme.glyphs;
    let room = room.min(DEEPEST);
    let level = model.tree.nodes()[node].level;
    let number = if level > room { format!("{level}{}", glyphs.more) } else { String::new() };
    let room = room.saturating_sub(width_of(&number));
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
    std::iter::once(number.as_str()).chain(guides.into_iter().rev()).collect()
}
