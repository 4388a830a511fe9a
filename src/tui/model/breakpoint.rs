//! Where to stop: a kind of event, an object, a light, a depth, or a condition on a quantity; several of them with `and` and `or`.

mod condition;
pub mod kind;
mod parse;
mod term;
#[cfg(test)]
mod tests;
#[cfg(test)]
mod tests_compound;

pub use condition::Condition;
pub use parse::{completions, parse};

use crate::report::Style;
use crate::report::side_by_side::Run;
use std::ops::Range;

/// A place to stop.
#[derive(Clone, Debug)]
pub struct Breakpoint {
    /// What must be so.
    pub condition: Condition,
    /// How it was typed.
    pub text: String,
    /// Whether one stops there.
    pub is_on: bool,
    /// How often it has stopped a run.
    pub hits: u32,
    /// Where it stops in the log that is shown.
    pub places: Places,
}

/// The places of a breakpoint in a log, found once: a run and a frame look them up.
#[derive(Clone, Debug, Default)]
pub struct Places {
    /// The events, in order.
    events: Vec<u32>,
    /// The nodes that they belong to, in order.
    nodes: Vec<u32>,
}

impl Breakpoint {
    /// A breakpoint that is on and has stopped nothing yet.
    pub fn new(condition: Condition, text: &str) -> Breakpoint {
        Breakpoint { condition, text: text.to_owned(), is_on: true, hits: 0, places: Places::default() }
    }

    /// Looks for its places in a log.
    pub fn find(&mut self, run: Run, style: Style) {
        let count = run.log.events.len();
        let stops = (0..count).filter(|event| self.condition.stops_at(run, *event, style));
        let events: Vec<u32> = stops.map(|event| event as u32).collect();
        let mut nodes: Vec<u32> = events.iter().map(|event| run.tree.owner(*event as usize) as u32).collect();
        nodes.sort_unstable();
        nodes.dedup();
        self.places = Places { events, nodes };
    }
}

impl Places {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.events.len()
    }

    /// Whether an event is one.
    pub fn has(&self, event: usize) -> bool {
        self.events.binary_search(&(event as u32)).is_ok()
    }

    /// Whether a node has one among its own events.
    pub fn are_in(&self, node: usize) -> bool {
        self.nodes.binary_search(&(node as u32)).is_ok()
    }

    /// Those among these events, in order.
    pub fn among(&self, events: Range<usize>) -> impl DoubleEndedIterator<Item = usize> + '_ {
        let first = self.events.partition_point(|event| (*event as usize) < events.start);
        let last = self.events.partition_point(|event| (*event as usize) < events.end);
        self.events[first..last.max(first)].iter().map(|event| *event as usize)
    }
}
