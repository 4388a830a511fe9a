//! What happens in a computation, as typed data. Objects and lights are numbers here; the header of the log names them.

pub(in crate::log) mod decision;
pub mod field;
mod words;

pub use decision::Decision;
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

/// What a node of the computation is.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Step {
    /// A pixel (opens the pixels of a region log).
    Pixel([u32; 2]),
    /// One sample of a pixel that takes several.
    Sample {
        /// Its number, from 1.
        number: u32,
    },
    /// A ray with everything that it brings.
    Ray {
        /// What the ray is for.
        kind: RayKind,
        /// Its level in the ray tree; the camera's ray has 0. A shadow ray has its surface's.
        depth: u32,
        /// Its number, from 1, among several of its kind from one place; 0 if it is alone.
        split: u32,
    },
    /// How a moving object is tested: the ray in the object's own frame, with the tests there, or the hit carried back from it.
    Motion {
        /// The object.
        object: u32,
    },
    /// An intersection test of the enclosing ray with an object.
    Test {
        /// The object.
        object: u32,
        /// The triangle, for a mesh.
        triangle: Option<u32>,
    },
    /// The local model at the hit of the enclosing ray.
    Shade {
        /// The object that was hit.
        object: u32,
    },
    /// What one light adds to the local model.
    Light {
        /// The light.
        light: u32,
        /// Of several points of an area light, its number from 1; 0 if there is one.
        split: u32,
    },
    /// A zone of the lobe about a blurred bounce: a direction in it, and what comes from there.
    Zone {
        /// Which bounce.
        what: Term,
        /// Its number, from 1.
        number: u32,
    },
    /// The weighted sum of the three contributions.
    Combine,
}

/// What a ray is for.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RayKind {
    /// From the eye through the picture.
    Camera,
    /// From a surface toward the light with this number.
    Shadow {
        /// The light, from 0.
        light: u32,
    },
    /// Mirrored at a surface.
    Reflected,
    /// Refracted through a surface.
    Transmitted,
}

impl RayKind {
    /// The word that stands for the kind in a log.
    pub fn word(self) -> &'static str {
        match self {
            RayKind::Camera => "camera",
            RayKind::Shadow { .. } => "shadow",
            RayKind::Reflected => "reflected",
            RayKind::Transmitted => "transmitted",
        }
    }

    /// The letter of the kind in a path such as `C R T S1`.
    pub fn letter(self) -> char {
        match self {
            RayKind::Camera => 'C',
            RayKind::Shadow { .. } => 'S',
            RayKind::Reflected => 'R',
            RayKind::Transmitted => 'T',
        }
    }
}
