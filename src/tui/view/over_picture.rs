//! The rays of the pixel over the picture, where the camera sees them. The picture's colour stays behind: only the characters change.

use super::labels::{FAR as FAR_OFF, Labels};
use super::only_ascii;
use crate::report::schematic::clip;
use crate::report::segments::Segment;
use crate::tui::model::Model;
use crate::tui::model::drawing::{Drawing, seen_part};
use crate::tui::model::picture::PictureView;
use crate::tui::model::schematic::Drawn;
use crate::tui::theme::{Background, Theme};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::Marker;
use ratatui::widgets::Widget;
use ratatui::widgets::canvas::{Canvas, Context, Line};

/// Behind a cell of the picture: its colour on the screen, and whether that is bright. `None` beyond the picture's edge.
pub(super) type Ground<'g> = &'g dyn Fn([u16; 2]) -> Option<(Color, bool)>;

/// How many times as far as the other rays reach one to infinity is drawn: nearly to the point where the camera sees it vanish.
const FAR: f64 = 1e4;

/// Draws the rays into the area of the picture itself.
pub(super) fn draw(model: &Model, view: &PictureView, theme: &Theme, dots: Rect, ground: Ground, buffer: &mut Buffer) {
    let Some(drawing) = model.drawing.as_deref().filter(|_| model.schematic.is_over_picture) else { return };
    let dots = dots.intersection(buffer.area);
    if dots.is_empty() {
        return;
    }
    let over = Over::new(view, drawing, model.drawn(), dots);
    // The canvas has a buffer of its own: there the picture isn't.
    let mut sheet = Buffer::empty(dots);
    Canvas::default()
        .marker(if theme.is_ascii() { Marker::Dot } else { Marker::Braille })
        .x_bounds([0.0, f64::from(2 * dots.width - 1)])
        .y_bounds([0.0, f64::from(4 * dots.height - 1)])
        .paint(|canvas| over.draw(canvas))
        .render(dots, &mut sheet);
    if theme.is_ascii() {
        only_ascii(dots, &mut sheet);
    }
    over.letter(theme, &mut sheet);
    for place in dots.positions() {
        let drawn = sheet.cell(place).filter(|cell| cell.symbol() != " ");
        let ground = ground([place.x - dots.x, place.y - dots.y]);
        let (Some(drawn), Some((behind, is_bright)), Some(cell)) = (drawn, ground, buffer.cell_mut(place)) else {
            continue;
        };
        cell.set_symbol(drawn.symbol()).set_style(over.style(drawn.fg, drawn.modifier, theme, behind, is_bright));
    }
}

/// The rays as the camera sees them.
struct Over {
    dots: Rect,
    /// Where the picture is: it may be narrower than its area.
    seen: Rect,
    /// The rays with the part of each that is on the screen, in columns and rows; the current one last.
    rays: Vec<(Segment, [[f64; 2]; 2])>,
    current: Option<usize>,
}

impl Over {
    fn new(view: &PictureView, drawing: &Drawing, drawn: Drawn, dots: Rect) -> Over {
        let (scale, start) = view.window([dots.width.into(), 2 * u32::from(dots.height)]);
        let [width, height] = view.image.size.map(f64::from);
        // Half a dot of the picture is a row.
        let cell = |place: [f64; 2]| [(place[0] - start[0]) / scale, (place[1] - start[1]) / scale / 2.0];
        let edges = [cell([0.0; 2]), cell([width, height])];
        let [x, y] = [(0, dots.width), (1, dots.height)]
            .map(|(axis, size)| [edges[0][axis].max(0.0), edges[1][axis].min(f64::from(size))]);
        let on_screen = |ray: &Segment| {
            let ends = seen_part(|point| (drawing.place_of)(point), ray.from, ray.end(FAR * drawn.far))?;
            clip(ends.map(cell), x, y).filter(|ends| ends.as_flattened().iter().all(|place| place.is_finite()))
        };
        let current = drawn.current.map(|ray| ray.node);
        let others = drawn.rays.iter().filter(|ray| Some(ray.node) != current);
        let rays = others.chain(&drawn.current).filter_map(|ray| Some((*ray, on_screen(ray)?))).collect();
        let [[left, right], [top, bottom]] = [x, y].map(|[from, to]| [from.floor() as u16, to.ceil() as u16]);
        let (left, top) = (left.min(dots.width), top.min(dots.height));
        let size = [right.saturating_sub(left), bottom.saturating_sub(top)];
        let seen = Rect { x: dots.x + left, y: dots.y + top, width: size[0], height: size[1] }.intersection(dots);
        Over { dots, seen, rays, current }
    }

    fn draw(&self, canvas: &mut Context) {
        let height = f64::from(self.dots.height);
        for (number, (_, ends)) in self.rays.iter().enumerate() {
            let [[x1, y1], [x2, y2]] = ends.map(|[column, row]| [2.0 * column - 0.5, 4.0 * (height - row) - 0.5]);
            // The last one lies over the others.
            if number + 1 == self.rays.len() {
                canvas.layer();
            }
            // What is written here as a colour is the number of the ray.
            canvas.draw(&Line { x1, y1, x2, y2, color: numbered(number) });
        }
    }

    /// Writes the letters of rays at their ends, the current one first.
    fn letter(&self, theme: &Theme, sheet: &mut Buffer) {
        let mut labels = Labels::new(self.seen);
        for (number, (ray, [from, to])) in self.rays.iter().enumerate().rev() {
            let text = if ray.is_blocked { theme.glyphs.blocked.to_owned() } else { ray.kind.letter().to_string() };
            // An end at the very edge belongs to the last cell.
            let left_and_top = [self.seen.x - self.dots.x, self.seen.y - self.dots.y].map(f64::from);
            let last = [self.seen.width, self.seen.height].map(|size| (f64::from(size) - 1.0).max(0.0));
            let inside = [0, 1].map(|axis| (to[axis] - left_and_top[axis]).clamp(0.0, last[axis]));
            let place =
                labels.at(inside, 1).or_else(|| labels.near(inside, [to[0] - from[0], to[1] - from[1]], 1, FAR_OFF));
            if let Some(cell) = place.and_then(|place| sheet.cell_mut(place.as_position())) {
                cell.set_symbol(&text).set_fg(numbered(number));
                cell.modifier = Modifier::BOLD;
                if Some(ray.node) == self.current {
                    cell.modifier |= Modifier::REVERSED;
                }
            }
        }
    }

    /// How a ray is drawn over a colour: bright on a dark one, dark on a bright one.
    fn style(&self, number: Color, modifier: Modifier, theme: &Theme, behind: Color, is_bright: bool) -> Style {
        let number = match number {
            Color::Rgb(high, middle, low) => u32::from_be_bytes([0, high, middle, low]) as usize,
            _ => 0,
        };
        let seen_on = if theme.has_few_colors() {
            *theme
        } else {
            theme.on(if is_bright { Background::Light } else { Background::Dark })
        };
        let kind = self.rays.get(number).map(|(ray, _)| seen_on.style(theme.of_ray(ray.kind).1));
        Style::reset().bg(behind).patch(kind.unwrap_or_default()).add_modifier(modifier)
    }
}

/// A number as a colour, as which it goes through the canvas.
fn numbered(number: usize) -> Color {
    let [_, high, middle, low] = (number as u32).to_be_bytes();
    Color::Rgb(high, middle, low)
}
