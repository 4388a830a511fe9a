//! Every problem of a text that is JSON but no scene, not only the first that the reader stops at.
//!
//! What is wrong is put right in a copy of the text, with whatever value fits, and the copy is read again, until the reader
//! comes to its end. What then follows only from a value that was put in is not reported: such values are *stand-ins*.

use serde::de::IgnoredAny;

use super::error::{Problem, SceneError};
use super::explain::{Complaint, Mistake, NoScene, describe_mistake, explain, other_format};
use super::key_path::{KeyPath, Step};
use super::load::read_scene;
use super::locate::{Place, locate, locate_repeated};
use super::schema::{FORMAT, SceneFile};
use super::source::Source;
use super::suggest::suggest;
use super::validate::limits::MAX_PROBLEMS;
use super::validate::{Finding, validate};

/// How many bytes are read again in all. Of a very large file only the first few mistakes of form are found.
const MAX_BYTES_READ_AGAIN: usize = 64 << 20;

/// How often a text is read again, whatever its size.
const MAX_ROUNDS: usize = 500;

/// All problems of a text that `read_scene` refused with `first`: of form, and of meaning as far as they don't depend on those.
pub(super) fn all_problems(source: &Source, text: &str, file_name: &str, first: &NoScene) -> SceneError {
    let is_of_form = first.error.is_data() && other_format(text).is_none();
    if !is_of_form {
        return explain(source, text, first).into();
    }
    if let Err(error) = serde_json::from_str::<IgnoredAny>(text) {
        // Where the text stops being JSON, the meaning is lost.
        let broken = NoScene { error, path: KeyPath::default() };
        return together(vec![explain(source, text, first), explain(source, text, &broken)], 0);
    }
    let mut mending = Mending { text, copy: text.to_owned(), stand_ins: Vec::new(), tried: Vec::new() };
    let mut problems = Vec::new();
    let scene = mending.run(file_name, |mistake| problems.push(describe_mistake(source, text, mistake)));
    let findings = scene.map(|scene| validate(&scene)).unwrap_or_default();
    let own: Vec<Finding> = findings.errors.into_iter().filter(|finding| !mending.makes_up(finding)).collect();
    problems.extend(super::load::place(&own, source, text));
    together(problems, findings.omitted)
}

/// The problems in the order of the file, no more than are shown.
fn together(mut problems: Vec<Problem>, mut omitted: usize) -> SceneError {
    problems.sort_by_key(|problem| problem.span.as_ref().map(|span| span.start));
    problems.dedup();
    omitted += problems.len().saturating_sub(MAX_PROBLEMS);
    problems.truncate(MAX_PROBLEMS);
    SceneError::Invalid { problems, omitted }
}

struct Mending<'t> {
    /// The text as it was given. A path leads to the same value in the copy.
    text: &'t str,
    copy: String,
    /// Where the copy holds something that the text doesn't say.
    stand_ins: Vec<KeyPath>,
    /// Where a value was replaced; another one wouldn't help.
    tried: Vec<KeyPath>,
}

