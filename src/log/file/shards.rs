//! The logs of a region's shards, put together line by line.

use super::LogError;
use super::document::is_document;
use super::line::Line;
use super::lines::Lines;
use super::read::{Ending, check_end, error_at, header};
use super::write::Writer;
use crate::log::header::Header;
use std::io::{Read, Write};

/// So many bytes are handed on at a time.
const PIECE: usize = 1 << 18;

/// The log of a shard.
pub struct ShardLog<R> {
    header: Header,
    lines: Lines<R>,
}

impl<R: Read> ShardLog<R> {
    /// Reads the header of a log in NDJSON.
    ///
    /// # Errors
    /// [`LogError`].
    pub fn open(input: R) -> Result<ShardLog<R>, LogError> {
        let mut lines = Lines::of(input);
        if is_document(lines.beginning()?) {
            return Err(LogError::NotALog { found: "one JSON document, while shards are NDJSON".to_owned() });
        }
        Ok(ShardLog { header: header(&mut lines)?, lines })
    }

    /// What the log says about itself.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Adds the lines behind the header to another log, without a change, if the log is whole.
    ///
    /// # Errors
    /// [`LogError::Damaged`] where it isn't, or [`LogError::Io`]; lines may have been added then.
    pub fn add_to(mut self, writer: &mut Writer<'_, impl Write>) -> Result<(), LogError> {
        let (mut text, mut events) = (Vec::new(), 0);
        loop {
            let Some(line) = self.lines.next_line()? else {
                return Err(LogError::damaged(1, 1, "the log has no end line: it was cut off"));
            };
            let number = line.number;
            if line.text.starts_with(b"{\"end\":") {
                let end = serde_json::from_slice::<Line>(line.text).map_err(|error| error_at(number, &error))?.end;
                let ending = end.map(|end| check_end(&end, events, self.lines.digest()));
                let what = match ending {
                    // Packed data that were cut off behind it aren't whole.
                    Some(Ending::Complete) if self.lines.count_rest()? == 0 && self.lines.damage().is_none() => {
                        return Ok(writer.append_text(&text, events)?);
                    }
                    Some(Ending::Complete) => "the log is damaged behind its end line".to_owned(),
                    Some(other) => other.warning().unwrap_or_default(),
                    None => "its end line can't be read".to_owned(),
                };
                return Err(LogError::damaged(number, 1, &what));
            }
            text.extend_from_slice(line.text);
            text.push(b'\n');
            events += 1;
            if text.len() >= PIECE {
                // Its events are counted when all of it is known to be whole.
                writer.append_text(&text, 0)?;
                text.clear();
            }
        }
    }
}
