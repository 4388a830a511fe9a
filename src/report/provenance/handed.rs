//! Inputs that are a computed value of another node, under another symbol or out of its scope.

use crate::log::scope;
use crate::log::tree::Child;
use crate::log::{Log, Name, Step, Term, Tree, Value};

/// The event that computed the input `name` of `event`; `None` for what the scene states. A value that was passed on has the same
/// bits, and nothing else counts.
pub fn origin(log: &Log, tree: &Tree, event: usize, name: Name, value: &Value) -> Option<usize> {
    let node = tree.owner(event);
    let found = match name {
        Name::RayOrigin | Name::RayDirection | Name::LobeMiddle => latest(log, tree, event, sources(name), value),
        Name::ShadeLocal => local_beside(log, tree, node, event),
        Name::IncomingReflected => brought(log, tree, tree.nodes()[node].parent, event, Term::Reflected),
        Name::IncomingTransmitted => brought(log, tree, tree.nodes()[node].parent, event, Term::Transmitted),
        Name::LobeColor => {
            let zone = scope::last_child(&log.events, tree, node, event, Child::Any)?;
            tree.children(zone).find_map(|ray| color_of_ray(log, tree, ray))
        }
        _ => None,
    }?;
    log.events[found].noted().filter(|(_, source)| source.same_bits(value)).map(|_| found)
}

/// The symbols of the quantities that may be passed on as an input.
fn sources(input: Name) -> &'static [&'static str] {
    match input {
        Name::RayOrigin => &["P"],
        Name::RayDirection => &["D_z", "R", "T", "L"],
        Name::LobeMiddle => &["R", "T"],
        Name::ShadeLocal => &["I_local"],
        Name::IncomingReflected | Name::IncomingTransmitted => &["I", "m_z"],
        Name::LobeColor => &["I"],
        _ => &[],
    }
}

/// Whether a quantity of this symbol may be passed on as that input: asked before anything is looked for.
pub(super) fn may_come_from(input: Name, symbol: &str) -> bool {
    sources(input).contains(&symbol)
}

/// The latest of several quantities in scope that has this value.
fn latest(log: &Log, tree: &Tree, event: usize, symbols: &[&str], value: &Value) -> Option<usize> {
    let in_scope = symbols.iter().filter_map(|symbol| scope::noted_before(&log.events, tree, event, symbol));
    in_scope.filter(|operand| operand.value.same_bits(value)).map(|operand| operand.event).max()
}

/// The local intensity that a node beside this one noted last.
fn local_beside(log: &Log, tree: &Tree, node: usize, before: usize) -> Option<usize> {
    let sibling = scope::last_child(&log.events, tree, tree.nodes()[node].parent, before, Child::Local)?;
    scope::noted_in(&log.events, tree, sibling, usize::MAX, Name::ShadeLocal.symbol()).map(|operand| operand.event)
}

/// The colour that a bounce brought to a ray: the mean of its lobe, or that of its one ray.
fn brought(log: &Log, tree: &Tree, ray: usize, before: usize, what: Term) -> Option<usize> {
    let last = scope::last_child(&log.events, tree, ray, before, Child::Bounce(what))?;
    if matches!(tree.nodes()[last].step, Some(Step::Zone { .. })) {
        let end = tree.nodes()[last].events.end;
        return scope::first_note(&log.events, tree, ray, end, Name::LobeMean).filter(|at| *at < before);
    }
    color_of_ray(log, tree, last)
}

/// The event with the colour of a ray that met something.
pub fn color_of_ray(log: &Log, tree: &Tree, ray: usize) -> Option<usize> {
    let combine = scope::last_child(&log.events, tree, ray, usize::MAX, Child::Combine)?;
    scope::first_note(&log.events, tree, combine, 0, Name::CombineColor)
}
