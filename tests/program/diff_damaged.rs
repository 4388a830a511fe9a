//! `raywalk diff` on logs that aren't whole, and on logs of scenes that aren't the same: what is said, and the exit code.

use crate::calls::{prints, raywalk};
use serde_json::{Value, json};
use std::fs;
use tempfile::TempDir;

/// A folder with the log of the numeric example, and others made of it.
struct Folder {
    folder: TempDir,
    whole: String,
}

impl Folder {
    fn new() -> Folder {
        let folder = tempfile::tempdir().expect("a folder");
        let whole = folder.path().join("whole.ndjson").to_str().expect("UTF-8").to_owned();
        prints(&["trace", "textbook", "--pixel", "160,120", "-o", &whole]);
        Folder { folder, whole }
    }

    fn lines(&self) -> Vec<String> {
        fs::read_to_string(&self.whole).expect("the log").lines().map(str::to_owned).collect()
    }

    fn written(&self, name: &str, lines: &[String]) -> String {
        let path = self.folder.path().join(name).to_str().expect("UTF-8").to_owned();
        fs::write(&path, lines.join("\n") + "\n").expect("written");
        path
    }

    /// The log of the numeric example with another text in its scene.
    fn of_scene(&self, name: &str, changes: &[(&str, &str)]) -> String {
        let mut scene = fs::read_to_string("scenes/textbook.json").expect("the scene");
        for (old, new) in changes {
            assert!(scene.contains(old), "{old}");
            scene = scene.replace(old, new);
        }
        let path = self.written(&format!("{name}.json"), &[scene]);
        let log = self.folder.path().join(format!("{name}.ndjson")).to_str().expect("UTF-8").to_owned();
        prints(&["trace", &path, "--pixel", "160,120", "-o", &log]);
        log
    }
}

/// What a comparison prints, what it warns of, and its exit code.
fn diff(arguments: &[&str]) -> (String, String, i32) {
    let answer = raywalk(&[&["diff"], arguments].concat()).output().expect("it runs");
    let [out, message] = [answer.stdout, answer.stderr].map(|bytes| String::from_utf8(bytes).expect("UTF-8"));
    (out, message, answer.status.code().expect("an exit code"))
}

/// The log that another program wrote: other order of keys, and what it changes in each line.
fn rewritten(lines: &[String], change: impl Fn(&mut Value)) -> Vec<String> {
    let line = |line: &String| {
        let mut value: Value = serde_json::from_str(line).expect("JSON");
        change(&mut value);
        // serde_json sorts the keys.
        value.to_string()
    };
    lines.iter().map(line).collect()
}

#[test]
fn a_log_that_is_not_whole_ends_with_2_and_its_differences_are_reported() {
    let folder = Folder::new();
    let lines = folder.lines();
    let unknown = |value: &mut Value| {
        if value["note"] == "plane.t" {
            value["note"] = json!("plane.time");
        }
    };
    let mut miscounted = lines.clone();
    miscounted.remove(20);
    let mut garbled = lines.clone();
    garbled[30] = "{\"at\":30,\"node\":".to_owned();
    let mut edited = lines.clone();
    edited[3] = edited[3].replace("-0.945", "-0.944");
    let mut one_unknown = rewritten(&lines, |line| {
        line["end"].as_object_mut().map(|end| end.remove("digest"));
    });
    one_unknown[7] = one_unknown[7].replace("\"plane.t\"", "\"plane.time\"");
    let cases = [
        ("cut", lines[..lines.len() - 1].to_vec(), "cut off"),
        ("miscounted", miscounted, "counts"),
        ("garbled", garbled, "the log is damaged"),
        ("edited", edited, "its digest fits neither"),
        ("unknown", rewritten(&lines, unknown), "its digest fits neither"),
        (
            "unknown without digest",
            rewritten(&lines, |line| {
                unknown(line);
                line["end"].as_object_mut().map(|end| end.remove("digest"));
            }),
            "values of unknown quantities were skipped, the first in line 8: `plane.time`",
        ),
        ("one unknown", one_unknown, "1 value of an unknown quantity was skipped, in line 8: `plane.time`"),
    ];
    for (name, lines, warning) in cases {
        let log = folder.written(name, &lines);
        for options in [&[][..], &["--common"], &["--brief"], &["--format", "json"]] {
            for pair in [[&folder.whole, &log], [&log, &folder.whole]] {
                let arguments = [&pair.map(String::as_str)[..], options].concat();
                let (out, message, code) = diff(&arguments);
                assert_eq!(code, 2, "{name} {options:?}: {message}");
                assert!(message.contains(warning) && message.contains("--allow-damaged"), "{name}: {message}");
                let (allowed, message, code) = diff(&[&arguments[..], &["--allow-damaged"]].concat());
                assert_eq!(allowed, out, "{name}");
                assert!(message.contains(warning) && !message.contains("error"), "{name}: {message}");
                let is_same = out.contains("none differs") || out.contains("\"same\":true");
                assert_eq!(code, i32::from(!is_same), "{name} {options:?}");
            }
        }
    }
    // What only the end of a log lacks isn't a difference.
    let cut = folder.written("cut", &lines[..lines.len() - 1]);
    let (out, _, code) = diff(&[&folder.whole, &cut, "--allow-damaged"]);
    assert!(code == 0 && out.contains("none differs"), "{out}");
}

