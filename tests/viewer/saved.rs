//! What the viewer saves: screenshots, the log in other formats, notes.

use crate::session::Session;
use crate::support;
use raywalk::record::{self, Arithmetic};
use raywalk::report::Language;
use raywalk::tui::{self, Controls, Options, Palette, Theme, dump};
use std::fs;
use std::path::{Path, PathBuf};

/// What the program prints.
fn printed(arguments: &[&str]) -> String {
    let output = assert_cmd::Command::cargo_bin("raywalk").expect("the program").args(arguments).output();
    String::from_utf8(output.expect("it runs").stdout).expect("text in UTF-8")
}

/// A saved log of the numeric example in a folder.
fn saved_log(folder: &Path) -> PathBuf {
    let log = folder.join("pixel.ndjson");
    fs::write(&log, printed(&["trace", "textbook", "--pixel", "160,120"])).expect("a log");
    log
}

fn open(log: &Path) -> Session {
    let session = Session::start(&["walk", log.to_str().expect("a path in UTF-8")], 160, 30);
    session.shows("step 1/");
    session
}

#[track_caller]
fn leave(mut session: Session) {
    session.press("q");
    session.ends_with(0);
}

#[test]
fn the_frame_is_saved_as_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let scene = folder.path().join("scene.txt");
    fs::write(&scene, raywalk::scene::builtin::text("textbook").expect("a built-in scene")).expect("a scene");
    let mut session = open(&scene);
    let path = |name: &str| folder.path().join(name).display().to_string();
    session.press(&format!("3n:screenshot {}\r", path("frame.txt")));
    session.shows("saved as");
    let text = fs::read_to_string(path("frame.txt")).expect("a screenshot");
    assert!(text.starts_with("▶ raywalk") && text.contains("pixel 160,120") && text.lines().count() == 30, "{text}");
    assert!(!text.contains(":screenshot") && text.contains("step "), "{text}");
    session.press(&format!("4n:screenshot {}\r", path("frame.svg")));
    session.shows("frame.svg");
    assert!(fs::read_to_string(path("frame.svg")).expect("a screenshot").ends_with("</svg>\n"));
    // Again, as the frame is then.
    session.press(&format!("$:screenshot {}\r", path("frame.txt")));
    session.shows("frame.txt");
    session.press("n");
    session.shows("no more");
    assert_ne!(fs::read_to_string(path("frame.txt")).expect("a screenshot"), text);
    for (name, said) in [
        ("frame.png", "expected a name that ends in one of .svg .txt"),
        ("scene.txt", "is the input, which would be overwritten"),
        ("nowhere/frame.svg", "cannot write"),
    ] {
        session.press(&format!(":screenshot {}\r", path(name)));
        session.shows(said);
    }
    // The terminal is no place for a result.
    session.press(":write -\r");
    session.shows("expected the name of a file");
    // Tab completes names.
    session.press(&format!(":screenshot {}\t", path("scen")));
    session.shows(&format!(":screenshot {}", path("scene.txt")));
    session.press("\x03");
    session.hides(":screenshot");
    leave(session);
}

