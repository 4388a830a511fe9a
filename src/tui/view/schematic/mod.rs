//! The scene with rays in it, as in figures 4 to 8 of the source text, or the vectors at a hit, as in figure 15.
//!
//! The current ray is drawn over the others and has its letter; each kind has its colour and its letter: C from the
//! eye, R reflected, T transmitted, S to a light.

mod stage;
mod vectors;

use super::labels::{CLOSE, Labels, Reach};
use super::{only_ascii, put, shown, title};
use crate::files::escape::shortened;
use crate::report::segments::{Segment, nearest};
use crate::tui::model::drawing::Wireframe;
use crate::tui::model::layout::Layout;
use crate::tui::model::schematic::{Drawn, Shown};
use crate::tui::model::{Model, Pane};
use crate::tui::text::width_of;
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::Marker;
use ratatui::text::Span;
use ratatui::widgets::Widget;
use ratatui::widgets::canvas::Canvas;
use stage::Stage;
use std::collections::HashSet;

/// The longest name of an object or a light, in characters.
const LONGEST: usize = 16;

/// The most objects that a place for their name is looked for.
const MOST_NAMES: usize = 60;

pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    if model.schematic.shown == Shown::Vectors {
        return vectors::draw(model, theme, area, buffer);
    }
    let texts = &model.texts().panes.schematic;
    let side = model.side();
    let shadows = if model.schematic.has_shadows { texts.with_shadows } else { "" };
    let name = format!("{}: {}{shadows}", side.title(model.language), texts.shown[model.schematic.shown as usize]);
    title(model, Pane::Schematic, shown(&name, theme), texts.turns, theme, area, buffer);
    let body = Layout::body(area);
    if body.height < 2 || body.width < 4 {
        return;
    }
    let drawn = model.drawn();
    let Some(stage) = Stage::of(model, side, &drawn, body) else {
        // A ray that hits nothing is drawn too; only a log that doesn't tell of any leaves nothing to draw.
        let why = if drawn.whole.is_empty() { texts.no_rays } else { texts.too_far };
        return put(buffer, body, Span::styled(shown(why, theme), theme.style(Role::Faint)).into());
    };
    let color = |role: Role| theme.style(role).fg.unwrap_or(Color::Reset);
    // Objects are grey: a canvas can't dim them.
    let gray = theme.line();
    Canvas::default()
        .marker(if theme.is_ascii() { Marker::Dot } else { Marker::Braille })
        .x_bounds(stage.x)
        .y_bounds(stage.y)
        .paint(|canvas| {
            if let Some(drawing) = &model.drawing {
                drawing.objects.iter().for_each(|wireframe| stage.draw_wireframe(canvas, wireframe, gray));
                canvas.layer();
                drawing.lights.iter().for_each(|wireframe| stage.draw_wireframe(canvas, wireframe, color(Role::Light)));
            }
            canvas.layer();
            let others = drawn.rays.iter().filter(|ray| drawn.current.is_none_or(|current| current.node != ray.node));
            others.for_each(|ray| stage.draw_ray(canvas, ray, color(theme.of_ray(ray.kind).1)));
            if let Some(ray) = &drawn.current {
                canvas.layer();
                stage.draw_ray(canvas, ray, Color::Reset);
            }
        })
        .render(body, buffer);
    if theme.is_ascii() {
        only_ascii(body, buffer);
    }
    let mut paper = Paper { theme, labels: Labels::new(body), buffer };
    label(model, &stage, &drawn, &mut paper);
}

/// Where texts are written.
struct Paper<'p> {
    theme: &'p Theme,
    labels: Labels,
    buffer: &'p mut Buffer,
}

impl Paper<'_> {
    /// Writes a text into the first of some cells that is free.
    fn write_at(&mut self, cells: &[[f64; 2]], text: &str, style: Style) {
        let text = shown(text, self.theme);
        let place = cells.iter().find_map(|cell| self.labels.at(*cell, width_of(&text)));
        self.write(place, text, style);
    }

    /// Writes a name near a cell, if there is room; says whether there was.
    fn write_near(&mut self, cell: [f64; 2], toward: [f64; 2], text: &str, style: Style, reach: Reach) -> bool {
        let text = shown(text, self.theme);
        let place = self.labels.near(cell, toward, width_of(&text), reach);
        self.write(place, text, style);
        place.is_some()
    }

    fn write(&mut self, place: Option<Rect>, text: String, style: Style) {
        if let Some(place) = place {
            put(self.buffer, place, Span::styled(text, style).into());
        }
    }
}

