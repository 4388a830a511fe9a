//! What a file may be besides: packed, or a picture.

use super::{is_a_message, is_short};
use raywalk::files::{Kind, Wanted};
use raywalk::log::file::{read, read_from};
use raywalk::render::difference::difference;
use raywalk::render::export;
use std::io::{Cursor, Read};

/// The largest file that is unpacked here: that a bomb ends at the limit needs no large one.
const MOST: u64 = 1 << 20;

/// A file compressed with gzip or zstd, or by nothing: what it holds comes out in one piece and as a stream, and a log in it is
/// read as it comes.
pub fn packed(bytes: &[u8]) {
    let wanted = Wanted { what: "a file", max_bytes: MOST };
    let opened = || wanted.begin(Cursor::new(bytes.to_vec()), 0, "a".to_owned());
    let whole = match opened() {
        Ok(opened) => opened.bytes(),
        Err(error) => return is_a_message(&error),
    };
    let mut streamed = Vec::new();
    let stream = || opened().unwrap_or_else(|error| panic!("it was opened before: {error}")).stream(MOST);
    let ending = stream().read_to_end(&mut streamed);
    assert!(streamed.len() as u64 <= MOST);
    match whole {
        Ok(whole) => {
            assert_eq!(ending.ok(), Some(whole.len()));
            assert_eq!(whole, streamed);
            if Kind::of(&whole).is_log() {
                let same =
                    [read(&whole), read_from(stream())].map(|found| found.map(|found| (found.log, found.ending)));
                let [a, b] = same.map(|found| found.map_err(|error| error.to_string()));
                assert_eq!(a, b);
            }
        }
        Err(error) => {
            is_a_message(&error);
            assert!(ending.is_err());
        }
    }
}

/// A picture: PNG, BMP, TGA, QOI, TIFF, JPEG, WebP, PPM, PGM, PFM or OpenEXR.
pub fn picture(bytes: &[u8]) {
    let picture = match export::read(bytes) {
        Ok(picture) => picture,
        Err(error) => return is_short(&error.to_string(), 500),
    };
    let [width, height] = picture.size();
    for place in [[0, 0], [width - 1, height - 1], [width, height], [u32::MAX; 2]] {
        let color = picture.pixel(place);
        assert!(picture.is_float() || color.iter().all(|level| (0.0..=1.0).contains(level)), "{color:?}");
    }
    if u64::from(width) * u64::from(height) <= MOST {
        let found = difference(&picture, &picture, |a, b| a != b && !(a.is_nan() && b.is_nan()));
        assert_eq!(found.differing, 0);
    }
}
