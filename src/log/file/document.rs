//! Reading a log that is one nested document.
//!
//! Its keys may be in any order, the header behind the events, and the nodes inside a node before what the node is. So it is read three
//! times: for the places of the nodes' contents, for the header and what is no JSON, and then event by event as lines are. No more of the
//! events is held in between than one.

use super::MAX_NESTING;
use super::error::{Ending, LogError, error_at, message_of};
use super::line::{End, Line, from_text};
use super::lines::{Brackets, MAX_LOG_LINE, too_long};
use super::reader::{ReadLog, Reader, check_names, check_version};
use crate::log::Header;
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::ops::Range;

mod places;

use places::{Contents, Places};

/// How deep the brackets of a document may nest: two for each node and for the document itself, and a few inside an event.
const MAX_BRACKETS: usize = 4114;
const _: () = assert!(MAX_BRACKETS == 2 * (MAX_NESTING + 1) + 16);

/// The keys around the events.
#[derive(Deserialize)]
struct Outside {
    header: Header,
    #[serde(rename = "children")]
    _children: IgnoredAny,
    end: Option<End>,
}

/// Reads the document.
pub(super) fn read(bytes: &[u8]) -> Result<ReadLog, LogError> {
    let places = Places::of(bytes).map_err(|too_deep| {
        let line = 1 + memchr::memchr_iter(b'\n', &bytes[..too_deep]).count();
        LogError::Damaged { line, column: 1, message: format!("brackets nested more than {MAX_BRACKETS} deep") }
    })?;
    let mut json = serde_json::Deserializer::from_slice(bytes);
    json.disable_recursion_limit();
    let Outside { header, end, .. } = Outside::deserialize(&mut json).map_err(|error| error_at(1, &error))?;
    let is_alone = json.end().is_ok();
    check_version(&header.log)?;
    check_names(&header)?;
    let mut reader = Reader::new(header);
    events(bytes, &places, &mut reader)?;
    let ending = match end {
        _ if !is_alone => Ending::Mismatch { what: "other text follows the document".into() },
        None => Ending::Missing { incomplete_record: false },
        // The digest is that of the same log as lines.
        Some(end) => reader.check_end(&end, None),
    };
    Ok(reader.finish(ending))
}

/// Reads the events, each node's before those inside it.
fn events(bytes: &[u8], places: &Places, reader: &mut Reader) -> Result<(), LogError> {
    let no_events = || LogError::damaged(1, 1, "expected a list of events as `children`");
    let first = places.get(0).ok_or_else(no_events)?;
    let (mut at, mut next) = (first.range.start + 1, 1);
    // The lists that are being read, each with the place behind its node.
    let mut open = vec![(first, bytes.len())];
    let mut text = Vec::new();
    while let Some((list, behind)) = open.last().copied() {
        at += bytes[at..].iter().take_while(|byte| byte.is_ascii_whitespace() || **byte == b',').count();
        if at + 1 >= list.range.end {
            (at, next) = (behind, list.after);
            open.pop();
            continue;
        }
        let own = Own::of(bytes, at, places, next);
        reader.take(own.line(bytes, &mut text)?, 1)?;
        if let Some(inside) = own.inside {
            open.push((inside, own.range.end));
            at = inside.range.start + 1;
            next += 1;
        } else {
            at = own.range.end;
        }
    }
    Ok(())
}

/// What belongs to an event itself.
struct Own<'p> {
    /// The whole of it.
    range: Range<usize>,
    /// The events inside.
    inside: Option<&'p Contents>,
}

/// The text that replaces the events inside.
const NOTHING: &[u8] = b"null";

impl<'p> Own<'p> {
    /// That of the event which begins at a place; `next` are the first contents behind that.
    fn of(bytes: &[u8], start: usize, places: &'p Places, mut next: usize) -> Own<'p> {
        let mut brackets = Brackets::default();
        let (mut at, mut inside) = (start, None);
        while at < bytes.len() {
            if let Some(contents) = places.get(next).filter(|contents| contents.range.start == at) {
                // Where there are two of them, the second is left, for the parser to refuse.
                if inside.is_none() {
                    inside = Some(contents);
                    (at, next) = (contents.range.end, contents.after);
                    continue;
                }
            }
            brackets.pass(&bytes[at..=at]);
            at += 1;
            if brackets.are_none() {
                break;
            }
        }
        Own { range: start..at, inside }
    }

    /// The event as a line of a log has it; `text` is where it is put together.
    fn line<'t>(&self, bytes: &'t [u8], text: &'t mut Vec<u8>) -> Result<Line<'t>, LogError> {
        let inside = self.inside.map_or(0, |contents| contents.range.len());
        if self.range.len() - inside > MAX_LOG_LINE {
            return Err(too_long(self.line_and_column(bytes, 0).0, MAX_LOG_LINE).into());
        }
        let text = match self.inside {
            None => &bytes[self.range.clone()],
            Some(Contents { range, .. }) => {
                let parts = [&bytes[self.range.start..range.start], NOTHING, &bytes[range.end..self.range.end]];
                text.clear();
                parts.iter().for_each(|part| text.extend_from_slice(part));
                &*text
            }
        };
        from_text(text).map_err(|error| {
            let before = text.split_inclusive(|byte| *byte == b'\n').take(error.line().saturating_sub(1));
            let place = before.map(<[u8]>::len).sum::<usize>() + error.column().saturating_sub(1);
            let (line, column) = self.line_and_column(bytes, place);
            LogError::damaged(line, column, &message_of(&error))
        })
    }

    /// Line and column, from 1, of a place in that line.
    fn line_and_column(&self, bytes: &[u8], place: usize) -> (usize, usize) {
        let mut place = self.range.start + place;
        if let Some(Contents { range, .. }) = self.inside
            && place >= range.start
        {
            place += range.len().saturating_sub(NOTHING.len());
        }
        let before = &bytes[..place.min(bytes.len())];
        let line = 1 + memchr::memchr_iter(b'\n', before).count();
        (line, before.len() - memchr::memrchr(b'\n', before).map_or(0, |end| end + 1) + 1)
    }
}
