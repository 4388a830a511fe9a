//! Files packed by gzip.

use flate2::bufread::GzDecoder;
use std::io::{BufRead, BufReader, Error, ErrorKind, Read, Result};

/// The two bytes that every gzip file begins with; no scene and no log does.
pub(super) const MAGIC: &[u8] = b"\x1f\x8b";

/// The bytes of a packed file as they were, of one member after the other. One that was cut off ends with
/// [`ErrorKind::UnexpectedEof`], other damage is [`ErrorKind::InvalidInput`] or [`ErrorKind::InvalidData`]. Not by `MultiGzDecoder`, which takes
/// what follows for a member that is damaged, or cut off.
pub(super) fn unpacked(input: impl Read) -> impl Read {
    Members { member: Some(GzDecoder::new(BufReader::new(input))) }
}

/// The members of a packed file.
struct Members<R> {
    member: Option<GzDecoder<R>>,
}

impl<R: BufRead> Read for Members<R> {
    fn read(&mut self, place: &mut [u8]) -> Result<usize> {
        while let Some(member) = &mut self.member {
            let count = member.read(place)?;
            if count > 0 || place.is_empty() {
                return Ok(count);
            }
            let Some(mut input) = self.member.take().map(GzDecoder::into_inner) else { break };
            let rest = input.fill_buf()?;
            if rest.is_empty() {
                break;
            }
            // One byte may be all of the next member that was read so far.
            if !rest.starts_with(MAGIC) && rest != &MAGIC[..1] {
                return Err(Error::new(ErrorKind::InvalidData, "other bytes follow the compressed data"));
            }
            self.member = Some(GzDecoder::new(input));
        }
        Ok(0)
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::GzEncoder;
    use std::io::Write;

    #[test]
    fn what_follows_a_packed_file_is_reported() {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(b"all of it").unwrap();
        let whole = encoder.finish().unwrap();
        for behind in [&b"x"[..], b"xxxx", &[0; 600]] {
            let mut read = Vec::new();
            let refused = unpacked(&[&whole, behind].concat()[..]).read_to_end(&mut read).unwrap_err();
            assert_eq!(refused.to_string(), "other bytes follow the compressed data");
            assert_eq!(read, b"all of it");
        }
        let mut read = Vec::new();
        unpacked(&[&whole[..], &whole[..]].concat()[..]).read_to_end(&mut read).unwrap();
        assert_eq!(read, b"all of itall of it");
    }
}
