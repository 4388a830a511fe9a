//! Turns what serde says into what a person needs: the place, what is there, what was expected, what was perhaps meant.

use std::ops::Range;

use serde_json::error::Category;
use serde_path_to_error::{Path, Segment};

use super::error::Problem;
use super::escape::shortened;
use super::key_path::{KeyPath, Step};
use super::locate::{Place, locate, locate_repeated};
use super::schema::FORMAT;
use super::source::Source;
use super::suggest::suggest;
use super::syntax;
use super::validate::limits::whole_numbers;

/// How many characters of a name or string from the file a message repeats.
const QUOTED: usize = 40;

/// Why and where the JSON reader stopped.
pub struct NoScene {
    /// What it said.
    pub error: serde_json::Error,
    /// How far it had come.
    pub path: KeyPath,
}

/// The problem behind an error of the JSON reader.
pub fn explain(source: &Source, text: &str, refused: &NoScene) -> Problem {
    let (span, path, message) = match refused.error.classify() {
        Category::Data => other_format(text).unwrap_or_else(|| wrong_data(text, &Mistake::of(text, refused))),
        Category::Syntax | Category::Eof | Category::Io => {
            let offset = offset_of(text, refused.error.line(), refused.error.column());
            let (span, message) = syntax::explain(text, offset, &without_position(&refused.error));
            (span, refused.path.clone(), message)
        }
    };
    source.problem(span, path, message)
}

/// The problem behind a mistake of form. The text may be another one than was read, as long as the path leads to the same.
pub fn describe_mistake(source: &Source, text: &str, mistake: &Mistake) -> Problem {
    let (span, path, message) = wrong_data(text, mistake);
    source.problem(span, path, message)
}

/// A mistake of form: the text is JSON, but no scene.
pub struct Mistake {
    /// The way to the value that is complained about.
    pub path: KeyPath,
    said: String,
}

impl Mistake {
    /// The mistake at which the reader of a text stopped.
    pub fn of(text: &str, refused: &NoScene) -> Self {
        let mut path = refused.path.clone();
        let depth = locate(text, &path).depth;
        // A word counts as a step of the path for serde, but in the text it is the value.
        while path.steps().len() > depth {
            path.pop();
        }
        Self { path, said: without_position(&refused.error) }
    }

    /// What kind it is.
    pub fn complaint(&self) -> Complaint<'_> {
        Complaint::of(&self.said)
    }
}

/// serde's message without its `at line 1 column 2`.
fn without_position(error: &serde_json::Error) -> String {
    let mut message = error.to_string();
    if let Some(end) = message.rfind(" at line ") {
        message.truncate(end);
    }
    message
}

/// The path as messages write it.
pub fn key_path(path: &Path) -> KeyPath {
    let steps = path.iter().filter_map(|segment| match segment {
        Segment::Seq { index } => Some(Step::Index(*index)),
        Segment::Map { key: name } | Segment::Enum { variant: name } => Some(name.clone().into()),
        Segment::Unknown => None,
    });
    steps.collect()
}

fn offset_of(text: &str, line: usize, column: usize) -> usize {
    let newlines = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n');
    let line_start = match line {
        0 | 1 => 0,
        _ => newlines.map(|(at, _)| at + 1).nth(line - 2).unwrap_or(text.len()),
    };
    (line_start + column.saturating_sub(1)).min(text.len())
}

/// A file of another format has other keys, so that only its format is worth a word.
pub fn other_format(text: &str) -> Option<(Range<usize>, KeyPath, String)> {
    let path = KeyPath::default().join("format");
    let place = locate(text, &path);
    let found: String = serde_json::from_str(&text[place.value.clone()]).ok()?;
    let is_other = place.depth == 1 && found != FORMAT;
    is_other.then(|| (place.value, path, unknown_format(&found)))
}

/// The message for another `format`.
pub fn unknown_format(found: &str) -> String {
    format!("this program reads `{FORMAT}`, found `{}`", shortened(found, QUOTED))
}

fn wrong_data(text: &str, mistake: &Mistake) -> (Range<usize>, KeyPath, String) {
    let mut path = mistake.path.clone();
    let place = locate(text, &path);
    match mistake.complaint() {
        Complaint::UnknownKey { name, valid } => {
            let message = format!("unknown key `{}`, {}", shortened(name, QUOTED), alternatives(name, &valid));
            (key_span(place), path, message)
        }
        Complaint::UnknownWord { name, valid } => {
            let message = format!("unknown word `{}`, {}", shortened(name, QUOTED), alternatives(name, &valid));
            let is_string = text[place.value.clone()].starts_with('"');
            if is_string {
                return (place.value, path, message);
            }
            path.push(name.to_string());
            (key_span(locate(text, &path)), path, message)
        }
        Complaint::Missing { name } => (place.value, path, format!("the key `{name}` is missing, expected it here")),
        Complaint::Repeated { name } => {
            let is_at_key = matches!(path.steps().last(), Some(Step::Key(key)) if key == name);
            if !is_at_key {
                path.push(name.to_string());
            }
            let second = key_span(locate_repeated(text, &path, 1));
            let message = format!("the key `{}` occurs twice, expected it once", shortened(name, QUOTED));
            (second, path, message)
        }
        Complaint::Length { found, expected } => {
            let message = format!("expected {}, found {found} elements", in_words(expected, &path));
            (place.value, path, message)
        }
        Complaint::Type { expected } => {
            let found = describe(&text[place.value.clone()]);
            let message = format!("expected {}, found {found}", in_words(expected, &path));
            (place.value, path, message)
        }
        Complaint::Other => (place.value, path, mistake.said.clone()),
    }
}

