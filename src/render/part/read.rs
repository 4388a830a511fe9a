//! Reading parts, also such as were cut off: what is whole is read.

use super::{CHECK, END, FORMAT, PartHeader, Picture, WENT_INTO, check, words};
use crate::files::PART;
use crate::files::escape::shortened;
use crate::render::Canvas;
use crate::render::pieces::PIECE;
use crate::scene::file::validate::limits::{MAX_PIXELS, MAX_SIDE};
use serde::Deserialize;
use std::collections::BTreeSet;
use std::io::{self, BufRead, ErrorKind, Read};

/// The longest header: one with the names of many objects.
pub const MAX_PART_HEADER: u64 = 1 << 28;

/// Why a part can't be read.
#[derive(Debug, thiserror::Error)]
pub enum PartError {
    /// The bytes couldn't be had.
    #[error("cannot read: {0}")]
    Io(#[from] io::Error),
    /// It was cut off in its header.
    #[error("the part was cut off in its header")]
    CutOff,
    /// It is something else.
    #[error("expected a part that `render --shard` wrote, of the format {FORMAT}: {0}")]
    NotAPart(String),
}

/// What is in a part.
#[derive(Clone, Debug, PartialEq)]
pub enum Record {
    /// The pixels of a piece.
    Piece(u32, Canvas),
    /// It went into a picture with this digest.
    WentInto(blake3::Hash),
    /// It is whole.
    End,
}

/// Reads a part record by record.
pub struct Reader<R> {
    input: R,
    header: PartHeader,
    hasher: blake3::Hasher,
    /// How many bytes are good: up to the last whole record.
    good: u64,
    /// How many pieces the picture has.
    pieces: u32,
}

impl<R: BufRead> Reader<R> {
    /// Reads the header.
    ///
    /// # Errors
    /// [`PartError`].
    pub fn open(mut input: R) -> Result<Reader<R>, PartError> {
        let mut line = Vec::new();
        input.by_ref().take(MAX_PART_HEADER).read_until(b'\n', &mut line)?;
        let is_part = line.starts_with(PART);
        let is_beginning = !line.is_empty() && PART.starts_with(&line);
        if is_beginning || (is_part && !line.ends_with(b"\n")) {
            return Err(PartError::CutOff);
        }
        if !is_part {
            return Err(PartError::NotAPart("it begins otherwise".to_owned()));
        }
        const LONGEST: usize = 200;
        /// What every version has.
        #[derive(Deserialize)]
        struct Version {
            part: String,
        }
        let wrong = |error: serde_json::Error| PartError::NotAPart(shortened(&error.to_string(), LONGEST));
        let version: Version = serde_json::from_slice(&line).map_err(wrong)?;
        if version.part != FORMAT {
            return Err(PartError::NotAPart(format!("found {}", shortened(&version.part, LONGEST))));
        }
        let header: PartHeader = serde_json::from_slice(&line).map_err(wrong)?;
        let pieces = count_of(&header.picture).ok_or_else(|| {
            PartError::NotAPart(format!("its rectangle of pixels is none: {:?}", header.picture.crop))
        })?;
        let mut hasher = blake3::Hasher::new();
        hasher.update(&line);
        Ok(Reader { input, header, hasher, good: line.len() as u64, pieces })
    }

    /// What the part is of.
    pub fn header(&self) -> &PartHeader {
        &self.header
    }

    /// How many bytes are good so far.
    pub fn good(&self) -> u64 {
        self.good
    }

