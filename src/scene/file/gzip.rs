//! Files packed by gzip.

use flate2::read::MultiGzDecoder;
use std::io::{Error, ErrorKind, Read};

/// The two bytes that every gzip file begins with; no scene and no log does.
const MAGIC: &[u8] = b"\x1f\x8b";

/// Whether a file that begins like this is packed.
pub fn is_packed(beginning: &[u8]) -> bool {
    beginning.starts_with(MAGIC)
}

/// The bytes of a packed file as they were. One that was cut off ends with [`ErrorKind::UnexpectedEof`].
pub fn unpacked(input: impl Read) -> impl Read {
    MultiGzDecoder::new(input)
}

/// What is wrong with a packed file, if that is why it can't be read.
pub fn damage(error: &Error) -> Option<String> {
    match error.kind() {
        ErrorKind::UnexpectedEof => Some("the gzip data end too early, expected a whole file".to_string()),
        ErrorKind::InvalidInput | ErrorKind::InvalidData => {
            Some(format!("damaged gzip data ({error}), expected a whole file"))
        }
        _ => None,
    }
}
