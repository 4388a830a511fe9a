//! An event in a few words, for lists and messages.

use super::model::Model;
use crate::log::{Value, What};
use crate::report::{number, words};

/// What an event says, such as `N·L = 0.300`, as far as it may be told.
pub(super) fn event(model: &Model, event: usize) -> String {
    if model.hides(event) {
        return match model.log.events.get(event).map(|event| &event.what) {
            Some(What::Note { name, .. }) => format!("{} = ?", name.symbol()),
            Some(What::Mark(_)) => "decision ?".to_owned(),
            _ => "result ?".to_owned(),
        };
    }
    if !model.guide.is_known(event) {
        return "not computed yet".to_owned();
    }
    let title = || words::title(&model.log, &model.tree, model.tree.owner(event));
    match model.log.events.get(event).map(|event| &event.what) {
        Some(What::Note { name, value }) => format!("{} = {}", name.symbol(), number::value(value, model.numbers)),
        Some(What::Mark(decision)) => words::decision(&model.log.header, decision, model.numbers),
        Some(What::Enter { .. }) => title(),
        Some(What::Leave) => format!("end of {}", title()),
        Some(What::Result { color }) => format!("result {}", number::value(&Value::Triple(*color), model.numbers)),
        None => String::new(),
    }
}
