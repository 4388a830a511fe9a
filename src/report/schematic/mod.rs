//! The rays of a pixel where they run, as in figures 2, 4, 6 and 15 of the source text: seen along the axis that they use least.
//!
//! One file a format; what is drawn where, and that no two labels lie on each other, is settled here. A log holds the rays; the
//! outlines of the objects come from whoever has the scene.

mod braille;
mod clip;
mod labels;
mod svg;
mod tikz;

pub use braille::braille;
pub use clip::clip;
pub use svg::svg_of;
pub use tikz::tikz;

use super::language::Language;
use super::segments::{Segment, around, nearest, reach, segments};
use super::words;
use crate::log::{Log, RayKind, Tree};
use labels::Labels;

/// Something in the scene.
#[derive(Clone, Debug)]
pub struct Wireframe {
    /// Its name.
    pub name: String,
    /// Its lines.
    pub lines: Vec<Vec<[f64; 3]>>,
}

/// What is known of the scene.
#[derive(Clone, Copy, Debug)]
pub struct Stage<'a> {
    /// The objects.
    pub wireframes: &'a [Wireframe],
    /// The axis of space that runs upward: 1, or 2 where it is z.
    pub upright: usize,
}

/// A place in the figure: from the left and from the top, in units of a hundredth of an inch or so.
pub type Point = [f64; 2];

/// What is drawn where.
#[derive(Clone, Debug)]
pub struct Plan {
    /// How wide and high it is.
    pub size: [f64; 2],
    /// Which axes of space run to the right and upward, such as `x` and `−z`.
    pub axes: [&'static str; 2],
    /// The outlines of objects; they may reach out of the figure.
    pub outlines: Vec<Vec<Point>>,
    /// The rays.
    pub rays: Vec<Ray>,
    /// Where they meet something.
    pub points: Vec<Point>,
    /// The lights that rays go to.
    pub lights: Vec<Point>,
    /// The eye.
    pub eye: Option<Point>,
    /// A text and where its middle is.
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
    pub from: Point,
    /// Where it ends, or the figure does.
    pub to: Point,
}

/// A text in the figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Its middle.
    pub at: Point,
    /// The text.
    pub text: String,
    /// The kind of ray that it belongs to, and whether that is blocked; none for names.
    pub ray: Option<(RayKind, bool)>,
}

impl Plan {
    fn is_inside(&self, place: Point) -> bool {
        (0..2).all(|axis| (0.0..=self.size[axis]).contains(&place[axis]))
    }
}

/// The most rays that are drawn: more can't be distinguished.
const MOST_RAYS: usize = 300;

/// The room for drawing, and around it.
const ROOM: [f64; 2] = [600.0, 420.0];
const MARGIN: f64 = 34.0;

/// How long rays to infinity are drawn, as a part of how far the others reach.
const FAR: f64 = 0.3;

