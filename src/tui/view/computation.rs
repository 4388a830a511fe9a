//! The computation of the selected node: its values with formulas and numbers put in, its decisions, its inputs.

use super::label::label;
use super::{highlight, pattern, watch};
use super::{put_all, title};
use crate::log::tree::Item;
use crate::log::{Decision, Event, What};
use crate::report::{self, path_class};
use crate::tui::model::layout::Layout;
use crate::tui::model::{Model, Pane};
use crate::tui::run;
use crate::tui::text::{Piece, shown, width_of, wrap};
use crate::tui::theme::{Palette, Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::text::{Line, Span};

pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let name = model.title(model.cursor);
    let is_ray = matches!(model.tree.nodes()[model.cursor].step, Some(crate::log::Step::Ray { .. }));
    // The class tells whether the ray hits anything.
    let is_told =
        model.facts.outcome(model.cursor).is_none_or(|event| !model.hides(event) && model.guide.is_known(event));
    let class = path_class::of_ray(&model.log, &model.tree, model.cursor).filter(|_| is_ray && is_told);
    let name = shown(&class.map_or(name.clone(), |class| format!("{name}, {class}")), theme);
    title(model, Pane::Computation, name, "", theme, area, buffer);
    let body = Layout::body(area);
    let lines = lines(model, theme, usize::from(body.width), usize::from(body.height));
    put_all(buffer, body, lines.into_iter().map(|(line, _)| line));
    highlight::draw(model, body, buffer);
}

/// What is shown at a place on the screen; `area` is that of the pane.
pub(in crate::tui) fn item_at(model: &Model, area: Rect, at: Position) -> Option<Item> {
    let body = Layout::body(watch::split(model, pattern::split(model, area).0).0);
    let theme = Theme::new(Palette::None, model.is_ascii);
    let lines = lines(model, &theme, usize::from(body.width), usize::from(body.height));
    let row = body.contains(at).then(|| usize::from(at.y - body.y))?;
    lines.get(row).map(|(_, item)| *item)
}

/// The lines to show with what they are about, so that the current step is among them.
fn lines(model: &Model, theme: &Theme, width: usize, height: usize) -> Vec<(Line<'static>, Item)> {
    let items = model.items();
    let has_gutter = run::has_gutter(model);
    let width = width.saturating_sub(2 + usize::from(has_gutter));
    let current = items.iter().position(|item| is_current(model, *item)).unwrap_or(0);
    // Every item has a line at least, so that no item further off can be on the screen.
    let first = current.saturating_sub(height);
    let mut lines = Vec::new();
    let (mut begin, mut mark, mut end) = (0, 0, 0);
    for (index, item) in items.iter().enumerate().skip(first).take(2 * height + 1) {
        let (block, marked) = block(model, *item, width, theme);
        if index == current {
            (begin, mark, end) = (lines.len(), lines.len() + marked, lines.len() + block.len());
        }
        lines.extend(block.into_iter().map(|line| (line, *item)));
    }
    // Beside the mark is a blank, or the gutter and a blank.
    let beside = if has_gutter { "" } else { " " };
    let at_mark = Span::styled(format!("{}{beside}", theme.glyphs.current), theme.style(Role::Current));
    let is_other = Span::styled(format!("{}{beside}", theme.glyphs.differs), theme.style(Role::Warning));
    let stops = Span::styled(theme.glyphs.breakpoint, theme.style(Role::Blocked));
    // A step of several lines has one mark: at its first line, or, if it is the current one, beside that of the step.
    let lines_of: Vec<_> = lines.iter().map(|(_, item)| *item).collect();
    let with_margin = |(number, (line, item)): (usize, (Line<'static>, Item))| {
        let own = match number == mark {
            true => at_mark.clone(),
            false if is_changed(model, item) => is_other.clone(),
            false => Span::raw(format!(" {beside}")),
        };
        let is_first =
            if (begin..end).contains(&number) { number == mark } else { number == 0 || lines_of[number - 1] != item };
        let stop = match has_gutter {
            true if is_first && is_stop(model, item) => Some(stops.clone()),
            true => Some(Span::raw(" ")),
            false => None,
        };
        let blank = has_gutter.then(|| Span::raw(" "));
        let margin = [Some(own), stop, blank].into_iter().flatten();
        (Line::from_iter(margin.chain(line.spans)), item)
    };
    let skipped = begin.saturating_sub(height / 3).min(lines.len().saturating_sub(height));
    // All of the step, or, if there is too much of it, the line with the mark.
    let skipped = skipped.max(end.saturating_sub(height)).min(mark);
    lines.into_iter().enumerate().map(with_margin).skip(skipped).take(height).collect()
}

/// Whether the last change of the scene has changed an item.
fn is_changed(model: &Model, item: Item) -> bool {
    match item {
        Item::Event(event) => model.changed.events.contains(&event),
        Item::Node(node) => model.changed.nodes.contains(&node),
    }
}

/// Whether a breakpoint stops at an item; at a node where it stops inside it.
fn is_stop(model: &Model, item: Item) -> bool {
    match item {
        Item::Event(event) => run::marks_event(model, event),
        Item::Node(node) => run::marks_inside(model, node),
    }
}

fn is_current(model: &Model, item: Item) -> bool {
    match item {
        Item::Event(event) => event == model.event,
        Item::Node(node) => model.tree.nodes()[node].events.contains(&model.event),
    }
}

/// The lines of an item, and which of them is the step itself: its inputs come before it.
fn block(model: &Model, item: Item, width: usize, theme: &Theme) -> (Vec<Line<'static>>, usize) {
    let event = match item {
        Item::Node(node) => return (wrap(&label(model, node, theme), width, 4), 0),
        Item::Event(event) => event,
    };
    let happening = &model.log.events[event];
    let inputs = (!model.hides_operands(event)).then(|| given(model, happening, theme)).flatten();
    let mut inputs = inputs.map(|pieces| wrap(&pieces, width, 6)).unwrap_or_default();
    let mut own = event_lines(model, event, theme, width);
    if matches!(happening.what, What::Enter { .. }) {
        own.append(&mut inputs);
        return (own, 0);
    }
    let marked = inputs.len();
    inputs.append(&mut own);
    (inputs, marked)
}

/// An event without its inputs.
fn event_lines(model: &Model, event: usize, theme: &Theme, width: usize) -> Vec<Line<'static>> {
    let (end, result) = (model.texts().panes.end, model.language.texts().result);
    let marker = report::digits::marker(model.language, &model.log, &model.tree, event);
    let pieces = match &model.log.events[event].what {
        What::Note { .. } => return note(model, event, theme, width),
        What::Enter { .. } => label(model, model.tree.owner(event), theme),
        What::Mark(_) if model.hides(event) => {
            vec![(format!("{} ?", theme.glyphs.leaf), theme.style(Role::Text))]
        }
        What::Mark(decision) => {
            let mut pieces = decision_pieces(model, decision, theme);
            let numbers = report::notation::line(model.language, &model.log, &model.tree, event, model.numbers);
            let faint = theme.style(Role::Faint);
            pieces.extend(numbers.map(|numbers| (format!("  {}", shown(&numbers, theme)), faint)));
            pieces.push((marker, theme.style(Role::Faint)));
            pieces
        }
        What::Leave => vec![(end.to_owned(), theme.style(Role::Faint))],
        What::Result { .. } if model.hides(event) => vec![(format!("{result}: ?"), theme.style(Role::Text))],
        What::Result { color } => vec![
            (format!("{result}: "), theme.style(Role::Text)),
            (shown(&model.color(*color), theme), theme.style(Role::Value)),
            (marker, theme.style(Role::Faint)),
        ],
    };
    wrap(&pieces, width, 4)
}

