//! The scene file `raywalk-scene/1`: reading it, checking it and printing it; and scenes of another format, [`nff`].
//!
//! This module owns the JSON form of a scene ([`schema`]), the way from bytes to a checked [`SceneFile`] ([`read`]), and
//! every sentence that says what is wrong with a scene and where. It must not know how a scene
//! is traced: no geometry, no cameras, only the numbers as they are written.
//!
//! ```
//! let text = br#"{"format": "raywalk-scene/1", "camera": {"position": [0, 0, 5], "direction": [0, 0, -1]}, "objects": []}"#;
//! let loaded = raywalk::scene::file::check(text, "empty.json").map_err(|error| error.report(false));
//! assert_eq!(loaded.map(|loaded| loaded.scene.name), Ok("empty".to_string()));
//! ```

pub mod mesh;
pub mod nff;
pub mod raw;
pub mod schema;
pub mod validate;

pub(crate) mod converted;
mod foreign;
mod form;
mod load;
mod locate;
mod mesh_path;
mod names;
mod part;
mod print;
mod strict;
mod syntax;
#[cfg(test)]
mod tests;
mod walk;

pub use load::{MAX_BYTES, check, check_as, check_scene, open, parse, placed, read, read_bytes};
pub use locate::{Place, locate, locate_all};
pub use mesh_path::{MeshPathError, resolve_mesh_path};
pub use schema::SceneFile;
pub use validate::{Finding, Findings, validate};

use crate::files::Problem;

/// A scene that may be traced.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    /// The scene, every name filled in.
    pub scene: SceneFile,
    /// What is odd about it but does not stop anybody.
    pub warnings: Vec<Problem>,
    /// How many more warnings there are.
    pub more_warnings: usize,
}
