//! Files as they come from outside, whatever is in them: scenes, meshes, logs, parts and pictures are opened, unpacked, recognised and
//! complained about in the same way.
//!
//! This module owns the way from a path to bytes ([`Wanted`]), what compresses them ([`Packing`]), what they are by their beginning ([`Kind`]), and
//! how a mistake in them is shown: its place ([`Source`]), its message with the line ([`Problem`]), what was perhaps meant ([`suggest`]), with
//! nothing that could drive a terminal ([`escape`]). It knows no format.

pub mod escape;

mod error;
mod gzip;
mod hidden;
mod key_path;
mod kind;
mod open;
mod packed;
mod picture_kind;
mod source;
mod suggest;
mod there;
mod zstd;

pub use error::{Excerpt, FileError, Problem, Severity, more_warnings};
pub use escape::{escape_hidden, escape_hidden_json, escape_hidden_lines};
pub use key_path::{KeyPath, Step};
pub use kind::{Kind, LogForm, PART, is_utf16};
pub use open::{Opened, Wanted, display_name, irregular};
pub use packed::{Packing, unpacked_name};
pub use picture_kind::{ImageKind, Netpbm, Notation, PictureKind};
pub use source::{Source, without_mark};
pub use suggest::{one_of, suggest, unknown};
pub use there::{is_callers_fault, is_there};
