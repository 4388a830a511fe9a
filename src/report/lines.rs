//! The rays of a log as lines in space, for 3D viewers.

mod obj;
mod ply;

pub use obj::obj;
pub use ply::ply;

use super::drawn::Drawn;
use super::segments::{Segment, segment};
use crate::log::{Log, Tree};

/// The name of a group of rays.
fn name(group: Drawn) -> &'static str {
    if group == Drawn::Blocked { "shadow_blocked" } else { group.word() }
}

/// Red, green and blue of a group.
fn color(group: Drawn) -> [u8; 3] {
    let number = u32::from_str_radix(group.hex(), 16).expect("colours are hexadecimal numbers");
    let [_, red, green, blue] = number.to_be_bytes();
    [red, green, blue]
}

/// The rays of a log.
pub fn rays(log: &Log) -> Vec<Segment> {
    let tree = Tree::of(&log.events);
    (0..tree.nodes().len()).filter_map(|node| segment(log, &tree, node, usize::MAX)).collect()
}

/// The groups that have rays, in order.
fn grouped(rays: &[Segment]) -> impl Iterator<Item = (Drawn, Vec<&Segment>)> {
    let of_group =
        |group| (group, rays.iter().filter(|ray| Drawn::of(ray.kind, ray.is_blocked) == group).collect::<Vec<_>>());
    Drawn::ALL.into_iter().map(of_group).filter(|(_, rays)| !rays.is_empty())
}

/// How long rays to infinity are drawn: as far as the places of all others reach, along the axis where they reach most.
fn far(rays: &[Segment]) -> f64 {
    let places = || rays.iter().flat_map(|ray| [ray.from, ray.end(0.0)]);
    let reach = |axis: usize| {
        let low = places().map(|place| place[axis]).fold(f64::INFINITY, f64::min);
        places().map(|place| place[axis]).fold(f64::NEG_INFINITY, f64::max) - low
    };
    Some((0..3).map(reach).fold(0.0, f64::max)).filter(|far| *far > 0.0 && far.is_finite()).unwrap_or(1.0)
}

/// A number that reads back as it is.
fn number(x: f64) -> String {
    let is_plain = x == 0.0 || (1e-5..1e16).contains(&x.abs());
    if is_plain { format!("{x}") } else { format!("{x:e}") }
}
