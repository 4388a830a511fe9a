//! Logs as snapshots, one telling pixel of each built-in scene and rays onto what none of them shows: enough that everything that a log
//! can say is in one of them.

mod rows;

use crate::support::{self, scene_of, snapshots};
use raywalk::log::schema::{Field, Kind, MARKS, Of, STEPS};
use raywalk::log::{Log, Name, file};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{Scene, builtin};
use serde_json::{Map, Value};
use std::collections::BTreeSet;
use std::fs;

/// A log that is pinned.
pub struct Pin {
    /// Of the snapshot, after `log_`.
    name: &'static str,
    /// A built-in scene, one of `tests/support`, or none: [`BARE`].
    scene: &'static str,
    /// What is changed in it, see [`patched`].
    patch: &'static str,
    at: At,
    arithmetic: Arithmetic,
    /// What the log shows.
    why: &'static str,
}

/// What is traced.
#[derive(Clone, Copy)]
pub enum At {
    Pixel([u32; 2]),
    Middle,
    Region([u32; 4]),
    Ray([f64; 3], [f64; 3]),
}

impl Pin {
    fn log(&self) -> Log {
        let text = match self.scene {
            "" => BARE,
            "effects" => include_str!("../support/effects.json"),
            "grazed" => include_str!("../support/grazed.json"),
            "shapes" => include_str!("../support/shapes.json"),
            "touching" => include_str!("../support/touching.json"),
            name => builtin::text(name).expect("a built-in scene"),
        };
        let scene = patched(if self.scene.is_empty() { self.name } else { self.scene }, text, self.patch);
        match self.at {
            At::Pixel(pixel) => record::pixel(&scene, pixel, self.arithmetic),
            At::Middle => record::pixel(&scene, support::middle(&scene), self.arithmetic),
            At::Region(region) => record::region::bounded(&scene, region, self.arithmetic).expect("a small log"),
            At::Ray(origin, direction) => record::ray(&scene, origin.into(), direction.into(), self.arithmetic),
        }
    }
}

/// The scene that rows without one of their own put their objects into.
const BARE: &str = r#"{"format": "raywalk-scene/1", "ambient": [1, 1, 1], "objects": [],
    "camera": {"position": [0, 0, 5], "direction": [0, 0, -1], "resolution": [3, 3], "vertical_fov": 20}}"#;

/// A scene from a file with some settings changed: a key of `patch` takes the old one's place, but keys of `tracing` go into it.
fn patched(name: &str, text: &str, patch: &str) -> Scene {
    let mut scene: Map<String, Value> = serde_json::from_str(text).expect("JSON");
    let patch: Map<String, Value> = serde_json::from_str(patch).unwrap_or_else(|error| panic!("{patch}: {error}"));
    for (key, value) in patch {
        match (scene.get_mut(&key), value) {
            (Some(Value::Object(old)), Value::Object(new)) if key == "tracing" => old.extend(new),
            (_, value) => drop(scene.insert(key, value)),
        }
    }
    scene_of(Value::Object(scene).to_string().as_bytes(), name)
}

/// The lines of a log with six significant digits. What changes with every scene, version or line further up is left out: digests,
/// the numbers of events, the end; so are the ends of nodes, which the nodes of the lines around tell.
fn lines(log: &Log) -> String {
    let ndjson = String::from_utf8(file::to_ndjson(log).expect("memory can be written")).expect("UTF-8");
    let mut shown = String::new();
    let is_shown = |line: &&str| !line.ends_with(",\"leave\":{}}") && !line.starts_with("{\"end\":");
    for line in ndjson.lines().filter(is_shown) {
        let line = without_member(line, "\"at\":", ',');
        let line = without_member(&line, "\"version\":", ',');
        let line = without_member(&line, ",\"digest\":", '}');
        shown.push_str(&with_six_digits(&line));
        shown.push('\n');
    }
    shown
}

/// A line without the first member that begins with `key`, up to the next `end` (which goes too, if it is a comma).
fn without_member(line: &str, key: &str, end: char) -> String {
    let Some(from) = line.find(key) else { return line.to_owned() };
    let length = line[from..].find(end).expect("a member ends") + usize::from(end == ',');
    format!("{}{}", &line[..from], &line[from + length..])
}

/// A line of JSON with its numbers rounded to six significant digits; whole numbers stay.
fn with_six_digits(line: &str) -> String {
    let mut out = String::new();
    let (mut number, mut in_text, mut is_escaped) = (String::new(), false, false);
    for sign in line.chars() {
        let is_part = !in_text && (sign.is_ascii_digit() || matches!(sign, '-' | '+' | '.' | 'e' | 'E'));
        // The letters of true, false and null aren't numbers: a number begins with a digit or a minus.
        if is_part && (!number.is_empty() || sign == '-' || sign.is_ascii_digit()) {
            number.push(sign);
            continue;
        }
        out.push_str(&rounded(&std::mem::take(&mut number)));
        out.push(sign);
        in_text ^= sign == '"' && !is_escaped;
        is_escaped = in_text && sign == '\\' && !is_escaped;
    }
    out.push_str(&rounded(&number));
    out
}

fn rounded(number: &str) -> String {
    if !number.contains(['.', 'e', 'E']) {
        return number.to_owned();
    }
    let value: f64 = number.parse().expect("a number of JSON");
    let rounded: f64 = format!("{value:.5e}").parse().expect("a number");
    serde_json::to_string(&rounded).expect("a finite number")
}

/// The node of a pixel, which isn't among [`STEPS`].
const PIXEL: &str = "enter pixel";

