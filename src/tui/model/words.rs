//! What the viewer says in its language: texts, numbers, titles, events.

use super::Model;
use crate::log::{Decision, RayKind, SkipReason, Step, Term, Value, What};
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

    /// What a decision means for its node, in a word or two, as rows of the tree have it; `None` for those that no row says.
    pub fn outcome(&self, decision: &Decision) -> Option<String> {
        let texts = &self.texts().panes.outcomes;
        let object = |object: &u32| words::plain(self.log.header.object(*object));
        Some(match decision {
            Decision::Hit => texts.hit.to_owned(),
            Decision::Miss { .. } => texts.miss.to_owned(),
            Decision::Nearest { object: nearest } => object(nearest),
            Decision::Background => texts.background.to_owned(),
            Decision::Free => texts.lit.to_owned(),
            Decision::Occluded { object: blocker } => (texts.blocked_by)(&object(blocker)),
            Decision::Attenuated { object: filter, .. } => (texts.weakened_by)(&object(filter)),
            Decision::Rejected { .. } => texts.rejected.to_owned(),
            Decision::Skipped { why: SkipReason::Behind, .. } => texts.behind.to_owned(),
            Decision::Skipped { what: Term::Shadow, .. } => texts.no_shadow_ray.to_owned(),
            Decision::DepthLimit { .. } => texts.depth_limit.to_owned(),
            Decision::TotalInternalReflection => texts.total_reflection.to_owned(),
            _ => return None,
        })
    }

    /// Whether a node is a shadow ray that nothing weakens, which no decision says: its end shows it.
    pub fn is_lit(&self, node: usize) -> bool {
        let node_events = &self.tree.nodes()[node].events;
        let is_shadow = matches!(self.tree.nodes()[node].step, Some(Step::Ray { kind: RayKind::Shadow { .. }, .. }));
        let last = self.log.events[node_events.clone()].last().map(|event| &event.what);
        is_shadow && self.facts.outcome(node).is_none() && last == Some(&What::Leave)
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
