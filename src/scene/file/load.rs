//! From bytes to a checked scene: decode, read, fill in names, validate, and give every problem its place.

use std::io::ErrorKind;
use std::path::Path;

use super::Loaded;
use super::form::{scene_in, spans};
use super::nff::{self, Import};
use super::schema::SceneFile;
use super::validate::{Finding, judge, validate};
use crate::files::{FileError, KeyPath, Opened, Problem, Source, Wanted, display_name, is_utf16, without_mark};

/// The largest scene file: 256 MiB.
pub const MAX_BYTES: u64 = 256 << 20;

/// What a scene is read from.
const SCENE: Wanted = Wanted { what: "a scene file", max_bytes: MAX_BYTES };

/// Opens a regular file, or standard input for `-`, which is a scene or a log.
///
/// # Errors
/// Those of [`Wanted::open`].
pub fn open(path: &Path) -> Result<Opened, FileError> {
    SCENE.open(path)
}

/// Reads a scene file, or standard input for `-`, up to [`MAX_BYTES`].
///
/// # Errors
/// Those of [`Wanted::read`].
pub fn read_bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    SCENE.read(path)
}

/// Reads and checks a scene file, or standard input for `-`.
///
/// # Errors
/// Those of [`Wanted::read`] and of [`check`].
pub fn read(path: &Path) -> Result<Loaded, FileError> {
    check(&read_bytes(path)?, &display_name(path))
}

/// Parses and validates the text of a scene file, JSON or [`nff`].
///
/// # Errors
/// [`FileError::Invalid`] with every problem found, or only those up to the place where the text stops being JSON.
pub fn check(text: &[u8], file_name: &str) -> Result<Loaded, FileError> {
    check_as(text, file_name, &Import::default())
}

/// The same, where a file of another format may be read in more than one way.
///
/// # Errors
/// Those of [`check`].
pub fn check_as(text: &[u8], file_name: &str, import: &Import) -> Result<Loaded, FileError> {
    if nff::is_nff(text, file_name) {
        ask_for_memory(text, NFF_GROWTH, file_name)?;
        return nff::check(text, file_name, import);
    }
    ask_for_memory(text, JSON_GROWTH, file_name)?;
    let (source, text) = decode(text, file_name)?;
    let scene = scene_in(&source, text)?;
    let (warnings, more_warnings) = judge(validate(&scene), |findings| place(findings, &source, text))?;
    Ok(Loaded { scene, warnings, more_warnings })
}

/// How much larger a scene is, ready to be traced, than its text: measured on files of nothing but the shapes that take most.
const JSON_GROWTH: usize = 12;
/// The same for NFF, where a sphere takes a few bytes.
const NFF_GROWTH: usize = 25;

/// Makes sure, as far as that goes, that there is memory for a scene: in the middle of the work it could only abort.
fn ask_for_memory(text: &[u8], growth: usize, file_name: &str) -> Result<(), FileError> {
    if raywalk_guard::has_room_for(text.len().saturating_mul(growth)) {
        return Ok(());
    }
    Err(FileError::Unreadable { file: file_name.to_owned(), source: ErrorKind::OutOfMemory.into() })
}

/// Validates a scene that did not come from JSON text as it is: from another format, or changed by options. Gives the
/// warnings; its problems have paths but no lines.
///
/// # Errors
/// [`FileError::Invalid`] with every problem.
pub fn check_scene(scene: &SceneFile, file_name: &str) -> Result<Vec<Problem>, FileError> {
    let unplaced = |findings: &[Finding]| findings.iter().map(|finding| unplaced(finding, file_name)).collect();
    judge(validate(scene), unplaced).map(|(warnings, _)| warnings)
}

/// Gives what others found about a scene its place in the text that it was loaded from. Where that isn't JSON there are
/// paths but no lines.
pub fn placed(findings: &[Finding], text: &[u8], file_name: &str) -> Vec<Problem> {
    match decode(text, file_name) {
        Ok((source, text)) if !nff::is_nff(text.as_bytes(), file_name) => place(findings, &source, text),
        _ => findings.iter().map(|finding| unplaced(finding, file_name)).collect(),
    }
}

fn unplaced(finding: &Finding, file_name: &str) -> Problem {
    Problem {
        file: file_name.to_string(),
        line: 0,
        column: 0,
        path: finding.path.clone(),
        message: finding.message.clone(),
        span: None,
        excerpt: None,
    }
}

/// Parses the text of a scene file: syntax, keys and types, but not whether the numbers make sense. A byte-order mark is
/// skipped and missing names are filled in.
///
/// # Errors
/// [`FileError::Invalid`] with every problem found, or only those up to the place where the text stops being JSON.
pub fn parse(text: &[u8], file_name: &str) -> Result<SceneFile, FileError> {
    let (source, text) = decode(text, file_name)?;
    scene_in(&source, text)
}

/// The text without a byte-order mark.
fn decode<'t>(bytes: &'t [u8], name: &'t str) -> Result<(Source<'t>, &'t str), FileError> {
    let body = without_mark(bytes);
    let skipped = bytes.len() - body.len();
    let source = Source { name, text: body };
    let problem =
        |offset: usize, message: String| Err(source.problem(offset..offset + 1, KeyPath::default(), message).into());
    if is_utf16(body) {
        return problem(0, "the text is UTF-16, expected UTF-8".to_string());
    }
    match std::str::from_utf8(body) {
        Ok(text) => Ok((source, text)),
        Err(error) => {
            let offset = error.valid_up_to();
            let byte = body[offset];
            problem(offset, format!("not UTF-8: byte {byte:#04x} at offset {}, expected UTF-8 text", offset + skipped))
        }
    }
}

fn place(findings: &[Finding], source: &Source, text: &str) -> Vec<Problem> {
    let placed = findings.iter().zip(spans(findings, text));
    placed.map(|(finding, span)| source.problem(span, finding.path.clone(), finding.message.clone())).collect()
}
