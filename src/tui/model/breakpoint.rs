//! Where to stop: a kind of event, an object, a light, a depth, or a condition on a quantity.

mod condition;
pub mod kind;
mod parse;
#[cfg(test)]
mod tests;

pub use condition::Condition;
pub use parse::{parse, words};

/// A place to stop.
#[derive(Clone, Debug, PartialEq)]
pub struct Breakpoint {
    /// What must be so.
    pub condition: Condition,
    /// How it was typed.
    pub text: String,
    /// Whether one stops there.
    pub is_on: bool,
}
