//! Where a value comes from, and where it goes.
//!
//! What a symbol of a formula means is settled in `log/scope.rs`. Here that rule is read in both directions, and goes on through
//! what a node passes on to another under a new symbol: the hit point becomes the origin of the next ray, the colour that a ray
//! brings becomes the I_reflected of the ray before it.

mod handed;
mod uses;

pub use handed::{color_of_ray, origin as handed_on_from};
pub use uses::uses;

use crate::log::formula::{self, Formula, Unary};
use crate::log::scope;
use crate::log::{Event, Log, Tree, Value, What};
use std::collections::HashSet;

/// A value that a step takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Operand {
    /// Its symbol in the formula.
    pub symbol: &'static str,
    /// The value.
    pub value: Value,
    /// The event that has it: noted there, or among its inputs.
    pub event: usize,
    /// Whether it is an input there.
    pub is_given: bool,
    /// The event that computed it, if that is known: `event` itself, or the one whose value was passed on as an input.
    pub computed: Option<usize>,
    /// Under a Σ: the node of the light to which it belongs.
    pub light: Option<usize>,
}

/// What a step takes: for a computed value the operands of its formula, in the order of the formula; for what has none, its inputs.
///
/// An operand that the log doesn't hold belongs to a term that is zero or a factor that is one, and isn't listed.
pub fn operands(log: &Log, tree: &Tree, event: usize) -> Vec<Operand> {
    let Some(happening) = log.events.get(event) else { return Vec::new() };
    let formula = match happening.what {
        What::Note { name, .. } => formula::of(name),
        _ => None,
    };
    let Some(formula) = formula else { return inputs(log, tree, event) };
    // A sum may go over thousands of lights.
    let (mut found, mut known) = (Vec::new(), HashSet::new());
    each_symbol(formula, false, &mut |symbol, is_under_sum| {
        let lights: Vec<_> =
            if is_under_sum { scope::lights(&log.events, tree, event).map(Some).collect() } else { vec![None] };
        for light in lights {
            if !known.contains(&(symbol, light)) && !known.contains(&(symbol, None)) {
                let operand = operand(log, tree, event, symbol, light);
                known.extend(operand.iter().map(|operand| (operand.symbol, operand.light)));
                found.extend(operand);
            }
        }
    });
    found
}

fn operand(log: &Log, tree: &Tree, event: usize, symbol: &'static str, light: Option<usize>) -> Option<Operand> {
    let source = match light {
        Some(light) => scope::operand_of_light(&log.events, tree, light, symbol),
        None => scope::operand(&log.events, tree, event, symbol),
    }?;
    // What doesn't belong to one light is the same for all.
    let light = light.filter(|light| tree.nodes()[*light].events.contains(&source.event));
    let is_given = !(source.event < event && notes(&log.events[source.event], symbol));
    let computed = if is_given { handed_on(log, tree, source.event, symbol, source.value) } else { Some(source.event) };
    Some(Operand { symbol, value: source.value, event: source.event, is_given, computed, light })
}

fn inputs(log: &Log, tree: &Tree, event: usize) -> Vec<Operand> {
    let inputs = log.given(event).iter().map(|(name, value)| Operand {
        symbol: name.symbol(),
        value: *value,
        event,
        is_given: true,
        computed: handed::origin(log, tree, event, *name, value),
        light: None,
    });
    inputs.collect()
}

/// The event that computed an input.
fn handed_on(log: &Log, tree: &Tree, event: usize, symbol: &str, value: Value) -> Option<usize> {
    let (name, _) = log.given(event).iter().rev().find(|(name, _)| name.symbol() == symbol)?;
    handed::origin(log, tree, event, *name, &value)
}

/// Hands every symbol of a formula to `f`, with whether it is under a Σ.
fn each_symbol(formula: &Formula, is_under_sum: bool, f: &mut impl FnMut(&'static str, bool)) {
    match formula {
        Formula::Number(_) => {}
        Formula::Leaf(symbol) => f(symbol, is_under_sum),
        Formula::Triple(parts) => parts.iter().for_each(|part| each_symbol(part, is_under_sum, f)),
        // What samples, cells and surfaces bring isn't in the scope of the node itself.
        Formula::Unary(Unary::Over(_), _) => {}
        Formula::Unary(unary, inner) => each_symbol(inner, is_under_sum || *unary == Unary::OverLights, f),
        Formula::Binary(_, left, right) => {
            each_symbol(left, is_under_sum, f);
            each_symbol(right, is_under_sum, f);
        }
    }
}

/// Whether an event notes a quantity of this symbol.
fn notes(event: &Event, symbol: &str) -> bool {
    matches!(event.what, What::Note { name, .. } if name.symbol() == symbol)
}

/// Whether an event has an input of this symbol.
fn gives(log: &Log, event: usize, symbol: &str) -> bool {
    log.given(event).iter().any(|(name, _)| name.symbol() == symbol)
}
