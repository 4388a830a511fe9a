//! PNG.

use crate::render::Film;
use image::codecs::png::PngEncoder;
use image::{ExtendedColorType, ImageEncoder, ImageError};

pub(super) fn png8(film: &Film, levels: &[u16]) -> Result<Vec<u8>, ImageError> {
    let bytes: Vec<u8> = levels.iter().map(|level| *level as u8).collect();
    encode(film, &bytes, ExtendedColorType::Rgb8)
}

pub(super) fn png16(film: &Film, levels: &[u16]) -> Result<Vec<u8>, ImageError> {
    // The encoder takes native bytes and writes big-endian ones.
    let bytes: Vec<u8> = levels.iter().flat_map(|level| level.to_ne_bytes()).collect();
    encode(film, &bytes, ExtendedColorType::Rgb16)
}

/// A PNG with 8 bits a channel from the levels of each pixel, row by row from the top.
pub fn of_levels(levels: &[u8], [width, height]: [u32; 2]) -> Result<Vec<u8>, ImageError> {
    let mut out = Vec::new();
    PngEncoder::new(&mut out).write_image(levels, width, height, ExtendedColorType::Rgb8)?;
    Ok(out)
}

fn encode(film: &Film, bytes: &[u8], color: ExtendedColorType) -> Result<Vec<u8>, ImageError> {
    let mut out = Vec::new();
    PngEncoder::new(&mut out).write_image(bytes, film.width(), film.height(), color)?;
    Ok(out)
}
