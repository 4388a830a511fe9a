//! The structured log of a computation: events as typed data, their files, and the tree that they make.
//!
//! This module knows no geometry: objects and lights are numbers that the header names, and what a quantity means is found
//! in the table of [`Name`].

pub mod event;
pub(crate) mod events;
pub mod file;
pub mod formula;
pub mod header;
pub(crate) mod name;
pub mod plane;
pub(crate) mod rounding;
pub mod schema;
pub mod scope;
pub(crate) mod shard;
pub mod table;
pub mod tree;
pub(crate) mod value;
mod whole;
pub(crate) mod words;

pub use event::{
    Acceptance, Asking, Decision, Digits, Event, Given, Miss, RayKind, SkipReason, Split, Step, Term, What,
};
pub use events::{Events, Input};
pub use header::{FrameId, Header, Parameter, Subject};
pub use name::{Name, Unit};
pub use rounding::round_half_away;
pub use shard::Shard;
pub use tree::{Node, Tree};
pub use value::Value;

/// A whole log: its header and its events.
#[derive(Clone, Debug, PartialEq)]
pub struct Log {
    /// The header.
    pub header: Header,
    /// The events, in the order of the computation.
    pub events: Events,
}

impl Log {
    /// The inputs of the event at this index, in the order of the table of names.
    pub fn given(&self, event: usize) -> &[Input] {
        self.events.given(&self.events[event])
    }

    /// The value of an input of the event at this index.
    pub fn input(&self, event: usize, name: Name) -> Option<Value> {
        self.given(event).iter().find(|(given, _)| *given == name).map(|(_, value)| *value)
    }
}
