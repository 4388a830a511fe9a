//! The probe that keeps the log.

use super::{Probe, Quantity};
use crate::log::{Decision, Event, Name, Step, Value, What};

/// Keeps every event of the computation.
#[derive(Clone, Debug, Default)]
pub struct Recorder {
    events: Vec<Event>,
    given: Vec<(Name, Value)>,
    nodes: u32,
    open: Vec<u32>,
}

impl Recorder {
    /// The events so far.
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// Ends the computation of a pixel with its colour and gives its events.
    pub fn finish(mut self, color: [f64; 3]) -> Vec<Event> {
        self.push(0, What::Result { color });
        self.events
    }

    fn here(&self) -> u32 {
        self.open.last().copied().unwrap_or(0)
    }

    fn push(&mut self, node: u32, what: What) {
        let at = self.events.len() as u32 + 1;
        self.events.push(Event { at, node, what, given: std::mem::take(&mut self.given) });
    }
}

impl Probe for Recorder {
    fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        self.given.push((name, value.value()));
    }

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        self.push(self.here(), What::Note { name, value: value.value() });
        value
    }

    fn mark(&mut self, decision: Decision) {
        self.push(self.here(), What::Mark(decision));
    }

    fn enter(&mut self, step: Step) {
        let parent = self.here();
        self.nodes += 1;
        self.open.push(self.nodes);
        self.push(self.nodes, What::Enter { parent, step });
    }

    fn leave(&mut self) {
        self.push(self.here(), What::Leave);
        self.open.pop();
    }
}
