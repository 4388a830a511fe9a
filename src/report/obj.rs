//! The rays of a log as lines in space, for 3D viewers (Wavefront OBJ).

use super::escape::line;
use super::segments::{Segment, segment};
use crate::log::escape::visible;
use crate::log::{Header, Log, RayKind, Tree};
use std::fmt::Write;

/// The groups, in the order of the file.
const GROUPS: [&str; 5] = ["camera", "reflected", "transmitted", "shadow", "shadow_blocked"];

/// All rays of a log, grouped by kind; those that meet nothing have a length that the file states.
pub fn obj(log: &Log) -> String {
    obj_of(&log.header, &rays(log))
}

/// The rays of a log.
pub fn rays(log: &Log) -> Vec<Segment> {
    let tree = Tree::of(&log.events);
    (0..tree.nodes().len()).filter_map(|node| segment(log, &tree, node, usize::MAX)).collect()
}

/// The same file from rays that are known already, of many pixels perhaps.
pub fn obj_of(header: &Header, rays: &[Segment]) -> String {
    let far = far(rays);
    let mut out = String::new();
    line!(out, "# rays of {}, traced by raywalk {}", visible(&header.scene.name), visible(&header.version));
    line!(out, "# rays that meet nothing are drawn {} long", number(far));
    let mut vertices = 0;
    for (group, name) in GROUPS.iter().enumerate() {
        let rays: Vec<_> = rays.iter().filter(|ray| group_of(ray) == group).collect();
        if rays.is_empty() {
            continue;
        }
        line!(out, "g {name}");
        for ray in &rays {
            for [x, y, z] in [ray.from, ray.end(far)] {
                line!(out, "v {} {} {}", number(x), number(y), number(z));
            }
        }
        for _ in &rays {
            line!(out, "l {} {}", vertices + 1, vertices + 2);
            vertices += 2;
        }
    }
    out
}

fn group_of(ray: &Segment) -> usize {
    match ray.kind {
        RayKind::Camera => 0,
        RayKind::Reflected => 1,
        RayKind::Transmitted => 2,
        RayKind::Shadow { .. } if ray.is_blocked => 4,
        RayKind::Shadow { .. } => 3,
    }
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