/// `symbol = formula = numbers put in = result`: in one line, or one below the other when that is too long.
fn note(model: &Model, event: usize, theme: &Theme, width: usize) -> Vec<Line<'static>> {
    let Some(computation) = report::computation(model.language, &model.log, &model.tree, event, model.numbers) else {
        return Vec::new();
    };
    let text = theme.style(Role::Text);
    let symbol = shown(&computation.symbol, theme);
    // Of a step that the quiz asks for later the numbers put in would tell the results before it.
    let substituted = computation.substituted.as_ref().filter(|_| !model.hides_operands(event));
    let middle = [computation.formula.as_ref(), substituted];
    let parts = middle.into_iter().flatten().map(|part| (shown(part, theme), text));
    let result = if model.hides(event) {
        "?".to_owned()
    } else {
        shown(&computation.result, theme) + &report::digits::marker(model.language, &model.log, &model.tree, event)
    };
    let parts: Vec<Piece> = parts.chain([(result, theme.style(Role::Value))]).collect();

    let one_line: usize = width_of(&symbol) + parts.iter().map(|(part, _)| 3 + width_of(part)).sum::<usize>();
    if one_line <= width {
        let mut spans = vec![Span::styled(symbol, text)];
        for (part, style) in parts {
            spans.extend([Span::styled(" = ", theme.style(Role::Faint)), Span::styled(part, style)]);
        }
        return vec![spans.into()];
    }
    let indent = width_of(&symbol).min(width / 4);
    let mut lines = Vec::new();
    for (number, (part, style)) in parts.into_iter().enumerate() {
        let before = if number == 0 { symbol.clone() } else { " ".repeat(indent) };
        lines.extend(wrap(
            &[(before, text), (" = ".to_owned(), theme.style(Role::Faint)), (part, style)],
            width,
            indent + 3,
        ));
    }
    lines
}

fn decision_pieces(model: &Model, decision: &Decision, theme: &Theme) -> Vec<Piece> {
    let glyphs = theme.glyphs;
    let (glyph, role) = match decision {
        Decision::Hit | Decision::Nearest { .. } | Decision::Free => (glyphs.hit, Role::Hit),
        Decision::Miss { .. } | Decision::Background => (glyphs.miss, Role::Text),
        Decision::Occluded { .. }
        | Decision::DepthLimit { .. }
        | Decision::TotalInternalReflection
        | Decision::LeakGuard { .. }
        | Decision::Rejected { .. } => (glyphs.blocked, Role::Blocked),
        Decision::Attenuated { .. } => (glyphs.shade, Role::Light),
        _ => (glyphs.leaf, Role::Text),
    };
    let words = model.decision(decision);
    vec![(format!("{glyph} {}", shown(&words, theme)), theme.style(role))]
}

/// The inputs of an event.
fn given(model: &Model, event: &Event, theme: &Theme) -> Option<Vec<Piece>> {
    let inputs = model.log.events.given(event);
    if inputs.is_empty() {
        return None;
    }
    let faint = theme.style(Role::Faint);
    let last = inputs.len() - 1;
    let mut pieces = vec![(format!("{} ", model.language.texts().given), faint)];
    for (index, (name, value)) in inputs.iter().enumerate() {
        let comma = if index == last { "" } else { ", " };
        let text = format!("{} = {}{comma}", name.symbol(), model.value(value));
        pieces.push((shown(&text, theme), faint));
    }
    Some(pieces)
}
