//! A node in a few words: what it is, and what it came to.

use super::table::cut;
use crate::log::{Decision, Step, What};
use crate::report::words;
use crate::tui::model::Model;
use crate::tui::text::{Piece, counted, shown, width_of};
use crate::tui::theme::{Role, Theme};
use ratatui::style::Style;

/// A node in a row of its own, in this many columns: what it is, how many rays it hides when it is closed, what it came to, and its value at the
/// right end. Where not all of it fits words are left out before digits, with a mark; a value is there as a whole or not at all.
pub(super) fn row(model: &Model, node: usize, theme: &Theme, room: usize) -> Vec<Piece> {
    let whole = Parts::of(model, node, theme);
    let hidden = hidden_rays(model, node, theme);
    let short = Parts { title: short_title(model, node, theme), ..whole.clone() };
    let outcomes = short.outcomes.iter().map(|outcome| Outcome { words: String::new(), ..outcome.clone() }).collect();
    let signs = Parts { outcomes, ..short.clone() };
    let is_told_by_glyph = matches!(model.tree.nodes()[node].step, Some(Step::Shade { .. }));
    let title = if is_told_by_glyph { String::new() } else { short.title.clone() };
    let bare = Parts { title, outcomes: Vec::new(), ..short.clone() };
    let ways = [whole.left(hidden), whole.left(None), short.left(None), signs.left(None), bare.left(None)];
    let mark = || (format!(" {}", theme.glyphs.cut_right), theme.style(Role::Faint));
    let right = whole.value.as_ref().map_or(0, |(value, _)| 2 + width_of(value));
    // Without a value words are cut rather than left out.
    let most = if whole.value.is_none() { 3 } else { ways.len() };
    for (number, way) in ways.iter().enumerate().take(most) {
        let mark = (number > 0).then(mark);
        let mut pieces: Vec<Piece> = way.iter().cloned().chain(mark).collect();
        let used = width(&pieces) + right;
        if used <= room {
            pieces.extend(whole.value.map(|(value, style)| (format!("{}  {value}", " ".repeat(room - used)), style)));
            return pieces;
        }
    }
    if whole.value.is_none() {
        return cut_at(short.left(None), room, theme);
    }
    match ways.into_iter().find(|way| width(way) + 2 <= room) {
        Some(way) => way.into_iter().chain([mark()]).collect(),
        None => cut_at(bare.left(None), room, theme),
    }
}

/// As much of the pieces as fits, with a mark.
fn cut_at(pieces: Vec<Piece>, room: usize, theme: &Theme) -> Vec<Piece> {
    let mut left = room;
    let mut shown = Vec::new();
    for (text, style) in pieces {
        if width_of(&text) < left {
            left -= width_of(&text);
            shown.push((text, style));
        } else {
            shown.push((cut(&format!("{text}  "), 0, left, theme), style));
            break;
        }
    }
    shown
}

fn width(pieces: &[Piece]) -> usize {
    pieces.iter().map(|(text, _)| width_of(text)).sum()
}

/// A node inside of another one's computation: what it is, and what it came to.
pub(super) fn label(model: &Model, node: usize, theme: &Theme) -> Vec<Piece> {
    let parts = Parts::of(model, node, theme);
    let mut pieces = parts.left(None);
    pieces.extend(parts.value.map(|(value, style)| (format!("  {value}"), style)));
    pieces
}

/// What is said of a node.
#[derive(Clone)]
struct Parts {
    glyph: &'static str,
    title: String,
    style: Style,
    outcomes: Vec<Outcome>,
    value: Option<Piece>,
}

/// What a node came to: each state has a glyph and a word.
#[derive(Clone)]
struct Outcome {
    glyph: &'static str,
    words: String,
    style: Style,
}

impl Parts {
    fn of(model: &Model, node: usize, theme: &Theme) -> Parts {
        let step = model.tree.nodes()[node].step;
        let (glyph, role) = theme.of_step(step);
        let title = match step {
            Some(Step::Ray { kind, .. }) => {
                format!("{} {}", end_of_path(model, node), words::ray_kind(model.language, &model.log.header, kind))
            }
            _ => model.title(node),
        };
        let (outcomes, value) = came_to(model, node, theme);
        let title = shown(&title, theme);
        Parts { glyph, title, style: theme.style(role), outcomes, value }
    }

    /// All but the value.
    fn left(&self, hidden: Option<Piece>) -> Vec<Piece> {
        let name = [(format!("{} {}", self.glyph, self.title).trim_end().to_owned(), self.style)];
        let outcome =
            |Outcome { glyph, words, style }: &Outcome| (format!("  {glyph} {words}").trim_end().to_owned(), *style);
        name.into_iter().chain(hidden).chain(self.outcomes.iter().map(outcome)).collect()
    }
}

