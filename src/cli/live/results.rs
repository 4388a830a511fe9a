//! What the viewer saves, and the names of files that are typed for it.

use crate::cli::failure::Failure;
use crate::cli::inputs::Inputs;
use crate::cli::output::Output;
use crate::cli::views::{TraceFormat, TreeOf, View};
use raywalk::files::escape_hidden;
use raywalk::log::{Log, Subject};
use raywalk::report::Style;
use raywalk::report::language::Language;
use raywalk::scene::Scene;
use raywalk::tui::Refusal;
use std::fs;
use std::path::Path;

/// Saves a result under this name, which leads to none of the inputs. It may replace an earlier one.
pub fn write(path: impl AsRef<Path>, inputs: &Inputs, bytes: &[u8]) -> Result<(), Refusal> {
    let path = path.as_ref();
    // Standard output is the terminal, which is the viewer's. To open a pipe would be to wait for somebody who reads it.
    let is_other = fs::metadata(path).is_ok_and(|found| !found.is_file() && !found.is_dir());
    if path == Path::new("-") || is_other || path.as_os_str().as_encoded_bytes().ends_with(b"/") {
        return Err(Refusal::NoFile);
    }
    let output = Output::create(Some(path), inputs).map_err(refused)?;
    output.commit_for_now(bytes).map_err(refused)
}

/// What a command would say of it, in one line.
pub fn refused(failure: Failure) -> Refusal {
    Refusal::Other(failure.line().to_owned())
}

/// Saves a log in the format of the ending of a name; of a saved log the scene isn't known.
pub fn export(
    scene: Option<&Scene>,
    log: &Log,
    (path, inputs): (&str, &Inputs),
    (language, style): (Language, Style),
) -> Result<(), Refusal> {
    let format = TraceFormat::of_ending(Path::new(path)).ok_or(Refusal::Ending(&TraceFormat::ENDINGS))?;
    if matches!(log.header.subject, Subject::Region(_)) && !format.is_of_regions() {
        return Err(Refusal::Ending(&TraceFormat::ENDINGS_OF_REGIONS));
    }
    let view = View { format, tree: TreeOf::Rays, language, style };
    let bytes = view.bytes(scene, log).map_err(|error| Refusal::Other(error.to_string()))?;
    write(path, inputs, &bytes)
}

/// The most files of a folder that are looked at.
const MOST_FILES: usize = 10_000;

/// The files and folders whose paths begin so, as far as their names can be typed.
pub fn files(beginning: &str) -> Vec<String> {
    let (folder, name) = match beginning.rfind('/') {
        Some(end) => beginning.split_at(end + 1),
        None => ("", beginning),
    };
    let entries = fs::read_dir(if folder.is_empty() { "." } else { folder });
    let mut found: Vec<_> = entries
        .into_iter()
        .flatten()
        .take(MOST_FILES)
        .filter_map(|entry| {
            let entry = entry.ok()?;
            let file = entry.file_name().into_string().ok()?;
            let is_meant = file.starts_with(name) && (name.starts_with('.') || !file.starts_with('.'));
            let end = if entry.path().is_dir() { "/" } else { "" };
            (is_meant && escape_hidden(&file) == file).then(|| format!("{folder}{file}{end}"))
        })
        .collect();
    found.sort();
    found
}
