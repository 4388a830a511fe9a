//! Pictures that aren't what their headers say: compared or refused within the limits of time and memory.

use crate::run::{answer, raywalk};
use flate2::write::ZlibEncoder;
use flate2::{Compression, Crc};
use std::fs;
use std::io::Write;
use std::path::Path;

/// The files of the corpus whose headers ask for 16000 × 16000 pixels, and have some bytes.
const HUGE: [&str; 6] = ["huge.bmp", "huge.tga", "huge.qoi", "huge.tiff", "huge.jpg", "huge.webp"];

#[test]
fn a_header_that_asks_for_more_than_there_is() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus/picture");
    if !folder.exists() {
        return;
    }
    for name in HUGE {
        let refused = answer(&mut raywalk(&folder, &["diff", name, "a.png"])).ends_with(2);
        let expected = format!(
            "error: {name}: the header of the picture is damaged: expected a size that fits the bytes behind it\n"
        );
        assert_eq!(refused.message, expected);
    }
    // As a scene it is a picture all the same.
    let refused = answer(&mut raywalk(&folder, &["scene", "check", "a.webp"])).ends_with(2);
    assert!(refused.message.contains("a picture; `raywalk diff` compares two"), "{}", refused.message);
}

/// A part of a PNG.
pub fn chunk(name: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let mut crc = Crc::new();
    crc.update(name);
    crc.update(data);
    [&(data.len() as u32).to_be_bytes()[..], name, data, &crc.sum().to_be_bytes()].concat()
}

/// A pixel of white, with parts before and behind the pixel.
pub fn white_png(before: &[u8], behind: &[u8]) -> Vec<u8> {
    let mut row = ZlibEncoder::new(Vec::new(), Compression::fast());
    row.write_all(&[0, 255, 255, 255]).expect("memory");
    let header = chunk(b"IHDR", &[0, 0, 0, 1, 0, 0, 0, 1, 8, 2, 0, 0, 0]);
    let data = chunk(b"IDAT", &row.finish().expect("memory"));
    [&b"\x89PNG\r\n\x1a\n"[..], &header, before, &data, behind, &chunk(b"IEND", &[])].concat()
}

/// A pixel of white with a profile of colours that unpacks to half a gigabyte.
#[test]
fn a_profile_that_unpacks_to_more_than_the_memory() {
    let zeros = vec![0; 1 << 20];
    let mut packed = ZlibEncoder::new(b"a\0\0".to_vec(), Compression::fast());
    (0..512).for_each(|_| packed.write_all(&zeros).expect("memory"));
    let profile = packed.finish().expect("memory");
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("bomb.png"), white_png(&chunk(b"iCCP", &profile), &[])).expect("written");
    fs::write(folder.path().join("white.ppm"), b"P6 1 1 255\n\xff\xff\xff").expect("written");
    let compared = answer(&mut raywalk(folder.path(), &["diff", "bomb.png", "white.ppm"])).ends_with(0);
    assert_eq!(String::from_utf8_lossy(&compared.out), "the same: 1 pixels, none differs\n");
}
