//! The logged values: formulas, digits, what may be trusted, and the files that hold them.

#[path = "../support/calls.rs"]
mod calls;
#[path = "../support/intervals.rs"]
mod intervals;
#[path = "../support/notations.rs"]
mod notations;
#[path = "../support/provoking_scenes.rs"]
mod provoking_scenes;
#[path = "../support/random.rs"]
mod random;
#[path = "../support/random_scenes.rs"]
mod random_scenes;
#[path = "../support/mod.rs"]
mod support;

mod adaptive_lights;
mod decisions;
mod diff;
mod digits;
mod evaluable;
mod floors;
mod foreign_logs;
mod formulas;
mod inside_solids;
mod log_files;
mod log_spellings;
mod notes;
mod overflow;
mod pinned;
mod planes;
mod read_back;
mod refraction;
mod regions;
mod rounding;
mod shadow_shafts;
mod skipped_light;
mod skips;
mod textbook;
mod totals;
mod trust;
mod understanding;
