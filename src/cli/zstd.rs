//! Zstandard as it is written: frames of a few MiB, one after the other, which is a file as good as one of a single frame.

use ruzstd::encoding::{CompressionLevel, compress_to_vec};
use std::io::{self, Write};

/// How many bytes a frame holds.
const PIECE: usize = 4 << 20;

/// Packs what is written to it. [`Frames::finish`] writes the last of it.
pub struct Frames<W: Write> {
    place: W,
    piece: Vec<u8>,
    is_empty: bool,
}

impl<W: Write> Frames<W> {
    /// Packs into this place.
    pub fn new(place: W) -> Frames<W> {
        Frames { place, piece: Vec::with_capacity(PIECE), is_empty: true }
    }

    /// Writes the last frame; of nothing, an empty one.
    pub fn finish(mut self) -> io::Result<()> {
        if !self.piece.is_empty() || self.is_empty {
            self.write_frame()?;
        }
        self.place.flush()
    }

    fn write_frame(&mut self) -> io::Result<()> {
        self.is_empty = false;
        let packed = compress_to_vec(self.piece.as_slice(), CompressionLevel::Fastest);
        self.piece.clear();
        self.place.write_all(&packed)
    }
}

impl<W: Write> Write for Frames<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let count = bytes.len().min(PIECE - self.piece.len());
        self.piece.extend_from_slice(&bytes[..count]);
        if self.piece.len() == PIECE {
            self.write_frame()?;
        }
        Ok(count)
    }

    /// A frame isn't ended early: what has come so far waits for the rest of it.
    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
