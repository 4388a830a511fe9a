//! PNG, written and read.

use super::read::{Channels, MAX_PICTURE_BYTES, PictureError, with_room_for};
use crate::render::Film;
use png::{BitDepth, ColorType, Compression, DecodingError, EncodingError, Filter, Limits, Transformations};
use std::io::Cursor;

pub(super) fn png8(film: &Film, levels: &[u16]) -> Result<Vec<u8>, EncodingError> {
    let bytes: Vec<u8> = levels.iter().map(|level| *level as u8).collect();
    of_levels(&bytes, [film.width(), film.height()])
}

pub(super) fn png16(film: &Film, levels: &[u16]) -> Result<Vec<u8>, EncodingError> {
    let bytes: Vec<u8> = levels.iter().flat_map(|level| level.to_be_bytes()).collect();
    encode(&bytes, [film.width(), film.height()], BitDepth::Sixteen)
}

/// A PNG with 8 bits a channel from the levels of each pixel, row by row from the top.
pub fn of_levels(levels: &[u8], size: [u32; 2]) -> Result<Vec<u8>, EncodingError> {
    encode(levels, size, BitDepth::Eight)
}

fn encode(bytes: &[u8], [width, height]: [u32; 2], depth: BitDepth) -> Result<Vec<u8>, EncodingError> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(depth);
    encoder.set_compression(Compression::Fast);
    encoder.set_filter(Filter::Adaptive);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(bytes)?;
    writer.finish()?;
    Ok(out)
}

/// As many bytes come from one at the most: a match of 258 bytes takes 2 bits or more (RFC 1951).
const DEFLATE_RATIO: usize = 1032;

/// What a PNG holds.
pub(super) struct Decoded {
    pub size: [u32; 2],
    pub channels: Channels,
    /// The levels of each pixel, row by row from the top.
    pub levels: Vec<u16>,
    pub highest: u16,
}

/// Reads a PNG of any kind: palettes and fewer than 8 bits are expanded, transparency is left out, and of an animation the picture is taken that readers without animations show.
pub(super) fn decode(bytes: &[u8]) -> Result<Decoded, PictureError> {
    // What unpacks to more than a picture of the greatest size would need isn't begun.
    const MOST: usize = MAX_PICTURE_BYTES as usize * 2;
    let mut decoder = png::Decoder::new_with_limits(Cursor::new(bytes), Limits { bytes: MOST });
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(damaged)?;
    let (color, depth) = reader.output_color_type();
    let needed = reader.output_buffer_size().filter(|needed| *needed <= MOST).ok_or(PictureError::Memory)?;
    // Nor what its bytes can't be unpacked to: a header costs nothing to write.
    if reader.info().raw_bytes() / DEFLATE_RATIO > bytes.len() {
        return Err(PictureError::Header("a size that fits the bytes behind it"));
    }
    // The decoder takes a palette in pieces of three.
    if reader.info().palette.as_ref().is_some_and(|palette| !palette.len().is_multiple_of(3)) {
        return Err(PictureError::Header("a palette of whole colours"));
    }
    let mut unpacked = with_room_for(needed)?;
    unpacked.resize(needed, 0_u8);
    let frame = reader.next_frame(&mut unpacked).map_err(damaged)?;
    let is_grey = matches!(color, ColorType::Grayscale | ColorType::GrayscaleAlpha);
    let channels = if is_grey { Channels::Grey } else { Channels::Rgb };
    let kept = channels as usize;
    let mut levels = with_room_for(frame.width as usize * frame.height as usize * kept)?;
    let highest = match depth {
        BitDepth::Sixteen => {
            let pixels = unpacked.as_chunks().0.chunks_exact(color.samples());
            levels.extend(pixels.flat_map(|pixel| &pixel[..kept]).map(|level| u16::from_be_bytes(*level)));
            u16::MAX
        }
        _ => {
            let pixels = unpacked.chunks_exact(color.samples());
            levels.extend(pixels.flat_map(|pixel| &pixel[..kept]).map(|level| u16::from(*level)));
            u8::MAX.into()
        }
    };
    Ok(Decoded { size: [frame.width, frame.height], channels, levels, highest })
}

