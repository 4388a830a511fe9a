//! Levels as the bytes of an integer format, by the crate `image` but for PPM, which is a line before them.

use super::{Format, ppm};
use image::codecs::bmp::BmpEncoder;
use image::codecs::jpeg::JpegEncoder;
use image::codecs::png::{CompressionType, FilterType, PngEncoder};
use image::codecs::qoi::QoiEncoder;
use image::codecs::tga::TgaEncoder;
use image::codecs::tiff::TiffEncoder;
use image::codecs::webp::WebPEncoder;
use image::error::ImageFormatHint;
use image::{ExtendedColorType, ImageEncoder, ImageError, ImageResult};
use std::io::Cursor;

/// Of 1 to 100. Colours aren't thinned out at any quality; at this one hardly any level is off by more than some hundredths of white.
const JPEG_QUALITY: u8 = 95;

/// Writes red, green and blue of each pixel, row by row from the top, as levels up to the highest of the format.
///
/// # Errors
/// Those of the encoder.
pub(super) fn levels(levels: &[u16], size: [u32; 2], format: Format) -> ImageResult<Vec<u8>> {
    let bytes: Vec<u8> = match format {
        // The encoder turns them into the order of bytes that the format has.
        Format::Png16 => levels.iter().flat_map(|level| level.to_ne_bytes()).collect(),
        _ => levels.iter().map(|level| *level as u8).collect(),
    };
    bytes_of(&bytes, size, format)
}

/// The same of levels as they lie in memory.
pub(super) fn bytes_of(levels: &[u8], [width, height]: [u32; 2], format: Format) -> ImageResult<Vec<u8>> {
    let color = if format == Format::Png16 { ExtendedColorType::Rgb16 } else { ExtendedColorType::Rgb8 };
    let mut out = Vec::new();
    match format {
        Format::Ppm => {
            out = ppm::ppm(levels, [width, height]);
            Ok(())
        }
        Format::Bmp => BmpEncoder::new(&mut out).write_image(levels, width, height, color),
        Format::Tga => TgaEncoder::new(&mut out).write_image(levels, width, height, color),
        Format::Qoi => QoiEncoder::new(&mut out).write_image(levels, width, height, color),
        Format::Tiff => TiffEncoder::new(Cursor::new(&mut out)).write_image(levels, width, height, color),
        Format::Jpeg => {
            let encoder = JpegEncoder::new_with_quality(&mut out, JPEG_QUALITY);
            encoder.write_image(levels, width, height, color)
        }
        Format::Webp => WebPEncoder::new_lossless(&mut out).write_image(levels, width, height, color),
        Format::Png8 | Format::Png16 => {
            let encoder = PngEncoder::new_with_quality(&mut out, CompressionType::Fast, FilterType::Adaptive);
            encoder.write_image(levels, width, height, color)
        }
        Format::Pfm | Format::Exr => {
            Err(ImageError::Unsupported(ImageFormatHint::Name("a format of floating-point values".to_owned()).into()))
        }
    }?;
    Ok(out)
}