#[test]
fn the_log_is_exported_as_trace_writes_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = saved_log(folder.path());
    let log_text = log.to_str().expect("a path in UTF-8");
    for (walked, traced) in
        [(vec!["textbook"], vec!["textbook", "--pixel", "160,120"]), (vec![log_text], vec![log_text])]
    {
        let call = [&["walk", "--lang", "es", "--digits", "4"], &walked[..]].concat();
        let mut session = Session::start(&call, 160, 30);
        session.shows("paso 1/");
        for (name, format) in [
            ("a.html", "html"),
            ("a.md", "markdown"),
            ("a.tex", "latex"),
            ("a.txt", "text"),
            ("a.ndjson", "ndjson"),
            ("a.json", "json"),
            ("a.svg", "svg"),
            ("a.dot", "dot"),
            ("a.mmd", "mermaid"),
            ("a.obj", "obj"),
            ("a.PLY", "ply"),
        ] {
            let path = folder.path().join(name);
            session.press(&format!(":export {}\r", path.display()));
            session.shows(&format!("guardado como {}", path.display()));
            session.press("l");
            session.hides("guardado como");
            let call = [&["trace"], &traced[..], &["--format", format, "--lang", "es", "--digits", "4"]].concat();
            assert_eq!(fs::read_to_string(&path).expect("it was written"), printed(&call), "{name} of {walked:?}");
            session.press("h");
        }
        session.press(&format!(":export {}\r", folder.path().join("a.docx").display()));
        session.shows(".html .md .tex .txt .ndjson .json");
        leave(session);
    }
    let before = fs::read(&log).expect("the log");
    let mut session = open(&log);
    session.press(&format!(":export {log_text}\r"));
    session.shows("is the input, which would be overwritten");
    // What reads the pipe may never come.
    let pipe = folder.path().join("pipe.html");
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().expect("a program of every Unix").success());
    session.press(&format!(":export {}\r", pipe.display()));
    session.shows("expected the name of a file");
    session.press("l");
    session.hides("expected the name of a file");
    session.press(&format!(":export {}/\r", folder.path().join("b.html").display()));
    session.shows("expected the name of a file");
    session.press("l:export -\r");
    session.shows("expected a name that ends in one of .html");
    session.press("Q:export b.html\r");
    session.shows("that would tell the results");
    session.press("\x03");
    session.hides(":export");
    leave(session);
    assert_eq!(fs::read(&log).expect("the log"), before);
}

#[test]
fn notes_are_kept_beside_a_saved_log() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = saved_log(folder.path());
    let notes = folder.path().join("pixel.ndjson.bookmarks.json");
    let mut session = open(&log);
    // A bookmark without a note is nobody's business.
    session.press("ma5n:bookmark b too dark here\r");
    session.shows("bookmark b: too dark here (kept in ");
    session.press("4n:note and here\r");
    session.shows("bookmark c: and here (kept in ");
    // They were read: nothing else may be written there.
    session.press(&format!(":export {}\r", notes.display()));
    session.shows("is the input, which would be overwritten");
    leave(session);
    let kept = fs::read_to_string(&notes).expect("the notes");
    let document: serde_json::Value = serde_json::from_str(&kept).expect("JSON");
    assert_eq!(document["format"], "raywalk-bookmarks/1");
    let text = fs::read_to_string(&log).expect("the log");
    let end: serde_json::Value = serde_json::from_str(text.lines().last().expect("an end line")).expect("JSON");
    assert_eq!(document["log"], end["end"]["digest"]);
    let bookmarks = document["bookmarks"].as_array().expect("a list");
    assert_eq!(bookmarks.iter().map(|one| one["letter"].as_str()).collect::<Vec<_>>(), [Some("b"), Some("c")]);
    let step = bookmarks[0]["step"].as_u64().expect("a step");

    let mut session = open(&log);
    session.shows("2 notes from ");
    session.press("'b");
    session.shows(&format!("step {step}/"));
    session.shows("bookmark b: too dark here");
    session.press("M");
    session.shows("too dark here");
    session.press("d");
    session.shows("no bookmark b any more (kept in ");
    session.press("d");
    session.shows("no notes are left");
    assert!(!notes.exists());
    session.press("q");
    session.hides("Bookmarks");
    leave(session);
}

