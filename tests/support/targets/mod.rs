//! What is done with bytes from outside to find out whether they do harm: one function a reader.
//!
//! Each takes any bytes. It panics if the program does something with them that it must never do: read what it has
//! written as something else, tell of a mistake with what would drive a terminal, compute what is no number. The fuzz
//! targets in `fuzz/` call these functions with what a fuzzer makes up, `tests/bad_input/corpus.rs` with the files of
//! `fuzz/corpus/`, so that what is replayed is what was fuzzed.

// Each fuzz target compiles this for itself and uses a part of it.
#![allow(dead_code)]

mod files;
mod logs;
mod meshes;
mod scenes;

pub use files::{packed, picture};
pub use logs::log;
pub use meshes::{obj, ply};
pub use scenes::{nff, scene};

use raywalk::files::FileError;

/// A target: its name, which is that of its folder in the corpus, and what it does.
pub type Target = (&'static str, fn(&[u8]));

/// All of them.
pub const TARGETS: [Target; 7] = [
    ("scene", scene),
    ("nff", nff),
    ("obj", obj),
    ("ply", ply),
    ("log", log),
    ("packed", packed),
    ("picture", picture),
];

/// The message is about the input, short, and holds nothing that would do something to a terminal.
fn is_a_message(error: &FileError) {
    assert_eq!(error.exit_code(), 2, "{error}");
    is_short(&error.report(false), 20_000);
}

fn is_short(message: &str, most: usize) {
    assert!(message.len() < most, "{} bytes of a message", message.len());
    assert!(!message.chars().any(|c| c.is_control() && c != '\n'), "{message:?}");
}
