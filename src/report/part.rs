//! What of a formula a log holds: factors that are 1 and terms that are 0 are absent from it, and left out where they are used.

use crate::log::formula::Operator;

/// A part of a formula.
#[derive(Clone, Copy, Debug)]
pub(super) enum Part<T> {
    /// What the log has of it.
    There(T),
    /// A factor that is absent because it is 1: it changes nothing.
    One,
    /// A term that is absent because it is 0, and so is what it multiplies; whether it is a number or a triple isn't known.
    Zero,
}

impl<T> Part<T> {
    /// What an operator makes of two parts of which one is absent; `None` where that can't be known.
    pub fn without(operator: Operator, left: Part<T>, right: Part<T>) -> Option<Part<T>> {
        use Operator::{Channelwise, Minus, Over, Plus, Power, Times};
        use Part::{One, Zero};
        match (operator, left, right) {
            (Plus, Zero, term) | (Plus | Minus, term, Zero) => Some(term),
            // An absent base is an absent term, even where its exponent is 0.
            (Times | Channelwise | Over | Power, Zero, _) | (Times | Channelwise, _, Zero) => Some(Zero),
            (Times | Channelwise, One, factor) | (Times | Channelwise | Over, factor, One) => Some(factor),
            _ => None,
        }
    }

    /// What is there of it.
    pub fn there(self) -> Option<T> {
        match self {
            Part::There(part) => Some(part),
            Part::One | Part::Zero => None,
        }
    }
}
