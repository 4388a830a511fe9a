//! A node in a few words: what it is, and what it came to.

use crate::log::{Decision, RayKind, Step, What};
use crate::report::words;
use crate::tui::model::Model;
use crate::tui::text::{Piece, counted, shown};
use crate::tui::theme::{Role, Theme};

/// A node in a row of its own: what it is, how much it hides when it is closed, and what it came to.
pub(super) fn row(model: &Model, node: usize, theme: &Theme) -> Vec<Piece> {
    let mut pieces = name(model, node, theme);
    pieces.extend(hidden_rays(model, node, theme));
    pieces.extend(outcome(model, node, theme));
    pieces
}

/// A node inside of another one's computation: what it is, and what it came to.
pub(super) fn label(model: &Model, node: usize, theme: &Theme) -> Vec<Piece> {
    let mut pieces = name(model, node, theme);
    pieces.extend(outcome(model, node, theme));
    pieces
}

/// A node's glyph, and what it is.
fn name(model: &Model, node: usize, theme: &Theme) -> Vec<Piece> {
    let step = model.tree.nodes()[node].step;
    let (glyph, role) = theme.of_step(step);
    let title = match step {
        Some(Step::Ray { kind, .. }) => {
            format!("{} {}", end_of_path(model, node), words::ray_kind(model.language, &model.log.header, kind))
        }
        _ => model.title(node),
    };
    let title = shown(&title, theme);
    vec![(format!("{glyph} "), theme.style(role)), (title, theme.style(role))]
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

/// What a node came to: each state has a glyph and a word.
fn outcome(model: &Model, node: usize, theme: &Theme) -> Vec<Piece> {
    let mut pieces = Vec::new();
    let step = model.tree.nodes()[node].step;
    let is_known = |event: &usize| model.guide.is_known(*event);
    let decision = model.facts.outcome(node).filter(is_known).and_then(|event| model.log.events[event].decision());
    if let Some(unknown) = unknown(model, node, theme) {
        return unknown;
    }
    let has_ended = model.log.events[model.tree.nodes()[node].events.clone()].last().map(|event| &event.what);
    let is_free_shadow = matches!(step, Some(Step::Ray { kind: RayKind::Shadow { .. }, .. }))
        && decision.is_none()
        && has_ended == Some(&What::Leave)
        && model.guide.is_known(model.tree.nodes()[node].events.end - 1);
    pieces.extend(if is_free_shadow { Some(lit(model, theme)) } else { decided(model, decision, theme) });
    pieces.extend(limited(model, node, theme));
    if !matches!(decision, Some(Decision::Miss { .. })) && !matches!(step, Some(Step::Light { .. })) {
        pieces.extend(value(model, node, step, theme));
    }
    pieces
}

/// What is shown of a node whose decision a quiz hides, or may: a question where each such node decides, so that those that
/// don't have to say anything look the same.
fn unknown(model: &Model, node: usize, theme: &Theme) -> Option<Vec<Piece>> {
    let step = model.tree.nodes()[node].step;
    // A free shadow ray and a light that isn't blocked decide nothing: their end shows it.
    let is_open = match model.facts.outcome(node) {
        Some(event) => model.hides(event),
        None => model.understanding.quiz.is_some() && model.tree.nodes()[node].events.end > model.event + 1,
    };
    let question = || vec![("  ?".to_owned(), theme.style(Role::Faint))];
    match step {
        Some(Step::Ray { .. } | Step::Test { .. } | Step::Motion { .. }) if is_open => Some(question()),
        Some(Step::Light { .. } | Step::Zone { .. }) if is_open => Some(Vec::new()),
        _ => None,
    }
}

/// What a shadow ray comes to that met nothing, which no decision says.
fn lit(model: &Model, theme: &Theme) -> Piece {
    (format!("  {} {}", theme.glyphs.hit, model.texts().panes.outcomes.lit), theme.style(Role::Hit))
}

fn decided(model: &Model, decision: Option<Decision>, theme: &Theme) -> Option<Piece> {
    let glyphs = theme.glyphs;
    let (header, texts) = (&model.log.header, &model.texts().panes.outcomes);
    let object = |object| words::plain(header.object(object));
    let (glyph, words, role) = match decision? {
        Decision::Hit => (glyphs.hit, texts.hit.to_owned(), Role::Hit),
        Decision::Miss { .. } => (glyphs.miss, texts.miss.to_owned(), Role::Faint),
        Decision::Nearest { object: nearest } => (glyphs.hit, object(nearest), Role::Hit),
        Decision::Background => (glyphs.miss, texts.background.to_owned(), Role::Faint),
        Decision::Occluded { object: blocker } => (glyphs.blocked, (texts.blocked_by)(&object(blocker)), Role::Blocked),
        Decision::Rejected { .. } => (glyphs.blocked, texts.rejected.to_owned(), Role::Blocked),
        Decision::Attenuated { object: filter, .. } => {
            (glyphs.shade, (texts.weakened_by)(&object(filter)), Role::Light)
        }
        _ => return None,
    };
    Some((format!("  {glyph} {}", shown(&words, theme)), theme.style(role)))
}

fn value(model: &Model, node: usize, step: Option<Step>, theme: &Theme) -> Option<Piece> {
    let event = model.facts.value(node).filter(|event| model.guide.is_known(*event))?;
    if model.hides(event) {
        return Some(("  = ?".to_owned(), theme.style(Role::Faint)));
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
    Some((format!("  {}", shown(&text, theme)), theme.style(Role::Text)))
}

fn limited(model: &Model, node: usize, theme: &Theme) -> Option<Piece> {
    let event = model.facts.limit(node).filter(|event| model.guide.is_known(*event) && !model.hides(*event))?;
    let What::Mark(decision) = model.log.events[event].what else { return None };
    let texts = &model.texts().panes.outcomes;
    let words = match decision {
        Decision::DepthLimit { .. } => texts.depth_limit,
        _ => texts.total_reflection,
    };
    Some((format!("  {} {}", theme.glyphs.blocked, shown(words, theme)), theme.style(Role::Blocked)))
}
