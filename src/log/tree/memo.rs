//! What nodes deep in a tree see in the nodes around them: asked for once every few levels, and remembered there. So it doesn't take
//! the longer, the deeper a node lies.

use super::Tree;
use crate::log::name::Name;
use std::collections::{HashMap, HashSet};
use std::sync::{LazyLock, Mutex, PoisonError};

/// From one level at which it is remembered to the next.
const LEVELS: usize = 16;

/// What was seen so far.
#[derive(Debug, Default)]
pub(in crate::log) struct Memo {
    /// The nodes at which it is remembered: those at such a level that have nodes so far below them again, so that a wide tree doesn't have many.
    stations: HashSet<usize>,
    /// By node, symbol and whether inputs count, the event that has the symbol in the nodes around.
    seen: Mutex<HashMap<(u32, u16, bool), Option<u32>>>,
}

impl Clone for Memo {
    fn clone(&self) -> Memo {
        Memo { stations: self.stations.clone(), seen: Mutex::default() }
    }
}

/// The numbers of the symbols.
static SYMBOLS: LazyLock<HashMap<&'static str, u16>> = LazyLock::new(|| {
    let mut numbers = HashMap::new();
    for name in Name::all() {
        let next = numbers.len() as u16;
        numbers.entry(name.symbol()).or_insert(next);
    }
    numbers
});

impl Memo {
    /// That of a tree of which nothing was asked yet.
    pub(super) fn of(tree: &Tree) -> Memo {
        let nodes = tree.nodes();
        let mut memo = Memo::default();
        if nodes.iter().all(|node| node.level < 2 * LEVELS) {
            return memo;
        }
        // The deepest level inside each node, from the last node on.
        let mut deepest: Vec<u32> = nodes.iter().map(|node| node.level as u32).collect();
        for node in (1..nodes.len()).rev() {
            let parent = nodes[node].parent;
            deepest[parent] = deepest[parent].max(deepest[node]);
            let level = nodes[node].level;
            if level.is_multiple_of(LEVELS) && deepest[node] as usize >= level + LEVELS {
                memo.stations.insert(node);
            }
        }
        memo
    }

    /// Whether it is remembered here.
    pub(in crate::log) fn has(&self, node: usize) -> bool {
        !self.stations.is_empty() && self.stations.contains(&node)
    }

    /// The event with a symbol in the nodes around this one, if that is known.
    pub(in crate::log) fn known(&self, node: usize, symbol: &str, with_inputs: bool) -> Option<Option<usize>> {
        let key = (node as u32, *SYMBOLS.get(symbol)?, with_inputs);
        let seen = self.seen.lock().unwrap_or_else(PoisonError::into_inner);
        seen.get(&key).map(|event| event.map(|event| event as usize))
    }

    /// Remembers it for nodes on the way to it.
    pub(in crate::log) fn remember(&self, nodes: &[usize], symbol: &str, with_inputs: bool, event: Option<usize>) {
        let Some(number) = SYMBOLS.get(symbol).filter(|_| !nodes.is_empty()) else { return };
        let mut seen = self.seen.lock().unwrap_or_else(PoisonError::into_inner);
        seen.extend(nodes.iter().map(|node| ((*node as u32, *number, with_inputs), event.map(|event| event as u32))));
    }
}
