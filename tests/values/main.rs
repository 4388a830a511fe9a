//! The logged values: formulas, digits, what may be trusted, and the files that hold them.

#[path = "../support/calls.rs"]
mod calls;
#[path = "../support/provoking_scenes.rs"]
mod provoking_scenes;
#[path = "../support/random.rs"]
mod random;
#[path = "../support/mod.rs"]
mod support;

mod diff;
mod digits;
mod foreign_logs;
mod formulas;
mod log_files;
mod log_spellings;
mod notes;
mod overflow;
mod refraction;
mod regions;
mod rounding;
mod skipped_light;
mod skips;
mod textbook;
mod trust;
mod understanding;