    /// The next record; `None` where the part was cut off or damaged, and behind its end.
    ///
    /// # Errors
    /// When the input can't be read.
    pub fn next_record(&mut self) -> io::Result<Option<Record>> {
        let mut record = Vec::new();
        if !self.fill(&mut record, size_of::<u32>())? {
            return Ok(None);
        }
        let number = u32::from_le_bytes([record[0], record[1], record[2], record[3]]);
        let found = match number {
            END => {
                let expected = self.hasher.finalize();
                let is_whole = self.fill(&mut record, blake3::OUT_LEN)? && record[4..] == expected.as_bytes()[..];
                return Ok((is_whole && self.is_at_end()?).then_some(Record::End));
            }
            WENT_INTO => self.content(&mut record, blake3::OUT_LEN)?.then(|| {
                let mut digest = [0; blake3::OUT_LEN];
                digest.copy_from_slice(&record[4..4 + blake3::OUT_LEN]);
                Record::WentInto(digest.into())
            }),
            _ => match self.area(number) {
                Some(area @ [left, top, right, bottom]) => {
                    let pixels = (right - left) as usize * (bottom - top) as usize;
                    let content = &self.header.picture.content;
                    let length = pixels * words::count(content) * size_of::<u64>();
                    let is_whole = self.content(&mut record, length)?;
                    is_whole.then(|| {
                        let content = &self.header.picture.content;
                        Record::Piece(number, words::from_bytes(content, area, &record[4..4 + length]))
                    })
                }
                None => None,
            },
        };
        if found.is_some() {
            self.hasher.update(&record);
            self.good += record.len() as u64;
        }
        Ok(found)
    }

    /// Hands on every piece that follows; whether the part is whole.
    ///
    /// # Errors
    /// When the input can't be read.
    pub fn each_piece(&mut self, mut take: impl FnMut(Canvas)) -> io::Result<bool> {
        let mut missing: BTreeSet<u32> = self.header.pieces().map(|(number, _)| number).collect();
        loop {
            match self.next_record()? {
                Some(Record::Piece(number, piece)) => {
                    missing.remove(&number);
                    take(piece);
                }
                Some(Record::End) => return Ok(missing.is_empty()),
                Some(Record::WentInto(_)) | None => return Ok(false),
            }
        }
    }

    /// Whether nothing follows, nor anything that was packed badly.
    fn is_at_end(&mut self) -> io::Result<bool> {
        match self.input.fill_buf() {
            Ok(rest) => Ok(rest.is_empty()),
            Err(error) if is_damage(&error) => Ok(false),
            Err(error) => Err(error),
        }
    }

    /// The rectangle of a piece that the part may have.
    fn area(&self, number: u32) -> Option<[u32; 4]> {
        let [left, top, right, bottom] = self.header.picture.crop;
        let across = (right - left).div_ceil(PIECE);
        let is_there = number < self.pieces && self.header.shard.has(number);
        is_there.then(|| {
            let (x, y) = (left + number % across * PIECE, top + number / across * PIECE);
            [x, y, right.min(x + PIECE), bottom.min(y + PIECE)]
        })
    }

    /// Reads the rest of a record behind its number; whether its check fits.
    fn content(&mut self, record: &mut Vec<u8>, length: usize) -> io::Result<bool> {
        if !self.fill(record, length + CHECK)? {
            return Ok(false);
        }
        let (content, found) = record.split_at(record.len() - CHECK);
        Ok(check(content) == found)
    }

    /// Reads this many bytes more; whether there were this many.
    fn fill(&mut self, record: &mut Vec<u8>, length: usize) -> io::Result<bool> {
        match self.input.by_ref().take(length as u64).read_to_end(record) {
            Ok(read) => Ok(read == length),
            Err(error) if is_damage(&error) => Ok(false),
            Err(error) => Err(error),
        }
    }
}

/// Whether packed data were cut off or changed.
fn is_damage(error: &io::Error) -> bool {
    matches!(error.kind(), ErrorKind::UnexpectedEof | ErrorKind::InvalidData)
}

/// How many pieces a picture has; `None` if its rectangle is none.
fn count_of(picture: &Picture) -> Option<u32> {
    let [left, top, right, bottom] = picture.crop;
    let is_rectangle = left < right && top < bottom && right <= MAX_SIDE && bottom <= MAX_SIDE;
    let (width, height) = (right.wrapping_sub(left), bottom.wrapping_sub(top));
    let is_small = u64::from(width) * u64::from(height) <= MAX_PIXELS;
    (is_rectangle && is_small).then(|| width.div_ceil(PIECE) * height.div_ceil(PIECE))
}
