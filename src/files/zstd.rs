//! Files packed by Zstandard.

use ruzstd::decoding::errors::{FrameDecoderError, ReadFrameHeaderError};
use ruzstd::decoding::{BlockDecodingStrategy, FrameDecoder};
use std::error;
use std::io::{self, BufRead, BufReader, Error, ErrorKind, Read, Result};

/// The four bytes that every frame begins with; no scene and no log does.
pub(super) const MAGIC: &[u8] = b"\x28\xb5\x2f\xfd";

/// The bytes of a packed file as they were, of one frame after the other. One that was cut off ends with
/// [`ErrorKind::UnexpectedEof`], other damage is [`ErrorKind::InvalidData`].
pub(super) fn unpacked(input: impl Read) -> impl Read {
    Frames { input: BufReader::new(input), decoder: FrameDecoder::new(), is_open: false }
}

/// The frames of a packed file.
struct Frames<R> {
    input: R,
    decoder: FrameDecoder,
    /// Whether a frame has begun.
    is_open: bool,
}

impl<R: BufRead> Read for Frames<R> {
    fn read(&mut self, place: &mut [u8]) -> Result<usize> {
        loop {
            if !self.is_open && !self.begins()? {
                return Ok(0);
            }
            while self.decoder.can_collect() == 0 && !self.decoder.is_finished() {
                let decoded = self.decoder.decode_blocks(&mut self.input, BlockDecodingStrategy::UptoBlocks(1));
                decoded.map_err(|error| damaged(&error))?;
            }
            let count = self.decoder.read(place)?;
            if count > 0 || place.is_empty() {
                return Ok(count);
            }
            let stated = self.decoder.get_checksum_from_data();
            if stated.is_some_and(|sum| self.decoder.get_calculated_checksum() != Some(sum)) {
                return Err(Error::new(ErrorKind::InvalidData, "the checksum is another one"));
            }
            self.is_open = false;
        }
    }
}

impl<R: BufRead> Frames<R> {
    /// Begins the next frame, past those that hold no data; false at the end.
    fn begins(&mut self) -> Result<bool> {
        while !self.input.fill_buf()?.is_empty() {
            match self.decoder.reset(&mut self.input) {
                Ok(()) => {
                    self.is_open = true;
                    return Ok(true);
                }
                Err(FrameDecoderError::ReadFrameHeaderError(ReadFrameHeaderError::SkipFrame { length, .. })) => {
                    io::copy(&mut self.input.by_ref().take(length.into()), &mut io::sink())?;
                }
                Err(error) => return Err(damaged(&error)),
            }
        }
        Ok(false)
    }
}

/// The error as a kind that says whether there is too little or something wrong; what the system says as it is.
fn damaged(error: &(dyn error::Error + 'static)) -> Error {
    let mut cause = Some(error);
    while let Some(error) = cause {
        if let Some(error) = error.downcast_ref::<Error>() {
            match error.raw_os_error() {
                Some(code) => return Error::from_raw_os_error(code),
                None if error.kind() == ErrorKind::UnexpectedEof => return ErrorKind::UnexpectedEof.into(),
                None => {}
            }
        }
        cause = error.source();
    }
    Error::new(ErrorKind::InvalidData, error.to_string())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use ruzstd::encoding::{CompressionLevel, compress_to_vec};

    fn packed(text: &[u8]) -> Vec<u8> {
        compress_to_vec(text, CompressionLevel::Fastest)
    }

    fn read(packed: &[u8]) -> (Vec<u8>, Result<usize>) {
        let mut bytes = Vec::new();
        let result = unpacked(packed).read_to_end(&mut bytes);
        (bytes, result)
    }

    #[test]
    fn frames_follow_one_another_and_skippable_ones_are_passed_over() {
        let long = vec![b'a'; 300_000];
        let term = [&0x184D_2A51_u32.to_le_bytes()[..], &3_u32.to_le_bytes(), b"xyz"].concat();
        let file = [packed(b"one "), term.clone(), packed(b""), packed(&long), term].concat();
        let (bytes, result) = read(&file);
        assert!(result.is_ok());
        assert_eq!(bytes, [b"one ", &long[..]].concat());
    }

    #[test]
    fn what_the_system_says_is_not_taken_for_damage() {
        /// A disk that fails after this many bytes.
        struct Failing<'b>(&'b [u8]);

        impl Read for Failing<'_> {
            fn read(&mut self, place: &mut [u8]) -> Result<usize> {
                const EIO: i32 = 5;
                match self.0.read(place)? {
                    0 => Err(Error::from_raw_os_error(EIO)),
                    count => Ok(count),
                }
            }
        }

        let whole = packed(b"all of it, and all of it again, and all of it once more");
        for length in 0..whole.len() {
            let result = unpacked(Failing(&whole[..length])).read_to_end(&mut Vec::new());
            assert_eq!(result.unwrap_err().raw_os_error(), Some(5), "{length}");
        }
    }

    #[test]
    fn a_file_that_is_cut_off_or_changed_is_distinguished() {
        let whole = packed(b"all of it, and all of it again, and all of it once more");
        for length in 1..whole.len() {
            let (_, result) = read(&whole[..length]);
            assert_eq!(result.unwrap_err().kind(), ErrorKind::UnexpectedEof, "{length}");
        }
        let (bytes, result) = read(&[&whole[..], b"other"].concat());
        assert!(bytes.starts_with(b"all of it") && result.unwrap_err().kind() == ErrorKind::InvalidData);
        let mut changed = whole.clone();
        *changed.last_mut().unwrap() ^= 1;
        assert_eq!(read(&changed).1.unwrap_err().kind(), ErrorKind::InvalidData);
    }
}
