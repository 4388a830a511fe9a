//! What a quiz hides.

use super::Model;
use crate::log::What;

/// Whether a quiz asks for this: a result or a decision.
pub fn is_asked(what: &What) -> bool {
    matches!(what, What::Note { .. } | What::Result { .. } | What::Mark(_))
}

impl Model {
    /// Whether the quiz hides the result or the decision of an event: it is at the current step or after it and wasn't
    /// answered yet.
    pub fn hides(&self, event: usize) -> bool {
        let Some(quiz) = &self.understanding.quiz else { return false };
        let is_asked = || self.log.events.get(event).is_some_and(|event| is_asked(&event.what));
        let is_answered = || quiz.pixels.get(&self.pixel()).is_some_and(|here| here.known.contains_key(&event));
        event >= self.event && is_asked() && !is_answered()
    }

    /// Whether what an event is called would tell what the quiz hides: a decision is called by what was decided.
    pub fn hides_name(&self, event: usize) -> bool {
        self.hides(event) && matches!(self.log.events[event].what, What::Mark(_))
    }

    /// The last event that may be shown, where some may not.
    pub fn told(&self) -> Option<usize> {
        let current = self.event.saturating_sub(usize::from(self.hides(self.event)));
        self.understanding.quiz.as_ref().map(|_| current).or(self.guide.grown)
    }

    /// Why what the whole pixel comes to may not be shown: a quiz asks for it, or the tree that grows hasn't come to it.
    pub fn hides_outcome(&self) -> Option<&'static str> {
        let texts = self.texts();
        match self.understanding.quiz {
            Some(_) => Some(texts.quiz.tells_results),
            None => self.guide.grown.map(|_| texts.lists.to_come.color),
        }
    }

    /// Whether the quiz hides what goes into an event: it is after the current step, and its operands would tell results.
    pub fn hides_operands(&self, event: usize) -> bool {
        self.understanding.quiz.is_some() && event > self.event
    }

    /// What the status line says of the quiz.
    pub fn score(&self) -> Option<String> {
        self.understanding.quiz.as_ref().map(|quiz| (self.texts().status.quiz)(quiz.score()))
    }
}
