//! Scenes that are refused: what every one of them has in common.

use crate::run::{Answer, answer, names_in, raywalk};
use std::fs;

/// The scene that rows spoil.
pub const TEXTBOOK: &str = include_str!("../../scenes/textbook.json");

/// The scene with one part of its text replaced.
#[track_caller]
pub fn textbook_with(old: &str, new: &str) -> String {
    assert!(TEXTBOOK.contains(old), "the textbook scene has no {old}");
    TEXTBOOK.replacen(old, new, 1)
}

/// A folder with a scene and the picture of an earlier call.
pub fn folder_with(scene: impl AsRef<[u8]>) -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("t.json"), scene).expect("written");
    fs::write(folder.path().join("old.png"), "old").expect("written");
    folder
}

/// The scene is refused wherever it is used: exit code 2, one message, no result, and the old picture stays. Gives the
/// message.
#[track_caller]
pub fn error_of(scene: impl AsRef<[u8]>) -> String {
    let folder = folder_with(scene);
    let checked = answer(&mut raywalk(folder.path(), &["scene", "check", "t.json"])).fails(2, "error: t.json:");
    let rendered = answer(&mut raywalk(folder.path(), &["render", "t.json", "-o", "old.png"])).fails(2, "");
    assert_eq!(rendered.message, checked.message);
    assert_eq!(names_in(folder.path()), ["old.png", "t.json"]);
    assert_eq!(fs::read(folder.path().join("old.png")).expect("the picture"), b"old");
    checked.message
}

/// The scene is refused, and the first problem reads so, its place included.
#[track_caller]
pub fn refuses(scene: impl AsRef<[u8]>, expected: &str) {
    let message = error_of(scene);
    let first = message.lines().next().unwrap_or_default();
    assert_eq!(first, format!("error: t.json:{expected}"), "\n{message}");
}

/// The scene is refused because of the value at a path.
#[track_caller]
pub fn refuses_value(scene: impl AsRef<[u8]>, expected: &str) {
    let message = error_of(scene);
    let mut problems = message.lines().filter_map(|line| line.strip_prefix("error: t.json:"));
    let is_there = problems.any(|problem| problem.split_once(": ").is_some_and(|(_, said)| said == expected));
    assert!(is_there, "expected {expected}\nfound {message}");
}

/// The scene is traced.
#[track_caller]
pub fn loads(scene: impl AsRef<[u8]>) -> Answer {
    let folder = folder_with(scene);
    answer(&mut raywalk(folder.path(), &["scene", "check", "t.json"])).ends_with(0)
}