/// The list of bookmarks with a note, at three sizes in both languages.
#[test]
fn notes_in_the_list() {
    let mut frames = String::new();
    for (language, note) in [(Language::English, "why so dark?"), (Language::Spanish, "¿por qué tan oscuro?")] {
        for (width, height) in [(40, 12), (80, 24), (120, 40)] {
            let theme = Theme::new(Palette::None, false);
            let numbers = Default::default();
            let controls = Controls::default();
            let options = Options { theme, start: None, warning: None, note: None, numbers, language, controls };
            let log = record::pixel(&support::scene("textbook"), [160, 120], Arithmetic::Decimal(3));
            let keys = format!("5n mb 4n :note {note} <Enter> M");
            let model = tui::opened_with_keys(log, &options, None, &keys, (width, height));
            let text = dump::text(&tui::frame(&model, width, height, &theme));
            // The panes below it are those of other frames.
            let list = text.lines().filter(|line| line.contains("──") || line.contains(['▶', '?']));
            frames += &format!("{}:\n{}\n", language.code(), list.collect::<Vec<_>>().join("\n"));
        }
    }
    support::snapshots().bind(|| insta::assert_snapshot!("viewer_notes", frames));
}

/// A log that has changed is noticed, and notes find their places by their addresses.
#[test]
fn notes_find_their_places_in_a_log_that_has_changed() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = saved_log(folder.path());
    let mut session = open(&log);
    session.press("20n:note first\r");
    session.shows("first (kept in ");
    leave(session);
    let notes = folder.path().join("pixel.ndjson.bookmarks.json");
    let kept: serde_json::Value = serde_json::from_str(&fs::read_to_string(&notes).expect("notes")).expect("JSON");
    let address = kept["bookmarks"][0]["address"].as_str().expect("an address").to_owned();
    fs::write(
        &log,
        printed(&["trace", "textbook", "--pixel", "160,120", "--tests", "all", "--arithmetic", "decimal:3"]),
    )
    .expect("another log");
    let mut session = open(&log);
    session.shows("the log has changed since the notes in ");
    session.shows("1 of 1 have a place in it");
    session.press("'a");
    session.shows("bookmark a: first");
    session.press("M");
    session.shows(&address);
    session.press("q");
    session.hides("Bookmarks");
    leave(session);
}

#[test]
fn notes_that_cant_be_kept_say_why() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = saved_log(folder.path());
    let notes = folder.path().join("pixel.ndjson.bookmarks.json");
    for foreign in ["{\"format\": \"raywalk-bookmarks/2\"}", "shopping list", ""] {
        fs::write(&notes, foreign).expect("a file");
        let mut session = open(&log);
        session.shows("is no file of bookmarks of this version, and stays as it is");
        session.press(":note mine\r");
        session.shows("bookmark a: mine (only until you leave: ");
        leave(session);
        assert_eq!(fs::read_to_string(&notes).expect("it is there"), foreign);
    }
    // Another viewer has written in the meantime.
    fs::remove_file(&notes).expect("it was there");
    let (mut one, mut other) = (open(&log), open(&log));
    one.press(":note one\r");
    one.shows("one (kept in ");
    other.press(":note other\r");
    other.shows("has been changed by another program");
    leave(one);
    leave(other);
    assert!(fs::read_to_string(&notes).expect("notes").contains("\"one\""));
    // A scene has no log to keep them beside.
    let mut session = Session::start(&["walk", "textbook"], 160, 30);
    session.shows("step 1/");
    session.press(":note mine\r");
    session.shows("(only until you leave: only notes on a saved log are kept in a file, beside it)");
    leave(session);
}

#[test]
fn hostile_notes_drive_no_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let log = saved_log(folder.path());
    let notes = folder.path().join("pixel.ndjson.bookmarks.json");
    let hostile = serde_json::json!({"format": "raywalk-bookmarks/1", "log": "\u{1b}]0;owned\u{7}", "bookmarks": [
        {"letter": "a", "address": "\u{1b}[2J\t", "number": u64::MAX, "step": u64::MAX, "note": "\u{1b}[31mred\tgreen\n"},
        {"letter": "b", "address": "", "number": 0, "step": 0, "note": "x"}]});
    fs::write(&notes, hostile.to_string()).expect("a file");
    let mut session = open(&log);
    session.shows("the log has changed since the notes in ");
    session.press("M");
    session.shows("\\u{1b}[31mred\\tgreen\\n");
    session.press("q'a");
    session.shows("this log has no \\u{1b}[2J\\t");
    leave(session);
}
