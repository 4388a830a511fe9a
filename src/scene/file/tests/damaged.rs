//! Texts that were damaged in every place, which are too many to run the program for each.

use super::*;

#[test]
fn what_is_cut_off_anywhere_is_refused() {
    let end = TEXTBOOK.trim_end().len();
    for length in 0..end {
        error_of(&TEXTBOOK.as_bytes()[..length]);
    }
}

#[test]
fn no_single_byte_makes_it_panic() {
    for at in 0..TEXTBOOK.len() {
        let mut bytes = TEXTBOOK.as_bytes().to_vec();
        bytes.remove(at);
        answers(&bytes);
        for byte in [b'"', b'{', b']', b',', b'\\', b'/', b'-', b'0', b'\n', 0, 0x1b, 0x80, 0xc3, 0xff] {
            bytes = TEXTBOOK.as_bytes().to_vec();
            bytes[at] = byte;
            answers(&bytes);
        }
    }
}

fn answers(bytes: &[u8]) {
    if check(bytes, "t").is_err() {
        error_of(bytes);
    }
}
