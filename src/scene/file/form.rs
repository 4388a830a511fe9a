//! Every problem of a text that the reader of scenes refused, not only the first.
//!
//! The text is walked along the JSON Schema of scenes, which is derived from the types that the reader is derived from. On the way what is
//! wrong is put right in a copy, with whatever value fits, so that the copy can be read and validated, too. What then follows only from a value
//! that was put in is not reported: such values are *stand-ins*.

use std::ops::Range;
use std::sync::LazyLock;

use serde::Deserialize;

use super::locate::{Place, locate, locate_all};
use super::names::fill_in_names;
use super::part::Part;
use super::schema::{FORMAT, SceneFile, inlined_schema};
use super::strict::Strict;
use super::syntax::Broken;
use super::validate::limits::MAX_PROBLEMS;
use super::validate::{Finding, unknown_format, validate};
use super::walk::{MAX_MISTAKES, Mistake, Walk};
use crate::files::{FileError, KeyPath, Source, Step};

/// What a scene may be.
static SCHEMA: LazyLock<Part> =
    LazyLock::new(|| serde_json::from_value(inlined_schema()).expect("the schema of scenes consists of such parts"));

/// Reads a scene, or says everything that is wrong with it.
pub(super) fn scene_in(source: &Source, text: &str) -> Result<SceneFile, FileError> {
    read_scene(text, source.name).map_err(|refused| all_problems(source, text, source.name, &refused))
}

/// Reads a scene; of the error only the place and sentences of our own are of use.
fn read_scene(text: &str, file_name: &str) -> serde_json::Result<SceneFile> {
    let mut json = serde_json::Deserializer::from_str(text);
    let mut scene = SceneFile::deserialize(Strict(&mut json))?;
    json.end()?;
    fill_in_names(&mut scene, file_name);
    Ok(scene)
}

/// All problems of a text that `read_scene` refused: of form, and of meaning as far as they don't depend on those.
fn all_problems(source: &Source, text: &str, file_name: &str, refused: &serde_json::Error) -> FileError {
    let limit = limit_of_reader(text, refused);
    if !limit.path.is_root() {
        // There is too much of it to be walked along.
        return together(source, vec![limit], 0);
    }
    let mut walk = Walk::new(text, limit.span.start);
    match walk.value(&SCHEMA).and_then(|()| walk.reader.end()) {
        // Where the text stops being JSON, the meaning is lost.
        Err(Broken { span, message }) => {
            let path = walk.path.clone();
            walk.mistakes.push(Mistake { span, path, message });
        }
        Ok(()) => match read_scene(&walk.mended, file_name) {
            Ok(scene) if scene.format != FORMAT => return together(source, vec![other_format(text, &scene.format)], 0),
            Ok(scene) if walk.mistakes.len() < MAX_MISTAKES => {
                let findings = validate(&scene);
                walk.omitted += findings.omitted;
                walk.judge(findings.errors);
            }
            _ => {}
        },
    }
    if walk.mistakes.is_empty() {
        walk.mistakes.push(limit);
    }
    together(source, walk.mistakes, walk.omitted)
}

/// The problems in the order of the file, no more than are shown.
fn together(source: &Source, mut mistakes: Vec<Mistake>, mut omitted: usize) -> FileError {
    mistakes.sort_by_key(|mistake| mistake.span.start);
    mistakes.dedup();
    omitted += mistakes.len().saturating_sub(MAX_PROBLEMS);
    mistakes.truncate(MAX_PROBLEMS);
    let placed = mistakes.into_iter().map(|Mistake { span, path, message }| source.problem(span, path, message));
    FileError::Invalid { problems: placed.collect(), omitted }
}

/// What the reader refuses because there is more than it has room for, and how its sentence about it begins.
const LIMITED: [(&str, &str); 3] =
    [("objects", "names must be unique"), ("lights", "too many lights"), ("materials", "too many materials")];

/// What the reader refuses in a sentence of its own.
fn limit_of_reader(text: &str, error: &serde_json::Error) -> Mistake {
    let (line, column) = (error.line(), error.column());
    let mut message = error.to_string();
    message.truncate(message.strip_suffix(&format!(" at line {line} column {column}")).map_or(message.len(), str::len));
    let mut ends = memchr::memchr_iter(b'\n', text.as_bytes());
    let before = line.checked_sub(2).and_then(|lines| ends.nth(lines)).map_or(0, |end| end + 1);
    let at = (before + column.saturating_sub(1)).min(text.len());
    let list = LIMITED.iter().find(|(_, begins)| message.starts_with(begins));
    let path = list.map_or_else(KeyPath::default, |(list, _)| KeyPath::default().join(*list));
    Mistake { span: at..at, path, message }
}

/// Where in a text these findings are.
pub(super) fn spans(findings: &[Finding], text: &str) -> Vec<Range<usize>> {
    if findings.is_empty() {
        return Vec::new();
    }
    let paths: Vec<KeyPath> = findings.iter().map(|finding| finding.path.clone()).collect();
    let places = findings.iter().zip(locate_all(text, &paths));
    let span = |(finding, Place { key, value, .. }): (&Finding, Place)| match key {
        Some(key) if finding.is_about_key => key,
        _ => value,
    };
    places.map(span).collect()
}

/// A file of another format has other keys, so that only its format is worth a word.
fn other_format(text: &str, found: &str) -> Mistake {
    let path = KeyPath::default().join("format");
    Mistake { span: locate(text, &path).value, path, message: unknown_format(found) }
}

impl Walk<'_> {
    /// Adds what is wrong about the mended scene, but for what follows from something that was put in.
    fn judge(&mut self, findings: Vec<Finding>) {
        let own: Vec<Finding> = findings.into_iter().filter(|finding| !self.makes_up(finding)).collect();
        let spans = spans(&own, self.text);
        let placed = own.into_iter().zip(spans);
        self.mistakes.extend(placed.map(|(Finding { path, message, .. }, span)| Mistake { span, path, message }));
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
