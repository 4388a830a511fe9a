//! The scene changed while one looks: by `:set`, by its file, by an editor. Keys are pressed once the viewer is there: before, the terminal
//! itself would change them.

use crate::session::Session;
use raywalk::log::Log;
use raywalk::record::{self, Arithmetic};
use raywalk::report::Language;
use raywalk::report::Style;
use raywalk::scene::file;
use raywalk::scene::{build, builtin};
use std::fs;
use std::path::Path;

/// The text of the numeric example with another radius of its sphere.
fn textbook(radius: &str) -> String {
    let text = builtin::text("textbook").expect("a built-in scene");
    assert!(text.contains("\"radius\": 3"));
    text.replace("\"radius\": 3", &format!("\"radius\": {radius}"))
}

fn log_of(text: &str) -> Log {
    let scene = file::check(text.as_bytes(), "test").expect("a scene").scene;
    record::pixel(&build(&scene, &Default::default()).expect("a scene that can be traced"), [160, 120], Arithmetic::F64)
}

/// The colour of the middle pixel as the viewer shows it.
fn color(radius: &str) -> String {
    let log = log_of(&textbook(radius));
    let result = log.events.iter().rev().find_map(|event| event.what.value()).expect("a result");
    Language::English.value(&result, Style::of(&log.header, 3))
}

#[test]
fn a_value_is_set_compared_and_taken_back() {
    let folder = tempfile::tempdir().expect("a folder");
    let saved = folder.path().join("saved.json");
    let mut session = Session::start(&["walk", "textbook"], 110, 30);
    session.shows("step 1/");
    session.press("$");
    session.shows(&color("3"));
    session.press(":set objects.sph\tra\t");
    session.shows("objects.sphere.shape.sphere.radius = 3");
    session.press("2.5\r");
    session.shows(&color("2.5"));
    session.shows("≠");
    session.press(":compare\r");
    session.shows("textbook - before");
    session.shows("textbook - now");
    session.press("q");
    session.hides("textbook - before");
    session.press(&format!(":write {}\r", saved.display()));
    session.shows("saved as");
    session.press(":undo\r");
    session.shows(&color("3"));
    session.press(":undo\r");
    session.shows("the scene is as it was read");
    session.press("q");
    session.ends_with(0);
    let saved = fs::read_to_string(saved).expect("the scene that was saved");
    assert_eq!(log_of(&saved).events, log_of(&textbook("2.5")).events);
}

#[test]
fn what_cant_be_set_changes_nothing() {
    let mut session = Session::start(&["walk", "textbook"], 130, 30);
    session.shows("step 1/");
    session.press("$");
    for (line, said) in [
        ("set objects.ball.shape.sphere.radius 2", "no `objects.ball`; there is plane, sphere"),
        ("set objects.sphere.shape.sphere.radius -2", "objects[1].shape.sphere.radius:"),
        ("set objects.sphere.shape.sphere.radus 2", "radus"),
        ("set", "expected a path and a value"),
        ("arithmetic decimal", "expected"),
        ("algorithm kajiya", "unknown algorithm"),
        ("depth -1", "expected a whole number from 0"),
        ("sampling lots", "unknown"),
        ("write", "expected :write FILE"),
        ("compare", "the scene is as it was read"),
    ] {
        session.press(&format!(":{line}\r"));
        session.shows(said);
        session.press("\x1b");
        session.hides(said);
        session.shows(&color("3"));
    }
    session.press("q");
    session.ends_with(0);
}

#[test]
fn options_of_the_tracing_are_commands() {
    let mut session = Session::start(&["walk", "textbook"], 110, 30);
    session.shows("step 1/");
    session.press("$");
    session.shows(&color("3"));
    session.press(":arithmetic decimal:3\r");
    // What the notes have by hand, but for the book's own slips.
    session.shows("(394.134, 312.306, 370.850)");
    session.press(":undo\r");
    session.shows(&color("3"));
    session.press(":depth 0\r");
    session.shows("difference");
    session.press("q");
    session.ends_with(0);
}

#[test]
fn a_file_that_changes_is_traced_anew() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("scene.json");
    let write = |text: &str| fs::write(&path, text).expect("a scene");
    write(&textbook("3"));
    let mut session = Session::start(&["walk", &path.to_string_lossy()], 110, 30);
    session.shows("step 1/");
    session.press("$");
    session.shows(&color("3"));
    write(&textbook("2.75"));
    session.shows("reloaded:");
    session.shows(&color("2.75"));
    write(&textbook("\"three\""));
    session.shows("not reloaded:");
    session.shows("radius");
    session.shows(&color("2.75"));
    write(&textbook("2.5"));
    session.shows(&color("2.5"));
    session.press("q");
    session.ends_with(0);
}

#[test]
fn the_editor_opens_where_the_object_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let (path, told) = (folder.path().join("scene.json"), folder.path().join("told"));
    fs::write(&path, textbook("3")).expect("a scene");
    let editor = folder.path().join("editor");
    let script =
        format!("#!/bin/sh\necho \"$@\" > {}\nsed -i 's/\"radius\": 3/\"radius\": 2.5/' \"$3\"\n", told.display());
    fs::write(&editor, script).expect("an editor");
    let editor = format!("EDITOR=sh {} -o", editor.display());
    let program = env!("CARGO_BIN_EXE_raywalk");
    let path_text = path.to_string_lossy();
    let mut session =
        Session::of(Path::new("env").as_os_str(), &["-u", "VISUAL", &editor, program, "walk", &path_text], 110, 30);
    session.shows("step 1/");
    session.press(":break object sphere\rr");
    session.shows("stopped by object sphere");
    session.press("\x05");
    session.shows("reloaded:");
    session.press("$");
    session.shows(&color("2.5"));
    session.is_taken(true);
    session.press("q");
    session.ends_with(0);
    let line =
        1 + textbook("3").lines().position(|line| line.contains("\"name\": \"sphere\"")).expect("the sphere's line");
    assert_eq!(fs::read_to_string(told).expect("what the editor was told").trim(), format!("-o +{line} {path_text}"));
}

#[test]
fn a_built_in_scene_has_no_file_to_edit() {
    let mut session = Session::start(&["walk", "textbook"], 110, 30);
    session.shows("step 1/");
    session.press(":edit\r");
    session.shows("this scene has no file of its own to edit");
    session.press("q");
    session.ends_with(0);
}
