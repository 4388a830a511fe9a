//! The scene file `raywalk-scene/1`: reading it, checking it and printing it; and scenes of another format, [`nff`].
//!
//! This module owns the JSON form of a scene ([`schema`]), the way from bytes to a checked [`SceneFile`] ([`read`]), and
//! every sentence that says what is wrong with a file and where ([`SceneError`]). It must not know how a scene
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

pub mod converted;
mod error;
mod escape;
mod foreign;
mod form;
mod gzip;
mod input;
mod key_path;
mod load;
mod locate;
mod mesh_path;
mod names;
mod packed;
mod part;
mod print;
mod scan;
mod source;
mod strict;
mod suggest;
mod syntax;
#[cfg(test)]
mod tests;
mod there;
mod zstd;

pub use error::{Problem, SceneError, Severity, more_warnings};
pub use escape::{escape_hidden, escape_hidden_json, escape_hidden_lines};
pub use input::{MAX_BYTES, Opened, Wanted, open, read_bytes};
pub use key_path::{KeyPath, Step};
pub use load::{Loaded, check, check_as, check_scene, parse, placed, read};
pub use locate::{Place, locate, locate_all};
pub use mesh_path::{MeshPathError, resolve_mesh_path};
pub use packed::{Packing, unpacked_name};
pub use schema::SceneFile;
pub use source::{Excerpt, Source};
pub use suggest::suggest;
pub use there::{is_callers_fault, is_there};
pub use validate::{Finding, Findings, validate};
