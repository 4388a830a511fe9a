//! An event in a few words, for lists and messages.

use super::model::Model;
use crate::log::What;

/// What an event says, such as `N·L = 0.300`, as far as it may be shown.
pub(super) fn event(model: &Model, event: usize) -> String {
    let panes = &model.texts().panes;
    if model.hides(event) {
        return match model.log.events.get(event).map(|event| &event.what) {
            Some(What::Note { name, .. }) => format!("{} = ?", name.symbol()),
            Some(What::Mark(_)) => panes.hidden_decision.to_owned(),
            _ => panes.hidden_result.to_owned(),
        };
    }
    if !model.guide.is_known(event) {
        return panes.not_computed.to_owned();
    }
    let title = || model.title(model.tree.owner(event));
    match model.log.events.get(event).map(|event| &event.what) {
        Some(What::Note { name, value }) => format!("{} = {}", name.symbol(), model.value(value)),
        Some(What::Mark(decision)) => model.decision(decision),
        Some(What::Enter { .. }) => title(),
        Some(What::Leave) => (panes.end_of)(&title()),
        Some(What::Result { color }) => (panes.result)(&model.color(*color)),
        None => String::new(),
    }
}
