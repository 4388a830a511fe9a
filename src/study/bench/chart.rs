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
    let _ = writeln!(svg, "<text x=\"10\" y=\"{}\" fill=\"#555555\">{}</text>", height - 10.0, xml(machine));
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
    let _ = writeln!(svg, "<text x=\"{left}\" y=\"22\" font-size=\"14\">{}</text>", xml(&panel.title));
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
        let _ = writeln!(svg, "<text x=\"{}\" y=\"{}\">{}</text>", right + 32.0, y + 4.0, xml(method));
    }
}

/// The frame, a line for each power of ten, and what the axes are.
fn draw_grid(svg: &mut String, times: &Axis, errors: &Axis) {
    let [left, top, right, bottom] = AREA;
    for decade in times.decades() {
        let x = times.place(libm::exp10(decade.into()));
        let _ = writeln!(svg, "<path d=\"M{x:.1} {top}V{bottom}\" stroke=\"#dddddd\"/>");
        let _ =
            writeln!(svg, "<text x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{}</text>", bottom + 16.0, power(decade));
    }
    for decade in errors.decades() {
        let y = errors.place(libm::exp10(decade.into()));
        let _ = writeln!(svg, "<path d=\"M{left} {y:.1}H{right}\" stroke=\"#dddddd\"/>");
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{}</text>",
            left - 6.0,
            y + 4.0,
            power(decade)
        );
    }
    let (middle, below) = ((left + right) / 2.0, bottom + 34.0);
    let _ = writeln!(svg, "<text x=\"{middle}\" y=\"{below}\" text-anchor=\"middle\">seconds</text>");
    let turned = format!("rotate(-90 16 {0})", (top + bottom) / 2.0);
    let y = (top + bottom) / 2.0;
    let _ = writeln!(
        svg,
        "<text x=\"16\" y=\"{y}\" text-anchor=\"middle\" transform=\"{turned}\">root of the mean square error (white = 1)</text>"
    );
}

/// The error of the reference itself, below which points say nothing.
fn draw_reference(svg: &mut String, comparison: &Comparison, errors: &Axis) {
    let [left, _, right, _] = AREA;
    if let Some(error) = comparison.reference_error.filter(|error| *error > 0.0) {
        let y = errors.place(error);
        let _ = writeln!(svg, "<path d=\"M{left} {y:.1}H{right}\" stroke=\"#999999\" stroke-dasharray=\"4 3\"/>");
        let _ = writeln!(
            svg,
            "<text x=\"{}\" y=\"{:.1}\" text-anchor=\"end\" fill=\"#666666\">error of the reference, {}</text>",
            right - 4.0,
            y - 5.0,
            xml(&comparison.reference)
        );
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
        let [x, y] = [times.place(outcome.seconds.median) + 7.0, errors.place(outcome.rmse.median) - 5.0];
        let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"9\">{number}</text>");
        let (below, name) = (top + 165.0 + 13.0 * f64::from(number), xml(&outcome.sampling));
        let _ = writeln!(svg, "<text x=\"{}\" y=\"{below}\" font-size=\"9\">{number} {name}</text>", right + 14.0);
    }
}

/// A point with its quartiles; its name is shown where the pointer rests.
fn draw_point(svg: &mut String, method: usize, outcome: &Outcome, times: &Axis, errors: &Axis) {
    let (time, error) = (outcome.seconds, outcome.rmse);
    let (x, y) = (times.place(time.median), errors.place(error.median));
    let color = COLORS[method % COLORS.len()];
    let name = xml(&outcome.sampling);
    let _ = writeln!(svg, "<g><title>{name}: {:.4} s, error {:.2e}</title>", time.median, error.median);
    let _ = writeln!(
        svg,
        "<path d=\"M{:.1} {y:.1}H{:.1}M{x:.1} {:.1}V{:.1}\" stroke=\"{color}\"/>",
        times.place(time.lower),
        times.place(time.upper),
        errors.place(error.lower),
        errors.place(error.upper)
    );
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

fn power(decade: i32) -> String {
    format!("10<tspan dy=\"-5\" font-size=\"9\">{decade}</tspan>")
}
