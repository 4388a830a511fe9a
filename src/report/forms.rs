//! By which of its formulas a quantity was computed, where a log doesn't say so.
//!
//! raywalk writes the form of a formula beside each value that has several. Another program may leave it out; then it is the form
//! whose formula gives the logged value from the logged operands, if there is one.

use super::Style;
use super::evaluate::evaluate;
use crate::log::{Event, Log, Name, Tree, Value, What, round_half_away};
use std::sync::LazyLock;

/// The values that are asked first whether the log lacks its forms at all: those that raywalk writes never do.
const ASKED: usize = 64;

/// Finds the forms that a log lacks. What no form explains stays as it is.
pub fn find(log: &mut Log) {
    // The book's own numbers follow from no formula.
    if log.header.arithmetic == "printed" || !log.events.iter().any(|event| has_rivals(event).is_some()) {
        return;
    }
    let tree = Tree::of(&log.events);
    let formless = log.events.iter().enumerate().filter_map(|(at, event)| {
        let name = has_rivals(event).filter(|name| name.form().is_empty())?;
        Some((at, name))
    });
    let formless: Vec<_> = formless.collect();
    // Under the formulas of the source text a value often follows from the robust formula, too.
    let follows_notes = log.header.tracing.formulas.as_deref() == Some("notes");
    let has_forms =
        log.events.iter().any(|event| matches!(event.what, What::Note { name, .. } if !name.form().is_empty()));
    if (has_forms || !follows_notes) && formless.iter().take(ASKED).all(|(at, name)| explains(log, &tree, *at, *name)) {
        return;
    }
    for (at, name) in formless {
        let rivals = || [name].into_iter().chain(Name::all().filter(|rival| rival.is(name)));
        // Of several that give the value, the one that takes up the event's own inputs, and that is of the header's formulas.
        let rank = |rival: &Name| {
            let formula = rival.formula().unwrap_or("");
            let ignored = log.given(at).iter().filter(|(given, _)| !formula.contains(given.symbol())).count();
            (ignored, ["notes", "normalized"].contains(&rival.form()) != follows_notes)
        };
        let exact = rivals().filter(|rival| gives(log, &tree, at, *rival)).min_by_key(rank);
        let found = exact.or_else(|| rivals().filter(|rival| explains(log, &tree, at, *rival)).min_by_key(rank));
        if let (Some(form), What::Note { name, .. }) = (found, &mut log.events[at].what) {
            *name = form;
        }
    }
}

/// The quantity that an event notes, if it has several formulas.
fn has_rivals(event: &Event) -> Option<Name> {
    let What::Note { name, .. } = event.what else { return None };
    // The forms of a key may be anywhere in the table.
    Some(name).filter(|name| RIVALS[*name as usize])
}

/// By name, whether there are several formulas for its key.
static RIVALS: LazyLock<Vec<bool>> = LazyLock::new(|| {
    let formulas = |key: &str| Name::all().filter(|name| name.key() == key && name.formula().is_some()).count();
    let has_rivals = |name: Name| formulas(name.key()) > usize::from(name.formula().is_some());
    Name::all().map(has_rivals).collect()
});

/// Whether the formula of a name gives the value that an event notes.
fn explains(log: &Log, tree: &Tree, event: usize, name: Name) -> bool {
    let What::Note { value, .. } = log.events[event].what else { return false };
    let computed = evaluate(log, tree, event, name).and_then(Result::ok);
    computed.is_some_and(|computed| is_near(log, &computed, &value, Style::default().digits))
}

/// Whether the formula of a name gives the value that an event notes to the last bit, rounded as the log says.
fn gives(log: &Log, tree: &Tree, event: usize, name: Name) -> bool {
    let What::Note { value, .. } = log.events[event].what else { return false };
    let rounded = |x: f64| match by_hand(log) {
        Some(digits) => round_half_away(x, digits),
        None if log.header.arithmetic == "f32" => f64::from((x as f32).clamp(f32::MIN, f32::MAX)),
        None => x,
    };
    let computed = evaluate(log, tree, event, name).and_then(Result::ok);
    computed.is_some_and(|computed| {
        let (computed, logged) = (computed.components(), value.components());
        computed.len() == logged.len() && computed.iter().zip(logged).all(|(a, b)| rounded(*a) == *b)
    })
}

/// The decimals of an arithmetic by hand; the book has three.
fn by_hand(log: &Log) -> Option<u32> {
    if log.header.arithmetic == "printed" {
        return Some(Style::default().digits);
    }
    log.header.arithmetic.strip_prefix("decimal:").and_then(|digits| digits.parse().ok())
}

/// Whether a value that a formula gives is the logged one, but for the log's own rounding and half a unit of the last
/// of this many digits, of decimals or, below 1, of those that count.
pub(super) fn is_near(log: &Log, computed: &Value, logged: &Value, digits: u32) -> bool {
    /// What other orders of the operations change, in proportion to the largest component.
    const NOISE: f64 = 1e-12;
    let (computed, logged) = (computed.components(), logged.components());
    let scale = logged.iter().fold(0.0, |scale: f64, x| scale.max(x.abs()));
    let shown = 0.5 * unit(digits);
    let by_hand = by_hand(log);
    let is_single = log.header.arithmetic == "f32";
    let near = |a: f64, b: f64| {
        let (a, rounded) = match by_hand {
            Some(digits) => (a, 0.5001 * unit(digits)),
            // What is too large or too small for single precision ends at its bounds.
            None if is_single => (
                a.clamp(f64::from(f32::MIN), f64::from(f32::MAX)),
                f64::from(f32::EPSILON) * b.abs() + f64::from(f32::MIN_POSITIVE),
            ),
            None => (a, 0.0),
        };
        (a - b).abs() <= f64::max(rounded, shown * b.abs().min(1.0)) + NOISE * scale
    };
    computed.len() == logged.len() && computed.iter().zip(logged).all(|(a, b)| a == b || near(*a, *b))
}

/// One unit in the last of this many decimals.
fn unit(digits: u32) -> f64 {
    libm::pow(10.0, -f64::from(digits))
}
