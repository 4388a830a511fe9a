//! The program's commands, the files that they read, and the pages that describe them.

// Each test program uses a part of it.
#[allow(dead_code)]
#[path = "../support/bitmap.rs"]
mod bitmap;
#[path = "../support/calls.rs"]
mod calls;
#[path = "../support/mutator.rs"]
mod mutator;
#[path = "../support/rays.rs"]
mod rays;
#[path = "../support/shared.rs"]
mod shared;
#[path = "../support/source.rs"]
mod source;
#[path = "../support/mod.rs"]
mod support;

mod bench;
mod command_line;
mod diff_command;
mod diff_damaged;
mod diff_mutations;
mod equal_luminance;
mod foreign_files;
mod gallery;
mod help;
mod layers;
mod limits;
mod log_schema;
mod manual;
mod mutations;
mod nff;
mod nff_pictures;
mod notes;
mod pictures;
mod rays_command;
mod scenes;
mod schema;
mod second_example;
mod shards;
mod stability;
mod usage;
mod worked_table;
