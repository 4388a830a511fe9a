//! What of the plane is on the screen.

use crate::report::schematic::clip;
use crate::report::segments::{Segment, around, reach};
use crate::tui::model::Model;
use crate::tui::model::drawing::{Drawing, Projection, Wireframe, seen_part};
use crate::tui::model::schematic::Drawn;
use ratatui::layout::Rect;
use ratatui::style::Color;
use ratatui::widgets::canvas::{Context, Line};

pub(super) struct Stage<'m> {
    side: Projection,
    drawing: Option<&'m Drawing>,
    body: Rect,
    pub(super) x: [f64; 2],
    pub(super) y: [f64; 2],
    /// How long a ray to infinity is drawn.
    far: f64,
}

/// A line on the screen.
pub(super) type Ends = [[f64; 2]; 2];

impl<'m> Stage<'m> {
    /// The smallest rectangle around all rays that end, in the proportions of the screen; around the current ray's end when enlarged.
    pub(super) fn of(model: &'m Model, side: Projection, drawn: &Drawn, body: Rect) -> Option<Stage<'m>> {
        let (drawing, far) = (model.drawing.as_deref(), drawn.far);
        let mut points = Vec::new();
        for ray in &drawn.whole {
            points.push(ray.from);
            points.extend(ray.length.map(|_| ray.end(0.0)));
        }
        if reach(&around(points.iter().copied())) == 0.0 {
            points.extend(drawn.whole.iter().map(|ray| ray.end(far)));
        }
        // What isn't much larger than the rays' region is seen whole.
        for wireframe in drawing.map(|drawing| drawing.objects.as_slice()).unwrap_or_default() {
            let lines = wireframe.lines.concat();
            if reach(&around(lines.iter().copied())) <= far {
                points.extend(lines);
            }
        }
        let (mut x, mut y) = match (side, drawing) {
            (Projection::Camera, Some(drawing)) => {
                let [width, height] = drawing.size.map(f64::from);
                ([0.0, width], [-height, 0.0])
            }
            _ => around_all(points.iter().filter_map(|point| side.of(drawing, *point)))?,
        };
        if x[0] == x[1] && y[0] == y[1] {
            // All of it lies behind one point.
            (x, y) = ([x[0] - far, x[1] + far], [y[0] - far, y[1] + far]);
        }
        let magnification = model.schematic.magnification;
        if magnification > 0
            && let Some(middle) = drawn.current.and_then(|ray| side.of(drawing, ray.end(far)))
        {
            let part = 1.0 / f64::from(1_u32 << magnification);
            let half = [x, y].map(|[from, to]| (to - from) * part / 2.0);
            x = [middle[0] - half[0], middle[0] + half[0]];
            y = [middle[1] - half[1], middle[1] + half[1]];
        }
        // A character is twice as high as it is wide.
        let proportion = f64::from(body.width) / (2.0 * f64::from(body.height));
        let (width, height) = ((x[1] - x[0]).max(1e-300) * 1.1, (y[1] - y[0]).max(1e-300) * 1.1);
        let (width, height) = (width.max(height * proportion), height.max(width / proportion));
        let wide = |[from, to]: [f64; 2], size: f64| [(from + to - size) / 2.0, (from + to + size) / 2.0];
        let stage = Stage { side, drawing, body, x: wide(x, width), y: wide(y, height), far };
        let is_drawable = |[from, to]: [f64; 2]| from.is_finite() && to.is_finite() && from < to;
        (is_drawable(stage.x) && is_drawable(stage.y)).then_some(stage)
    }

    pub(super) fn project(&self, point: [f64; 3]) -> Option<[f64; 2]> {
        self.side.of(self.drawing, point)
    }

    /// The place on the screen, in columns and rows of the pane.
    pub(super) fn cell(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let column = (x - self.x[0]) / (self.x[1] - self.x[0]) * f64::from(self.body.width);
        let row = (self.y[1] - y) / (self.y[1] - self.y[0]) * f64::from(self.body.height);
        [column, row]
    }

    /// The same for a place that is on the screen.
    pub(super) fn cell_seen(&self, place: [f64; 2]) -> Option<[f64; 2]> {
        let [column, row] = self.cell(place);
        let is_inside =
            (0.0..f64::from(self.body.width)).contains(&column) && (0.0..f64::from(self.body.height)).contains(&row);
        is_inside.then_some([column, row])
    }

    pub(super) fn draw_wireframe(&self, canvas: &mut Context, wireframe: &Wireframe, color: Color) {
        for line in &wireframe.lines {
            line.windows(2).for_each(|ends| self.draw_line(canvas, ends[0], ends[1], color));
        }
    }

    pub(super) fn draw_ray(&self, canvas: &mut Context, ray: &Segment, color: Color) {
        self.draw_line(canvas, ray.from, ray.end(self.far), color);
    }

    fn draw_line(&self, canvas: &mut Context, from: [f64; 3], to: [f64; 3], color: Color) {
        if let Some([[x1, y1], [x2, y2]]) = self.on_screen(from, to) {
            canvas.draw(&Line { x1, y1, x2, y2, color });
        }
    }

    /// The part of a line that is on the screen.
    pub(super) fn on_screen(&self, from: [f64; 3], to: [f64; 3]) -> Option<Ends> {
        clip(seen_part(|point| self.project(point), from, to)?, self.x, self.y)
    }

    /// The part of a ray that is on the screen.
    pub(super) fn ray_on_screen(&self, ray: &Segment) -> Option<Ends> {
        self.on_screen(ray.from, ray.end(self.far))
    }

    /// Where a ray's letter may be: three quarters of the way first, where rays of one point have parted; where that is off the
    /// screen, in the middle of what is on it.
    pub(super) fn places_of_letter(&self, ray: &Segment) -> Vec<[f64; 2]> {
        let end = ray.end(self.far);
        let along = |part: f64| std::array::from_fn(|axis| ray.from[axis] * (1.0 - part) + end[axis] * part);
        let far_on = [0.75, 0.6, 0.85, 0.45].into_iter().filter_map(|part| self.project(along(part)));
        let middle = self.ray_on_screen(ray).map(|[begin, end]| [0, 1].map(|axis| (begin[axis] + end[axis]) / 2.0));
        far_on.chain(middle).filter_map(|place| self.cell_seen(place)).collect()
    }
}

/// The rectangle around these places.
fn around_all(places: impl Iterator<Item = [f64; 2]>) -> Option<([f64; 2], [f64; 2])> {
    places.fold(None, |around: Option<([f64; 2], [f64; 2])>, [x, y]| {
        let ([left, right], [low, high]) = around.unwrap_or(([x; 2], [y; 2]));
        Some(([left.min(x), right.max(x)], [low.min(y), high.max(y)]))
    })
}
