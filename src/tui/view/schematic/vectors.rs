//! The vectors at the hit of the selected node as arrows, as in figure 15 of the source text. A dot is as wide as it is high, so that
//! angles are seen as they are.

use super::{Paper, name_of};
use crate::report::close_up::{Arrow, Bend, Ink, OnePlane, one_plane};
use crate::tui::model::layout::Layout;
use crate::tui::model::{Model, Pane};
use crate::tui::text::{counted, shown, width_of};
use crate::tui::theme::{Role, Theme};
use crate::tui::view::labels::{FAR, Labels};
use crate::tui::view::{only_ascii, put, title};
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::Marker;
use ratatui::text::Span;
use ratatui::widgets::Widget;
use ratatui::widgets::canvas::{Canvas, Context, Line};

/// The least room in which arrows can be told apart, in columns and rows.
const SMALLEST: (u16, u16) = (14, 5);

/// How far the surface reaches to each side, and the way to another point, in lengths of a unit vector.
const SURFACE: f64 = 1.15;
const WAY: f64 = 1.35;

/// The radius of a round surface: what it is is seen, how large it is isn't.
const RADIUS: f64 = 2.2;

/// A vector that is drawn shorter than this is said to point out of the plane.
const FORESHORTENED: f64 = 0.95;

pub(super) fn draw(model: &Model, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let texts = &model.texts().panes.schematic;
    let last = model.told().unwrap_or(usize::MAX);
    let plane = one_plane(&model.log, &model.tree, model.cursor, last);
    let name = match &plane {
        Some(plane) => (texts.vectors)(&plane.point, &counted(&model.tree.shown_path(plane.ray))),
        None => texts.shown[model.schematic.shown as usize].to_owned(),
    };
    title(model, Pane::Schematic, shown(&name, theme), "", theme, area, buffer);
    let body = Layout::body(area).intersection(buffer.area);
    let say = |buffer: &mut Buffer, area: Rect, text: &str| {
        put(buffer, area, Span::styled(shown(text, theme), theme.style(Role::Faint)).into());
    };
    // Whether there is a hit may be what a quiz asks for.
    let no_hit = model.hides_outcome().unwrap_or(texts.no_hit);
    let Some(plane) = plane else { return say(buffer, body, no_hit) };
    if body.width < SMALLEST.0 || body.height < SMALLEST.1 {
        return say(buffer, body, texts.too_small);
    }
    let is_short = |arrow: &Arrow| libm::hypot(arrow.tip[0], arrow.tip[1]) < FORESHORTENED;
    let below = Rect { y: body.bottom() - 1, height: 1, ..body };
    let is_noted = body.height > 2 * SMALLEST.1
        && plane.arrows.iter().any(is_short)
        && width_of(texts.out_of_plane) <= usize::from(body.width);
    let body = Rect { height: body.height - u16::from(is_noted), ..body };
    let Some(sheet) = Sheet::of(&plane, body) else { return say(buffer, body, texts.too_far) };
    if is_noted {
        say(buffer, below, texts.out_of_plane);
    }
    Canvas::default()
        .marker(if theme.is_ascii() { Marker::Dot } else { Marker::Braille })
        .x_bounds([0.0, f64::from(2 * body.width - 1)])
        .y_bounds([0.0, f64::from(4 * body.height - 1)])
        .paint(|canvas| sheet.draw(canvas, &plane, theme))
        .render(body, buffer);
    if theme.is_ascii() {
        only_ascii(body, buffer);
    }
    let mut labels = Labels::new(body);
    labels.avoid_drawn(buffer);
    let mut paper = Paper { theme, labels, buffer };
    sheet.label(model, &plane, &mut paper);
}

/// Where the plane lies on the screen, in dots from the left and from below.
struct Sheet {
    origin: [f64; 2],
    unit: f64,
    height: f64,
}

impl Sheet {
    /// As large as there is room, with a column of letters at the left and right and a row of them above and below.
    fn of(plane: &OnePlane, body: Rect) -> Option<Sheet> {
        let size = [2.0 * f64::from(body.width), 4.0 * f64::from(body.height)];
        let room = [size[0] - 13.0, size[1] - 9.0];
        let arrows = plane.arrows.iter().map(|arrow| arrow.tip);
        let ways = plane.ways.iter().map(|way| way.tip.map(|part| WAY * part));
        let ends = arrows.chain(ways).chain([[-SURFACE, 0.0], [SURFACE, 0.0], [0.0, -0.2]]);
        let [left, right, low, high] = ends.fold([0.0_f64; 4], |[left, right, low, high], [x, y]| {
            [left.min(x), right.max(x), low.min(y), high.max(y)]
        });
        let unit = (room[0] / (right - left)).min(room[1] / (high - low));
        let middle = [(left + right) / 2.0, (low + high) / 2.0];
        let origin = [0, 1].map(|axis| ((size[axis] - 1.0) / 2.0 - unit * middle[axis]).round());
        (unit.is_finite() && unit > 1.0).then_some(Sheet { origin, unit, height: size[1] })
    }

