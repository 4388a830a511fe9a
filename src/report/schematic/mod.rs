//! The rays of a pixel where they run, as in figures 2, 4, 6 and 15 of the source text: seen along the axis that they use least.
//!
//! One file a format; what is drawn where, and that no two labels lie on each other, is settled here. A log holds the rays; the
//! outlines of the objects come from whoever has the scene.

mod braille;
mod labels;
mod svg;
mod tikz;

pub use braille::braille;
pub use svg::svg_of;
pub use tikz::tikz;

use super::language::Language;
use super::segments::{Segment, segments};
use super::words;
use crate::log::{Decision, Log, RayKind, Tree, What};
use labels::Labels;

/// Something in the scene.
#[derive(Clone, Debug)]
pub struct Thing {
    /// Its name.
    pub name: String,
    /// Its lines.
    pub lines: Vec<Vec<[f64; 3]>>,
}

/// A place in the figure: from the left and from the top, in units of a hundredth of an inch or so.
pub type Place = [f64; 2];

/// What is drawn where.
#[derive(Clone, Debug)]
pub struct Plan {
    /// How wide and high it is.
    pub size: [f64; 2],
    /// Which axes of space run to the right and upward, such as `x` and `−z`.
    pub axes: [&'static str; 2],
    /// The outlines of objects; they may reach out of the figure.
    pub outlines: Vec<Vec<Place>>,
    /// The rays.
    pub rays: Vec<Ray>,
    /// Where they meet something.
    pub points: Vec<Place>,
    /// The lights that rays go to.
    pub lights: Vec<Place>,
    /// The eye.
    pub eye: Option<Place>,
    /// What stands where: the middle of a text.
    pub labels: Vec<Label>,
}

/// A ray in the figure.
#[derive(Clone, Debug)]
pub struct Ray {
    /// What it is for.
    pub kind: RayKind,
    /// Whether it is stopped on its way to a light.
    pub is_blocked: bool,
    /// Where it begins.
    pub from: Place,
    /// Where it ends, or the figure does.
    pub to: Place,
}

/// A text in the figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Its middle.
    pub at: Place,
    /// The text.
    pub text: String,
    /// The kind of ray that it belongs to, and whether that is blocked; none for names.
    pub ray: Option<(RayKind, bool)>,
}

/// The most rays that are drawn: more nobody tells apart.
const MOST_RAYS: usize = 300;

/// The room for drawing, and around it.
const ROOM: [f64; 2] = [600.0, 420.0];
const MARGIN: f64 = 34.0;

/// How long rays to infinity are drawn, as a part of how far the others reach.
const FAR: f64 = 0.3;

/// The rays of a node; `None` if the log has none that can be drawn.
pub fn plan(log: &Log, tree: &Tree, node: usize, things: &[Thing], language: Language) -> Option<Plan> {
    let rays = segments(log, tree, node, MOST_RAYS);
    let (far, dropped) = extent(&rays)?;
    let flat = |point: [f64; 3]| match dropped {
        0 => [point[1], -point[2]],
        1 => [point[0], point[2]],
        _ => [point[0], -point[1]],
    };
    let axes = [["y", "z"], ["x", "−z"], ["x", "y"]][dropped];
    let ends: Vec<_> = rays.iter().flat_map(|ray| [flat(ray.from), flat(ray.end(FAR * far))]).collect();
    let bounded = things.iter().filter(|thing| is_small(thing, far)).flat_map(|thing| thing.lines.concat());
    let around: Vec<_> = ends.iter().copied().chain(bounded.map(flat)).collect();
    let [left, top] = [0, 1].map(|axis| around.iter().map(|place| place[axis]).fold(f64::INFINITY, f64::min));
    let [right, bottom] = [0, 1].map(|axis| around.iter().map(|place| place[axis]).fold(f64::NEG_INFINITY, f64::max));
    let scale = (ROOM[0] / (right - left)).min(ROOM[1] / (bottom - top));
    let scale = if scale.is_finite() && scale > 0.0 { scale } else { return None };
    let place = |point: [f64; 3]| {
        let [x, y] = flat(point);
        [(x - left) * scale + MARGIN, (y - top) * scale + MARGIN]
    };
    let size = [(right - left) * scale + 2.0 * MARGIN, (bottom - top) * scale + 2.0 * MARGIN];
    let drawn = |ray: &Segment| Ray {
        kind: ray.kind,
        is_blocked: ray.is_blocked,
        from: place(ray.from),
        to: place(ray.end(FAR * far)),
    };
    let outlines = things.iter().flat_map(|thing| &thing.lines);
    let mut plan = Plan {
        size,
        axes,
        outlines: outlines.map(|line| line.iter().map(|point| place(*point)).collect()).collect(),
        rays: rays.iter().map(drawn).collect(),
        points: Vec::new(),
        lights: Vec::new(),
        eye: None,
        labels: Vec::new(),
    };
    label(&mut plan, log, tree, &rays, language);
    Some(plan)
}

