//! Moves and scalings that are exact must change no bit of an answer.

use super::case::Family;
use serde_json::{Value, json};
use std::collections::HashMap;

/// The cases whose answer differs from that of the first one in their group, although the scene was only moved by coordinates
/// that f64 has, or scaled by a power of two.
pub(super) fn different_from_base(family: &Family, answers: &[Value]) -> Vec<bool> {
    let mut bases: HashMap<String, Value> = HashMap::new();
    let of_case = |(case, answer): (&super::case::Case, &Value)| {
        let text = |key: &str| case.input.get(key).map(Value::to_string);
        let is_exact = ["exact_move", "exact_scale"].iter().any(|key| case.input.get(*key) == Some(&Value::Bool(true)));
        let Some(group) = text("group").filter(|_| is_exact) else { return false };
        let scale = case.input.get("scale").and_then(Value::as_f64).unwrap_or(1.0);
        let unscaled = unscaled(answer, scale);
        *bases.entry(group).or_insert_with(|| unscaled.clone()) != unscaled
    };
    family.cases.iter().zip(answers).map(of_case).collect()
}

/// The answer with its distance brought back to the size of the base.
fn unscaled(answer: &Value, scale: f64) -> Value {
    let mut answer = answer.clone();
    if let Some(t) = answer.get("t").and_then(Value::as_f64) {
        answer["t"] = json!(t / scale);
    }
    answer
}
