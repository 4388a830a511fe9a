//! Pictures that the crate `image` reads. What a header asks for is compared with what its file can hold before anything is unpacked.

use super::picture::{Channels, MAX_PICTURE_BYTES, Picture, PictureError, Samples, check_size, with_room_for};
use crate::files::ImageKind;
use crate::files::escape::shortened;
use image::codecs::bmp::BmpDecoder;
use image::codecs::jpeg::JpegDecoder;
use image::codecs::png::PngDecoder;
use image::codecs::qoi::QoiDecoder;
use image::codecs::tga::TgaDecoder;
use image::codecs::tiff::TiffDecoder;
use image::codecs::webp::WebPDecoder;
use image::{ImageDecoder, ImageError, Limits};
use std::error::Error;
use std::io::Cursor;

/// The most bytes that a picture may have unpacked: what one of the greatest size needs.
const MOST: u64 = MAX_PICTURE_BYTES * 2;

/// What may be unpacked beside the pixels: profiles of colours, tables.
const MOST_BESIDE: u64 = 1 << 26;

/// As many bytes come from one at most: a match of 258 bytes takes 2 bits or more (RFC 1951).
const DEFLATE_RATIO: u64 = 1032;

/// Where nothing bounds what a byte is unpacked to, a picture with more pixels than these has no more than this many a byte: WebP packs 4096
/// equal pixels into one length, and takes a byte or more for it.
const PIXELS_OF_ANY_FILE: u64 = 1 << 26;
const PIXELS_PER_BYTE: u64 = 1 << 12;

/// What decoders take beside the pixels themselves, as a multiple of those: JPEG has coefficients of two bytes, twice.
const BYTES_BESIDE: usize = 4;

/// This many bytes from there on.
fn at<const N: usize>(bytes: &[u8], place: usize) -> Option<[u8; N]> {
    bytes.get(place..).and_then(|rest| rest.first_chunk()).copied()
}

/// Reads a picture of this format: palettes and fewer than 8 bits are expanded, transparency is left out, and of an animation the picture
/// is taken that readers without animations show.
pub(super) fn read(bytes: &[u8], kind: ImageKind) -> Result<Picture, PictureError> {
    let file = Cursor::new(bytes);
    match kind {
        ImageKind::Png => {
            let bytes = &critical(bytes)?;
            let file = Cursor::new(&**bytes);
            // What is unpacked by the way is bounded by what the pixels need, which is checked as soon as the header itself is.
            check_size([16, 20].map(|place| at(bytes, place).map_or(0, u32::from_be_bytes).into()))?;
            let most = unpacked_png(bytes).min(MOST) + MOST_BESIDE;
            let decoder = PngDecoder::with_limits(file, limits(most)).map_err(damaged)?;
            check_png(bytes)?;
            picture(Ok(decoder), bytes, kind)
        }
        ImageKind::Bmp => picture(BmpDecoder::new(file), bytes, kind),
        ImageKind::Tga => picture(TgaDecoder::new(file), bytes, kind),
        ImageKind::Qoi => {
            // Its decoder knows a limit of its own, and says nothing of it.
            check_size([4, 8].map(|place| at(bytes, place).map_or(0, u32::from_be_bytes).into()))?;
            picture(QoiDecoder::new(file), bytes, kind)
        }
        ImageKind::Tiff => picture(TiffDecoder::new(file), bytes, kind),
        ImageKind::Jpeg => picture(JpegDecoder::new(file), bytes, kind),
        ImageKind::Webp => picture(WebPDecoder::new(file), bytes, kind),
    }
}

fn limits(bytes: u64) -> Limits {
    let mut limits = Limits::no_limits();
    limits.max_alloc = Some(bytes);
    limits
}

