//! Reading logs, also such as were cut off or damaged: what is complete is read, and what isn't is said.

use super::document;
use super::error::{Ending, LogError, error_at};
use super::line::{Line, from_text};
use super::lines::{Lines, TextLine};
use super::reader::{ReadLog, Reader, check_names, check_version};
use crate::files::{Kind, LogForm};
use crate::log::header::Header;
use serde::Deserialize;
use std::io::{ErrorKind, Read};

/// Reads a log, NDJSON or one JSON document, from memory.
///
/// # Errors
/// [`LogError`]; [`LogError::Io`] when there is no memory for it.
pub fn read(bytes: &[u8]) -> Result<ReadLog, LogError> {
    read_from(bytes)
}

/// Reads a log, NDJSON or one JSON document. Of NDJSON no more text is held than a block, so that the memory is that of the
/// events. It is read up to the first record that is damaged; input that ends with
/// [`UnexpectedEof`](std::io::ErrorKind::UnexpectedEof) counts as cut off there, such that ends with
/// [`InvalidData`](std::io::ErrorKind::InvalidData) as damaged.
///
/// # Errors
/// [`LogError`] for what has no good header or is a damaged document; [`LogError::Io`] when the input can't be read or there is
/// no memory for the log.
pub fn read_from(input: impl Read) -> Result<ReadLog, LogError> {
    let mut lines = Lines::of(input);
    if Kind::of(lines.beginning()?) == Kind::Log(LogForm::Document) {
        return document::read(&lines.whole()?);
    }
    let mut reader = Reader::new(header(&mut lines)?);
    let ending = loop {
        if let Some(ending) = record(&mut lines, &mut reader)? {
            break with_damage(ending, &lines);
        }
    };
    Ok(reader.finish(ending))
}

/// Reads the next record behind the header; the ending where there is none that can be read.
pub(super) fn record(lines: &mut Lines<impl Read>, reader: &mut Reader) -> Result<Option<Ending>, LogError> {
    let Some(line) = lines.next_line()? else { return Ok(Some(Ending::Missing { incomplete_record: false })) };
    if line.text.trim_ascii().is_empty() {
        return Ok(None);
    }
    let number = line.number;
    let parsed = match from_text::<Line>(line.text) {
        Ok(parsed) => parsed,
        Err(_) if !line.is_terminated => return Ok(Some(Ending::Missing { incomplete_record: true })),
        Err(error) => return Ok(Some(Ending::Damaged { what: error_at(number, &error).to_string() })),
    };
    if let Some(end) = parsed.end {
        let digest = lines.digest();
        return Ok(Some(match lines.count_rest()? {
            0 => reader.check_end(&end, Some(digest)),
            after => Ending::Mismatch { what: format!("{after} bytes follow its end line") },
        }));
    }
    let before = reader.events.len();
    match reader.take(parsed, number) {
        Ok(()) => Ok(None),
        Err(error @ LogError::Damaged { .. }) => {
            reader.events.truncate(before);
            Ok(Some(Ending::Damaged { what: error.to_string() }))
        }
        Err(error) => Err(error),
    }
}

/// How a log ends whose last record is read, if its packed data were damaged.
pub(super) fn with_damage(ending: Ending, lines: &Lines<impl Read>) -> Ending {
    match (ending, lines.damage()) {
        (Ending::Complete | Ending::Unknown { .. }, Some(damage)) => Ending::Damaged { what: damage.to_string() },
        (Ending::Missing { .. }, Some(damage)) if damage.kind() == ErrorKind::InvalidData => {
            Ending::Damaged { what: damage.to_string() }
        }
        (ending, _) => ending,
    }
}

/// The header in the first line that isn't blank.
pub(super) fn header(lines: &mut Lines<impl Read>) -> Result<Header, LogError> {
    while let Some(line) = lines.next_line()? {
        if !line.text.trim_ascii().is_empty() {
            let header = header_in(&line)?;
            lines.pass_header();
            return Ok(header);
        }
    }
    Err(LogError::NotALog { found: "nothing".into() })
}

