//! Where the source text explains a value: the section of its formula, and in the numeric example the step of the calculation.
//!
//! A section belongs to a quantity, a step to a place: V, L and H are step 6 at P₂ and step 8 at P₁. Only the walk of the numeric
//! example itself has steps, and there only what the book computes: it leaves out the camera ray's test of the sphere and all
//! shadow rays.

use crate::log::{Input, Log, Name, RayKind, Tree, Value, What};
use crate::probe::Printed;

/// What the book computes without printing it: the ray's path, the quantity's key, the step. The normal of the plane is put into
/// step 4; the sum of the last step adds what is reflected to what is local.
const UNPRINTED: &[(&str, &str, &str)] =
    &[("C", "hit.normal", "4"), ("C", "combine.local", "8"), ("C", "combine.reflected", "8")];

/// The geometry of the numeric example: the inputs by which its walk is known.
const EXAMPLE: &[(Name, Value)] = &[
    (Name::PlaneNormal, Value::Triple([1.0, 0.0, 0.0])),
    (Name::PlaneOffset, Value::Number(-4.0)),
    (Name::SphereCenter, Value::Triple([17.0, 9.0, 8.0])),
    (Name::SphereRadius, Value::Number(3.0)),
    (Name::LightPosition, Value::Triple([9.0, 12.0, 16.0])),
];

/// The eye of the numeric example, and the way in which it looks.
const EYE: &[(Name, Value)] =
    &[(Name::RayOrigin, Value::Triple([16.0, 2.0, 7.0])), (Name::RayVector, Value::Triple([-12.0, 4.0, 1.0]))];

/// More events than the walk of the numeric example has in any arithmetic, also where all tests are shown.
const MOST_EVENTS: usize = 1 << 10;

/// More nodes than are around any value that the book computes.
const DEEPEST: usize = 16;

/// Where the source text (Ramos, "Trazado de rayos") explains the value that `event` notes, such as `1.2.1`, or `1.3 (5d)` in the
/// walk of the numeric example; `None` for what the text doesn't have, and for other events.
pub fn tag(log: &Log, tree: &Tree, event: usize) -> Option<String> {
    let What::Note { name, .. } = log.events.get(event)?.what else { return None };
    match step(log, tree, event, name) {
        Some(step) => Some(format!("1.3 ({step})")),
        None => Some(name.section().to_owned()).filter(|section| !section.is_empty()),
    }
}

/// Whether the walk of the numeric example comes to the value that `event` notes and the book doesn't: that of the sphere's test by the
/// camera ray, or of a shadow ray.
pub fn is_left_out(log: &Log, tree: &Tree, event: usize) -> bool {
    let What::Note { name, .. } = log.events[event].what else { return false };
    let node = tree.owner(event);
    tree.nodes()[node].level <= DEEPEST && step(log, tree, event, name).is_none() && is_of_the_example(log, tree, node)
}

/// The step of the numeric example that computes the value.
fn step(log: &Log, tree: &Tree, event: usize, name: Name) -> Option<&'static str> {
    // Its walk is no deeper, and a path is as long as the way to its node.
    if tree.nodes()[tree.owner(event)].level > DEEPEST {
        return None;
    }
    let path = tree.path(tree.owner(event));
    let unprinted = || UNPRINTED.iter().find(|(ray, key, _)| *ray == path && *key == name.key());
    let step = Printed::of(&path, name.key()).map(|printed| printed.step);
    let step = step.or_else(|| unprinted().map(|(_, _, step)| *step))?;
    is_of_the_example(log, tree, tree.owner(event)).then_some(step)
}

/// Whether the camera ray around this node sets out as in the numeric example, and meets nothing else in all its tree.
fn is_of_the_example(log: &Log, tree: &Tree, node: usize) -> bool {
    let nodes = tree.nodes();
    let is_camera = |node: usize| tree.ray(node) == Some(RayKind::Camera);
    let Some(camera) = tree.around(node).find(|node| is_camera(*node)) else { return false };
    // This is asked for every value that the book may have, and its walk is short.
    if nodes[camera].events.len() > MOST_EVENTS {
        return false;
    }
    let sets_out = EYE.iter().all(|input| tree.own_events(camera).any(|event| has(log.given(event), input)));
    let agrees =
        |(name, value): &(Name, Value)| EXAMPLE.iter().all(|(known, there)| known != name || there.same_bits(value));
    sets_out && nodes[camera].events.clone().all(|event| log.given(event).iter().all(agrees))
}

/// Whether this input is among those.
fn has(given: &[Input], (name, value): &Input) -> bool {
    given.iter().any(|(there, of)| there == name && of.same_bits(value))
}