/// Reads the picture of a decoder, if its file can hold it.
fn picture<D: ImageDecoder>(
    decoder: Result<D, ImageError>,
    bytes: &[u8],
    kind: ImageKind,
) -> Result<Picture, PictureError> {
    let mut decoder = decoder.map_err(damaged)?;
    let ((width, height), color) = (decoder.dimensions(), decoder.color_type());
    let (pixels, needed) = (u64::from(width) * u64::from(height), decoder.total_bytes());
    if pixels == 0 {
        return Err(PictureError::Header("a width and a height of 1 or more"));
    }
    check_size([width.into(), height.into()])?;
    if needed > MOST {
        return Err(PictureError::Memory);
    }
    // A header costs nothing to write.
    if pixels > most_pixels(bytes, kind) {
        return Err(PictureError::Header("a size that fits the bytes behind it"));
    }
    decoder.set_limits(limits(needed + MOST_BESIDE)).map_err(damaged)?;
    let needed = needed as usize;
    // What decoders take by the way, and after them the samples, could only abort.
    drop(with_room_for::<u8>(needed * (1 + BYTES_BESIDE))?);
    // Zeros that aren't written take no memory: a header may ask for more than its file holds.
    let mut unpacked = vec![0_u8; needed];
    decoder.read_image(&mut unpacked).map_err(damaged)?;
    let channels = if color.has_color() { Channels::Rgb } else { Channels::Grey };
    let count = Count { all: color.channel_count() as usize, kept: channels as usize };
    let samples = match usize::from(color.bytes_per_pixel()) / count.all {
        4 => Samples::Floats(count.samples(&unpacked, f32::from_ne_bytes)?),
        2 => Samples::Levels { levels: count.samples(&unpacked, u16::from_ne_bytes)?, highest: u16::MAX },
        _ => Samples::Levels { levels: count.samples(&unpacked, |[level]| u16::from(level))?, highest: u8::MAX.into() },
    };
    Ok(Picture { width, height, channels, samples })
}

/// How many samples a pixel has, and how many of them are colours.
struct Count {
    all: usize,
    kept: usize,
}

impl Count {
    /// The colours of all pixels.
    fn samples<const N: usize, T>(&self, bytes: &[u8], sample: impl Fn([u8; N]) -> T) -> Result<Vec<T>, PictureError> {
        let unpacked = bytes.as_chunks().0;
        let mut samples = with_room_for(unpacked.len() / self.all * self.kept)?;
        let pixels = unpacked.chunks_exact(self.all);
        samples.extend(pixels.flat_map(|pixel| &pixel[..self.kept]).map(|bytes| sample(*bytes)));
        Ok(samples)
    }
}

/// The most pixels that a file of this format and length can hold.
fn most_pixels(bytes: &[u8], kind: ImageKind) -> u64 {
    let length = bytes.len() as u64;
    let of_any_file = PIXELS_OF_ANY_FILE.max(length.saturating_mul(PIXELS_PER_BYTE));
    length.saturating_mul(match kind {
        // With one bit a pixel; `check_png` knows how many there are.
        ImageKind::Png => 8 * DEFLATE_RATIO,
        // A run of up to 62 pixels takes a byte.
        ImageKind::Qoi => 62,
        // A run of up to 128 pixels takes a byte and a level.
        ImageKind::Tga => 64,
        // A block of 64 levels takes a bit or more, and the finest levels have one a pixel.
        ImageKind::Jpeg => 8 * 64,
        // Packed, a row's end leaves the rest of it out; else a pixel takes a bit.
        ImageKind::Bmp => match at(bytes, 30).map(u32::from_le_bytes) {
            Some(1 | 2) => return of_any_file,
            _ => 8,
        },
        ImageKind::Tiff | ImageKind::Webp => return of_any_file,
    })
}