#[test]
fn logs_of_other_programs_are_whole() {
    let folder = Folder::new();
    let bare = rewritten(&folder.lines(), |line| {
        line.as_object_mut().expect("an object").remove("form");
        line["scene"].as_object_mut().map(|scene| scene.remove("digest"));
        line["end"].as_object_mut().map(|end| end.remove("digest"));
    });
    // Reading a key of a line that hasn't it puts a null there.
    let bare: Vec<String> = bare.iter().map(|line| without_nulls(line)).collect();
    let log = folder.written("bare", &bare);
    let (out, message, code) = diff(&[&folder.whole, &log]);
    assert_eq!((code, message.as_str()), (0, ""), "{out}");
    assert!(out.contains("none differs") && !out.contains("note:"), "{out}");
    let text = prints(&["trace", &log, "--format", "text"]);
    assert_eq!(text, prints(&["trace", &folder.whole, "--format", "text"]));
    // It says what is missing, and goes on.
    let mut more = bare.clone();
    more.insert(9, r#"{"at":9,"node":1,"note":"my.own","value":"seven","given":{"my.input":[1]}}"#.to_owned());
    more.insert(9, r#"{"at":9,"node":1,"note":"my.own","value":7}"#.to_owned());
    let end = more.len() - 1;
    more[end] = format!(r#"{{"end":{{"events":{}}}}}"#, end - 1);
    more.remove(10);
    more[end - 1] = format!(r#"{{"end":{{"events":{}}}}}"#, end - 2);
    let log = folder.written("more", &more);
    for call in [&["trace", &log, "--format", "text"][..], &["walk", &log]] {
        let answer = raywalk(call).output().expect("it runs");
        let message = String::from_utf8_lossy(&answer.stderr);
        assert!(
            answer.status.success() && message.contains("1 value of an unknown quantity was skipped"),
            "{call:?}: {message}"
        );
        assert!(String::from_utf8_lossy(&answer.stdout).ends_with("result: (393.054, 311.666, 370.310)\n"), "{call:?}");
    }
}

fn without_nulls(line: &str) -> String {
    let mut value: Value = serde_json::from_str(line).expect("JSON");
    value.as_object_mut().expect("an object").retain(|_, value| !value.is_null());
    value.to_string()
}

#[test]
fn a_changed_input_of_the_scene_is_named() {
    let folder = Folder::new();
    let point = r#""point": {"position": [9, 12, 16]}"#;
    for (name, old, new, expected) in [
        ("moved", "[9, 12, 16]", "[9, 12, 17]", "lights.F.position: (9, 12, 16) → (9, 12, 17)"),
        ("kind", point, r#""directional": {"direction": [-1, 0, 0]}"#, "lights.F: point → directional"),
        ("ball", "\"radius\": 3", "\"radius\": 3.5", "objects.sphere.radius: 3 → 3.500"),
        (
            "wall",
            "\"diffuse\": [0.7,",
            "\"diffuse\": [0.6,",
            "objects.plane.material.diffuse: (0.700, 0.500, 0.400) → (0.600, 0.500, 0.400)",
        ),
        ("eye", "[16, 2, 7]", "[16, 2, 8]", "camera.position: (16, 2, 7) → (16, 2, 8)"),
        ("ambient", "[180, 160, 190]", "[180, 160, 191]", "ambient: (180, 160, 190) → (180, 160, 191)"),
        (
            "shape",
            r#""sphere": {"center": [17, 9, 8], "radius": 3}"#,
            r#""box": {"min": [14, 6, 5], "max": [20, 12, 11]}"#,
            "objects.sphere: sphere → box",
        ),
        ("renamed", r#""name": "sphere","#, r#""name": "ball","#, "objects.sphere: sphere → absent"),
        ("new name", r#""name": "sphere","#, r#""name": "ball","#, "objects.ball: absent → sphere"),
        (
            "moving",
            r#""name": "sphere","#,
            r#""name": "sphere", "motion": {"translation": [0, 0, 1]},"#,
            "objects.sphere.motion: absent → present",
        ),
        ("another light", r#""name": "F","#, r#""name": "G","#, "lights.G: absent → point"),
    ] {
        let other = folder.of_scene(name, &[(old, new)]);
        let (out, _, code) = diff(&[&folder.whole, &other]);
        assert_eq!(code, 1, "{out}");
        assert!(out.contains(&format!("  {expected}\n")), "{name}: expected `{expected}` in: {out}");
        assert!(!out.contains("nothing before it differs"), "{name}: {out}");
        if name == "renamed" {
            assert!(out.contains("the other scene has no such object"), "{out}");
        }
        let (out, _, _) = diff(&[&folder.whole, &other, "--format", "json"]);
        let document: Value = serde_json::from_str(&out).expect("JSON");
        let (input, _) = expected.split_once(": ").expect("an input");
        let changed = document["pixels"][0]["scene"].as_array().expect("a list");
        assert!(changed.iter().any(|changed| changed["input"] == input), "{changed:?}");
    }
}
