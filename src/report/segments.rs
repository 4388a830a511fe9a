//! The rays of a log as lines in space.

use crate::log::{Decision, Log, Name, RayKind, Step, Tree, Value, What};

/// A ray as a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Its node.
    pub node: usize,
    /// What kind of ray.
    pub kind: RayKind,
    /// Where it begins.
    pub from: [f64; 3],
    /// Its unit direction.
    pub direction: [f64; 3],
    /// How far it goes; `None` to infinity.
    pub length: Option<f64>,
    /// Whether it was stopped on its way: a shadow ray that doesn't reach its light.
    pub is_blocked: bool,
}

impl Segment {
    /// Where it ends; a ray to infinity after this distance.
    pub fn end(&self, far: f64) -> [f64; 3] {
        let length = self.length.unwrap_or(far);
        std::array::from_fn(|axis| self.from[axis] + self.direction[axis] * length)
    }
}

/// The rays of a node and of all nodes inside it, at most so many. Rays without a direction or an origin in the log are left out.
pub fn segments(log: &Log, tree: &Tree, node: usize, most: usize) -> Vec<Segment> {
    let nodes = node..tree.nodes()[node].subtree_end;
    nodes.filter_map(|node| segment(log, tree, node)).take(most).collect()
}

/// The ray of a node; `None` for another node, and for a ray whose origin or direction isn't in the log.
pub fn segment(log: &Log, tree: &Tree, node: usize) -> Option<Segment> {
    let Some(Step::Ray { kind, .. }) = tree.nodes()[node].step else { return None };
    let mut ray =
        Segment { node, kind, from: [f64::NAN; 3], direction: [f64::NAN; 3], length: None, is_blocked: false };
    for event in tree.own_events(node) {
        let event = &log.events[event];
        let noted = match event.what {
            What::Note { name, value } => Some((name, value)),
            _ => None,
        };
        for (name, value) in event.given.iter().copied().chain(noted) {
            match value {
                Value::Triple(origin) if name == Name::RayOrigin => ray.from = origin,
                Value::Triple(direction) if name == Name::RayDirection => ray.direction = direction,
                Value::Triple(point) if name.key() == Name::HitPoint.key() && ray.length.is_none() => {
                    ray.length = Some(distance(ray.from, point));
                }
                _ => {}
            }
        }
        ray.is_blocked |= matches!(event.what, What::Mark(Decision::Occluded { .. }));
    }
    if matches!(kind, RayKind::Shadow { .. }) {
        ray.length =
            if ray.is_blocked { blocked_at(log, tree, node) } else { None }.or_else(|| to_light(log, tree, node));
    }
    (ray.from.iter().chain(&ray.direction).all(|x| x.is_finite())).then_some(ray)
}

fn distance(from: [f64; 3], to: [f64; 3]) -> f64 {
    let squares = (0..3).map(|axis| (to[axis] - from[axis]) * (to[axis] - from[axis]));
    squares.sum::<f64>().sqrt()
}

/// The distance of the first hit of a shadow ray's tests.
fn blocked_at(log: &Log, tree: &Tree, node: usize) -> Option<f64> {
    let tests = node + 1..tree.nodes()[node].subtree_end;
    let distances = tests.filter_map(|test| {
        let mut distance = None;
        for event in tree.own_events(test) {
            match log.events[event].what {
                What::Note { name, value: Value::Number(t) } if name.key().ends_with(".t") => distance = Some(t),
                What::Mark(Decision::Hit) => return distance,
                _ => {}
            }
        }
        None
    });
    distances.reduce(f64::min)
}

/// The distance to the light, which the node around a shadow ray has; `None` for a light infinitely far away.
fn to_light(log: &Log, tree: &Tree, node: usize) -> Option<f64> {
    let parent = tree.nodes()[node].parent;
    let distance = |event: usize| match log.events[event].what {
        What::Note { name: Name::LightDistance, value: Value::Number(distance) } => Some(distance),
        _ => None,
    };
    tree.own_events_before(parent, tree.nodes()[node].events.start).filter_map(distance).last()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::record::{self, Arithmetic};
    use crate::scene::{build, builtin, file};

    fn rays(name: &str, pixel: [u32; 2]) -> (Log, Vec<Segment>) {
        let loaded = file::check(builtin::text(name).unwrap().as_bytes(), name).unwrap();
        let scene = build(&loaded.scene, &Default::default()).unwrap();
        let log = record::pixel(&scene, pixel, Arithmetic::F64);
        let segments = segments(&log, &Tree::of(&log.events), 0, usize::MAX);
        (log, segments)
    }

    #[test]
    fn the_rays_of_the_numeric_example() {
        let (_, rays) = rays("textbook", [160, 120]);
        assert_eq!(rays.len(), 4);
        let [camera, shadow, reflected, second] = [0, 1, 2, 3].map(|at| rays[at]);
        assert_eq!((camera.from, camera.kind), ([16.0, 2.0, 7.0], RayKind::Camera));
        let ends_at = |ray: Segment, point: [f64; 3]| {
            assert!(distance(ray.end(0.0), point) < 1e-12, "{ray:?} ends at {:?}", ray.end(0.0));
        };
        ends_at(camera, [4.0, 6.0, 8.0]);
        // The light.
        ends_at(shadow, [9.0, 12.0, 16.0]);
        assert!(!shadow.is_blocked);
        assert_eq!(reflected.from, [4.0, 6.0, 8.0]);
        assert!((reflected.length.unwrap() - 10.729_408_786_907_17).abs() < 1e-12);
        ends_at(second, [9.0, 12.0, 16.0]);
    }

    #[test]
    fn every_ray_of_every_scene_is_a_line() {
        for name in builtin::names() {
            let (log, rays) = rays(name, [3, 3]);
            let count =
                Tree::of(&log.events).nodes().iter().filter(|node| matches!(node.step, Some(Step::Ray { .. }))).count();
            assert_eq!(rays.len(), count, "{name}");
            for ray in rays {
                let shadow = matches!(ray.kind, RayKind::Shadow { .. });
                assert!(ray.length.is_none_or(|length| length > 0.0) && (shadow || !ray.is_blocked), "{name}: {ray:?}");
            }
        }
    }
}
