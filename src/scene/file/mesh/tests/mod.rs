//! What mesh files may and may not say, in many small cases.

#![allow(clippy::unwrap_used)]

mod dialects;
mod from_scenes;
mod obj;
mod ply;

use super::{Read, parse};
use crate::files::Severity;

/// The square of two triangles, as OBJ.
const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

#[track_caller]
fn reads(bytes: impl AsRef<[u8]>, name: &str) -> Read {
    parse(bytes.as_ref(), name).unwrap_or_else(|error| panic!("{}", error.report(false)))
}

/// The file is refused in these words, its name left out.
#[track_caller]
fn refuses(bytes: impl AsRef<[u8]>, name: &str, expected: &str) {
    let error = parse(bytes.as_ref(), name).unwrap_err();
    assert_eq!(error.exit_code(), 2);
    assert_eq!(error.to_string(), format!("{name}:{expected}"), "\n{}", error.report(false));
    let report = error.report(false);
    assert!(!report.chars().any(|c| c.is_control() && c != '\n'), "{report:?}");
}

#[track_caller]
fn warns(bytes: impl AsRef<[u8]>, name: &str, expected: &[&str]) {
    let warnings: Vec<_> = reads(bytes, name)
        .warnings
        .iter()
        .map(|warning| warning.report(Severity::Warning, false).lines().next().unwrap_or_default().to_owned())
        .collect();
    assert_eq!(warnings, expected);
}

#[test]
fn other_names_are_no_meshes() {
    refuses(SQUARE, "square.stl", " unknown kind of mesh, expected a name that ends in .obj or .ply");
    refuses(SQUARE, "square", " unknown kind of mesh, expected a name that ends in .obj or .ply");
}

#[test]
fn endings_may_be_in_capitals() {
    assert_eq!(reads(SQUARE, "SQUARE.OBJ").mesh.faces.len(), 2);
    assert_eq!(reads(SQUARE, "square.obj.gz").mesh.faces.len(), 2);
    assert_eq!(reads(SQUARE, "square.obj.ZST").mesh.faces.len(), 2);
}
