//! The rays of a log as lines in space, for 3D viewers.

mod obj;
mod ply;

pub use obj::obj;
pub use ply::ply;

use super::segments::{Segment, around, reach, segment};
use crate::log::{Log, RayKind, Tree};

/// What rays are distinguished by: where they come from, and whether they reach their light.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Group {
    Camera,
    Reflected,
    Transmitted,
    Shadow,
    Blocked,
}

impl Group {
    /// In the order of the files.
    const ALL: [Group; 5] = [Group::Camera, Group::Reflected, Group::Transmitted, Group::Shadow, Group::Blocked];

    fn of(ray: &Segment) -> Group {
        match ray.kind {
            RayKind::Camera => Group::Camera,
            RayKind::Reflected => Group::Reflected,
            RayKind::Transmitted => Group::Transmitted,
            RayKind::Shadow { .. } if ray.is_blocked => Group::Blocked,
            RayKind::Shadow { .. } => Group::Shadow,
        }
    }

    fn name(self) -> &'static str {
        match self {
            Group::Camera => "camera",
            Group::Reflected => "reflected",
            Group::Transmitted => "transmitted",
            Group::Shadow => "shadow",
            Group::Blocked => "shadow_blocked",
        }
    }

    /// Red, green and blue, those of the ray tree.
    fn color(self) -> [u8; 3] {
        match self {
            Group::Camera => [0x3b, 0x42, 0x52],
            Group::Reflected => [0x1d, 0x6f, 0xb8],
            Group::Transmitted => [0x2c, 0x8a, 0x4b],
            Group::Shadow => [0xc9, 0x8a, 0x00],
            Group::Blocked => [0xc0, 0x39, 0x2b],
        }
    }
}

/// The rays of a log.
pub fn rays(log: &Log) -> Vec<Segment> {
    let tree = Tree::of(&log.events);
    (0..tree.nodes().len()).filter_map(|node| segment(log, &tree, node, usize::MAX)).collect()
}

/// The groups that have rays, in order.
fn grouped(rays: &[Segment]) -> impl Iterator<Item = (Group, Vec<&Segment>)> {
    let of_group = |group| (group, rays.iter().filter(|ray| Group::of(ray) == group).collect::<Vec<_>>());
    Group::ALL.into_iter().map(of_group).filter(|(_, rays)| !rays.is_empty())
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
