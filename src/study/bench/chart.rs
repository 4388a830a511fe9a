//! Error against time as a picture: both axes logarithmic, one colour and one sign a method, the Pareto front as a line.

use super::samplers::{Comparison, Outcome};
use crate::report::escape::xml;
use std::fmt::Write;

/// The size of a panel, and of the area of the points in it, in the units of the picture.
const PANEL: [f64; 2] = [880.0, 460.0];
const AREA: [f64; 4] = [70.0, 40.0, 560.0, 400.0];

/// What is used in turn for the methods: colours that colour-blind people tell apart (Okabe and Ito), and signs.
const COLORS: [&str; 8] = ["#000000", "#E69F00", "#56B4E9", "#009E73", "#D55E00", "#0072B2", "#CC79A7", "#7F7F7F"];

/// A panel of the picture.
pub struct Panel<'a> {
    /// What is above it.
    pub title: String,
    /// What is shown.
    pub comparison: &'a Comparison,
}

/// A logarithmic axis between two powers of ten.
struct Axis {
    from: f64,
    to: f64,
    /// Where these are in the picture.
    ends: [f64; 2],
}

impl Axis {
    /// The axis on which all these values are, if they are positive.
    fn of(values: impl Iterator<Item = f64>, ends: [f64; 2]) -> Axis {
        let logs = values.filter(|value| *value > 0.0).map(libm::log10);
        let (least, greatest) = logs.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), log| (a.min(log), b.max(log)));
        let (from, to) = if least <= greatest { (least.floor(), greatest.ceil()) } else { (-1.0, 0.0) };
        Axis { from, to: to.max(from + 1.0), ends }
    }

    /// Where a value is; one that is not positive is at the beginning.
    fn place(&self, value: f64) -> f64 {
        let log = if value > 0.0 { libm::log10(value) } else { self.from };
        let part = ((log - self.from) / (self.to - self.from)).clamp(0.0, 1.0);
        self.ends[0] + part * (self.ends[1] - self.ends[0])
    }

    fn decades(&self) -> impl Iterator<Item = i32> + use<> {
        self.from as i32..=self.to as i32
    }
}

/// The picture, panel below panel, with a line about the machine below all.
pub fn svg(panels: &[Panel], machine: &str) -> String {
    let (width, height) = (PANEL[0], PANEL[1] * panels.len() as f64 + 24.0);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\" font-family=\"sans-serif\" font-size=\"12\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
    );
    for (number, panel) in panels.iter().enumerate() {
        let _ = writeln!(svg, "<g transform=\"translate(0 {})\">", number as f64 * PANEL[1]);
        draw(&mut svg, panel);
        svg.push_str("</g>\n");
    }
    text(&mut svg, [10.0, height - 10.0], " fill=\"#555555\"", &xml(machine));
    svg.push_str("</svg>\n");
    svg
}

fn draw(svg: &mut String, panel: &Panel) {
    let outcomes = &panel.comparison.outcomes;
    let [left, top, right, bottom] = AREA;
    let seconds = |spread: fn(&Outcome) -> [f64; 2]| outcomes.iter().flat_map(spread);
    let times = Axis::of(seconds(|outcome| [outcome.seconds.lower, outcome.seconds.upper]), [left, right]);
    let floor = panel.comparison.reference_error.into_iter();
    let errors = outcomes.iter().flat_map(|outcome| [outcome.rmse.lower, outcome.rmse.upper]).chain(floor);
    let errors = Axis::of(errors, [bottom, top]);
    text(svg, [left, 22.0], " font-size=\"14\"", &xml(&panel.title));
    draw_grid(svg, &times, &errors);
    draw_reference(svg, panel.comparison, &errors);
    draw_front(svg, outcomes, &times, &errors);
    let mut methods: Vec<&str> = Vec::new();
    for outcome in outcomes {
        let number = methods.iter().position(|method| *method == outcome.method).unwrap_or_else(|| {
            methods.push(outcome.method);
            methods.len() - 1
        });
        draw_point(svg, number, outcome, &times, &errors);
    }
    for (number, method) in methods.iter().enumerate() {
        let y = top + 10.0 + 20.0 * number as f64;
        svg.push_str(&sign(number, [right + 20.0, y], 4.5));
        text(svg, [right + 32.0, y + 4.0], "", &xml(method));
    }
}

/// The frame, a line for each power of ten, and what the axes are.
fn draw_grid(svg: &mut String, times: &Axis, errors: &Axis) {
    let [left, top, right, bottom] = AREA;
    for decade in times.decades() {
        let x = times.place(libm::exp10(decade.into()));
        path(svg, &format!("M{x:.1} {top}V{bottom}"), GRID);
        text(svg, [x, bottom + 16.0], MIDDLE, &power(decade));
    }
    for decade in errors.decades() {
        let y = errors.place(libm::exp10(decade.into()));
        path(svg, &format!("M{left} {y:.1}H{right}"), GRID);
        text(svg, [left - 6.0, y + 4.0], END, &power(decade));
    }
    text(svg, [(left + right) / 2.0, bottom + 34.0], MIDDLE, "seconds");
    let y = (top + bottom) / 2.0;
    let turned = format!("{MIDDLE} transform=\"rotate(-90 16 {y})\"");
    text(svg, [16.0, y], &turned, "root of the mean square error (white = 1)");
}

