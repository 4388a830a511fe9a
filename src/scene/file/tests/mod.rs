//! What a scene file may and may not say, in many small cases around the textbook scene.

#![allow(clippy::unwrap_used)]

mod accepted;
mod damaged;
mod every_problem;
mod meaning;
mod spelling;

use super::Loaded;
use super::load::{check, parse};
use super::schema::json_schema;
use crate::files::{FileError, Severity};
use jsonschema::Validator;
use serde_json::Value;
use std::sync::LazyLock;

/// The scene of the numeric example.
const TEXTBOOK: &str = r#"{
  "format": "raywalk-scene/1",
  "name": "textbook",
  "camera": {"position": [16, 2, 7], "direction": [-12, 4, 1], "up": [0, 0, 1],
             "vertical_fov": 45, "resolution": [321, 241]},
  "ambient": [180, 160, 190],
  "background": [200, 200, 255],
  "lights": [{"name": "F", "point": {"position": [9, 12, 16]}, "color": [220, 200, 255]}],
  "materials": {
    "wall": {"ambient": [0.2, 0.3, 0.1], "diffuse": [0.7, 0.5, 0.4], "specular": [0.8, 0.6, 0.9], "shininess": 255,
             "weights": {"local": 1, "reflected": 1, "transmitted": 0}},
    "ball": {"ambient": [0.3, 0.2, 0.4], "diffuse": [0.5, 0.7, 0.9], "specular": [0.7, 0.4, 0.2], "shininess": 2,
             "weights": {"local": 1, "reflected": 1, "transmitted": 0}}
  },
  "objects": [{"name": "plane", "shape": {"plane": {"coefficients": [1, 0, 0, -4]}}, "material": "wall"},
              {"name": "sphere", "shape": {"sphere": {"center": [17, 9, 8], "radius": 3}}, "material": "ball"}],
  "tracing": {"algorithm": "recursive", "max_depth": 1, "specular": "half_vector", "sphere_method": "geometric"},
  "sampling": {"none": {}},
  "output": {"white": 255, "transfer": "linear"}
}
"#;

/// Loads a text, which the JSON Schema must accept too.
#[track_caller]
fn loads(text: &str) -> Loaded {
    if let Ok(value) = serde_json::from_str::<Value>(text.trim_start_matches('\u{feff}')) {
        let errors: Vec<String> = SCHEMA.iter_errors(&value).map(|error| error.to_string()).collect();
        assert!(errors.is_empty(), "the schema refuses what is accepted: {errors:#?}");
    }
    check(text.as_bytes(), "scenes/t.json").unwrap_or_else(|error| panic!("{}", error.report(false)))
}

static SCHEMA: LazyLock<Validator> =
    LazyLock::new(|| jsonschema::draft202012::new(&json_schema()).expect("a good schema"));

/// What the reader refuses for its form, the JSON Schema refuses. It can't see a duplicate key.
#[track_caller]
fn schema_refuses(bytes: &[u8]) {
    let Ok(value) = serde_json::from_slice::<Value>(bytes) else { return };
    let Err(error) = parse(bytes, "t") else { return };
    let is_of_form = !error.to_string().contains("occurs twice");
    assert!(!is_of_form || !SCHEMA.is_valid(&value), "the schema accepts what is refused: {error}");
}

/// The textbook scene with one part of its text replaced.
#[track_caller]
fn textbook_with(old: &str, new: &str) -> String {
    assert!(TEXTBOOK.contains(old), "the textbook scene has no {old}");
    TEXTBOOK.replacen(old, new, 1)
}

/// A scene of one object.
fn scene_of(object: &str) -> String {
    format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 9], "direction": [0, 0, -1]}}, "objects": [{object}]}}"#
    )
}

/// A scene of one shape.
fn shape(shape: &str) -> String {
    scene_of(&format!(r#"{{"name": "it", "shape": {shape}}}"#))
}

#[track_caller]
fn error_of(bytes: &[u8]) -> FileError {
    let error = check(bytes, "t").unwrap_err();
    assert_eq!(error.exit_code(), 2);
    let report = error.report(false);
    assert!(!report.chars().any(|c| c.is_control() && c != '\n'), "{report:?}");
    schema_refuses(bytes);
    error
}

/// The text is refused, and the first problem reads so, its place included.
#[track_caller]
fn refuses(text: impl AsRef<[u8]>, expected: &str) {
    let error = error_of(text.as_ref());
    let found = error.to_string();
    let first = found.lines().next().unwrap();
    assert_eq!(first, format!("t:{expected}"), "\n{}", error.report(false));
}

/// The text is refused because of the value at a path.
#[track_caller]
fn refuses_value(text: impl AsRef<[u8]>, expected: &str) {
    let found = error_of(text.as_ref()).to_string();
    let is_there = found.lines().any(|line| line.split_once(": ").unwrap().1 == expected);
    assert!(is_there, "expected {expected}\nfound {found}");
}

/// The text is accepted with this warning.
#[track_caller]
fn warns(text: &str, expected: &str) {
    let warnings: Vec<String> =
        loads(text).warnings.iter().map(|warning| warning.report(Severity::Warning, false)).collect();
    assert!(warnings.iter().any(|warning| warning.contains(expected)), "{warnings:?}");
}
