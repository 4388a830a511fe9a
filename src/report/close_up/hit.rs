//! What the log holds of a ray's hit.

use crate::log::{Log, Name, RayKind, Step, Tree, Value};
use glam::DVec3;

/// The rays of a log that may hit something: all but the shadow rays.
pub(super) fn rays(tree: &Tree) -> Vec<usize> {
    let is_traced = |node: &usize| tree.ray(*node).is_some_and(|kind| !matches!(kind, RayKind::Shadow { .. }));
    (0..tree.nodes().len()).filter(is_traced).collect()
}

/// The last value of a quantity that a node itself noted or was given, by its key.
pub(super) fn value(log: &Log, tree: &Tree, node: usize, name: Name) -> Option<Value> {
    let events: Vec<usize> = tree.own_events(node).collect();
    events.into_iter().rev().find_map(|event| {
        let mut values = log.events[event].noted().into_iter().chain(log.given(event).iter().rev().copied());
        values.find(|(found, _)| found.is(name)).map(|(_, value)| value)
    })
}

/// A triple among them.
pub(super) fn vector(log: &Log, tree: &Tree, node: usize, name: Name) -> Option<DVec3> {
    value(log, tree, node, name)?.triple().map(DVec3::from).filter(|vector| vector.is_finite())
}

/// A number among them.
pub(super) fn number(log: &Log, tree: &Tree, node: usize, name: Name) -> Option<f64> {
    value(log, tree, node, name)?.number().filter(|x| x.is_finite())
}

/// The local model of a ray's hit.
pub(super) fn shade(tree: &Tree, ray: usize) -> Option<usize> {
    tree.children(ray).find(|child| matches!(tree.nodes()[*child].step, Some(Step::Shade { .. })))
}

/// The lights of a local model, each point of an area light by itself: node, number of the light, number of the point.
pub(super) fn lights(tree: &Tree, shade: usize) -> Vec<(usize, u32, u32)> {
    let of = |child: usize| match tree.nodes()[child].step {
        Some(Step::Light { light, split }) => Some((child, light, split)),
        _ => None,
    };
    tree.children(shade).filter_map(of).collect()
}

/// A vector scaled to length 1; `None` of the zero vector.
pub(super) fn unit(vector: DVec3) -> Option<DVec3> {
    let length = vector.length();
    (length > 0.0 && length.is_finite()).then(|| vector / length)
}
