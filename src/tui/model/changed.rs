//! What a change of the scene has changed in the log that is shown.

use crate::log::{Log, Tree};
use crate::report::diff::{self, Differing, Numbering};
use crate::report::side_by_side::Run;
use std::collections::HashSet;

/// What differs from the log before.
#[derive(Clone, Debug, Default)]
pub struct Changed {
    /// The events of the new log that differ, and those that the old one didn't have.
    pub events: HashSet<usize>,
    /// The nodes that they belong to.
    pub nodes: HashSet<usize>,
    /// How many values, decisions and nodes differ, those that are gone too.
    pub count: usize,
    /// What the first of them is called.
    pub first: String,
}

impl Changed {
    /// What differs between two logs, the second with its tree.
    pub fn between(mut before: Log, log: &Log, tree: &Tree) -> Changed {
        renumber(&mut before, log);
        let tree_before = Tree::of(&before.events);
        let Differing { events, count, first } =
            diff::differing(Run { log: &before, tree: &tree_before }, Run { log, tree });
        let nodes = events.iter().map(|event| tree.owner(*event)).collect();
        Changed { events: events.into_iter().collect(), nodes, count, first: first.unwrap_or_default() }
    }
}

/// Gives the objects and lights of a log the numbers that they have in another one.
pub fn renumber(log: &mut Log, as_in: &Log) {
    let numbering = Numbering::unify(&as_in.header, &mut log.header);
    numbering.apply(&mut log.events);
}
