//! What the program measures about itself.

pub mod bench;
pub mod ladder;
mod rendered;
pub mod rounding;
pub mod stress;
pub mod textbook;
