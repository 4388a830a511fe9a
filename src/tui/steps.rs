//! Where stepping goes: the next and the previous event of a kind.

use crate::log::{Event, Step, What};

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
            Stop::Ray => matches!(event.what, What::Enter { step: Step::Ray { .. }, .. }),
        }
    }

    /// What it is called at the ends of the log.
    pub fn word(self) -> &'static str {
        match self {
            Stop::Event => "step",
            Stop::Value => "computed value",
            Stop::Ray => "ray",
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
