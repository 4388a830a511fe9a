//! Files packed by gzip.

use std::io::{ErrorKind, Read};

use flate2::read::MultiGzDecoder;

/// The two bytes that every gzip file begins with; no scene and no log does.
const MAGIC: &[u8] = b"\x1f\x8b";

/// The bytes unpacked if they are packed, at most `limit` of them.
///
/// # Errors
/// A sentence, when they are damaged or more than that.
pub fn unpacked(bytes: Vec<u8>, limit: u64) -> Result<Vec<u8>, String> {
    if !bytes.starts_with(MAGIC) {
        return Ok(bytes);
    }
    let mut unpacked = Vec::new();
    let read = MultiGzDecoder::new(bytes.as_slice()).take(limit + 1).read_to_end(&mut unpacked);
    match read {
        Ok(_) if unpacked.len() as u64 > limit => {
            Err(format!("too large, expected at most {limit} bytes when unpacked, found more"))
        }
        Ok(_) => Ok(unpacked),
        Err(error) if error.kind() == ErrorKind::UnexpectedEof => {
            Err("the gzip data end too early, expected a whole file".to_string())
        }
        Err(error) => Err(format!("damaged gzip data ({error}), expected a whole file")),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::GzEncoder;
    use std::io::Write;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn what_is_not_packed_stays_as_it_is() {
        assert_eq!(unpacked(b"{}".to_vec(), 1), Ok(b"{}".to_vec()));
        assert_eq!(unpacked(Vec::new(), 1), Ok(Vec::new()));
    }

    #[test]
    fn packed_bytes_come_back_also_in_several_members() {
        let two = [packed(b"s 0 0"), packed(b" 0 1")].concat();
        assert_eq!(unpacked(two, 9), Ok(b"s 0 0 0 1".to_vec()));
    }

    #[test]
    fn a_bomb_ends_at_the_limit() {
        let bomb = packed(&vec![b' '; 1 << 20]);
        assert!(bomb.len() < 2000);
        let message = "too large, expected at most 1000 bytes when unpacked, found more";
        assert_eq!(unpacked(bomb.clone(), 1000), Err(message.to_string()));
        assert_eq!(unpacked(bomb, 1 << 20).map(|bytes| bytes.len()), Ok(1 << 20));
    }

    #[test]
    fn damage_is_said() {
        let whole = packed(b"some text that is long enough");
        let short = whole[..whole.len() - 9].to_vec();
        assert_eq!(unpacked(short, 99), Err("the gzip data end too early, expected a whole file".to_string()));
        let mut changed = whole;
        let crc = changed.len() - 6;
        changed[crc] ^= 1;
        assert!(unpacked(changed, 99).unwrap_err().starts_with("damaged gzip data ("));
    }
}
