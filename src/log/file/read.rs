//! Reading logs, also such as were cut off or damaged: what is complete is read, and what isn't is said.

use super::LogError;
use super::document::{self, is_document};
use super::line::{End, Line};
use super::lines::Lines;
use super::reader::Reader;
use crate::log::Log;
use crate::log::escape::{is_hidden, shortened, visible};
use crate::log::header::{FORMAT, Header};
use serde::Deserialize;
use std::io::Read;

/// A log as it was found.
#[derive(Debug)]
pub struct ReadLog {
    /// What could be read.
    pub log: Log,
    /// How it ends.
    pub ending: Ending,
}

/// How a log ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Ending {
    /// With an end line that fits.
    Complete,
    /// Without an end line: the log was cut off, or is still being written.
    Missing {
        /// Whether the last line is incomplete (it was passed over).
        incomplete_record: bool,
    },
    /// With an end line that doesn't fit what stands before it.
    Mismatch {
        /// What doesn't fit.
        what: String,
    },
}

impl Ending {
    /// A sentence for people; `None` if all is well.
    pub fn warning(&self) -> Option<String> {
        match self {
            Ending::Complete => None,
            Ending::Missing { incomplete_record: false } => Some("the log has no end line: it was cut off".into()),
            Ending::Missing { incomplete_record: true } => {
                Some("the log was cut off: 1 incomplete record was passed over".into())
            }
            Ending::Mismatch { what } => Some(format!("the log was changed after it was written: {what}")),
        }
    }
}

/// Whether what begins like this is a log: by its first key.
pub fn is_log(beginning: &[u8]) -> bool {
    let first_key = beginning.trim_ascii_start().strip_prefix(b"{").map(<[u8]>::trim_ascii_start);
    first_key.is_some_and(|key| key.starts_with(b"\"log\"")) || is_document(beginning)
}

/// Reads a log, NDJSON or one JSON document, from memory.
///
/// # Errors
/// [`LogError`]; [`LogError::Io`] when there is no memory for it.
pub fn read(bytes: &[u8]) -> Result<ReadLog, LogError> {
    read_from(bytes)
}

/// Reads a log, NDJSON or one JSON document. Of NDJSON no more text is held than a block, so that the memory is that of the
/// events. Input that ends with [`UnexpectedEof`](std::io::ErrorKind::UnexpectedEof) counts as cut off there.
///
/// # Errors
/// [`LogError`]; [`LogError::Io`] when the input can't be read or there is no memory for the log.
pub fn read_from(input: impl Read) -> Result<ReadLog, LogError> {
    let mut lines = Lines::of(input);
    if is_document(lines.beginning()?) {
        return document::read(&lines.whole()?);
    }
    let header = header(lines.next_line()?.map(|line| line.text).unwrap_or_default())?;
    let mut reader = Reader::new(&header);
    let mut ending = Ending::Missing { incomplete_record: false };
    while let Some(line) = lines.next_line()? {
        if line.text.trim_ascii().is_empty() {
            continue;
        }
        let parsed = match serde_json::from_slice::<Line>(line.text) {
            Ok(parsed) => parsed,
            Err(_) if !line.is_terminated => {
                ending = Ending::Missing { incomplete_record: true };
                break;
            }
            Err(error) => return Err(error_at(line.number, &error)),
        };
        if let Some(end) = parsed.end {
            ending = check_end(&end, reader.events.len(), lines.digest());
            let after = lines.count_rest()?;
            if after > 0 {
                ending = Ending::Mismatch { what: format!("{after} bytes stand after its end line") };
            }
            break;
        }
        reader.take(parsed, line.number)?;
    }
    let mut events = reader.events;
    events.shrink_to_fit();
    Ok(ReadLog { log: Log { header, events }, ending })
}

fn header(line: &[u8]) -> Result<Header, LogError> {
    #[derive(Deserialize)]
    struct Version {
        log: String,
    }
    let Ok(version) = serde_json::from_slice::<Version>(line) else {
        let found: String = String::from_utf8_lossy(line).chars().take(40).flat_map(char::escape_default).collect();
        return Err(LogError::NotALog {
            found: if found.is_empty() { "nothing".into() } else { format!("`{found}`") },
        });
    };
    check_version(&version.log)?;
    let header = serde_json::from_slice(line).map_err(|error| error_at(1, &error))?;
    check_names(&header)?;
    Ok(header)
}

/// Whoever shows a log shows its names, so that none may hold what drives a terminal. No scene has such names.
pub(super) fn check_names(header: &Header) -> Result<(), LogError> {
    let tracing = &header.tracing;
    let words = [&header.version, &header.arithmetic, &tracing.algorithm, &tracing.specular, &tracing.sphere_method];
    let parameters = header.sampling.iter().flat_map(|(word, parameters)| [word].into_iter().chain(parameters.keys()));
    let names = header.objects.iter().chain(&header.lights).chain([&header.scene.name, &header.scene.digest]);
    match words.into_iter().chain(parameters).chain(names).find(|name| name.chars().any(is_hidden)) {
        None => Ok(()),
        Some(name) => {
            Err(LogError::damaged(1, 1, &format!("a name must not hold control characters, found `{}`", visible(name))))
        }
    }
}

pub(super) fn check_version(found: &str) -> Result<(), LogError> {
    if found == FORMAT { Ok(()) } else { Err(LogError::OtherVersion { found: shortened(found, 40) }) }
}

pub(super) fn check_end(end: &End, events: usize, found: blake3::Hash) -> Ending {
    let digest = format!("blake3:{}", found.to_hex());
    if end.events != events as u64 {
        Ending::Mismatch { what: format!("its end line counts {} events, there are {events}", end.events) }
    } else if end.digest != digest {
        Ending::Mismatch { what: "its digest doesn't fit its bytes".into() }
    } else {
        Ending::Complete
    }
}

pub(super) fn error_at(line: usize, error: &serde_json::Error) -> LogError {
    let text = error.to_string();
    let message = text.split(" at line ").next().unwrap_or(&text);
    LogError::damaged(line, error.column().max(1), message)
}
