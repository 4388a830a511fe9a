//! raywalk: a deterministic ray tracer whose every computed value can be walked through in the terminal.
//!
//! Start reading at [`trace`], the recursion; [`probe`] is what sees its values, [`log`] is what they are recorded in.

pub mod geometry;
pub mod log;
pub mod probe;
pub mod random;
pub mod record;
pub mod render;
pub mod report;
pub mod sampling;
pub mod scene;
pub mod study;
pub mod threads;
pub mod trace;
pub mod tui;
