//! PPM and PGM, in ASCII and binary, and PFM read back. White space and comments are those of the specification of Netpbm.

use super::picture::{Channels, Picture, PictureError, Samples, check_size, with_room_for};
use crate::files::escape::quoted;
use crate::files::{Netpbm, Notation, without_mark};
use std::ops::Range;
use std::str::FromStr;

/// Reads a picture of this format.
pub(super) fn read(bytes: &[u8], Netpbm { is_colored, notation }: Netpbm) -> Result<Picture, PictureError> {
    let channels = if is_colored { Channels::Rgb } else { Channels::Grey };
    let mut words = Words { bytes, at: bytes.len() - without_mark(bytes).len() + 2 };
    let mut side =
        |what: &str| words.number(|side: &u32| *side > 0, || format!("the {what} of the picture, 1 or more"));
    let (width, height) = (side("width")?, side("height")?);
    check_size([width.into(), height.into()])?;
    let count = (u64::from(width) * u64::from(height)).saturating_mul(channels as u64);
    let samples = match notation {
        Notation::Float => {
            let scale = words.number(
                |scale: &f64| scale.is_finite() && *scale != 0.0,
                || "a scale, whose sign is the order of bytes".to_owned(),
            )?;
            let row = width as usize * channels as usize;
            Samples::Floats(floats(words.raster(count, 4)?, row, scale < 0.0)?)
        }
        Notation::Ascii | Notation::Binary => {
            let highest =
                words.number(|highest: &u16| *highest > 0, || "a highest level from 1 to 65535".to_owned())?;
            let levels = match notation {
                Notation::Ascii => words.levels(count, highest)?,
                _ => levels(words.raster(count, if highest > 255 { 2 } else { 1 })?, highest)?,
            };
            Samples::Levels { levels, highest }
        }
    };
    Ok(Picture { width, height, channels, samples })
}

/// Levels of one byte, or of two with the higher one first.
fn levels(raster: &[u8], highest: u16) -> Result<Vec<u16>, PictureError> {
    let mut levels = with_room_for(raster.len())?;
    match highest {
        ..256 => levels.extend(raster.iter().map(|level| u16::from(*level))),
        _ => levels.extend(raster.as_chunks().0.iter().map(|level| u16::from_be_bytes(*level))),
    }
    match levels.iter().find(|level| **level > highest) {
        Some(found) => Err(PictureError::Level { highest, found: *found }),
        None => Ok(levels),
    }
}

/// Rows go from the bottom up.
fn floats(raster: &[u8], row: usize, is_little_endian: bool) -> Result<Vec<f32>, PictureError> {
    let mut floats = with_room_for(raster.len() / 4)?;
    let float = |four: &[u8; 4]| if is_little_endian { f32::from_le_bytes(*four) } else { f32::from_be_bytes(*four) };
    for row in raster.as_chunks().0.chunks(row).rev() {
        floats.extend(row.iter().map(float));
    }
    Ok(floats)
}

/// White space as C's `isspace` has it.
fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t'..=b'\r')
}

/// The words of a text, between white space and comments, which go from a `#` to the end of the line.
struct Words<'b> {
    bytes: &'b [u8],
    /// Where the last word ends.
    at: usize,
}

impl<'b> Words<'b> {
    /// The place of the next word; an empty one at the end.
    fn next(&mut self) -> Range<usize> {
        while let Some(byte) = self.bytes.get(self.at).filter(|byte| is_space(**byte) || **byte == b'#') {
            if *byte == b'#' { self.pass_comment() } else { self.at += 1 }
        }
        let (start, rest) = (self.at, &self.bytes[self.at..]);
        self.at += rest.iter().position(|byte| is_space(*byte) || *byte == b'#').unwrap_or(rest.len());
        start..self.at
    }

    /// Goes to the end of the line of a comment.
    fn pass_comment(&mut self) {
        let rest = &self.bytes[self.at..];
        self.at += rest.iter().position(|byte| matches!(byte, b'\n' | b'\r')).unwrap_or(rest.len());
    }

