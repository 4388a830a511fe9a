//! What happens in a computation, as typed data. Objects and lights are numbers here; the header of the log names them.

pub(in crate::log) mod decision;
pub mod field;
pub(crate) mod question;
pub(in crate::log) mod step;
mod words;

pub use decision::Decision;
use field::Id;
pub use step::{RayKind, Step};
pub use words::{Acceptance, Asking, Miss, SkipReason, Split, Term};

use super::name::Name;
use super::value::Value;
use std::ops::Range;

/// An event of the log, in the order of the computation.
#[derive(Clone, Debug)]
pub struct Event {
    /// The number of the event in its pixel, from 1 (0 opens a pixel of a region log).
    pub at: u32,
    /// The node that the event belongs to; for [`What::Enter`] the new node itself.
    pub node: u32,
    /// What happened.
    pub what: What,
    /// Inputs that the problem states and no arithmetic rounds, used from this event on: [`Events::given`](super::Events::given) has them.
    pub given: Given,
    /// How far several perturbed runs agree on it, if there were any.
    pub digits: Option<Box<Digits>>,
}

impl Event {
    /// The one that opens a pixel of a region log.
    pub fn opening(pixel: [u32; 2]) -> Event {
        let what = What::Enter { parent: 0, step: Step::Pixel(pixel) };
        Event { at: 0, node: 0, what, given: Given::default(), digits: None }
    }

    /// The decision that it marks.
    pub fn decision(&self) -> Option<Decision> {
        match self.what {
            What::Mark(decision) => Some(decision),
            _ => None,
        }
    }

    /// The quantity that it notes, with its value.
    pub fn noted(&self) -> Option<(Name, Value)> {
        match self.what {
            What::Note { name, value } => Some((name, value)),
            _ => None,
        }
    }
}

/// Where the inputs of an event are among those of its log.
#[derive(Clone, Copy, Debug, Default)]
pub struct Given {
    start: u32,
    end: u32,
}

impl Given {
    /// Events have numbers of 32 bits, too.
    pub(super) fn of(start: usize, end: usize) -> Given {
        Given { start: start as u32, end: end as u32 }
    }

    pub(super) fn range(self) -> Range<usize> {
        self.start as usize..self.end as usize
    }
}

/// How far several runs of a computation, each perturbed in its own way, agree on what an event says.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Digits {
    /// This many significant decimal digits of each component are the same.
    Significant(Value),
    /// None: the decision isn't the same in all runs, or one before this value.
    DecisionDiffers,
}

/// What an event says.
#[derive(Clone, PartialEq, Debug)]
pub enum What {
    /// A node begins, inside the node `parent`.
    Enter {
        /// The enclosing node (0 is the pixel).
        parent: u32,
        /// What the node is.
        step: Step,
    },
    /// A named quantity was computed; the computation went on with this value.
    Note {
        /// Which quantity, by which formula.
        name: Name,
        /// Its value.
        value: Value,
    },
    /// A decision was taken.
    Mark(Decision),
    /// The node ends.
    Leave,
    /// The colour of the pixel.
    Result {
        /// Red, green, blue; linear, not clipped.
        color: [f64; 3],
    },
}

impl What {
    /// The value of a quantity, or the colour of the pixel.
    pub fn value(&self) -> Option<Value> {
        match *self {
            What::Note { value, .. } => Some(value),
            What::Result { color } => Some(Value::Triple(color)),
            What::Enter { .. } | What::Mark(_) | What::Leave => None,
        }
    }

    /// Hands on the objects and lights that it names.
    pub fn each_id(&mut self, take: &mut impl FnMut(Id)) {
        match self {
            What::Enter { step, .. } => step.each_id(take),
            What::Mark(decision) => decision.each_id(take),
            What::Note { .. } | What::Leave | What::Result { .. } => {}
        }
    }
}
