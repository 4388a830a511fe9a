//! What the program measures about itself.

pub mod rounding;
pub mod ladder;
pub mod stress;
pub mod textbook;
