//! The bottom line: where one is, and the keys to begin with.

use super::put;
use crate::log::What;
use crate::report::language::viewer::Viewer;
use crate::report::tag::{is_left_out, tag};
use crate::tui::keys;
use crate::tui::model::prompt::Prompt;
use crate::tui::model::schematic::Shown;
use crate::tui::model::{Model, Pane};
use crate::tui::text::{counted, shown, width_of};
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};

pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let [step, _] = positions(model, theme);
    let room = usize::from(area.width).saturating_sub(width_of(&step));
    let places = places(model).map(|place| shown(&place, theme));
    let place = places.into_iter().find(|place| width_of(place) <= room).unwrap_or_default();
    let position = Line::from(vec![Span::styled(step, theme.style(Role::Title)), Span::raw(place)]);
    let used = position.width();
    put(buffer, area, position);

    let room = usize::from(area.width).saturating_sub(used + 2);
    let hint = shown(&hints(model, room), theme);
    let width = width_of(&hint);
    if width <= room {
        let place = Rect { x: area.right() - width as u16, width: width as u16, ..area };
        put(buffer, place, Line::styled(hint, theme.style(Role::Faint)));
    }
}

/// The step, with the modes that are on and without.
pub(super) fn positions(model: &Model, theme: &Theme) -> [String; 2] {
    let step = (model.texts().status.step)(model.step(), model.log.events.len());
    let score = model.score().map(|score| format!("  {score}")).unwrap_or_default();
    let modes: String = modes(model).iter().map(|mode| format!("  {mode}")).collect();
    [format!("{step}{score}{modes}"), step].map(|position| shown(&position, theme))
}

/// The modes that are on, in words for the bottom line.
fn modes(model: &Model) -> Vec<String> {
    let (guide, status) = (&model.guide, &model.texts().status);
    let search = guide.search.as_ref().map(|search| search.place(model.event, status));
    let modes = [
        guide.pace.is_playing.then(|| (status.playing)(guide.pace.rate())),
        guide.grown.map(|_| status.growing.to_owned()),
        search,
        guide.filter.as_ref().map(|_| status.filtered.to_owned()),
        guide.hides_tests.then(|| status.no_tests.to_owned()),
        guide.has_mouse.then(|| status.mouse.to_owned()),
    ];
    modes.into_iter().flatten().collect()
}

/// The line that is being typed, with its cursor; of a long one the part around the cursor.
pub(super) fn draw_prompt(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if let Some(prompt) = &model.prompt {
        draw_line(prompt, model.texts(), theme, area, buffer);
    }
}

/// Such a line.
pub(in crate::tui) fn draw_line(prompt: &Prompt, texts: &Viewer, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let blank = " ".repeat(usize::from(area.width));
    put(buffer, area, Line::raw(blank));
    let sign = &shown(prompt.purpose.sign(&texts.status), theme);
    let room = usize::from(area.width).saturating_sub(width_of(sign) + 1);
    let scrolled = prompt.line.visual_scroll(room);
    // Blank where the cursor is at the end.
    let text: Vec<char> = prompt.line.value().chars().chain([' ']).collect();
    let cursor = prompt.line.cursor();
    let part = |range: std::ops::Range<usize>| shown(&text[range].iter().collect::<String>(), theme);
    let cursor_style = Style::reset().add_modifier(Modifier::REVERSED);
    let line = Line::from(vec![
        Span::styled(sign.as_str(), theme.style(Role::Title)),
        Span::raw(part(scrolled.min(cursor)..cursor)),
        Span::styled(part(cursor..cursor + 1), cursor_style),
        Span::raw(part((cursor + 1).min(text.len())..text.len())),
    ]);
    put(buffer, area, line);
}

/// The path of the ray, and which quantity of the source text the current step computes; from the longest way to say it
/// to the shortest.
fn places(model: &Model) -> [String; 3] {
    let path = counted(&model.tree.shown_path(model.cursor));
    let path = if path.is_empty() { path } else { format!("  {path}") };
    match model.log.events.get(model.event).map(|event| &event.what) {
        Some(What::Note { name, .. }) => {
            let key = name.key();
            let status = &model.texts().status;
            let tag = tag(&model.log, &model.tree, model.event).map(|tag| (status.section)(&tag));
            let left_out = is_left_out(&model.log, &model.tree, model.event).then(|| status.left_out.to_owned());
            let source: String =
                tag.iter().chain(&left_out).zip(["  ", " "]).map(|(text, gap)| format!("{gap}{text}")).collect();
            [format!("{path}  {key}{source}"), format!("{path}  {key}"), format!("  {key}")]
        }
        _ => [path, String::new(), String::new()],
    }
}

/// What to say about keys: of those that are useful here as many as there is room for.
fn hints(model: &Model, room: usize) -> String {
    let pending = model.pending;
    if pending.count.is_some() || pending.prefix.is_some() {
        let count = pending.count.map(|count| count.to_string()).unwrap_or_default();
        return format!("{count}{}", pending.prefix.map(String::from).unwrap_or_default());
    }
    let hints = &model.texts().status.hints;
    let of_mode = [
        (model.guide.search.is_some(), hints.search),
        (model.guide.pace.is_playing, hints.playing),
        (model.understanding.quiz.is_some(), hints.quiz),
    ];
    let of_mode = of_mode.into_iter().filter(|(is_on, _)| *is_on).flat_map(|(_, hints)| hints);
    let of_pane = match model.focus {
        Pane::Tree => hints.tree,
        Pane::Computation => hints.computation,
        Pane::Picture => hints.picture,
        Pane::Schematic if model.schematic.shown == Shown::Vectors => hints.vectors,
        Pane::Schematic => hints.schematic,
        Pane::Code => hints.code,
    };
    let now = |hint: &&str| Some(keys::hint(&model.guide.bindings, hint)).filter(|hint| !hint.is_empty());
    let of_mode: Vec<_> = of_mode.filter_map(now).collect();
    let useful: Vec<_> = of_mode.iter().cloned().chain(of_pane.iter().filter_map(now)).collect();
    let ends: Vec<_> = [hints.help, hints.quit].iter().filter_map(now).collect();
    let lines = (1..=useful.len()).rev().map(|count| [&useful[..count], &ends[..]].concat());
    // What a mode has of its own is worth more than those.
    let brief = of_mode.first().map(|own| vec![own.clone()]);
    let mut lines = lines
        .chain(brief)
        .chain([ends.clone(), ends.first().cloned().into_iter().collect()])
        .map(|hints| hints.join(GAP));
    lines.find(|line| width_of(line) <= room).unwrap_or_default()
}

/// What is between two hints.
const GAP: &str = "  ";
