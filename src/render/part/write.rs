//! Writing parts.

use super::{END, PartHeader, WENT_INTO, check, words};
use crate::render::Canvas;
use std::io::{self, Write};

/// Writes a part piece by piece. What is there at any time can be read.
pub struct Writer<W: Write> {
    out: W,
    hasher: blake3::Hasher,
}

impl<W: Write> Writer<W> {
    /// Begins a part.
    pub fn new(out: W, header: &PartHeader) -> io::Result<Self> {
        let mut writer = Writer::going_on(out);
        let mut line = serde_json::to_vec(header)?;
        line.push(b'\n');
        writer.put(&line)?;
        Ok(writer)
    }

    /// Goes on with a part that has its header. It can't be ended as a whole one.
    pub fn going_on(out: W) -> Self {
        Writer { out, hasher: blake3::Hasher::new() }
    }

    /// Writes a piece.
    pub fn piece(&mut self, number: u32, pixels: &Canvas) -> io::Result<()> {
        self.record(number, &words::to_bytes(pixels))
    }

    /// Says that the part went into a picture with this digest.
    pub fn went_into(&mut self, picture: &blake3::Hash) -> io::Result<()> {
        self.record(WENT_INTO, picture.as_bytes())
    }

    /// Ends a part that is whole.
    pub fn finish(mut self) -> io::Result<W> {
        let digest = self.hasher.finalize();
        self.put(&[&END.to_le_bytes()[..], digest.as_bytes()].concat())?;
        self.out.flush()?;
        Ok(self.out)
    }

    /// One write, so that a record is rarely there in part.
    fn record(&mut self, number: u32, content: &[u8]) -> io::Result<()> {
        let mut record = [&number.to_le_bytes()[..], content].concat();
        record.extend_from_slice(&check(&record));
        self.put(&record)
    }

    fn put(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.hasher.update(bytes);
        self.out.write_all(bytes)
    }
}
