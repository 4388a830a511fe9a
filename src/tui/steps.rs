//! Where stepping goes: the next and the previous event of a kind; into, over and out of nodes.

use crate::log::{self, Event, Tree, What};
use crate::report::language::viewer::Messages;
use std::ops::Range;

/// What one steps to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    /// Every event.
    Event,
    /// A computed value.
    Value,
    /// The beginning of a ray.
    Ray,
}

impl Stop {
    /// Whether one stops here.
    pub fn is_at(self, event: &Event) -> bool {
        match self {
            Stop::Event => true,
            Stop::Value => matches!(event.what, What::Note { .. } | What::Result { .. }),
            Stop::Ray => matches!(event.what, What::Enter { step: log::Step::Ray { .. }, .. }),
        }
    }

    /// What is said at the ends of the log.
    pub fn end(self, messages: &Messages) -> &'static str {
        match self {
            Stop::Event => messages.no_steps,
            Stop::Value => messages.no_values,
            Stop::Ray => messages.no_rays,
        }
    }
}

/// The `count`-th stop after an event, or the last there is.
pub fn after(events: &[Event], event: usize, stop: Stop, count: usize) -> Option<usize> {
    let later = (event + 1..events.len()).filter(|index| stop.is_at(&events[*index]));
    later.take(count).last()
}

/// The `count`-th stop before an event, or the first there is.
pub fn before(events: &[Event], event: usize, stop: Stop, count: usize) -> Option<usize> {
    let earlier = (0..event).rev().filter(|index| stop.is_at(&events[*index]));
    earlier.take(count).last()
}

/// A way to step by the nesting of the nodes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Step {
    Into,
    IntoBack,
    Over,
    OverBack,
    Out,
    OutBack,
}

impl Step {
    /// Where it leads from an event.
    pub fn from(self, tree: &Tree, event: usize) -> Option<usize> {
        let node = tree.owner(event);
        let around = tree.nodes()[node].parent;
        let Range { start, end } = tree.nodes()[node].events;
        match self {
            Step::Into => Some(event + 1).filter(|next| *next < tree.nodes()[0].events.end),
            Step::IntoBack => event.checked_sub(1),
            Step::Over => own_from(tree, node, event + 1),
            Step::OverBack => own_before(tree, node, event),
            Step::Out if node != 0 => own_from(tree, around, end),
            Step::OutBack if node != 0 => own_before(tree, around, start),
            Step::Out | Step::OutBack => None,
        }
    }

    /// What is said where it leads nowhere.
    pub fn end(self, messages: &Messages) -> &'static str {
        match self {
            Step::Into | Step::IntoBack => messages.no_steps,
            Step::Over | Step::OverBack => messages.no_step_over,
            Step::Out | Step::OutBack => messages.no_step_out,
        }
    }
}

/// The first event from this one on that belongs to a node itself, or else to one around it. `from` lies directly in the
/// node: it is an event of its own, or begins a node inside.
fn own_from(tree: &Tree, mut node: usize, mut from: usize) -> Option<usize> {
    loop {
        let end = tree.nodes()[node].events.end;
        while from < end {
            let owner = tree.owner(from);
            if owner == node {
                return Some(from);
            }
            from = tree.nodes()[owner].events.end;
        }
        if node == 0 {
            return None;
        }
        node = tree.nodes()[node].parent;
    }
}

/// The last event before this one that belongs to a node itself, or else to one around it.
fn own_before(tree: &Tree, mut node: usize, mut before: usize) -> Option<usize> {
    loop {
        let own = tree.own_events_before(node, before).next_back();
        if own.is_some() || node == 0 {
            return own;
        }
        before = tree.nodes()[node].events.start;
        node = tree.nodes()[node].parent;
    }
}

#[cfg(test)]
mod tests;
