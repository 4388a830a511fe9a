//! Pictures as files: one file a format, and `read` for those that are compared. Only integer formats know white, transfer and clipping.

mod exr;
mod netpbm;
mod pfm;
mod png;
mod ppm;
mod quantize;
mod read;

pub use exr::{Channel, ExrLayer};
pub use png::of_levels as png_of_levels;
pub use quantize::levels_of as levels;
pub use read::{MAX_PICTURE_BYTES, Picture, PictureError, is_picture, read};

use super::Film;
use crate::scene::Output;

/// A picture format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// PNG with 8 bits a channel.
    Png8,
    /// PNG with 16 bits a channel.
    Png16,
    /// Binary PPM with 8 bits a channel.
    Ppm,
    /// PFM, 32-bit floating point.
    Pfm,
    /// OpenEXR, 32-bit floating point.
    Exr,
}

/// A picture as the bytes of a file.
#[derive(Clone, Debug)]
pub struct Encoded {
    /// The bytes.
    pub bytes: Vec<u8>,
    /// How many pixels had a value that the format can't hold.
    pub clipped_pixels: u64,
}

impl Format {
    /// The format that a file's ending stands for; PNG with 16 bits if asked for.
    pub fn of_ending(ending: &str, png16: bool) -> Option<Format> {
        match ending.to_ascii_lowercase().as_str() {
            "png" if png16 => Some(Format::Png16),
            "png" => Some(Format::Png8),
            "ppm" => Some(Format::Ppm),
            "pfm" => Some(Format::Pfm),
            "exr" => Some(Format::Exr),
            _ => None,
        }
    }

    /// The endings that are known.
    pub const ENDINGS: &str = ".png, .ppm, .pfm or .exr";
}

/// Why a picture can't be written into memory.
#[derive(Debug, thiserror::Error)]
pub enum EncodeError {
    /// The encoder of PNG says so.
    #[error(transparent)]
    Png(#[from] ::png::EncodingError),
    /// The encoder of OpenEXR says so.
    #[error(transparent)]
    Exr(#[from] ::exr::error::Error),
}

/// Writes a picture into memory.
///
/// # Errors
/// Those of the encoders.
pub fn encode(film: &Film, format: Format, output: &Output) -> Result<Encoded, EncodeError> {
    Ok(match format {
        Format::Png8 => {
            let (levels, clipped_pixels) = quantize::levels(film, output, 255);
            Encoded { bytes: png::png8(film, &levels)?, clipped_pixels }
        }
        Format::Png16 => {
            let (levels, clipped_pixels) = quantize::levels(film, output, 65535);
            Encoded { bytes: png::png16(film, &levels)?, clipped_pixels }
        }
        Format::Ppm => {
            let (levels, clipped_pixels) = quantize::levels(film, output, 255);
            Encoded { bytes: ppm::ppm(film, &levels), clipped_pixels }
        }
        Format::Pfm => Encoded { bytes: pfm::pfm(film), clipped_pixels: 0 },
        Format::Exr => with_layers(film, Vec::new())?,
    })
}

/// Writes a picture with layers beside it into memory, as OpenEXR.
///
/// # Errors
/// Those of the encoder.
pub fn with_layers(film: &Film, layers: Vec<ExrLayer>) -> Result<Encoded, EncodeError> {
    Ok(Encoded { bytes: exr::exr(film, layers)?, clipped_pixels: 0 })
}
