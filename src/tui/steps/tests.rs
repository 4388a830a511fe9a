//! Stepping through every small log.

use super::*;
use crate::tui::testing::nested;

/// Every log of up to seven events that begin a node, leave one or note a value, damaged ones among them.
fn every_small_tree(check: impl Fn(&Tree, usize, &str)) {
    for length in 1..=7 {
        for mut code in 0..3_usize.pow(length) {
            let mut shape = String::new();
            for _ in 0..length {
                shape.push(['(', ')', '.'][code % 3]);
                code /= 3;
            }
            let tree = Tree::of(&nested(&shape).events);
            (0..length as usize).for_each(|event| check(&tree, event, &shape));
        }
    }
}

/// Whether a node is another one, or lies around it.
fn is_around(tree: &Tree, outer: usize, inner: usize) -> bool {
    (outer..tree.nodes()[outer].subtree_end).contains(&inner)
}

#[test]
fn into_and_back_undo_each_other() {
    every_small_tree(|tree, event, shape| {
        let next = Step::Into.from(tree, event);
        assert_eq!(next, Some(event + 1).filter(|next| *next < shape.len()));
        assert_eq!(next.and_then(|next| Step::IntoBack.from(tree, next)), next.map(|_| event));
    });
}

#[test]
fn over_and_back_undo_each_other_in_a_node() {
    every_small_tree(|tree, event, shape| {
        let node = tree.owner(event);
        let around = |other: &usize| is_around(tree, tree.owner(*other), node);
        let next = Step::Over.from(tree, event);
        assert_eq!(next, (event + 1..shape.len()).find(around), "{shape} at {event}");
        let previous = Step::OverBack.from(tree, event);
        assert_eq!(previous, (0..event).rev().find(around), "{shape} at {event}");
        for (there, back) in [(next, Step::OverBack), (previous, Step::Over)] {
            if let Some(there) = there.filter(|there| tree.owner(*there) == node) {
                assert_eq!(back.from(tree, there), Some(event), "{shape} at {event}");
            }
        }
    });
}

#[test]
fn out_leads_to_the_nearest_event_around_the_node() {
    every_small_tree(|tree, event, shape| {
        let node = tree.owner(event);
        let around = |other: &usize| tree.owner(*other) != node && is_around(tree, tree.owner(*other), node);
        let end = tree.nodes()[node].events.end;
        assert_eq!(Step::Out.from(tree, event), (end..shape.len()).find(around), "{shape} at {event}");
        let start = tree.nodes()[node].events.start;
        assert_eq!(Step::OutBack.from(tree, event), (0..start).rev().find(around), "{shape} at {event}");
    });
}