/// Letters and names, as far as they have room: the current ray first, what is named beside it last.
fn label(model: &Model, stage: &Stage, drawn: &Drawn, paper: &mut Paper) {
    let theme = paper.theme;
    let cells = |point: [f64; 3]| stage.project(point).and_then(|place| stage.cell_seen(place));
    let mark = |paper: &mut Paper, ray: &Segment, style: Style| {
        let text = if ray.is_blocked { theme.glyphs.blocked.to_owned() } else { ray.kind.letter().to_string() };
        paper.write_at(&stage.places_of_letter(ray), &text, style);
    };
    let style_of = |ray: &Segment| theme.style(theme.of_ray(ray.kind).1);
    if let Some(ray) = &drawn.current {
        mark(paper, ray, style_of(ray).add_modifier(Modifier::REVERSED | Modifier::BOLD));
    }
    for ray in drawn.rays.iter().chain(&drawn.current) {
        if let Some(ends) = stage.ray_on_screen(ray) {
            paper.labels.avoid_line(ends.map(|end| stage.cell(end)));
        }
    }
    let middle = |light: &Wireframe| light.lines.first().and_then(|line| cells(*line.first()?));
    if let Some(drawing) = &model.drawing {
        paper.write_at(&Vec::from_iter(cells(drawing.eye)), theme.glyphs.camera, theme.style(Role::Camera));
        for light in &drawing.lights {
            paper.write_at(&Vec::from_iter(middle(light)), theme.glyphs.light, theme.style(Role::Light));
        }
    }
    let others = drawn.rays.iter().filter(|ray| drawn.current.is_none_or(|current| current.node != ray.node));
    others.for_each(|ray| mark(paper, ray, style_of(ray)));
    let Some(drawing) = &model.drawing else { return name_hits(model, stage, drawn, paper) };
    for light in &drawing.lights {
        if let Some(cell) = middle(light) {
            paper.write_near(cell, [1.0, 0.0], &name_of(&light.name), theme.style(Role::Light), CLOSE);
        }
    }
    // What the rays hit is named first.
    let hit: Vec<_> = hits(model, drawn).map(|(_, object)| object as usize).collect();
    let others = (0..drawing.objects.len()).filter(|object| !hit.contains(object));
    let mut named = HashSet::new();
    for object in hit.iter().copied().chain(others).filter(|object| named.insert(*object)).take(MOST_NAMES) {
        if !hit.contains(&object) {
            // The others' names hide no outline.
            paper.labels.avoid_drawn(paper.buffer);
        }
        if let Some(object) = drawing.objects.get(object) {
            name_outline(object, stage, paper);
        }
    }
}

/// Writes an object's name at the top, the right, the left or the bottom of what is seen of its outline.
fn name_outline(object: &Wireframe, stage: &Stage, paper: &mut Paper) {
    let lines = object.lines.iter().flat_map(|line| line.windows(2));
    let seen: Vec<[f64; 2]> =
        lines.filter_map(|ends| stage.on_screen(ends[0], ends[1])).flatten().map(|place| stage.cell(place)).collect();
    // At the end of it in each of these directions.
    let most = |[x, y]: [f64; 2]| {
        let along = |place: &[f64; 2]| place[0] * x + place[1] * y;
        seen.iter().copied().max_by(|a, b| along(a).total_cmp(&along(b)))
    };
    let (name, style) = (name_of(&object.name), paper.theme.style(Role::Faint));
    for toward in [[0.0, -1.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0]] {
        if most(toward).is_some_and(|cell| paper.write_near(cell, toward, &name, style, CLOSE)) {
            break;
        }
    }
}

/// Without a scene nobody knows outlines: names are where the rays hit.
fn name_hits(model: &Model, stage: &Stage, drawn: &Drawn, paper: &mut Paper) {
    let mut named = HashSet::new();
    for (ray, object) in hits(model, drawn).take(MOST_NAMES) {
        let place = stage.project(ray.end(0.0)).and_then(|place| stage.cell_seen(place));
        if let Some(cell) = place.filter(|_| named.insert(object)) {
            let style = paper.theme.style(Role::Faint);
            paper.write_near(cell, [0.0, 1.0], &name_of(model.log.header.object(object)), style, CLOSE);
        }
    }
}

/// The rays of which one knows where they end, with what they hit there.
fn hits<'d>(model: &'d Model, drawn: &'d Drawn) -> impl Iterator<Item = (&'d Segment, u32)> {
    let known = drawn.rays.iter().filter(|ray| ray.length.is_some());
    known.filter_map(|ray| Some((ray, nearest(&model.log, &model.tree, ray.node)?)))
}

/// A name as it is shown: escaped, and of a long one its beginning.
fn name_of(name: &str) -> String {
    shortened(name, LONGEST)
}
