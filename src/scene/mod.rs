//! What is traced, and where it comes from.

pub mod file;
