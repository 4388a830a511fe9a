//! What a quiz hides.

use super::Model;
use crate::log::What;

impl Model {
    /// Whether the quiz hides the result or the decision of an event: it is at the current step or after it and wasn't
    /// answered yet.
    pub fn hides(&self, event: usize) -> bool {
        let is_asked = || {
            let what = self.log.events.get(event).map(|event| &event.what);
            matches!(what, Some(What::Note { .. } | What::Result { .. } | What::Mark(_)))
        };
        let is_answered = || {
            let here = self.understanding.answered.get(&self.pixel());
            here.is_some_and(|answered| answered.contains(&event))
        };
        self.understanding.quiz.is_some() && event >= self.event && is_asked() && !is_answered()
    }

    /// Whether what an event is called would tell what the quiz hides: a decision is called by what was decided.
    pub fn hides_name(&self, event: usize) -> bool {
        self.hides(event) && matches!(self.log.events[event].what, What::Mark(_))
    }

    /// The last event that may be shown, where some may not.
    pub fn told(&self) -> Option<usize> {
        let current = self.event.saturating_sub(usize::from(self.hides(self.event)));
        self.understanding.quiz.map(|_| current).or(self.guide.grown)
    }

    /// Whether the quiz hides what goes into an event: it is after the current step, and its operands would tell results.
    pub fn hides_operands(&self, event: usize) -> bool {
        self.understanding.quiz.is_some() && event > self.event
    }

    /// What the status line says of the quiz.
    pub fn score(&self) -> Option<String> {
        self.understanding.quiz.map(|quiz| (self.texts().status.quiz)(quiz.right, quiz.asked))
    }
}