    fn dot(&self, place: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| self.origin[axis] + self.unit * place[axis])
    }

    /// The place in columns and rows.
    fn cell(&self, place: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.dot(place);
        [(x + 0.5) / 2.0, (self.height - 0.5 - y) / 4.0]
    }

    fn draw(&self, canvas: &mut Context, plane: &OnePlane, theme: &Theme) {
        let gray = theme.line();
        let outline = surface(plane.bend);
        outline.windows(2).for_each(|ends| self.line(canvas, ends[0], ends[1], gray));
        canvas.layer();
        for way in &plane.ways {
            self.dashes(canvas, way.tip.map(|part| WAY * part), color(theme, way.ink));
        }
        canvas.layer();
        // The normal, which has the terminal's own colour, lies over what else begins with it.
        for arrow in plane.arrows.iter().rev() {
            self.arrow(canvas, arrow.tip, color(theme, arrow.ink));
        }
    }

    fn line(&self, canvas: &mut Context, from: [f64; 2], to: [f64; 2], color: Color) {
        let ([x1, y1], [x2, y2]) = (self.dot(from), self.dot(to));
        canvas.draw(&Line { x1, y1, x2, y2, color });
    }

    /// A line of dashes from the origin.
    fn dashes(&self, canvas: &mut Context, to: [f64; 2], color: Color) {
        /// The dots of a dash and of the gap behind it.
        const DASH: f64 = 4.0;
        let count = (self.unit * libm::hypot(to[0], to[1]) / DASH).clamp(1.0, 400.0);
        let mut begin = 0.0;
        while begin < count {
            let [from, end] = [begin, (begin + 0.5).min(count)].map(|part| to.map(|axis| axis * part / count));
            self.line(canvas, from, end, color);
            begin += 1.0;
        }
    }

    /// A line from the origin with two short ones at its end.
    fn arrow(&self, canvas: &mut Context, tip: [f64; 2], color: Color) {
        /// The length of the short lines in dots, along the arrow and across.
        const BARB: [f64; 2] = [3.0, 1.6];
        const SMALL_BARB: [f64; 2] = [2.0, 1.0];
        self.line(canvas, [0.0; 2], tip, color);
        let length = libm::hypot(tip[0], tip[1]);
        let [back, beside] = if self.unit < 30.0 { SMALL_BARB } else { BARB };
        if length * self.unit < 3.0 * back {
            return;
        }
        let [x, y] = tip.map(|part| part / length / self.unit);
        for side in [beside, -beside] {
            let barb = [tip[0] - back * x - side * y, tip[1] - back * y + side * x];
            self.line(canvas, tip, barb, color);
        }
    }

    /// The letters at the ends of arrows, and the names of the points and of the object.
    fn label(&self, model: &Model, plane: &OnePlane, paper: &mut Paper) {
        let theme = paper.theme;
        // On the screen y grows downward.
        let outward = |[x, y]: [f64; 2]| [x, -y];
        let beyond = |tip: [f64; 2], dots: f64| {
            let length = libm::hypot(tip[0], tip[1]).max(f64::MIN_POSITIVE);
            tip.map(|part| part + part / length * dots / self.unit)
        };
        for arrow in &plane.arrows {
            let style = style(theme, arrow.ink).add_modifier(Modifier::BOLD);
            paper.write_near(self.cell(beyond(arrow.tip, 3.0)), outward(arrow.tip), &arrow.symbol, style, FAR);
        }
        for way in &plane.ways {
            let end = way.tip.map(|part| WAY * part);
            paper.write_near(self.cell(beyond(end, 3.0)), outward(way.tip), &way.symbol, style(theme, way.ink), FAR);
        }
        let has_ray_below = plane.arrows.iter().any(|arrow| arrow.tip[1] < -0.3);
        let below = if has_ray_below { [-1.0, 0.6] } else { [0.0, 1.0] };
        paper.write_near(self.cell([0.0, -0.08]), below, &plane.point, Style::new().add_modifier(Modifier::BOLD), FAR);
        if let Some(object) = plane.object {
            let (outline, name) = (surface(plane.bend), name_of(model.log.header.object(object)));
            for end in [outline.last(), outline.first()].into_iter().flatten() {
                let outward = [-end[0].signum(), 1.0];
                if paper.write_near(self.cell(*end), outward, &name, theme.style(Role::Faint), FAR) {
                    break;
                }
            }
        }
    }
}

/// The surface across the plane: a line, or an arc that touches it.
fn surface(bend: Bend) -> Vec<[f64; 2]> {
    const STEPS: i32 = 24;
    let down = match bend {
        Bend::Flat => return vec![[-SURFACE, 0.0], [SURFACE, 0.0]],
        Bend::Away => -1.0,
        Bend::Toward => 1.0,
    };
    let place = |step: i32| {
        let x = SURFACE * f64::from(step) / f64::from(STEPS);
        [x, down * (RADIUS - (RADIUS * RADIUS - x * x).sqrt())]
    };
    (-STEPS..=STEPS).map(place).collect()
}