impl Mending<'_> {
    /// Reads and mends until there is a scene; `None` if that can't be done. `report` gets the mistakes of the text itself.
    fn run(&mut self, file_name: &str, mut report: impl FnMut(&Mistake)) -> Option<SceneFile> {
        let rounds = (MAX_BYTES_READ_AGAIN / self.text.len().max(1)).clamp(1, MAX_ROUNDS);
        for _ in 0..=rounds {
            let refused = match read_scene(&self.copy, file_name) {
                Ok(scene) => return Some(scene),
                Err(refused) => refused,
            };
            let mistake = Mistake::of(&self.copy, &refused);
            if !self.follows_from_a_stand_in(&mistake) {
                report(&mistake);
            }
            self.mend(mistake)?;
        }
        None
    }

    fn follows_from_a_stand_in(&self, mistake: &Mistake) -> bool {
        let path = match mistake.complaint() {
            Complaint::Missing { name } => mistake.path.join(name.to_owned()),
            // What is said of an object as a whole may be due to what was put into it or taken out.
            Complaint::Other => {
                let inside = |stand_in: &KeyPath| stand_in.starts_with(&mistake.path);
                return self.is_stand_in(&mistake.path) || self.stand_ins.iter().any(inside);
            }
            _ => mistake.path.clone(),
        };
        self.is_stand_in(&path)
    }

    fn is_stand_in(&self, path: &KeyPath) -> bool {
        self.stand_ins.iter().any(|stand_in| path.starts_with(stand_in))
    }

    /// Changes the copy so that the reader comes further; `None` if there is no way.
    fn mend(&mut self, mistake: Mistake) -> Option<()> {
        let path = mistake.path.clone();
        match mistake.complaint() {
            Complaint::UnknownKey { name, valid } => {
                let place = locate(&self.copy, &path);
                match suggest(name, valid.iter().copied()) {
                    Some(meant) => self.rename(path, place, meant),
                    None => self.take_out(place),
                }
            }
            Complaint::Repeated { name } => {
                let is_at_key = matches!(path.steps().last(), Some(Step::Key(key)) if key == name);
                let path = if is_at_key { path } else { path.join(name.to_owned()) };
                self.take_out(locate_repeated(&self.copy, &path, 1))
            }
            Complaint::Missing { name } => {
                // What the reader says of `null` shows what belongs here.
                let place = locate(&self.copy, &path);
                self.stand_ins.push(path.join(name.to_owned()));
                let rest = self.copy[place.value.start + 1..].trim_start();
                let comma = if rest.starts_with('}') { "" } else { "," };
                let entry = format!("{}: null{comma}", serde_json::to_string(name).ok()?);
                self.copy.insert_str(place.value.start + 1, &entry);
                Some(())
            }
            Complaint::Length { expected, .. } | Complaint::Type { expected } => self.replace(path, expected),
            Complaint::UnknownWord { .. } | Complaint::Other => self.replace(path, ""),
        }
    }

    /// Puts a value that fits in the place of one that doesn't, or takes it out.
    fn replace(&mut self, mut path: KeyPath, expected: &str) -> Option<()> {
        let mut value = fitting(&path, expected);
        // A value that didn't help: then the one around it.
        while self.tried.contains(&path) {
            path.pop()?;
            value = fitting(&path, "");
        }
        let place = locate(&self.copy, &path);
        if place.depth != path.steps().len() || path.is_root() {
            return None;
        }
        self.stand_ins.push(path.clone());
        self.tried.push(path);
        match value {
            Some(value) => {
                self.copy.replace_range(place.value, &value);
                Some(())
            }
            None => self.take_out(place),
        }
    }

    /// Gives a misspelt key the name that was meant, unless the object has that already.
    fn rename(&mut self, mut path: KeyPath, place: Place, meant: &str) -> Option<()> {
        path.pop();
        path.push(meant.to_owned());
        let is_there = locate(&self.copy, &path).depth == path.steps().len();
        self.stand_ins.push(path);
        if is_there {
            return self.take_out(place);
        }
        self.copy.replace_range(place.key?, &format!("\"{meant}\""));
        Some(())
    }

    /// Takes a key and its value out of their object. An element stays where it is, since others are counted after it.
    fn take_out(&mut self, place: Place) -> Option<()> {
        let start = place.key?.start;
        let rest = &self.copy[place.value.end..];
        let gap = rest.len() - rest.trim_start().len();
        if rest.trim_start().starts_with(',') {
            self.copy.replace_range(start..place.value.end + gap + 1, "");
        } else {
            let before = self.copy[..start].trim_end();
            let from = before.strip_suffix(',').map_or(start, str::len);
            self.copy.replace_range(from..place.value.end, "");
        }
        Some(())
    }

    /// Whether something wrong about the mended scene may come from what was put in: into the value itself, or into one
    /// beside it that it is compared with.
    fn makes_up(&self, finding: &Finding) -> bool {
        let path = &finding.path;
        let mut keys = path.steps().iter().rev().filter_map(|step| match step {
            Step::Key(key) => Some(key.as_ref()),
            Step::Index(_) => None,
        });
        let key = keys.next().unwrap_or_default();
        self.stand_ins.iter().any(|stand_in| {
            let mut around = stand_in.clone();
            around.pop();
            let is_compared = COMPARED.contains(&key) && !around.is_root() && path.starts_with(&around);
            let is_sought_there = key == "material" && stand_in.to_string() == "materials";
            path.starts_with(stand_in) || stand_in.starts_with(path) || is_compared || is_sought_there
        })
    }
}

/// The keys whose values are checked against those of the keys beside them.
const COMPARED: [&str; 5] = ["look_at", "up", "max", "apex", "normals"];

const CAMERA: &str = r#"{"position": [0, 0, 0], "direction": [0, 0, -1]}"#;
const LIGHT: &str = r#"{"point": {"position": [0, 0, 0]}}"#;
const SHAPE: &str = r#"{"sphere": {"center": [0, 0, 0], "radius": 1}}"#;

/// A value that the reader takes at a path where it expected something else; `None` if the key had better go.
fn fitting(path: &KeyPath, expected: &str) -> Option<String> {
    let text = match path.steps() {
        [Step::Key(key)] if key == "format" => return serde_json::to_string(FORMAT).ok(),
        [Step::Key(key)] if key == "camera" => CAMERA,
        [Step::Key(key)] if key == "lights" || key == "objects" => "[]",
        [Step::Key(key), Step::Index(_)] if key == "lights" => LIGHT,
        [Step::Key(key), Step::Index(_)] if key == "objects" => return Some(format!("{{\"shape\": {SHAPE}}}")),
        [.., Step::Key(key)] if key == "shape" => SHAPE,
        _ => match expected {
            "f64" | "u32" | "u64" | "a number or an array of 3 numbers" => "1",
            "a boolean" => "true",
            "a string" | "string" => "\"\"",
            "a sequence" => "[]",
            "an object" | "a map" | "an object of materials by name" => "{}",
            _ => {
                let length = expected.strip_prefix("an array of length ")?.parse().ok()?;
                return Some(format!("[{}]", vec!["null"; length].join(", ")));
            }
        },
    };
    Some(text.to_owned())
}
