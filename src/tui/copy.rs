//! What is copied: a value with all its digits, or an address.

use super::bookmarks::address;
use super::effect::Effect;
use super::model::Model;
use crate::log::{Value, What};
use crate::report::words::plain;

/// Copies the value of the current step; of a node what it came to.
pub(super) fn value(model: &mut Model) -> Effect {
    let Some(event) = model.log.events.get(model.event) else { return Effect::None };
    let of_node = || model.facts.value(model.tree.owner(model.event)).filter(|event| model.guide.is_known(*event));
    if model.hides(model.event)
        || (model.understanding.quiz.is_some() && of_node().is_some_and(|event| model.hides(event)))
    {
        model.say(model.texts().quiz.tells_result);
        return Effect::None;
    }
    let what = match &event.what {
        What::Enter { .. } | What::Leave => of_node().map_or(&event.what, |event| &model.log.events[event].what),
        what => what,
    };
    let text = what.value().map_or_else(|| model.describe(model.event), |value| in_full(&value));
    copied(model, text)
}

/// Copies the address of the current step.
pub(super) fn path(model: &mut Model) -> Effect {
    if model.log.events.is_empty() {
        return Effect::None;
    }
    if model.hides_name(model.event) {
        model.say(model.texts().quiz.tells_decision);
        return Effect::None;
    }
    let text = address(&model.log, &model.tree, model.event);
    copied(model, text)
}

fn copied(model: &mut Model, text: String) -> Effect {
    model.say(&(model.texts().messages.copied)(&plain(&text)));
    Effect::Copy(text)
}

/// A value so that it can be read back to the last bit.
fn in_full(value: &Value) -> String {
    let numbers: Vec<_> = value.components().iter().map(|number| number_in_full(*number)).collect();
    if numbers.len() == 1 { numbers.concat() } else { format!("({})", numbers.join(", ")) }
}

/// The shortest text that gives the number again.
fn number_in_full(number: f64) -> String {
    let text = format!("{number:?}");
    text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_in_full_can_be_read_back() {
        for number in [0.0, -0.0, 1.0, 0.1, 1.0 / 3.0, -1e-300, f64::MAX, f64::EPSILON] {
            let read: f64 = number_in_full(number).parse().expect("it was written as a number");
            assert_eq!(read.to_bits(), number.to_bits());
        }
        assert_eq!(in_full(&Value::Triple([1.0, -0.5, 1e-12])), "(1, -0.5, 1e-12)");
    }
}
