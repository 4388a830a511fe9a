//! A deterministic ray tracer whose every computed value can be walked through in the terminal.

pub mod scene;