    /// The next word as a number that fits.
    fn number<T: FromStr>(
        &mut self,
        fits: impl Fn(&T) -> bool,
        expected: impl Fn() -> String,
    ) -> Result<T, PictureError> {
        let place = self.next();
        let word = &self.bytes[place.clone()];
        let number = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok()).filter(fits);
        number.ok_or_else(|| {
            let shown = || quoted(&String::from_utf8_lossy(word));
            let found = if word.is_empty() { "the end of the file".to_owned() } else { shown() };
            PictureError::Word { place, expected: expected(), found }
        })
    }

    /// The levels of a picture in ASCII: the words behind its header.
    fn levels(&mut self, count: u64, highest: u16) -> Result<Vec<u16>, PictureError> {
        // A level takes a digit and a blank: a header that asks for more costs nothing to write.
        let most = (self.bytes.len() - self.at) as u64 / 2 + 1;
        let mut levels = with_room_for(count.min(most) as usize)?;
        while (levels.len() as u64) < count && !self.is_at_end() {
            levels.push(self.number(|level| *level <= highest, || format!("a level from 0 to {highest}"))?);
        }
        let mut found = levels.len() as u64;
        while !self.is_at_end() {
            self.next();
            found += 1;
        }
        if found == count { Ok(levels) } else { Err(PictureError::Length { expected: count, found, unit: "levels" }) }
    }

    /// Whether no word is left.
    fn is_at_end(&self) -> bool {
        Words { ..*self }.next().is_empty()
    }

    /// The bytes of `count` samples behind the one white space after the header.
    fn raster(&mut self, count: u64, bytes_each: u64) -> Result<&'b [u8], PictureError> {
        if self.bytes.get(self.at) == Some(&b'#') {
            self.pass_comment();
        }
        let expected = count.saturating_mul(bytes_each);
        let raster = self.bytes.get(self.at + 1..).unwrap_or_default();
        match raster {
            // A line may end with two bytes. Whether the end of a comment counts is answered differently by the programs of Netpbm (yes)
            // and by its specification (no). The number of bytes decides.
            [space, raster @ ..] if is_space(*space) && raster.len() as u64 == expected => Ok(raster),
            _ if raster.len() as u64 == expected => Ok(raster),
            _ => Err(PictureError::Length { expected, found: raster.len() as u64, unit: "bytes" }),
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use crate::files::PictureKind;
    use crate::render::export;
    use proptest::prelude::*;
    use proptest::sample::select;

    /// What may be between two words.
    const GAPS: [&[u8]; 11] =
        [b" ", b"\n", b"\t", b"\r", b"\r\n", b"\x0b", b"\x0c", b"  \n ", b"#\n", b" # a 1\r", b"\n##\n# \xff\r\n\t"];

    /// What may be between the last word of a header and the bytes.
    const LAST_GAPS: [&[u8]; 8] = [b" ", b"\n", b"\t", b"\r", b"\r\n", b"#c\n", b"# c\r\n", b"#\n "];

    #[derive(Clone, Debug)]
    struct Spelled {
        magic: &'static str,
        size: [u32; 2],
        highest: u16,
        levels: Vec<u16>,
        gaps: Vec<&'static [u8]>,
        last_gap: &'static [u8],
        zeros: usize,
        before: &'static str,
    }

    impl Spelled {
        fn channels(&self) -> usize {
            if matches!(self.magic, "P3" | "P6" | "PF") { 3 } else { 1 }
        }

        fn is_float(&self) -> bool {
            matches!(self.magic, "PF" | "Pf")
        }

        /// The value that a pixel's channel is to have.
        fn value(&self, [x, y]: [u32; 2], channel: usize) -> f64 {
            let count = self.channels();
            let level = f64::from(self.levels[(y * self.size[0] + x) as usize * count + channel.min(count - 1)]);
            if self.is_float() { level } else { level / f64::from(self.highest) }
        }

        fn bytes(&self) -> Vec<u8> {
            let mut gaps = self.gaps.iter().cycle();
            let mut bytes = [self.before, self.magic].concat().into_bytes();
            let mut word = |bytes: &mut Vec<u8>, word: &str| {
                bytes.extend_from_slice(gaps.next().unwrap());
                bytes.extend(word.as_bytes());
            };
            let zeros = "0".repeat(self.zeros);
            self.size.iter().for_each(|side| word(&mut bytes, &format!("{zeros}{side}")));
            if self.is_float() {
                // The highest level is no part of a PFM; here it chooses the order of bytes.
                let is_little_endian = self.highest.is_multiple_of(2);
                word(&mut bytes, if is_little_endian { "-1.0" } else { "2.5e0" });
                bytes.extend_from_slice(self.last_gap);
                let row = self.size[0] as usize * self.channels();
                for level in self.levels.chunks(row).rev().flatten() {
                    let float = f32::from(*level);
                    bytes.extend(if is_little_endian { float.to_le_bytes() } else { float.to_be_bytes() });
                }
                return bytes;
            }
            word(&mut bytes, &format!("{zeros}{}", self.highest));
            if matches!(self.magic, "P2" | "P3") {
                self.levels.iter().for_each(|level| word(&mut bytes, &format!("{zeros}{level}")));
                bytes.extend_from_slice(self.last_gap);
            } else {
                bytes.extend_from_slice(self.last_gap);
                let each = if self.highest > 255 { 0..2 } else { 1..2 };
                bytes.extend(self.levels.iter().flat_map(|level| level.to_be_bytes()[each.clone()].to_vec()));
            }
            bytes
        }
    }

    fn spelled() -> impl Strategy<Value = Spelled> {
        let highest = prop_oneof![1..=u16::MAX, select(vec![1, 255, 256, 1023, 65535])];
        let picture = (select(vec!["P2", "P3", "P5", "P6", "PF", "Pf"]), [1_u32..5, 1..5], highest);
        let levels = picture.prop_flat_map(|(magic, size, highest)| {
            let count = (size[0] * size[1] * 3) as usize;
            (Just((magic, size, highest)), prop::collection::vec(0..=highest, count))
        });
        let gaps = (prop::collection::vec(select(GAPS.to_vec()), 1..20), select(LAST_GAPS.to_vec()));
        (levels, gaps, 0..3_usize, select(vec!["", "\u{feff}"])).prop_map(
            |(((magic, size, highest), levels), (gaps, last_gap), zeros, before)| {
                let mut spelled = Spelled { magic, size, highest, levels, gaps, last_gap, zeros, before };
                spelled.levels.truncate((size[0] * size[1]) as usize * spelled.channels());
                spelled
            },
        )
    }

    proptest! {
        #[test]
        fn a_picture_is_the_same_in_every_spelling(spelled in spelled()) {
            let bytes = spelled.bytes();
            prop_assert!(PictureKind::of(&bytes).is_some());
            let picture = export::read(&bytes).unwrap();
            prop_assert_eq!((picture.size(), picture.is_float()), (spelled.size, spelled.is_float()));
            let [width, height] = spelled.size;
            for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
                prop_assert_eq!(picture.pixel(pixel), [0, 1, 2].map(|channel| spelled.value(pixel, channel)));
            }
        }
    }

    #[track_caller]
    fn refuses(bytes: &[u8], message: &str) {
        assert!(PictureKind::of(bytes).is_some());
        assert_eq!(export::read(bytes).unwrap_err().to_string(), message);
    }

    #[test]
    fn what_is_wrong_is_named() {
        refuses(b"P3 0 1 255", "expected the width of the picture, 1 or more, found `0`");
        refuses(b"P5 1 -1 255\n\0", "expected the height of the picture, 1 or more, found `-1`");
        refuses(b"Pf", "expected the width of the picture, 1 or more, found the end of the file");
        refuses(b"P6 1 1 65536\n\0\0\0", "expected a highest level from 1 to 65535, found `65536`");
        refuses(b"PF 1 1 0\n", "expected a scale, whose sign is the order of bytes, found `0`");
        refuses(b"P3 1 1 255 1 2 3.5", "expected a level from 0 to 255, found `3.5`");
        refuses(b"P2 1 1 100 \x1b[2J", "expected a level from 0 to 100, found `\\u{1b}[2J`");
        refuses(b"P2 2 1 100 1 101", "expected a level from 0 to 100, found `101`");
        refuses(b"P2 2 2 1 1 0 1 ", "the picture is damaged: expected 4 levels behind the header, found 3");
        refuses(b"P2 1 1 1 1 0 #", "the picture is damaged: expected 1 levels behind the header, found 2");
        refuses(b"P3 99999 99999 1 1", "the picture has 99999 x 99999 pixels, expected at most 268435456 in all");
        refuses(
            b"P6 4294967295 4294967295 1 \0",
            "the picture has 4294967295 x 4294967295 pixels, expected at most 268435456 in all",
        );
        refuses(b"P5 2 1 255\n\0", "the picture is damaged: expected 2 bytes behind the header, found 1");
        refuses(b"P5 1 1 255", "the picture is damaged: expected 1 bytes behind the header, found 0");
        refuses(b"P5 1 1 256\n\x02\x00", "the picture is damaged: its highest level is 256, found 512");
        refuses(b"Pf 1 1 1\n\0\0\0\0\0", "the picture is damaged: expected 4 bytes behind the header, found 5");
    }

    #[test]
    fn words_that_begin_like_a_picture_are_none() {
        for other in ["P", "P31 1", "P4 1 1\n", "PFM", "p3 1 1 1", "v 0 0 0"] {
            assert!(PictureKind::of(other.as_bytes()).is_none(), "{other}");
        }
    }
}
