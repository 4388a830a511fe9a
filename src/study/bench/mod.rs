//! What the program measures about its own speed. Every figure is a median with its quartiles; nothing here reads or writes files.

pub mod chart;
pub mod clock;
pub mod exact;
pub mod limits;
pub mod overhead;
mod pictures;
pub mod samplers;
pub mod scaling;
pub mod spread;
pub mod throughput;

pub use spread::Spread;