/// What a line says, of what every log could say.
fn said(line: &str) -> Vec<String> {
    let line: Value = serde_json::from_str(line).unwrap_or_else(|error| panic!("{line}: {error}"));
    let mut said = Vec::new();
    if let Some(key) = line["note"].as_str() {
        said.push(quantity(key, line["form"].as_str().unwrap_or("")));
    }
    said.extend(line["given"].as_object().into_iter().flatten().map(|(key, _)| quantity(key, "")));
    for (what, kinds) in [("enter", STEPS), ("mark", MARKS)] {
        for (word, fields) in line[what].as_object().into_iter().flatten() {
            said.push(format!("{what} {word}"));
            let kind = kinds.iter().find(|kind| kind.word == word);
            for field in kind.into_iter().flat_map(|kind| kind.fields) {
                match (field.value, fields.get(field.key)) {
                    (Of::Words(_), Some(value)) => {
                        said.push(with_word(what, word, field.key, value.as_str().unwrap_or("")));
                    }
                    (_, Some(_)) if field.is_optional => said.push(with_field(what, word, field.key)),
                    _ => {}
                }
            }
        }
    }
    said
}

fn quantity(key: &str, form: &str) -> String {
    format!("{key} {form}").trim_end().to_owned()
}

fn with_word(what: &str, kind: &str, field: &str, word: &str) -> String {
    format!("{what} {kind}, {field} {word}")
}

fn with_field(what: &str, kind: &str, field: &str) -> String {
    format!("{what} {kind}, with {field}")
}

/// Everything that a log can say.
fn sayable() -> BTreeSet<String> {
    let of_kind = |what: &'static str, kind: &'static Kind| {
        let of_field = move |field: &'static Field| match field.value {
            Of::Words(words) => words().into_iter().map(|word| with_word(what, kind.word, field.key, word)).collect(),
            _ if field.is_optional => vec![with_field(what, kind.word, field.key)],
            _ => Vec::new(),
        };
        kind.fields.iter().flat_map(of_field).chain([format!("{what} {}", kind.word)])
    };
    let quantities = Name::all().map(|name| quantity(name.key(), name.form()));
    let steps = STEPS.iter().flat_map(|kind| of_kind("enter", kind));
    let marks = MARKS.iter().flat_map(|kind| of_kind("mark", kind));
    quantities.chain(steps).chain(marks).chain([PIXEL.to_owned()]).collect()
}

#[test]
fn pinned_logs() {
    for pin in rows::PINS {
        let lines = lines(&pin.log());
        assert!(lines.lines().count() <= MOST_LINES, "{}: {} lines", pin.name, lines.lines().count());
        let mut settings = snapshots();
        settings.set_description(pin.why);
        settings.bind(|| insta::assert_snapshot!(format!("log_{}", pin.name), lines));
    }
}

/// More nobody reads.
const MOST_LINES: usize = 360;

#[test]
fn everything_that_a_log_can_say_is_in_a_snapshot() {
    let mut missing = sayable();
    let mut needless = Vec::new();
    let pinned = said_in_snapshots();
    missing.retain(|what| !pinned.contains(what));
    for (what, why) in EXEMPT {
        if !missing.remove(*what) {
            needless.push((what, why));
        }
    }
    assert!(needless.is_empty(), "exempt, but no name or pinned: {needless:#?}");
    assert!(missing.is_empty(), "in no snapshot: {missing:#?}");
}

#[test]
fn every_built_in_scene_is_pinned() {
    let pinned: BTreeSet<_> = rows::PINS.iter().map(|pin| pin.scene).collect();
    let missing: Vec<_> = builtin::names().filter(|name| !pinned.contains(name)).collect();
    assert!(missing.is_empty(), "{missing:?}");
}

/// What the logs of the stored snapshots say.
fn said_in_snapshots() -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    for entry in fs::read_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots")).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|extension| extension != "snap") {
            continue;
        }
        let text = fs::read_to_string(&path).expect("a snapshot");
        let mut lines = text.lines().skip_while(|line| !line.starts_with("{\"log\":"));
        if lines.next().is_some() {
            all.extend(lines.flat_map(said));
        }
    }
    all
}

/// What no snapshot has, and why.
const EXEMPT: &[(&str, &str)] = &[
    ("box.t", FOREIGN),
    ("cone.t", FOREIGN),
    ("cylinder.t", FOREIGN),
    ("ellipsoid.t", FOREIGN),
    ("hit.geometric_normal", FOREIGN),
    ("hit.normal", FOREIGN),
    ("pattern.color", FOREIGN),
    ("pattern.point", FOREIGN),
    ("quadratic.q", FOREIGN),
    ("enter zone, what local", BOUNCES),
    ("enter zone, what shadow", BOUNCES),
    ("enter zone, what specular", BOUNCES),
    ("mark bent, what local", BOUNCES),
    ("mark bent, what shadow", BOUNCES),
    ("mark bent, what specular", BOUNCES),
    ("mark depth_limit, what local", BOUNCES),
    ("mark depth_limit, what shadow", BOUNCES),
    ("mark depth_limit, what specular", BOUNCES),
    ("mark rejected, what local", BOUNCES),
    ("mark rejected, what shadow", BOUNCES),
    ("mark rejected, what specular", BOUNCES),
    ("mark leak_guard, what local", SHADOWS),
    ("mark leak_guard, what reflected", SHADOWS),
    ("mark leak_guard, what specular", SHADOWS),
    ("mark leak_guard, what transmitted", SHADOWS),
];

const FOREIGN: &str =
    "the kernels note it with the form of its formula only; logs of other programs may have it without";
const BOUNCES: &str = "only a reflected or transmitted ray has a lobe, a depth and a side of the surface";
const SHADOWS: &str = "the local model alone lets no light leak; bounces are bent or not traced";
