//! What one light adds to a local intensity: the term under the Σ of its formula, computed again from the logged values.
//!
//! A log holds the sum over the lights and all that goes into it, but no light's own part. In f64 the parts add up to the sum but
//! for roundings; in other arithmetics the logged sum is rounded once more.

use crate::log::formula::{self, Formula, Operator};
use crate::log::{Log, Name, Tree, Value, scope};

/// A colour, or the absence of a factor or a term.
#[derive(Clone, Copy)]
enum Part {
    Number(f64),
    Triple([f64; 3]),
    One,
    Zero,
}

/// The term of the light in the node `light`, in the local intensity `name`.
pub(super) fn of_light(log: &Log, tree: &Tree, light: usize, name: Name) -> [f64; 3] {
    let Some(Formula::Binary(Operator::Plus, _, lights)) = formula::of(name) else { return [0.0; 3] };
    let Formula::OverLights(term) = &**lights else { return [0.0; 3] };
    match part(log, tree, light, term) {
        Part::Triple(color) => color,
        Part::Number(x) => [x; 3],
        Part::One | Part::Zero => [0.0; 3],
    }
}

/// The value of a part of the term; formulas of local intensities are sums, products and powers.
fn part(log: &Log, tree: &Tree, light: usize, formula: &Formula) -> Part {
    let of = |inner: &Formula| part(log, tree, light, inner);
    match formula {
        Formula::Number(x) => Part::Number(*x),
        Formula::Symbol(symbol) => match scope::operand_of_light(&log.events, tree, light, symbol) {
            Some(operand) => match operand.value {
                Value::Number(x) => Part::Number(x),
                Value::Triple(triple) => Part::Triple(triple),
            },
            None if scope::is_one_when_absent(symbol) => Part::One,
            None => Part::Zero,
        },
        Formula::Grouped(inner) => of(inner),
        Formula::Positive(inner) => match of(inner) {
            Part::Number(x) => Part::Number(x.clamp(0.0, 1.0)),
            other => other,
        },
        Formula::Binary(Operator::Plus, left, right) => sum(of(left), of(right)),
        Formula::Binary(Operator::Power, base, exponent) => match (of(base), of(exponent)) {
            (Part::Number(base), Part::Number(exponent)) => Part::Number(libm::pow(base, exponent)),
            _ => Part::Zero,
        },
        Formula::Binary(Operator::Times | Operator::Channelwise, left, right) => product(of(left), of(right)),
        _ => Part::Zero,
    }
}

fn sum(left: Part, right: Part) -> Part {
    match (left, right) {
        (Part::Zero, other) | (other, Part::Zero) => other,
        (Part::Triple(a), Part::Triple(b)) => Part::Triple([0, 1, 2].map(|k| a[k] + b[k])),
        (Part::Number(a), Part::Number(b)) => Part::Number(a + b),
        _ => Part::Zero,
    }
}

fn product(left: Part, right: Part) -> Part {
    match (left, right) {
        (Part::Zero, _) | (_, Part::Zero) => Part::Zero,
        (Part::One, other) | (other, Part::One) => other,
        (Part::Number(a), Part::Number(b)) => Part::Number(a * b),
        (Part::Number(x), Part::Triple(triple)) | (Part::Triple(triple), Part::Number(x)) => {
            Part::Triple(triple.map(|component| component * x))
        }
        (Part::Triple(a), Part::Triple(b)) => Part::Triple([0, 1, 2].map(|k| a[k] * b[k])),
    }
}
