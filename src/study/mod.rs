//! What the program measures about itself.

pub mod textbook;