fn damaged(error: DecodingError) -> PictureError {
    match error {
        DecodingError::LimitsExceeded => PictureError::Memory,
        error => PictureError::Png(error),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of two by one pixels in this encoding.
    fn of_two_pixels(color: ColorType, depth: BitDepth, data: &[u8]) -> Decoded {
        let mut out = Vec::new();
        let mut encoder = png::Encoder::new(&mut out, 2, 1);
        encoder.set_color(color);
        encoder.set_depth(depth);
        if color == ColorType::Indexed {
            encoder.set_palette(vec![1, 2, 3, 4, 5, 6]);
        }
        let mut writer = encoder.write_header().expect("a header");
        writer.write_image_data(data).expect("the pixels");
        writer.finish().expect("the end");
        decode(&out).unwrap_or_else(|error| panic!("{color:?} {depth:?}: {error}"))
    }

    #[test]
    fn every_kind_is_read() {
        use BitDepth::{Eight, Four, One, Sixteen, Two};
        use ColorType::{Grayscale, GrayscaleAlpha, Indexed, Rgb, Rgba};
        let kinds: [(_, _, &[u8], &[u16], _); 11] = [
            (Grayscale, One, &[0b0100_0000], &[0, 255], 255),
            (Grayscale, Two, &[0b0110_0000], &[85, 170], 255),
            (Grayscale, Four, &[0x1f], &[17, 255], 255),
            (Grayscale, Eight, &[7, 9], &[7, 9], 255),
            (Grayscale, Sixteen, &[1, 2, 3, 4], &[258, 772], 65535),
            (GrayscaleAlpha, Eight, &[7, 0, 9, 255], &[7, 9], 255),
            (Indexed, One, &[0b0100_0000], &[1, 2, 3, 4, 5, 6], 255),
            (Indexed, Eight, &[1, 0], &[4, 5, 6, 1, 2, 3], 255),
            (Rgb, Eight, &[1, 2, 3, 4, 5, 6], &[1, 2, 3, 4, 5, 6], 255),
            (Rgba, Eight, &[1, 2, 3, 0, 4, 5, 6, 128], &[1, 2, 3, 4, 5, 6], 255),
            (Rgb, Sixteen, &[0, 1, 0, 2, 0, 3, 1, 4, 1, 5, 1, 6], &[1, 2, 3, 260, 261, 262], 65535),
        ];
        for (color, depth, data, levels, highest) in kinds {
            let decoded = of_two_pixels(color, depth, data);
            assert_eq!((decoded.size, decoded.highest), ([2, 1], highest), "{color:?} {depth:?}");
            assert_eq!(decoded.levels, levels, "{color:?} {depth:?}");
        }
    }

    #[test]
    fn a_palette_that_ends_within_a_colour() {
        let mut out = Vec::new();
        let mut encoder = png::Encoder::new(&mut out, 1, 1);
        encoder.set_color(ColorType::Indexed);
        encoder.set_palette(vec![1, 2, 3, 4]);
        let mut writer = encoder.write_header().expect("a header");
        writer.write_image_data(&[0]).expect("the pixel");
        writer.finish().expect("the end");
        assert!(matches!(decode(&out), Err(PictureError::Header("a palette of whole colours"))));
    }

    #[test]
    fn what_unpacks_to_too_much_is_not_begun() {
        // Some bytes that say they are so many pixels.
        let claim = |side: u32| {
            let mut out = Vec::new();
            let mut writer = png::Encoder::new(&mut out, side, side).write_header().expect("a header");
            writer.write_chunk(png::chunk::IDAT, b"\x78\x9c\x01").expect("a chunk");
            drop(writer);
            decode(&out)
        };
        assert!(matches!(claim(1 << 30), Err(PictureError::Memory)));
        // They could be held, and aren't there.
        assert!(matches!(claim(1 << 14), Err(PictureError::Header("a size that fits the bytes behind it"))));
        // What is all black is packed to a thousandth.
        let black = of_levels(&vec![0; 3 << 20], [1 << 10, 1 << 10]).expect("a PNG");
        assert!(black.len() < 50_000 && decode(&black).expect("a picture").levels == vec![0; 3 << 20]);
    }
}
