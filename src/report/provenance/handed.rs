//! Inputs that are a computed value of another node, under another symbol or out of its scope.

use super::noted;
use crate::log::scope;
use crate::log::{Log, Name, RayKind, Skippable, Step, Tree, Value};

/// The event that computed the input `name` of `event`; `None` for what the scene states. A value that was handed on has the same
/// bits, and nothing else counts.
pub fn origin(log: &Log, tree: &Tree, event: usize, name: Name, value: &Value) -> Option<usize> {
    let node = tree.owner(event);
    let found = match name {
        Name::RayOrigin => latest(log, tree, event, &["P"], value),
        Name::RayDirection => latest(log, tree, event, &["D_z", "R", "T", "L"], value),
        Name::LobeMiddle => latest(log, tree, event, &["R", "T"], value),
        Name::ShadeLocal => inside_of_parent(log, tree, node, event, "I_local"),
        Name::IncomingReflected => brought(log, tree, tree.nodes()[node].parent, event, Skippable::Reflected),
        Name::IncomingTransmitted => brought(log, tree, tree.nodes()[node].parent, event, Skippable::Transmitted),
        Name::LobeColor => {
            let zone = tree.children(node).filter(|child| tree.nodes()[*child].events.end <= event).last()?;
            tree.children(zone).find_map(|ray| color_of(log, tree, ray))
        }
        _ => None,
    }?;
    noted(&log.events[found]).filter(|(_, source)| source.same_bits(value)).map(|_| found)
}

/// Whether a quantity of this symbol may be handed on as that input: asked before anything is looked for.
pub(super) fn may_come_from(input: Name, symbol: &str) -> bool {
    match input {
        Name::RayOrigin => symbol == "P",
        Name::RayDirection => ["D_z", "R", "T", "L"].contains(&symbol),
        Name::LobeMiddle => ["R", "T"].contains(&symbol),
        Name::ShadeLocal => symbol == "I_local",
        Name::IncomingReflected | Name::IncomingTransmitted => ["I", "m_z"].contains(&symbol),
        Name::LobeColor => symbol == "I",
        _ => false,
    }
}

/// The latest of several quantities in scope that has this value.
fn latest(log: &Log, tree: &Tree, event: usize, symbols: &[&str], value: &Value) -> Option<usize> {
    let in_scope = symbols.iter().filter_map(|symbol| scope::noted_before(&log.events, tree, event, symbol));
    in_scope.filter(|operand| operand.value.same_bits(value)).map(|operand| operand.event).max()
}

/// What a node beside this one noted last.
fn inside_of_parent(log: &Log, tree: &Tree, node: usize, before: usize, symbol: &str) -> Option<usize> {
    let siblings = tree.children(tree.nodes()[node].parent).filter(|child| tree.nodes()[*child].events.end <= before);
    let noted =
        siblings.filter_map(|sibling| tree.own_events(sibling).rfind(|at| super::notes(&log.events[*at], symbol)));
    noted.last()
}

/// The colour that a bounce brought to a ray: the mean of its lobe, or that of its one ray.
fn brought(log: &Log, tree: &Tree, ray: usize, before: usize, what: Skippable) -> Option<usize> {
    let is_of_bounce = |child: &usize| match tree.nodes()[*child].step {
        Some(Step::Ray { kind: RayKind::Reflected, .. }) => what == Skippable::Reflected,
        Some(Step::Ray { kind: RayKind::Transmitted, .. }) => what == Skippable::Transmitted,
        Some(Step::Zone { what: zone, .. }) => zone == what,
        _ => false,
    };
    let last =
        tree.children(ray).filter(is_of_bounce).take_while(|child| tree.nodes()[*child].events.end <= before).last()?;
    if matches!(tree.nodes()[last].step, Some(Step::Zone { .. })) {
        let end = tree.nodes()[last].events.end;
        let after = tree.own_events(ray).filter(|at| *at >= end && *at < before);
        return after.into_iter().find(|at| matches!(noted(&log.events[*at]), Some((Name::LobeMean, _))));
    }
    color_of(log, tree, last)
}

/// The event with the colour of a ray that met something.
pub(super) fn color_of(log: &Log, tree: &Tree, ray: usize) -> Option<usize> {
    let combine = tree.children(ray).filter(|child| tree.nodes()[*child].step == Some(Step::Combine)).last()?;
    tree.own_events(combine).find(|at| matches!(noted(&log.events[*at]), Some((Name::CombineColor, _))))
}
