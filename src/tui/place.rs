//! A place in a log that can be found again in another one: the way down to its node, and which event of the node it is.

use crate::log::{Log, Name, Step, Tree, What};
use std::mem::{Discriminant, discriminant};

/// A place, by what it is and not by its number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Each node on the way down from the root: what it is, and its index among the nodes of that kind of its parent.
    way: Vec<(Step, usize)>,
    /// The event in the node.
    event: Option<Mark>,
}

/// Which event of a node.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Mark {
    kind: Discriminant<What>,
    name: Option<Name>,
    /// How many of this kind and name come before it in the node.
    number: usize,
}

impl Place {
    /// The place of an event.
    pub fn of(log: &Log, tree: &Tree, event: usize) -> Place {
        let mut way = Vec::new();
        let mut node = tree.owner(event);
        let mark = log.events.get(event).map(|found| {
            let (kind, name) = kind(&found.what);
            let before = tree.own_events_before(node, event);
            let number = before.filter(|other| kind_at(log, *other) == Some((kind, name))).count();
            Mark { kind, name, number }
        });
        while node != 0 {
            let parent = tree.nodes()[node].parent;
            if let Some(step) = tree.nodes()[node].step {
                let before = tree.children(parent).take_while(|sibling| *sibling != node);
                way.push((step, before.filter(|sibling| is_alike(tree.nodes()[*sibling].step, step)).count()));
            }
            node = parent;
        }
        way.reverse();
        Place { way, event: mark }
    }

    /// The event at this place of a log, or the beginning of the innermost node on the way there that it has.
    pub fn found_in(&self, log: &Log, tree: &Tree) -> usize {
        let mut node = 0;
        for (step, number) in &self.way {
            let mut alike = tree.children(node).filter(|child| is_alike(tree.nodes()[*child].step, *step));
            match alike.nth(*number) {
                Some(child) => node = child,
                None => return tree.nodes()[node].events.start,
            }
        }
        let mark = self.event.as_ref();
        let found = mark.and_then(|mark| {
            let alike = tree.own_events(node).filter(|event| kind_at(log, *event) == Some((mark.kind, mark.name)));
            alike.clone().nth(mark.number)
        });
        found.unwrap_or(tree.nodes()[node].events.start)
    }
}

/// Whether two nodes are the same part of a computation: the pixel may differ, nothing else.
fn is_alike(one: Option<Step>, other: Step) -> bool {
    match (one, other) {
        (Some(Step::Pixel(_)), Step::Pixel(_)) => true,
        (one, other) => one == Some(other),
    }
}

fn kind(what: &What) -> (Discriminant<What>, Option<Name>) {
    let name = match what {
        What::Note { name, .. } => Some(*name),
        _ => None,
    };
    (discriminant(what), name)
}

fn kind_at(log: &Log, event: usize) -> Option<(Discriminant<What>, Option<Name>)> {
    log.events.get(event).map(|event| kind(&event.what))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::tui::testing::{glass, textbook};

    #[test]
    fn every_place_is_found_again() {
        for log in [textbook(), glass()] {
            let tree = Tree::of(&log.events);
            for event in 0..log.events.len() {
                assert_eq!(Place::of(&log, &tree, event).found_in(&log, &tree), event);
            }
        }
    }

    #[test]
    fn what_another_log_lacks_is_its_nearest_node() {
        let (log, other) = (glass(), textbook());
        let (tree, other_tree) = (Tree::of(&log.events), Tree::of(&other.events));
        for event in 0..log.events.len() {
            let found = Place::of(&log, &tree, event).found_in(&other, &other_tree);
            assert!(found < other.events.len());
        }
        let last = Place::of(&log, &tree, log.events.len() - 1);
        let pixel = |log: &Log, event: usize| matches!(log.events[event].what, What::Result { .. });
        assert!(pixel(&other, last.found_in(&other, &other_tree)));
    }
}
