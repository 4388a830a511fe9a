//! The scene with the rays of the pixel in it, as in figures 4 to 8 of the source text.
//!
//! The current ray is drawn over the others and has its letter at its end; each kind has its colour and its letter: C from the
//! eye, R reflected, T transmitted, S to a light.

use super::{only_ascii, put, shown, title};
use crate::log::Step;
use crate::report::schematic::clip;
use crate::report::segments::{Segment, around, reach, segment, segments};
use crate::tui::model::drawing::{Drawing, Projection, Wireframe};
use crate::tui::model::layout::Layout;
use crate::tui::model::{Model, Pane};
use crate::tui::theme::{Role, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::Marker;
use ratatui::text::Span;
use ratatui::widgets::Widget;
use ratatui::widgets::canvas::{Canvas, Context, Line};

/// The most rays that are drawn: more can't be distinguished.
const MOST_RAYS: usize = 400;

/// The parts of a line that are projected by themselves, so that one which passes the eye is drawn as far as it is seen.
const PARTS: u32 = 8;

pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let texts = &model.texts().panes.schematic;
    let name = shown(model.projection.title(model.language), theme);
    title(model, Pane::Schematic, name, texts.turns, theme, area, buffer);
    let body = Layout::body(area);
    if body.height < 2 || body.width < 4 {
        return;
    }
    // Of a ray that is on its way, in the tree that grows or in a quiz, its end is to come.
    let last = model.told().unwrap_or(usize::MAX);
    let current = model.tree.around(model.cursor).find_map(|node| segment(&model.log, &model.tree, node, last));
    let mut rays = segments(&model.log, &model.tree, first_node(model), MOST_RAYS);
    let Some(stage) = Stage::of(model, &rays, current.as_ref(), body) else {
        // A ray that hits nothing is drawn too; only a log that doesn't tell of any leaves nothing to draw.
        let why = if rays.is_empty() { texts.no_rays } else { texts.too_far };
        return put(buffer, body, Span::styled(shown(why, theme), theme.style(Role::Faint)).into());
    };
    // Rays that are to come have their room already, so that nothing jumps.
    if last != usize::MAX {
        rays = rays.iter().filter_map(|ray| segment(&model.log, &model.tree, ray.node, last)).collect();
    }
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
            let others = rays.iter().filter(|ray| current.is_none_or(|current| current.node != ray.node));
            others.for_each(|ray| stage.draw_ray(canvas, ray, color(theme.of_ray(ray.kind).1)));
            if let Some(ray) = &current {
                canvas.layer();
                stage.draw_ray(canvas, ray, Color::Reset);
            }
        })
        .render(body, buffer);
    if theme.is_ascii() {
        only_ascii(body, buffer);
    }
    label(model, theme, &stage, &rays, current.as_ref(), body, buffer);
}

/// The node whose rays are drawn: the sample that the selected node is in, or else the whole pixel.
fn first_node(model: &Model) -> usize {
    let is_whole =
        |node: &usize| matches!(model.tree.nodes()[*node].step, None | Some(Step::Sample { .. } | Step::Pixel(_)));
    model.tree.around(model.cursor).find(is_whole).unwrap_or(0)
}

/// Names and letters, as far as they have room: the current ray last, over everything else.
fn label(
    model: &Model,
    theme: &Theme,
    stage: &Stage,
    rays: &[Segment],
    current: Option<&Segment>,
    body: Rect,
    buffer: &mut Buffer,
) {
    let mut write = |place: Option<[f64; 2]>, text: &str, style: Style| {
        if let Some((x, y)) = place.and_then(|place| stage.cell(place, body)) {
            let area = Rect { x, y, width: body.right() - x, height: 1 };
            put(buffer, area, Span::styled(shown(text, theme), style).into());
        }
    };
    if let Some(drawing) = &model.drawing {
        for wireframe in &drawing.lights {
            let middle = wireframe.lines.first().and_then(|line| stage.project(*line.first()?));
            write(middle, &format!("{}{}", theme.glyphs.light, wireframe.name), theme.style(Role::Light));
        }
        write(stage.project(drawing.eye), theme.glyphs.camera, theme.style(Role::Camera));
    }
    let mut mark = |ray: &Segment, style: Style| {
        let text = if ray.is_blocked { theme.glyphs.blocked.to_owned() } else { ray.kind.letter().to_string() };
        write(stage.place_of_letter(ray, body), &text, style);
    };
    rays.iter().for_each(|ray| mark(ray, theme.style(theme.of_ray(ray.kind).1)));
    if let Some(ray) = current {
        mark(ray, theme.style(theme.of_ray(ray.kind).1).add_modifier(Modifier::REVERSED | Modifier::BOLD));
    }
}

/// What of the plane is on the screen.
struct Stage<'m> {
    projection: Projection,
    drawing: Option<&'m Drawing>,
    x: [f64; 2],
    y: [f64; 2],
    /// How long a ray to infinity is drawn.
    far: f64,
}