/// How far the rays reach along the axis that they use most, and the axis that they use least.
fn extent(rays: &[Segment]) -> Option<(f64, usize)> {
    let ends = |far: f64| rays.iter().flat_map(move |ray| [ray.from, ray.end(ray.length.map_or(far, |_| 0.0))]);
    let spread = |far: f64, axis: usize| {
        let low = ends(far).map(|point| point[axis]).fold(f64::INFINITY, f64::min);
        ends(far).map(|point| point[axis]).fold(f64::NEG_INFINITY, f64::max) - low
    };
    let reach = |far: f64| (0..3).map(|axis| spread(far, axis)).fold(0.0, f64::max);
    // Rays that meet nothing say nothing of a scale: any will do.
    let far = Some(reach(0.0)).filter(|far| *far > 0.0).unwrap_or(1.0);
    let spreads = [0, 1, 2].map(|axis| spread(far * FAR, axis));
    let dropped = (0..3).min_by(|a, b| spreads[*a].total_cmp(&spreads[*b]))?;
    (!rays.is_empty() && spreads.iter().all(|spread| spread.is_finite())).then_some((far, dropped))
}

/// What isn't much larger than the rays' region is seen whole.
fn is_small(thing: &Thing, far: f64) -> bool {
    let points = || thing.lines.iter().flatten();
    (0..3).all(|axis| {
        let low = points().map(|point| point[axis]).fold(f64::INFINITY, f64::min);
        points().map(|point| point[axis]).fold(f64::NEG_INFINITY, f64::max) - low <= far
    })
}

/// Names of what is met, and the letters of the rays, as far as they have room.
fn label(plan: &mut Plan, log: &Log, tree: &Tree, rays: &[Segment], language: Language) {
    let header = &log.header;
    let mut labels = Labels::new(plan.size, &plan.rays);
    let mut named: Vec<String> = Vec::new();
    for (ray, drawn) in rays.iter().zip(&plan.rays) {
        let (dot, name) = match ray.kind {
            RayKind::Shadow { light } if !ray.is_blocked && ray.length.is_some() => {
                plan.lights.push(drawn.to);
                (drawn.to, words::plain(header.light(light)))
            }
            RayKind::Shadow { .. } => continue,
            _ => {
                if ray.kind == RayKind::Camera && plan.eye.is_none() {
                    plan.eye = Some(drawn.from);
                    labels.name(drawn.from, language.texts().figure.eye);
                }
                let Some(object) = nearest(log, tree, ray.node) else { continue };
                plan.points.push(drawn.to);
                (drawn.to, words::plain(header.object(object)))
            }
        };
        if !named.contains(&name) {
            labels.name(dot, &name);
            named.push(name);
        }
    }
    for ray in &plan.rays {
        labels.letter(ray);
    }
    plan.labels = labels.placed();
}

fn nearest(log: &Log, tree: &Tree, ray: usize) -> Option<u32> {
    tree.own_events(ray).find_map(|event| match log.events[event].what {
        What::Mark(Decision::Nearest { object }) => Some(object),
        _ => None,
    })
}