/// The title without the words that the glyph stands for.
fn short_title(model: &Model, node: usize, theme: &Theme) -> String {
    let header = &model.log.header;
    let title = match model.tree.nodes()[node].step {
        Some(Step::Ray { .. }) => end_of_path(model, node),
        Some(Step::Test { object, triangle: None } | Step::Shade { object } | Step::Motion { object }) => {
            words::plain(header.object(object))
        }
        Some(Step::Light { light, split: 0 }) => words::plain(header.light(light)),
        Some(Step::Combine) => String::new(),
        _ => model.title(node),
    };
    shown(&title, theme)
}

/// The path of a ray, its repetitions counted. Of a long one only the end: the nodes around it have the rest.
fn end_of_path(model: &Model, node: usize) -> String {
    const LONG: usize = 4;
    let path = counted(&model.tree.shown_path(node));
    match path.rmatch_indices(' ').nth(LONG - 1) {
        Some((end, _)) => format!("…{}", &path[end..]),
        None => path,
    }
}

/// How many rays a closed node hides.
fn hidden_rays(model: &Model, node: usize, theme: &Theme) -> Option<Piece> {
    let begun = model.tree.nodes()[node].subtree_end.min(model.fold.visible.end());
    let inside = node + 1..begun.max(node + 1);
    if model.fold.is_open(&model.tree, node) || inside.is_empty() {
        return None;
    }
    let count = Some(model.facts.rays(inside)).filter(|count| *count > 0)?;
    Some((format!("  [{}]", (model.texts().panes.hidden_rays)(count)), theme.style(Role::Faint)))
}

/// What a node came to, and its value.
fn came_to(model: &Model, node: usize, theme: &Theme) -> (Vec<Outcome>, Option<Piece>) {
    let step = model.tree.nodes()[node].step;
    if let Some(unknown) = unknown(model, node, theme) {
        return (unknown, None);
    }
    let decision_of = |event: Option<usize>| {
        event.filter(|event| model.guide.is_known(*event)).and_then(|event| model.log.events[event].decision())
    };
    let limit = model.facts.limit(node).filter(|event| !model.hides(*event));
    let is_lit = model.is_lit(node) && model.guide.is_known(model.tree.nodes()[node].events.end - 1);
    let decision = if is_lit { Some(Decision::Free) } else { decision_of(model.facts.outcome(node)) };
    let decided = [decision, decision_of(limit)].into_iter().flatten();
    let outcomes = decided.filter_map(|decision| outcome(model, &decision, theme)).collect();
    let has_value = !matches!(decision, Some(Decision::Miss { .. })) && !matches!(step, Some(Step::Light { .. }));
    (outcomes, has_value.then(|| value(model, node, step, theme)).flatten())
}

/// What is shown of a node whose decision a quiz hides, or may: a question where each such node decides, so that those that
/// don't have to say anything look the same.
fn unknown(model: &Model, node: usize, theme: &Theme) -> Option<Vec<Outcome>> {
    let step = model.tree.nodes()[node].step;
    // A free shadow ray and a light that isn't blocked decide nothing: their end shows it.
    let is_open = match model.facts.outcome(node) {
        Some(event) => model.hides(event),
        None => model.understanding.quiz.is_some() && model.tree.nodes()[node].events.end > model.event + 1,
    };
    let question = || vec![Outcome { glyph: "?", words: String::new(), style: theme.style(Role::Faint) }];
    match step {
        Some(Step::Ray { .. } | Step::Test { .. } | Step::Motion { .. }) if is_open => Some(question()),
        Some(Step::Light { .. } | Step::Zone { .. }) if is_open => Some(Vec::new()),
        _ => None,
    }
}

fn outcome(model: &Model, decision: &Decision, theme: &Theme) -> Option<Outcome> {
    let glyphs = theme.glyphs;
    let (glyph, role) = match decision {
        Decision::Hit | Decision::Nearest { .. } | Decision::Free => (glyphs.hit, Role::Hit),
        Decision::Miss { .. } | Decision::Background | Decision::Skipped { .. } => (glyphs.miss, Role::Faint),
        Decision::Attenuated { .. } => (glyphs.shade, Role::Light),
        _ => (glyphs.blocked, Role::Blocked),
    };
    Some(Outcome { glyph, words: shown(&model.outcome(decision)?, theme), style: theme.style(role) })
}

fn value(model: &Model, node: usize, step: Option<Step>, theme: &Theme) -> Option<Piece> {
    let event = model.facts.value(node).filter(|event| model.guide.is_known(*event))?;
    if model.hides(event) {
        return Some(("= ?".to_owned(), theme.style(Role::Faint)));
    }
    let text = match model.log.events[event].what {
        What::Note { name, value } => {
            let number = model.value(&value);
            // A test's value is the distance; all other nodes come to a colour.
            if matches!(step, Some(Step::Test { .. })) { format!("{} = {number}", name.symbol()) } else { number }
        }
        What::Result { color } => model.color(color),
        _ => return None,
    };
    Some((shown(&text, theme), theme.style(Role::Text)))
}
