//! How far answers are from the exact ones.

use super::case::Case;
use super::decimal;
use super::requirement::{COARSE, Requirement, Unit};
use serde_json::{Map, Value};

/// What became of a case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Whether a decision is wrong: a hit, an order, an identity, an answer that is none.
    pub is_wrong: bool,
    /// The worst error of its numbers, in the unit of the requirement; `None` where there is none to measure.
    pub error: Option<f64>,
}

/// Compares the answer to a case with the exact one.
pub(super) fn judge(case: &Case, answer: &Value, requirement: &Requirement) -> Outcome {
    let none = Map::new();
    let answer = answer.as_object().unwrap_or(&none);
    let mut outcome = Outcome::default();
    let is_expected = |key: &&&str| case.out.contains_key(**key);
    for key in requirement.decisions.iter().filter(is_expected) {
        outcome.is_wrong |= !decided_rightly(key, &case.out[*key], answer);
    }
    for key in requirement.coarse.iter().filter(is_expected) {
        let mut measured = Measured { unit: Unit::Relative, cond: 1.0, outcome: Outcome::default() };
        measured.compare(&case.out[*key], answer.get(*key).unwrap_or(&Value::Null));
        outcome.is_wrong |= measured.outcome.is_wrong || measured.outcome.error.is_some_and(|error| error > COARSE);
    }
    // After a wrong decision there is nothing to measure.
    if outcome.is_wrong {
        return outcome;
    }
    let mut measured = Measured { unit: requirement.unit, cond: case.cond.unwrap_or(1.0), outcome };
    for key in requirement.numbers.iter().filter(is_expected) {
        measured.compare(&case.out[*key], answer.get(*key).unwrap_or(&Value::Null));
    }
    measured.outcome
}

/// `ids` lists every winner that is right; the answer has one as `id`.
fn decided_rightly(key: &str, expected: &Value, answer: &Map<String, Value>) -> bool {
    if key != "ids" {
        return answer.get(key) == Some(expected);
    }
    let id = answer.get("id");
    expected.as_array().is_some_and(|ids| id.is_some_and(|id| ids.contains(id)))
}

struct Measured {
    unit: Unit,
    cond: f64,
    outcome: Outcome,
}

impl Measured {
    /// Compares number with number, part by part.
    fn compare(&mut self, expected: &Value, found: &Value) {
        match (expected, found) {
            (Value::Null, found) => self.outcome.is_wrong |= !found.is_null(),
            (Value::String(text), found) if text == "finite" => self.outcome.is_wrong |= !is_finite(found),
            (Value::String(text), found) => match (decimal::parse(text), found.as_f64()) {
                (Some(exact), Some(found)) => {
                    let error = self.in_unit(decimal::error(found, exact), exact);
                    self.outcome.error = Some(self.outcome.error.unwrap_or(0.0).max(error));
                }
                _ => self.outcome.is_wrong = true,
            },
            (Value::Array(expected), Value::Array(found)) if expected.len() == found.len() => {
                expected.iter().zip(found).for_each(|(expected, found)| self.compare(expected, found));
            }
            (Value::Object(expected), Value::Object(found)) => {
                // What an answer doesn't have isn't asked of it.
                let common = expected.iter().filter_map(|(key, value)| Some((value, found.get(key)?)));
                common.for_each(|(expected, found)| self.compare(expected, found));
            }
            (expected, found) => self.outcome.is_wrong |= expected != found,
        }
    }

    fn in_unit(&self, error: f64, exact: crate::geometry::doubled::Doubled) -> f64 {
        if error == 0.0 {
            return 0.0;
        }
        let size = exact.head.abs();
        match self.unit {
            Unit::Ulp => error / decimal::ulp(exact),
            Unit::K => error / (f64::EPSILON / 2.0 * size * self.cond),
            Unit::Epsilon => error / f64::EPSILON,
            Unit::Relative | Unit::None => error / size,
        }
    }
}

/// Whether a value is a number or is made of numbers: JSON writes what is no number as null.
fn is_finite(value: &Value) -> bool {
    match value {
        Value::Array(parts) => parts.iter().all(is_finite),
        value => value.is_number(),
    }
}
