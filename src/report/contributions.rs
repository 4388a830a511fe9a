//! Why a pixel has its colour: what each light brings along each path, and what brings nothing and why.
//!
//! The colour is a sum over paths. Each path ends at a light, in the ambient light, or in the background; what it brings there is
//! multiplied by the weights W_l, W_r and W_t of the surfaces on its way to the eye, the share of its direction in a blurred
//! bounce, and that of its sample in the pixel. In f64 these products add up to the pixel's colour, up to rounding; what the
//! rounding of named values adds in other arithmetics is a row of its own, and so is what a log of another program leaves unexplained.

mod groups;
mod rays;
mod samples;
pub mod totals;

use super::path_class::{Source, cases, notation};
pub use groups::{Group, groups};

use crate::log::{Event, Log, Name, Step, Tree, Unit, What};

/// A colour, or a factor for each of its channels.
pub type Color = [f64; 3];

/// Where the light of a path comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Origin {
    /// A light, on a surface.
    Light {
        /// Its number.
        light: u32,
        /// The object that it shines on.
        object: u32,
    },
    /// Ambient light on a surface.
    Ambient {
        /// The object.
        object: u32,
    },
    /// The background.
    Background,
    /// The rounding of named values.
    Rounding,
    /// What the log doesn't explain: another program left operands out, or adds up otherwise.
    Unexplained,
}

/// What a path brings.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// Where its light comes from.
    pub origin: Origin,
    /// Its way from the eye, such as `C R S1`; without a shadow ray for what needs none.
    pub path: String,
    /// The same without the numbers of samples and splits, for the program.
    pub way: LightPath,
    /// The product of the weights on the way.
    pub weight: Color,
    /// What it brings to the way's end.
    pub own: Color,
    /// What it adds to the pixel.
    pub color: Color,
    /// Its part of the pixel's colour: that of its three channels' sum in the pixel's.
    pub share: f64,
    /// How its light is scattered on the way, such as `LDSE`.
    pub class: String,
    /// The ways of figure 14 that it goes.
    pub cases: &'static str,
    /// The event that says so; none for roundings.
    pub event: Option<usize>,
}

/// A way from the eye.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LightPath {
    /// The node of its last ray, of a light in full view that of the ray to the surface; the root for what comes along no ray.
    pub node: usize,
    /// The same for all ways of the same kinds of rays.
    pub number: u32,
    /// How often light bounces on it.
    pub bounces: usize,
}

/// A path that brings nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Ended {
    /// Its way from the eye.
    pub path: String,
    /// Why.
    pub why: Why,
    /// The event that says so.
    pub event: usize,
}

/// Why a path brings nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Why {
    /// A decision of the computation, in the event.
    Decided,
    /// A light is on the wrong side of the surface.
    LightBehind {
        /// The light.
        light: u32,
    },
    /// An object blocks a light.
    Blocked {
        /// The light.
        light: u32,
    },
    /// The log ends before the path does.
    LogEnds,
}

/// The colour of a pixel as a sum.
#[derive(Clone, Debug, PartialEq)]
pub struct Account {
    /// The colour; in a log that was cut off, what is known of it.
    pub color: Color,
    /// Whether the log has the colour.
    pub is_whole: bool,
    /// What adds to it, the greatest share first.
    pub contributions: Vec<Contribution>,
    /// What doesn't, in the order of the computation.
    pub ended: Vec<Ended>,
}

/// The account of the pixel (or ray) around a node.
pub fn account(log: &Log, tree: &Tree, node: usize) -> Account {
    let pixel = pixel_around(tree, node);
    let mut walk = rays::Walk::new(log, tree);
    for (ray, weight) in samples::camera_rays(log, tree, pixel) {
        walk.follow(ray, [weight; 3]);
    }
    let result = result(log, tree, pixel).map(|(color, _)| color);
    let (mut contributions, mut ended) = walk.finish(result);
    contributions.sort_by_key(|contribution| contribution.event);
    ended.sort_by_key(|ended| ended.event);
    let brought = sum(&contributions);
    let color = result.unwrap_or(brought);
    let rest = [0, 1, 2].map(|channel| color[channel] - brought[channel]);
    if let Some(origin) = origin_of_rest(log, tree, pixel, &rest, &color, &contributions) {
        contributions.push(Contribution::new(origin, Default::default(), [1.0; 3], rest, None, None));
    }
    let whole: f64 = color.iter().sum();
    for contribution in &mut contributions {
        let part: f64 = contribution.color.iter().sum();
        contribution.share = if whole == 0.0 { 0.0 } else { part / whole };
    }
    // Stable: equal ones stay in the order of the computation.
    contributions.sort_by(|a, b| b.share.abs().total_cmp(&a.share.abs()));
    Account { color, is_whole: result.is_some(), contributions, ended }
}