/// The error of the reference itself, below which points say nothing.
fn draw_reference(svg: &mut String, comparison: &Comparison, errors: &Axis) {
    let [left, _, right, _] = AREA;
    if let Some(error) = comparison.reference_error.filter(|error| *error > 0.0) {
        let y = errors.place(error);
        path(svg, &format!("M{left} {y:.1}H{right}"), "stroke=\"#999999\" stroke-dasharray=\"4 3\"");
        let about = format!("error of the reference, {}", xml(&comparison.reference));
        text(svg, [right - 4.0, y - 5.0], &format!("{END} fill=\"#666666\""), &about);
    }
}

fn draw_front(svg: &mut String, outcomes: &[Outcome], times: &Axis, errors: &Axis) {
    let mut front: Vec<_> = outcomes.iter().filter(|outcome| outcome.is_on_front).collect();
    front.sort_by(|one, other| one.seconds.median.total_cmp(&other.seconds.median));
    let place = |outcome: &&Outcome| {
        format!("{:.1},{:.1}", times.place(outcome.seconds.median), errors.place(outcome.rmse.median))
    };
    let places: Vec<_> = front.iter().map(place).collect();
    let _ = writeln!(svg, "<polyline points=\"{}\" fill=\"none\" stroke=\"#444444\"/>", places.join(" "));
    // Names beside the points would lie over each other: the points have numbers, and the names are below the methods.
    let [_, top, right, _] = AREA;
    for (number, outcome) in (1..).zip(front) {
        let at = [times.place(outcome.seconds.median) + 7.0, errors.place(outcome.rmse.median) - 5.0];
        text(svg, at, SMALL, &number.to_string());
        let below = [right + 14.0, top + 165.0 + 13.0 * f64::from(number)];
        text(svg, below, SMALL, &format!("{number} {}", xml(&outcome.sampling)));
    }
}

/// A point with its quartiles; its name is shown where the pointer rests.
fn draw_point(svg: &mut String, method: usize, outcome: &Outcome, times: &Axis, errors: &Axis) {
    let (time, error) = (outcome.seconds, outcome.rmse);
    let (x, y) = (times.place(time.median), errors.place(error.median));
    let color = COLORS[method % COLORS.len()];
    let name = xml(&outcome.sampling);
    let _ = writeln!(svg, "<g><title>{name}: {:.4} s, error {:.2e}</title>", time.median, error.median);
    let [left, right] = [time.lower, time.upper].map(|value| times.place(value));
    let [bottom, top] = [error.lower, error.upper].map(|value| errors.place(value));
    let ends = format!("M{left:.1} {y:.1}H{right:.1}M{x:.1} {bottom:.1}V{top:.1}");
    path(svg, &ends, &format!("stroke=\"{color}\""));
    svg.push_str(&sign(method, [x, y], if outcome.is_on_front { 6.0 } else { 3.5 }));
    svg.push_str("</g>\n");
}

/// A sign of half the given width: a disc, a square, a diamond or a triangle.
fn sign(number: usize, [x, y]: [f64; 2], half: f64) -> String {
    let color = COLORS[number % COLORS.len()];
    let shape = match number % 4 {
        0 => format!("M{:.1} {y:.1}a{half} {half} 0 1 0 {w} 0a{half} {half} 0 1 0 -{w} 0", x - half, w = 2.0 * half),
        1 => format!("M{:.1} {:.1}h{w}v{w}h-{w}z", x - half, y - half, w = 2.0 * half),
        2 => format!("M{x:.1} {:.1}l{half} {half}l-{half} {half}l-{half} -{half}z", y - half),
        _ => format!("M{x:.1} {:.1}l{half} {w}h-{w}z", y - half, w = 2.0 * half),
    };
    format!("<path d=\"{shape}\" fill=\"{color}\"/>\n")
}

/// Attributes of texts: around their place, up to it, and small.
const MIDDLE: &str = " text-anchor=\"middle\"";
const END: &str = " text-anchor=\"end\"";
const SMALL: &str = " font-size=\"9\"";

/// Those of a line of the grid.
const GRID: &str = "stroke=\"#dddddd\"";

/// A text that XML can have, at its place.
fn text(svg: &mut String, [x, y]: [f64; 2], attributes: &str, text: &str) {
    let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\"{attributes}>{text}</text>");
}

/// Lines.
fn path(svg: &mut String, places: &str, attributes: &str) {
    let _ = writeln!(svg, "<path d=\"{places}\" {attributes}/>");
}

fn power(decade: i32) -> String {
    format!("10<tspan dy=\"-5\" font-size=\"9\">{decade}</tspan>")
}
