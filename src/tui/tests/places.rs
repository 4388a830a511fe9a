//! Places are found again, in their own log and in others.

use crate::log::tree::Place;
use crate::log::{Log, Tree, What};
use crate::tui::testing::{glass, textbook};

#[test]
fn every_place_is_found_again() {
    for log in [textbook(), glass()] {
        let tree = Tree::of(&log.events);
        for event in 0..log.events.len() {
            let place = Place::of(&log, &tree, event);
            assert_eq!(place.find(&log, &tree), Ok(event));
            assert_eq!(place.find_on_any_object(&log, &tree), Some(event));
        }
    }
}

#[test]
fn what_another_log_lacks_is_its_nearest_node() {
    let (log, other) = (glass(), textbook());
    let (tree, other_tree) = (Tree::of(&log.events), Tree::of(&other.events));
    for event in 0..log.events.len() {
        let (Ok(found) | Err(found)) = Place::of(&log, &tree, event).find(&other, &other_tree);
        assert!(found < other.events.len());
    }
    let last = Place::of(&log, &tree, log.events.len() - 1);
    let pixel = |log: &Log, event: usize| matches!(log.events[event].what, What::Result { .. });
    assert!(last.find(&other, &other_tree).is_ok_and(|found| pixel(&other, found)));
}
