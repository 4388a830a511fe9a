//! The catalogue of bad inputs, run on the command line: each row is a test whose name begins with the row's id.
//!
//! Whatever is wrong, the program ends with the exit code that the row names and one message that says where; it takes
//! at most 2 s and 256 MiB, never panics, and leaves no half of a result. [`run`] checks the limits in every call.

#![cfg(unix)]

#[path = "../support/mutator.rs"]
mod mutator;
#[path = "../support/shared.rs"]
mod shared;
#[path = "../support/targets/mod.rs"]
mod targets;

mod run;
mod scenes;

mod catalogue;

mod corpus;
mod doubled;
mod grown;
mod inputs;
mod little_memory;
mod logs;
mod machine;
mod memory;
mod meshes;
mod numbers;
mod obj;
mod output;
mod pictures;
mod resume;
mod signals;
mod streams;
mod text;
mod threads;