fn key_span(place: Place) -> Range<usize> {
    place.key.unwrap_or(place.value)
}

/// The kinds of message that serde composes.
pub enum Complaint<'s> {
    /// A key that nobody knows.
    UnknownKey { name: &'s str, valid: Vec<&'s str> },
    /// A word that nobody knows, as a string or as the only key of an object.
    UnknownWord { name: &'s str, valid: Vec<&'s str> },
    /// A key that must be there.
    Missing { name: &'s str },
    /// A duplicate key.
    Repeated { name: &'s str },
    /// Too few or too many elements.
    Length { found: &'s str, expected: &'s str },
    /// A value of the wrong kind.
    Type { expected: &'s str },
    /// A sentence of our own.
    Other,
}

impl<'s> Complaint<'s> {
    fn of(said: &'s str) -> Self {
        let after = |beginning: &str| said.strip_prefix(beginning);
        if let Some(rest) = after("unknown field `") {
            let (name, valid) = name_and_valid(rest);
            return Self::UnknownKey { name, valid };
        }
        if let Some(rest) = after("unknown variant `") {
            let (name, valid) = name_and_valid(rest);
            return Self::UnknownWord { name, valid };
        }
        if let Some(name) = after("missing field `") {
            return Self::Missing { name: name.trim_end_matches('`') };
        }
        if let Some(name) = after("duplicate field `") {
            return Self::Repeated { name: name.strip_suffix('`').unwrap_or(name) };
        }
        // The name of a wrong value may itself hold the words, so the last ones count.
        if let Some((found, expected)) = after("invalid length ").and_then(|rest| rest.rsplit_once(", expected ")) {
            return Self::Length { found, expected };
        }
        let is_type = said.starts_with("invalid type: ") || said.starts_with("invalid value: ");
        match said.rsplit_once(", expected ") {
            Some((_, expected)) if is_type => Self::Type { expected },
            _ => Self::Other,
        }
    }
}

/// Takes apart "name`, expected one of `a`, `b`".
fn name_and_valid(rest: &str) -> (&str, Vec<&str>) {
    match rest.rsplit_once("`, expected ") {
        Some((name, list)) => (name, list.split('`').skip(1).step_by(2).collect()),
        None => (rest.strip_suffix("`, there are no fields").unwrap_or(rest), Vec::new()),
    }
}

/// "expected `a`, `b` or `c`; did you mean `b`?"
pub fn alternatives(name: &str, valid: &[&str]) -> String {
    let quoted: Vec<String> = valid.iter().map(|name| format!("`{name}`")).collect();
    let list = match quoted.as_slice() {
        [] => return "expected no key here".to_string(),
        [only] => only.clone(),
        [head @ .., last] => format!("{} or {last}", head.join(", ")),
    };
    match suggest(name, valid.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`? expected {list}"),
        None => format!("expected {list}"),
    }
}

/// serde's words for what it wanted at a path, in the words of JSON.
fn in_words(expected: &str, path: &KeyPath) -> String {
    match expected {
        "f64" => "a number".to_string(),
        "u32" | "u64" => {
            let keys = path.steps().iter().rev().filter_map(|step| match step {
                Step::Key(key) => Some(&**key),
                Step::Index(_) => None,
            });
            match whole_numbers(keys) {
                Some([low, high]) => format!("a whole number from {low} to {high}"),
                None => "a whole number, 0 or more".to_string(),
            }
        }
        "a boolean" => "`true` or `false`".to_string(),
        "a sequence" => "an array".to_string(),
        "a map" => "an object".to_string(),
        "string" => "a string".to_string(),
        _ if expected.starts_with("struct ") => "an object".to_string(),
        _ => match expected.strip_prefix("an array of length ") {
            Some(length) => format!("an array of {length} elements"),
            None => expected.to_string(),
        },
    }
}

/// What is in the file, in words.
fn describe(value: &str) -> String {
    match value.as_bytes().first() {
        Some(b'"') => format!("the string {}", shortened(value, QUOTED)),
        Some(b'[') => "an array".to_string(),
        Some(b'{') => "an object".to_string(),
        Some(_) => shortened(value, QUOTED),
        None => "nothing".to_string(),
    }
}
