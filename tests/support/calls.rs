//! Calls of the program from the project's own folder.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

use assert_cmd::Command;

pub fn raywalk(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("raywalk").expect("the program");
    command.args(arguments).env_remove("NO_COLOR").current_dir(env!("CARGO_MANIFEST_DIR"));
    command
}

#[track_caller]
pub fn prints(arguments: &[&str]) -> String {
    let output = raywalk(arguments).output().expect("it runs");
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// The error message of a call that ends with this code and prints nothing else.
#[track_caller]
pub fn fails(code: i32, arguments: &[&str]) -> String {
    let output = raywalk(arguments).output().expect("it runs");
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(String::from_utf8_lossy(&output.stdout), "", "{arguments:?}");
    String::from_utf8(output.stderr).expect("UTF-8")
}

#[track_caller]
pub fn says(code: i32, arguments: &[&str], expected: &str) {
    let message = fails(code, arguments);
    assert!(message.contains(expected), "{arguments:?}: expected `{expected}` in: {message}");
}