fn header_in(&TextLine { text: line, number, is_terminated }: &TextLine) -> Result<Header, LogError> {
    #[derive(Deserialize)]
    struct Version {
        log: String,
    }
    let Ok(version) = from_text::<Version>(line) else {
        if !is_terminated && Kind::of(line).is_log() {
            return Err(LogError::NoWholeHeader);
        }
        let found: String = String::from_utf8_lossy(line).chars().take(40).flat_map(char::escape_default).collect();
        return Err(LogError::NotALog { found: format!("`{found}`") });
    };
    check_version(&version.log)?;
    let header = from_text(line).map_err(|error| error_at(number, &error))?;
    check_names(&header)?;
    Ok(header)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::log::Log;
    use crate::log::file::{to_json, to_ndjson};
    use crate::record::{self, Arithmetic};
    use crate::scene::{build, builtin, file};

    fn textbook() -> Log {
        let text = builtin::text("textbook").unwrap();
        let scene = build(&file::check(text.as_bytes(), "test").unwrap().scene, &Default::default()).unwrap();
        record::pixel(&scene, [160, 120], Arithmetic::F64)
    }

    #[track_caller]
    fn reads(before: &[u8], bytes: &[u8]) {
        let bytes = [before, bytes].concat();
        assert!(Kind::of(&bytes).is_log());
        let found = read(&bytes).unwrap();
        assert_eq!((found.ending, found.log), (Ending::Complete, textbook()));
    }

    #[test]
    fn a_log_may_begin_with_a_byte_order_mark_and_blank_lines() {
        let (lines, document) = (to_ndjson(&textbook()).unwrap(), to_json(&textbook()).unwrap());
        for before in [&b"\xef\xbb\xbf"[..], b"\n", b"\xef\xbb\xbf \r\n\n"] {
            reads(before, &lines);
            reads(before, &document);
        }
    }

    #[track_caller]
    fn warns(bytes: &[u8], expected: &str) {
        let warning = read(bytes).unwrap().ending.warning().unwrap();
        assert!(warning.contains(expected), "{warning}");
    }

    #[test]
    fn endless_nesting_is_damage() {
        let mut lines = to_ndjson(&textbook()).unwrap();
        lines.truncate(lines.iter().position(|byte| *byte == b'\n').unwrap() + 1);
        for node in 1..5000 {
            let line =
                format!("{{\"at\":{node},\"node\":{node},\"enter\":{{\"combine\":{{}}}},\"parent\":{}}}\n", node - 1);
            lines.extend_from_slice(line.as_bytes());
        }
        warns(&lines, "2050:1: nested more than 2048 deep");
        let log = read(&lines).unwrap().log;
        assert_eq!(log.events.len(), 2048);
        // The deepest log that lines can have can be a document, too.
        assert_eq!(read(&to_json(&log).unwrap()).unwrap().log, log);
    }

    #[test]
    fn damage_is_reported_with_its_place() {
        let lines = String::from_utf8(to_ndjson(&textbook()).unwrap()).unwrap();
        let line = "\n{\"at\":7,";
        assert!(lines.contains(line));
        warns(lines.replacen(line, "\n{\"at\":x,", 1).as_bytes(), "8:7: expected value");
    }

    #[test]
    fn a_header_that_was_cut_off_is_distinguished_from_none() {
        let lines = to_ndjson(&textbook()).unwrap();
        for length in [20, 50, 200] {
            let said = read(&lines[..length]).unwrap_err().to_string();
            assert_eq!(said, "1:1: the log was cut off in its header", "{length}");
        }
        for blank in ["", "\n \n"] {
            assert!(read(blank.as_bytes()).unwrap_err().to_string().ends_with("found nothing"));
        }
    }
}
