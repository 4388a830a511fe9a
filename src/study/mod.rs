//! What the program measures about itself.

pub mod stress;
pub mod textbook;
