//! What scene files may ask for and can't be traced.

use super::file::Finding;
use crate::files::KeyPath;

/// Something that a scene file asks for and that isn't there.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}: {}", .0.path, .0.message)]
pub struct Unsupported(Finding);

/// A mesh that nobody has read.
pub(super) fn not_loaded(object: usize) -> Unsupported {
    let path = KeyPath::default().join("objects").join(object).join("shape").join("mesh").join("path");
    Unsupported(Finding { path, message: "a mesh that was not loaded".to_owned(), is_about_key: true })
}
