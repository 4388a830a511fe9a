//! Files packed by gzip.

use flate2::bufread::MultiGzDecoder;
use std::io::{BufReader, Read};

/// The two bytes that every gzip file begins with; no scene and no log does.
pub(super) const MAGIC: &[u8] = b"\x1f\x8b";

/// The bytes of a packed file as they were, of one member after the other. One that was cut off ends with
/// [`UnexpectedEof`](std::io::ErrorKind::UnexpectedEof), other damage, and other bytes behind it, is
/// [`InvalidInput`](std::io::ErrorKind::InvalidInput) or [`InvalidData`](std::io::ErrorKind::InvalidData).
pub(super) fn unpacked(input: impl Read) -> impl Read {
    MultiGzDecoder::new(BufReader::new(input))
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
            assert!(unpacked(&[&whole, behind].concat()[..]).read_to_end(&mut read).is_err());
            assert_eq!(read, b"all of it");
        }
        let mut read = Vec::new();
        unpacked(&[&whole[..], &whole[..]].concat()[..]).read_to_end(&mut read).unwrap();
        assert_eq!(read, b"all of itall of it");
    }
}
