//! The rays of a log as lines in space, for 3D viewers.

mod obj;
mod ply;

pub use obj::obj;
pub use ply::ply;

use super::ray_group::RayGroup;
use super::segments::{Segment, around, reach, segment};
use crate::log::{Log, Tree};

/// The rays of a log.
pub fn rays(log: &Log) -> Vec<Segment> {
    let tree = Tree::of(&log.events);
    (0..tree.nodes().len()).filter_map(|node| segment(log, &tree, node, usize::MAX)).collect()
}

/// The groups that have rays, in order.
fn grouped(rays: &[Segment]) -> impl Iterator<Item = (RayGroup, Vec<&Segment>)> {
    let is_of = |ray: &Segment, group| RayGroup::of(ray.kind, ray.is_blocked) == group;
    let of_group = move |group| (group, rays.iter().filter(|ray| is_of(ray, group)).collect::<Vec<_>>());
    RayGroup::ALL.into_iter().map(of_group).filter(|(_, rays)| !rays.is_empty())
}

/// What a group is called.
fn name(group: RayGroup) -> &'static str {
    if group == RayGroup::Blocked { "shadow_blocked" } else { group.word() }
}

/// How long rays to infinity are drawn: as far as the places of all others reach, along the axis where they reach most.
fn far(rays: &[Segment]) -> f64 {
    let places = rays.iter().flat_map(|ray| [ray.from, ray.end(0.0)]);
    Some(reach(&around(places))).filter(|far| *far > 0.0 && far.is_finite()).unwrap_or(1.0)
}

/// A number that reads back as it is.
fn number(x: f64) -> String {
    let is_plain = x == 0.0 || (1e-5..1e16).contains(&x.abs());
    if is_plain { format!("{x}") } else { format!("{x:e}") }
}
