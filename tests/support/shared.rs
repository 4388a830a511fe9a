//! What lies beside the repository and is no part of it: data of others that some tests compare with.

use std::io::Write;
use std::path::{Path, PathBuf};

/// A part of the folder `shared` beside the repository (or where `RAYWALK_SHARED` says); says so where it is absent.
pub fn shared(part: &str) -> Option<PathBuf> {
    let named = std::env::var_os("RAYWALK_SHARED").map(PathBuf::from);
    let folder = named.unwrap_or_else(|| Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared"));
    let place = folder.join(part);
    if place.exists() {
        return Some(place);
    }
    skipped(&format!("there is no {}", place.display()));
    None
}

/// Says that a test is skipped: straight to the terminal, past the harness, which hides what passing tests print.
pub fn skipped(why: &str) {
    let _ = writeln!(std::io::stderr(), "skipped: {why}");
}