/// Refuses a PNG whose header asks for more than can be unpacked from the bytes behind it, or whose palette the decoder would leave
/// within a colour.
fn check_png(bytes: &[u8]) -> Result<(), PictureError> {
    let unpacked = unpacked_png(bytes);
    if unpacked > MOST {
        return Err(PictureError::Memory);
    }
    if unpacked / DEFLATE_RATIO > bytes.len() as u64 {
        return Err(PictureError::Header("a size that fits the bytes behind it"));
    }
    let mut rest = bytes.get(SIGNATURE..).unwrap_or_default();
    while let (Some(length), Some(name)) = (at(rest, 0).map(u32::from_be_bytes), at::<4>(rest, 4)) {
        match &name {
            b"PLTE" if !length.is_multiple_of(3) => return Err(PictureError::Header("a palette of whole colours")),
            b"IDAT" => break,
            _ => {}
        }
        // Behind the data is their check.
        rest = rest
            .get(8..)
            .and_then(|rest| rest.get(length as usize..))
            .and_then(|rest| rest.get(4..))
            .unwrap_or_default();
    }
    Ok(())
}

/// The signature before the chunks of a PNG.
const SIGNATURE: usize = 8;

/// The parts of a PNG of which its pixels are made. Profiles of colours, texts and the pictures of an animation are left out: the decoder would
/// unpack them, and some kilobytes of them unpack to more than there is memory for.
fn critical(bytes: &[u8]) -> Result<Vec<u8>, PictureError> {
    const KEPT: [&[u8; 4]; 5] = [b"IHDR", b"PLTE", b"tRNS", b"IDAT", b"IEND"];
    let mut kept = with_room_for(bytes.len())?;
    let (signature, mut rest) = bytes.split_at(SIGNATURE.min(bytes.len()));
    kept.extend_from_slice(signature);
    // A chunk is its length, its name, this many bytes, and their check.
    while let (Some(length), Some(name)) = (at(rest, 0).map(u32::from_be_bytes), at::<4>(rest, 4)) {
        let (chunk, behind) = rest.split_at((length as usize).saturating_add(12).min(rest.len()));
        // Unknown ones without which the picture can't be understood begin with a capital letter. The decoder says what is wrong with them.
        if KEPT.contains(&&name) || name[0].is_ascii_uppercase() {
            kept.extend_from_slice(chunk);
        }
        rest = behind;
    }
    kept.extend_from_slice(rest);
    Ok(kept)
}

/// How many bytes the pixels of a PNG have before they are expanded, by its header; 0 where that is cut off.
fn unpacked_png(bytes: &[u8]) -> u64 {
    // The header is the first chunk, behind the signature, its length and its name.
    let (Some(width), Some(height), Some([depth, color])) = (at(bytes, 16), at(bytes, 20), at(bytes, 24)) else {
        return 0;
    };
    let samples = match color {
        2 => 3,
        4 => 2,
        6 => 4,
        _ => 1,
    };
    let bits = u64::from(u32::from_be_bytes(width)) * samples * u64::from(depth);
    // A row begins with a byte that says how it is filtered.
    (bits.div_ceil(8) + 1).saturating_mul(u32::from_be_bytes(height).into())
}

/// A message as one line. Some end with a line feed, or are in quotes with one escaped.
fn one_line(text: &str) -> String {
    let text = text.trim();
    let unquoted = text.strip_prefix('"').and_then(|text| text.strip_suffix('"'));
    let text = unquoted.map_or(text, |text| text.trim_end_matches("\\n"));
    text.lines().map(str::trim).filter(|line| !line.is_empty()).collect::<Vec<_>>().join(" ")
}

/// What a decoder says. Names of chunks and words of headers come from the file.
fn damaged(error: ImageError) -> PictureError {
    const SHOWN: usize = 200;
    let said = |error: &dyn std::fmt::Display| shortened(&one_line(&error.to_string()), SHOWN);
    match error {
        ImageError::Limits(_) => PictureError::Memory,
        ImageError::Unsupported(error) => PictureError::Kind(said(&error)),
        // The name of the format before it says nothing new.
        ImageError::Decoding(error) => {
            PictureError::Damaged(error.source().map_or_else(|| said(&error), |source| said(&source)))
        }
        error => PictureError::Damaged(said(&error)),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests;
