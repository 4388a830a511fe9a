//! Reading a log that is one nested document.

use super::LogError;
use super::line::{End, Line, with_whole_numbers};
use super::lines::Brackets;
use super::read::{Ending, ReadLog, check_names, check_version, error_at};
use super::reader::Reader;
use crate::log::{Header, Log};
use raywalk_guard::attempt;
use serde::Deserialize;
use std::io::{self, ErrorKind};
use std::{slice, thread};

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

/// A nesting for which any stack is enough: the parser's own limit would be 128.
const SHALLOW: usize = 64;

/// How much larger than its bytes a document is in memory, with the lines that are made of it.
const GROWTH: usize = 3;

/// Reads the document.
pub(super) fn read(bytes: &[u8]) -> Result<ReadLog, LogError> {
    // In the middle of the work it could only abort.
    let asked = attempt(|| Vec::<u8>::new().try_reserve_exact(bytes.len().saturating_mul(GROWTH)));
    asked.map_err(|_| io::Error::from(ErrorKind::OutOfMemory))?;
    if let Some(line) = deeper_at(bytes, MAX_NESTING) {
        let message = format!("nested more than {MAX_NESTING} deep");
        return Err(LogError::Damaged { line, column: 1, message });
    }
    // The parser's recursion follows the nesting: where that is deep it gets a stack that is large enough.
    if deeper_at(bytes, SHALLOW).is_none() {
        return parse(bytes);
    }
    thread::scope(|scope| {
        let parse = thread::Builder::new().stack_size(STACK).spawn_scoped(scope, || parse(bytes))?;
        parse.join().unwrap_or_else(|_| Err(LogError::NotALog { found: "a document that can't be read".into() }))
    })
}

fn parse(bytes: &[u8]) -> Result<ReadLog, LogError> {
    let (document, is_alone) = parse_as::<Document>(bytes)
        .or_else(|error| {
            let mut is_alone = false;
            let again = || {
                let (value, alone) = parse_as(bytes)?;
                is_alone = alone;
                Ok(value)
            };
            with_whole_numbers(error, again).map(|document| (document, is_alone))
        })
        .map_err(|error| error_at(1, &error))?;
    check_version(&document.header.log)?;
    check_names(&document.header)?;
    let mut reader = Reader::new(&document.header);
    for child in document.children {
        reader.take(child, 1)?;
    }
    let ending = match document.end {
        _ if !is_alone => Ending::Mismatch { what: "other text stands after the document".into() },
        None => Ending::Missing { incomplete_record: false },
        // The digest is that of the same log as lines.
        Some(end) => reader.check_end(&end, None),
    };
    Ok(ReadLog { log: Log { events: reader.events, header: document.header }, ending })
}

/// The value that the bytes begin with, and whether nothing stands after it.
fn parse_as<'t, T: Deserialize<'t>>(bytes: &'t [u8]) -> Result<(T, bool), serde_json::Error> {
    let mut json = serde_json::Deserializer::from_slice(bytes);
    json.disable_recursion_limit();
    let value = T::deserialize(&mut json)?;
    Ok((value, json.end().is_ok()))
}

/// The line where the document nests deeper than this, if it does.
fn deeper_at(bytes: &[u8], most: usize) -> Option<usize> {
    let mut brackets = Brackets::default();
    let at = bytes.iter().position(|byte| {
        brackets.pass(slice::from_ref(byte));
        brackets.depth > most
    })?;
    Some(1 + bytes[..at].iter().filter(|byte| **byte == b'\n').count())
}
