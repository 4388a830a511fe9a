//! The rays of a log as lines in space.

use crate::log::scope;
use crate::log::{Decision, Log, Name, RayKind, Tree, Value, What};

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

/// The rays of a node and of all nodes inside it, at most this many. Rays without a direction or an origin in the log are left out,
/// and what lies beyond the first 2^16 nodes, so that it is quick for any log.
pub fn segments(log: &Log, tree: &Tree, node: usize, most: usize) -> Vec<Segment> {
    const MOST_NODES: usize = 1 << 16;
    let nodes = node..tree.nodes()[node].subtree_end.min(node + MOST_NODES);
    nodes.filter_map(|node| segment(log, tree, node, usize::MAX)).take(most).collect()
}

/// The ray of a node as far as the events up to the last of these tell it; `None` for another node, and for a ray whose origin or
/// direction isn't in the log, or not yet.
pub fn segment(log: &Log, tree: &Tree, node: usize, last: usize) -> Option<Segment> {
    let kind = tree.ray(node)?;
    let mut ray =
        Segment { node, kind, from: [f64::NAN; 3], direction: [f64::NAN; 3], length: None, is_blocked: false };
    for event in tree.own_events(node).take_while(|event| *event <= last) {
        let what = &log.events[event].what;
        for (name, value) in log.given(event).iter().copied().chain(log.events[event].noted()) {
            match value {
                Value::Triple(origin) if name.is(Name::RayOrigin) => ray.from = origin,
                Value::Triple(direction) if name.is(Name::RayDirection) => ray.direction = direction,
                Value::Triple(point) if name.is(Name::HitPoint) && ray.length.is_none() => {
                    ray.length = Some(distance(ray.from, point));
                }
                _ => {}
            }
        }
        ray.is_blocked |= matches!(what, What::Mark(Decision::Occluded { .. }));
    }
    if matches!(kind, RayKind::Shadow { .. }) {
        ray.length =
            if ray.is_blocked { blocked_at(log, tree, node) } else { None }.or_else(|| to_light(log, tree, node));
    }
    (ray.from.iter().chain(&ray.direction).all(|x| x.is_finite())).then_some(ray)
}

/// The box around points: its lowest and its highest corner.
pub fn around(points: impl Iterator<Item = [f64; 3]>) -> [[f64; 3]; 2] {
    points.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], point| {
        [0, 1].map(|side| {
            std::array::from_fn(|axis| if side == 0 { low[axis].min(point[axis]) } else { high[axis].max(point[axis]) })
        })
    })
}

/// The longest side of a box.
pub fn reach([low, high]: &[[f64; 3]; 2]) -> f64 {
    (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max)
}

/// The object that a node hits.
pub fn nearest(log: &Log, tree: &Tree, node: usize) -> Option<u32> {
    tree.own_events(node).find_map(|event| match log.events[event].decision()? {
        Decision::Nearest { object } => Some(object),
        _ => None,
    })
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
    let (parent, before) = (tree.nodes()[node].parent, tree.nodes()[node].events.start);
    let noted = scope::latest_note(&log.events, tree, parent, before, Name::LightDistance)?;
    log.events[noted].noted()?.1.number()
}
