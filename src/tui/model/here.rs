//! The values that hold at the current step.

use super::{Model, quantity};
use crate::log::Name;
use crate::log::scope::Operand;

impl Model {
    /// The latest value of one of these quantities, which have one symbol, as a formula at the current step takes it: of the step itself, its node or
    /// those around it. What a quiz hides is no value yet.
    pub fn here(&self, names: &[Name]) -> Option<Operand> {
        let event = self.event;
        let noted = self.log.events.get(event)?.noted().filter(|(name, _)| names.contains(name) && !self.hides(event));
        match noted {
            Some((_, value)) => Some(Operand { event, value }),
            None => quantity::latest(&self.log.events, &self.tree, event, names),
        }
    }

    /// Whether the value of an event may be shown: neither a quiz nor a tree that grows hides it.
    pub fn is_told(&self, event: usize) -> bool {
        self.told().is_none_or(|told| event <= told) && !self.hides(event)
    }
}
