//! What the fuzz targets do with their bytes is in `tests/support/targets/`, where the replay of the corpus finds it too.

#[path = "../../tests/support/targets/mod.rs"]
mod targets;

pub use targets::*;
