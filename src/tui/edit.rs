//! Where the scene is opened in an editor.

use super::effect::Effect;
use super::model::Model;
use crate::log::{Decision, Step, What};

/// Opens the scene where it has the object that the current step is about.
pub(super) fn object(model: &Model) -> Effect {
    let of_node = |node: usize| match model.tree.nodes()[node].step {
        Some(Step::Test { object, .. } | Step::Shade { object } | Step::Motion { object }) => Some(object),
        _ => None,
    };
    let here = model.log.events.get(model.event).and_then(|event| match event.what {
        What::Mark(
            Decision::Nearest { object } | Decision::Occluded { object } | Decision::Attenuated { object, .. },
        ) => Some(object),
        _ => None,
    });
    Effect::Edit(here.or_else(|| model.tree.around(model.tree.owner(model.event)).find_map(of_node)))
}
