//! Reading a log that is one nested document.

use super::LogError;
use super::line::{End, Line};
use super::read::{Ending, ReadLog, check_end, check_names, check_version, error_at};
use super::reader::Reader;
use crate::log::{Header, Log};
use serde::Deserialize;
use std::io::{self, ErrorKind};
use std::thread;

/// How deep the nodes of a log, and the brackets of a document, may nest: a ray tree of the greatest depth takes two brackets a level, and a few more at its end.
pub const MAX_NESTING: usize = 2048;

/// Enough stack for the parser at that depth, with room to spare.
const STACK: usize = 256 << 20;

#[derive(Deserialize)]
struct Document<'t> {
    header: Header,
    #[serde(borrow)]
    children: Vec<Line<'t>>,
    end: Option<End>,
}

/// Whether the bytes begin like such a document.
pub(super) fn is_document(bytes: &[u8]) -> bool {
    let first_key = bytes.trim_ascii_start().strip_prefix(b"{").map(<[u8]>::trim_ascii_start);
    first_key.is_some_and(|key| key.starts_with(b"\"header\""))
}

/// How much larger than its bytes a document is in memory, with the lines that are made of it.
const GROWTH: usize = 3;

/// Reads the document.
pub(super) fn read(bytes: &[u8]) -> Result<ReadLog, LogError> {
    // In the middle of the work it could only abort.
    let asked = Vec::<u8>::new().try_reserve_exact(bytes.len().saturating_mul(GROWTH));
    asked.map_err(|_| io::Error::from(ErrorKind::OutOfMemory))?;
    if let Some(line) = too_deep_at(bytes) {
        let message = format!("nested more than {MAX_NESTING} deep");
        return Err(LogError::Damaged { line, column: 1, message });
    }
    // The parser's own limit is 128 and its recursion follows the nesting, so it gets a stack that is large enough.
    thread::scope(|scope| {
        let parse = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, || parse(bytes))?;
        parse.join().unwrap_or_else(|_| Err(LogError::NotALog { found: "a document that can't be read".into() }))
    })
}

fn parse(bytes: &[u8]) -> Result<ReadLog, LogError> {
    let mut json = serde_json::Deserializer::from_slice(bytes);
    json.disable_recursion_limit();
    let document = Document::deserialize(&mut json).map_err(|error| error_at(error.line(), &error))?;
    check_version(&document.header.log)?;
    check_names(&document.header)?;
    let mut reader = Reader::new(&document.header);
    for child in document.children {
        reader.take(child, 1)?;
    }
    let log = Log { events: reader.events, header: document.header };
    // The digest is that of the same log as lines.
    let ending = match document.end {
        _ if json.end().is_err() => Ending::Mismatch { what: "other text stands after the document".into() },
        None => Ending::Missing { incomplete_record: false },
        Some(end) => {
            let lines = super::to_ndjson(&log)?;
            let before_end = lines[..lines.len() - 1].iter().rposition(|byte| *byte == b'\n').map_or(0, |at| at + 1);
            check_end(&end, log.events.len(), blake3::hash(&lines[..before_end]))
        }
    };
    Ok(ReadLog { log, ending })
}

/// The line where the document nests too deep, if it does. Brackets in strings don't count.
fn too_deep_at(bytes: &[u8]) -> Option<usize> {
    let (mut line, mut depth, mut in_string, mut is_escaped) = (1, 0_usize, false, false);
    for byte in bytes {
        match byte {
            b'\n' => line += 1,
            _ if is_escaped => is_escaped = false,
            b'\\' if in_string => is_escaped = true,
            b'"' => in_string = !in_string,
            b'{' | b'[' if !in_string => depth += 1,
            b'}' | b']' if !in_string => depth = depth.saturating_sub(1),
            _ => {}
        }
        if depth > MAX_NESTING {
            return Some(line);
        }
    }
    None
}