impl Contribution {
    fn new(
        origin: Origin,
        (path, way): (String, LightPath),
        weight: Color,
        own: Color,
        source: Option<Source>,
        event: Option<usize>,
    ) -> Contribution {
        let bounces = way.bounces;
        let color = times(&weight, &own);
        let class = source.map(|source| notation(source, bounces)).unwrap_or_default();
        let cases = source.map_or("", |source| cases(source, bounces));
        Contribution { origin, path, way, weight, own, color, share: 0.0, class, cases, event }
    }
}

/// The sum of what paths bring.
pub fn sum(contributions: &[Contribution]) -> Color {
    let add = |sum: Color, part: &Contribution| [0, 1, 2].map(|channel| sum[channel] + part.color[channel]);
    contributions.iter().fold([0.0; 3], add)
}

fn times(a: &Color, b: &Color) -> Color {
    [0, 1, 2].map(|channel| a[channel] * b[channel])
}

/// Where a rest comes from; `None` for what sums in f64 leave.
fn origin_of_rest(
    log: &Log,
    tree: &Tree,
    pixel: usize,
    rest: &Color,
    whole: &Color,
    contributions: &[Contribution],
) -> Option<Origin> {
    const NOISE: f64 = 1e-9;
    let largest = |color: &Color| color.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let (rest, whole) = (largest(rest), largest(whole));
    if !rest.is_finite() || rest <= NOISE * whole {
        return None;
    }
    // Each rounding of an intensity moves it by half a unit at most, and the weights on its way carry that on.
    let unit = match log.header.arithmetic.as_str() {
        // The book's own numbers follow from no rounding.
        "printed" => f64::INFINITY,
        "f32" => f64::from(f32::EPSILON) * whole,
        hand => hand
            .strip_prefix("decimal:")
            .and_then(|digits| digits.parse::<u32>().ok())
            .map_or(0.0, |digits| libm::pow(10.0, -f64::from(digits))),
    };
    let is_intensity = |event: &&Event| event.noted().is_some_and(|(name, _)| name.unit() == Unit::Intensity);
    let roundings = log.events[tree.nodes()[pixel].events.clone()].iter().filter(is_intensity).count() as f64;
    let weight = contributions.iter().fold(1.0, |weight: f64, part| weight.max(largest(&part.weight)));
    Some(if rest <= roundings * unit * weight { Origin::Rounding } else { Origin::Unexplained })
}

/// The event of a local model that notes its intensity, and which quantity it is by its formula.
pub(super) fn local(log: &Log, tree: &Tree, shade: usize) -> Option<(usize, Name)> {
    let noted = tree.own_events(shade).rev().filter_map(|event| Some((event, log.events[event].noted()?.0)));
    noted.into_iter().find(|(_, name)| name.key() == Name::ShadeLocal.key())
}

/// The colour of a pixel, and the event that says so.
pub fn result(log: &Log, tree: &Tree, pixel: usize) -> Option<(Color, usize)> {
    tree.own_events(pixel).rev().find_map(|event| match log.events[event].what {
        What::Result { color } => Some((color, event)),
        _ => None,
    })
}

/// The pixel that a node lies in: the root, but in a region.
pub fn pixel_around(tree: &Tree, node: usize) -> usize {
    let is_pixel = |at: &usize| matches!(tree.nodes()[*at].step, Some(Step::Pixel(_)));
    let at = tree.around(node).find(is_pixel).unwrap_or(0);
    // A region with nothing selected is that of its first pixel.
    Some(at).filter(|at| *at != 0).or_else(|| tree.children(0).next().filter(is_pixel)).unwrap_or(0)
}
