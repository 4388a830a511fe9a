//! What the viewer says in its language: texts, numbers, titles, events.

use super::Model;
use crate::log::{Decision, Value, What};
use crate::report::language::viewer::Viewer;
use crate::report::words;
use crate::tui::text::with_counted;

impl Model {
    /// The viewer's texts.
    pub fn texts(&self) -> &'static Viewer {
        &self.language.texts().viewer
    }

    /// A value as it is shown.
    pub fn value(&self, value: &Value) -> String {
        self.language.value(value, self.numbers)
    }

    /// A colour as it is shown.
    pub fn color(&self, color: [f64; 3]) -> String {
        self.value(&Value::Triple(color))
    }

    /// What a node is; repeated steps of a ray's path are counted.
    pub fn title(&self, node: usize) -> String {
        let title = words::title(self.language, &self.log, &self.tree, node);
        match self.tree.ray(node) {
            Some(_) => with_counted(&title, &self.tree.shown_path(node)),
            None => title,
        }
    }

    /// A decision as a sentence.
    pub fn decision(&self, decision: &Decision) -> String {
        words::decision(self.language, &self.log.header, decision, self.numbers)
    }

    /// What an event says, such as `N·L = 0.300`, as far as it may be shown: for lists and messages.
    pub fn describe(&self, event: usize) -> String {
        let (panes, what) = (&self.texts().panes, self.log.events.get(event).map(|event| &event.what));
        if self.hides(event) {
            return match what {
                Some(What::Note { name, .. }) => format!("{} = ?", name.symbol()),
                Some(What::Mark(_)) => panes.hidden_decision.to_owned(),
                _ => panes.hidden_result.to_owned(),
            };
        }
        if !self.guide.is_known(event) {
            return panes.not_computed.to_owned();
        }
        let title = || self.title(self.tree.owner(event));
        match what {
            Some(What::Note { name, value }) => format!("{} = {}", name.symbol(), self.value(value)),
            Some(What::Mark(decision)) => self.decision(decision),
            Some(What::Enter { .. }) => title(),
            Some(What::Leave) => (panes.end_of)(&title()),
            Some(What::Result { color }) => (panes.result)(&self.color(*color)),
            None => String::new(),
        }
    }
}