/// The rays of a node; `None` if the log has none that can be drawn.
pub fn plan(log: &Log, tree: &Tree, node: usize, stage: Stage, language: Language) -> Option<Plan> {
    let wireframes = stage.wireframes;
    let rays = segments(log, tree, node, MOST_RAYS);
    let Seen { all: seen, rays: of_rays, far } = seen(&rays, wireframes)?;
    let spreads = [0, 1, 2].map(|axis| of_rays[1][axis] - of_rays[0][axis]);
    let dropped = (0..3).min_by(|a, b| spreads[*a].total_cmp(&spreads[*b]))?;
    let (axes, flat) = view(dropped, stage.upright);
    let corners = seen.map(flat);
    let [left, top] = [0, 1].map(|axis| corners[0][axis].min(corners[1][axis]));
    let [right, bottom] = [0, 1].map(|axis| corners[0][axis].max(corners[1][axis]));
    let scale = (ROOM[0] / (right - left)).min(ROOM[1] / (bottom - top));
    let scale = if scale.is_finite() && scale > 0.0 { scale } else { return None };
    let place = |point: [f64; 3]| {
        let [x, y] = flat(point);
        [(x - left) * scale + MARGIN, (y - top) * scale + MARGIN]
    };
    let drawn = |ray: &Segment| Ray {
        kind: ray.kind,
        is_blocked: ray.is_blocked,
        from: place(ray.from),
        to: place(ray.end(FAR * far)),
    };
    let outlines = wireframes.iter().flat_map(|wireframe| &wireframe.lines);
    let mut plan = Plan {
        size: [(right - left) * scale + 2.0 * MARGIN, (bottom - top) * scale + 2.0 * MARGIN],
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

/// From a point in space to its place on the page.
type Flat = fn([f64; 3]) -> Point;

/// Which axes of space run to the right and upward where one is left out, and the place of a point there, downward.
fn view(dropped: usize, upright: usize) -> ([&'static str; 2], Flat) {
    match (dropped, upright) {
        (0, 2) => (["y", "z"], |[_, y, z]| [y, -z]),
        (0, _) => (["z", "y"], |[_, y, z]| [z, -y]),
        (1, 2) => (["x", "z"], |[x, _, z]| [x, -z]),
        (1, _) => (["x", "−z"], |[x, _, z]| [x, z]),
        _ => (["x", "y"], |[x, y, _]| [x, -y]),
    }
}

/// What is seen.
struct Seen {
    /// A box around it.
    all: [[f64; 3]; 2],
    /// A box around what is seen of rays.
    rays: [[f64; 3]; 2],
    /// How far the rays reach.
    far: f64,
}

/// The first ray, and what lies not much farther from it than it is long. What
/// lies beyond would make all else small; rays there run out of the figure.
fn seen(rays: &[Segment], wireframes: &[Wireframe]) -> Option<Seen> {
    let first = rays.first()?;
    let ends = || rays.iter().flat_map(|ray| [ray.from, ray.end(0.0)]);
    let of_first = around([first.from, first.end(0.0)].into_iter());
    let long = Some(reach(&of_first)).filter(|long| *long > 0.0);
    let long = long.unwrap_or_else(|| Some(reach(&around(ends()))).filter(|long| *long > 0.0).unwrap_or(1.0));
    let is_near = |point: &[f64; 3], part: f64| {
        (0..3).all(|axis| (of_first[0][axis] - part * long..=of_first[1][axis] + part * long).contains(&point[axis]))
    };
    let near = ends().filter(|point| is_near(point, NEAR));
    // A figure without its lights says little.
    let lights = rays.iter().filter(|ray| matches!(ray.kind, RayKind::Shadow { .. }) && !ray.is_blocked);
    let lights = lights.map(|ray| ray.end(0.0)).filter(|point| is_near(point, NEAR_LIGHT));
    let met = around(near.chain(lights).chain(of_first));
    let far = reach(&met).max(long);
    let beyond = rays.iter().filter(|ray| ray.length.is_none()).map(|ray| ray.end(FAR * far));
    let of_rays = around(met.into_iter().chain(beyond.filter(|point| is_near(point, NEAR_LIGHT))));
    // What is near and small is seen whole.
    let points = |wireframe: &Wireframe| wireframe.lines.concat();
    let is_small = |points: &[[f64; 3]]| reach(&around(points.iter().copied())) <= SMALL * long;
    let whole = wireframes.iter().map(points).filter(|points| is_small(points));
    let whole = whole.filter(|points| points.iter().all(|point| is_near(point, NEAR))).flatten();
    let all = around(of_rays.into_iter().chain(whole));
    all.iter().flatten().all(|number| number.is_finite()).then_some(Seen { all, rays: of_rays, far })
}

/// How far from the first ray wireframes are seen, in parts of its length, and lights.
const NEAR: f64 = 1.0;
const NEAR_LIGHT: f64 = 4.0;

/// How large a wireframe may be to be seen whole.
const SMALL: f64 = 0.7;

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
        if !named.contains(&name) && plan.is_inside(dot) {
            labels.name(dot, &name);
            named.push(name);
        }
    }
    for ray in &plan.rays {
        labels.letter(ray);
    }
    plan.labels = labels.placed();
}