fn color(theme: &Theme, ink: Ink) -> Color {
    style(theme, ink).fg.unwrap_or(Color::Reset)
}

/// How an arrow is written: as the rays of its kind in the other figures.
fn style(theme: &Theme, ink: Ink) -> Style {
    let role = match ink {
        Ink::Black => Role::Text,
        Ink::Gray => Role::Faint,
        Ink::Viewer => Role::Camera,
        Ink::Reflected => Role::Reflected,
        // H is the only vector that isn't one of a ray; it is seldom beside T.
        Ink::Transmitted | Ink::Half => Role::Transmitted,
        Ink::Light => Role::Light,
        Ink::Blocked => Role::Blocked,
    };
    theme.style(role)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::{Log, Name, Step, Tree, Value};
    use crate::record::Arithmetic;
    use crate::tui::testing::{log_of, reflecting};

    /// The dots of an arrow, from its beginning to its tip.
    fn dots(sheet: &Sheet, arrow: &Arrow) -> [f64; 2] {
        let tip = sheet.dot(arrow.tip).map(f64::round);
        [0, 1].map(|axis| tip[axis] - sheet.origin[axis])
    }

    fn arrow<'p>(plane: &'p OnePlane, symbol: &str) -> &'p Arrow {
        plane.arrows.iter().find(|arrow| arrow.symbol == symbol).expect("an arrow with this symbol")
    }

    fn plane(log: &Log, node: usize) -> (OnePlane, Sheet) {
        let plane = one_plane(log, &Tree::of(&log.events), node, usize::MAX).expect("a hit");
        let sheet = Sheet::of(&plane, Rect::new(0, 0, 60, 24)).expect("room for it");
        (plane, sheet)
    }

    /// The eye at (0, 3, 4) and the lamp at (0, −2, 2) see the wall z = 0 at the origin: all lies in one plane, V leans from the normal
    /// by atan(3/4), R by as much to the other side, and L by 45° to the side of R.
    #[test]
    fn angles_are_those_of_the_vectors_where_the_plane_holds_them() {
        let (plane, sheet) = plane(&reflecting(), 1);
        let from_normal = |symbol: &str| {
            let [x, y] = dots(&sheet, arrow(&plane, symbol));
            (libm::atan2(x, y).to_degrees(), (1.0 / libm::hypot(x, y)).to_degrees())
        };
        let lean = libm::atan2(3.0, 4.0).to_degrees();
        for (symbol, expected) in [("N", 0.0), ("V", -lean), ("R", lean), ("L", 45.0), ("H", (45.0 - lean) / 2.0)] {
            let (found, dot) = from_normal(symbol);
            assert!((found - expected).abs() < dot, "{symbol}: {found} instead of {expected}, a dot is {dot}");
        }
        assert_eq!(plane.ways.iter().map(|way| way.symbol.as_str()).collect::<Vec<_>>(), ["P₀"]);
    }

    /// The plane holds the normal, so that a vector reaches as high as its cosine: that of L is a quantity of the log.
    #[test]
    fn the_height_of_a_light_is_its_cosine() {
        let log = log_of("figure-6", Arithmetic::F64);
        let tree = Tree::of(&log.events);
        let lights =
            (0..tree.nodes().len()).filter(|node| matches!(tree.nodes()[*node].step, Some(Step::Light { .. })));
        let mut count = 0;
        for light in lights {
            let noted = tree.own_events(light).filter_map(|event| log.events[event].noted());
            let cosine = noted.filter(|(name, _)| name.is(Name::ShadeNDotL)).find_map(|(_, value)| match value {
                Value::Number(cosine) => Some(cosine),
                _ => None,
            });
            let Some(cosine) = cosine else { continue };
            let (plane, sheet) = plane(&log, light);
            let is_one = |arrow: &&Arrow| arrow.symbol.starts_with('L');
            let [toward] = plane.arrows.iter().filter(is_one).collect::<Vec<_>>()[..] else { panic!("{plane:?}") };
            assert!((toward.tip[1] - cosine).abs() < 1e-12, "{toward:?} and {cosine}");
            assert!((dots(&sheet, toward)[1] - sheet.unit * cosine).abs() <= 0.5, "{toward:?} and {cosine}");
            count += 1;
        }
        assert!(count >= 6, "{count} lights");
    }

    #[test]
    fn round_surfaces_touch_their_tangent() {
        for (bend, sign) in [(Bend::Away, -1.0), (Bend::Toward, 1.0), (Bend::Flat, 0.0)] {
            let outline = surface(bend);
            let [left, right] = [outline[0], outline[outline.len() - 1]];
            assert_eq!((left[0], right[0], left[1]), (-SURFACE, SURFACE, right[1]));
            assert!(left[1] * sign >= 0.0 && (left[1] == 0.0) == (sign == 0.0));
        }
        assert!(surface(Bend::Away).contains(&[0.0, -0.0]));
    }
}