impl<'m> Stage<'m> {
    /// The smallest rectangle around all rays that end, in the proportions of the screen; around the current ray's end when enlarged.
    fn of(model: &'m Model, rays: &[Segment], current: Option<&Segment>, body: Rect) -> Option<Stage<'m>> {
        let drawing = model.drawing.as_deref();
        let (projection, mut points) = (model.projection, Vec::new());
        for ray in rays {
            points.push(ray.from);
            points.extend(ray.length.map(|_| ray.end(0.0)));
        }
        let mut far = reach(&around(points.iter().copied()));
        if far == 0.0 {
            // Rays that hit nothing say nothing of a scale: any will do that numbers of this size can tell apart.
            far = points.iter().flatten().fold(1.0, |most: f64, number| most.max(number.abs()));
            points.extend(rays.iter().map(|ray| ray.end(far)));
        }
        // What isn't much larger than the rays' region is seen whole.
        for wireframe in drawing.map(|drawing| drawing.objects.as_slice()).unwrap_or_default() {
            let lines = wireframe.lines.concat();
            if reach(&around(lines.iter().copied())) <= far {
                points.extend(lines);
            }
        }
        let (mut x, mut y) = match (projection, drawing) {
            (Projection::Camera, Some(drawing)) => {
                let [width, height] = drawing.size.map(f64::from);
                ([0.0, width], [-height, 0.0])
            }
            _ => around_all(points.iter().filter_map(|point| projection.of(drawing, *point)))?,
        };
        if x[0] == x[1] && y[0] == y[1] {
            // All of it lies behind one point.
            (x, y) = ([x[0] - far, x[1] + far], [y[0] - far, y[1] + far]);
        }
        if model.magnification > 0
            && let Some(middle) = current.and_then(|ray| projection.of(drawing, ray.end(far)))
        {
            let part = 1.0 / f64::from(1_u32 << model.magnification);
            let half = [x, y].map(|[from, to]| (to - from) * part / 2.0);
            x = [middle[0] - half[0], middle[0] + half[0]];
            y = [middle[1] - half[1], middle[1] + half[1]];
        }
        // A character is twice as high as it is wide.
        let proportion = f64::from(body.width) / (2.0 * f64::from(body.height));
        let (width, height) = ((x[1] - x[0]).max(1e-300) * 1.1, (y[1] - y[0]).max(1e-300) * 1.1);
        let (width, height) = (width.max(height * proportion), height.max(width / proportion));
        let wide = |[from, to]: [f64; 2], size: f64| [(from + to - size) / 2.0, (from + to + size) / 2.0];
        let stage = Stage { projection, drawing, x: wide(x, width), y: wide(y, height), far };
        let is_drawable = |[from, to]: [f64; 2]| from.is_finite() && to.is_finite() && from < to;
        (is_drawable(stage.x) && is_drawable(stage.y)).then_some(stage)
    }

    fn project(&self, point: [f64; 3]) -> Option<[f64; 2]> {
        self.projection.of(self.drawing, point)
    }

    /// The character of a place.
    fn cell(&self, [x, y]: [f64; 2], body: Rect) -> Option<(u16, u16)> {
        let column = (x - self.x[0]) / (self.x[1] - self.x[0]) * f64::from(body.width);
        let row = (self.y[1] - y) / (self.y[1] - self.y[0]) * f64::from(body.height);
        let is_inside = (0.0..f64::from(body.width)).contains(&column) && (0.0..f64::from(body.height)).contains(&row);
        is_inside.then(|| (body.x + column as u16, body.y + row as u16))
    }

    fn draw_wireframe(&self, canvas: &mut Context, wireframe: &Wireframe, color: Color) {
        for line in &wireframe.lines {
            line.windows(2).for_each(|ends| self.draw_line(canvas, ends[0], ends[1], color));
        }
    }

    fn draw_ray(&self, canvas: &mut Context, ray: &Segment, color: Color) {
        self.draw_line(canvas, ray.from, ray.end(self.far), color);
    }

    fn draw_line(&self, canvas: &mut Context, from: [f64; 3], to: [f64; 3], color: Color) {
        for [[x1, y1], [x2, y2]] in self.parts(from, to) {
            canvas.draw(&Line { x1, y1, x2, y2, color });
        }
    }

    /// The parts of a line that can be seen from here, on the screen or not.
    fn parts(&self, from: [f64; 3], to: [f64; 3]) -> impl Iterator<Item = [[f64; 2]; 2]> {
        let count = if self.projection == Projection::Camera { PARTS } else { 1 };
        let at = move |part: u32| {
            let part = f64::from(part) / f64::from(count);
            self.project(std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * part))
        };
        (0..count).filter_map(move |part| Some([at(part)?, at(part + 1)?]))
    }

    /// Where a ray's letter is: three quarters of the way, where rays of one point have parted; where that is off the
    /// screen, in the middle of what is on it.
    fn place_of_letter(&self, ray: &Segment, body: Rect) -> Option<[f64; 2]> {
        let end = ray.end(self.far);
        let far_on = std::array::from_fn(|axis| ray.from[axis] * 0.25 + end[axis] * 0.75);
        self.project(far_on).filter(|place| self.cell(*place, body).is_some()).or_else(|| {
            let seen: Vec<_> = self.parts(ray.from, end).filter_map(|part| clip(part, self.x, self.y)).collect();
            let ([begin, _], [_, end]) = (*seen.first()?, *seen.last()?);
            Some([0, 1].map(|axis| (begin[axis] + end[axis]) / 2.0))
        })
    }
}

/// The rectangle around these places.
fn around_all(places: impl Iterator<Item = [f64; 2]>) -> Option<([f64; 2], [f64; 2])> {
    places.fold(None, |around: Option<([f64; 2], [f64; 2])>, [x, y]| {
        let ([left, right], [low, high]) = around.unwrap_or(([x; 2], [y; 2]));
        Some(([left.min(x), right.max(x)], [low.min(y), high.max(y)]))
    })
}
