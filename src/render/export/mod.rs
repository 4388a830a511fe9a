//! Pictures as files, written and read: integer formats by the crate `image`, OpenEXR by `exr`, PFM, PPM and PGM here. Only integer formats
//! know white, transfer, exposure and clipping.

mod beside;
mod decode;
mod encode;
mod exr;
mod format;
mod netpbm;
mod pfm;
mod picture;
mod ppm;
mod quantize;
mod read;

pub use beside::{Beside, Numbers, beside};
pub use exr::{Channel, ExrLayer};
pub use format::{Format, MAX_WEBP_SIDE};
pub use picture::{MAX_PICTURE_BYTES, Picture, PictureError, READABLE};
pub use quantize::{Clipped, levels_of as levels};
pub use read::read;

use super::Film;
use crate::scene::Output;

/// A picture as the bytes of a file.
#[derive(Clone, Debug)]
pub struct Encoded {
    /// The bytes.
    pub bytes: Vec<u8>,
    /// The pixels that had a value that the format can't hold.
    pub clipped: Clipped,
}

/// Why a picture can't be written into memory.
#[derive(Debug, thiserror::Error)]
pub enum EncodeError {
    /// The encoder of an integer format says so.
    #[error(transparent)]
    Image(#[from] ::image::ImageError),
    /// The encoder of OpenEXR says so.
    #[error(transparent)]
    Exr(#[from] ::exr::error::Error),
}

/// Writes a picture into memory.
///
/// # Errors
/// Those of the encoders.
pub fn encode(film: &Film, format: Format, output: &Output) -> Result<Encoded, EncodeError> {
    Ok(match (format, format.highest()) {
        (Format::Exr, _) => with_layers(film, Vec::new())?,
        (_, None) => Encoded { bytes: pfm::pfm(film), clipped: Clipped::default() },
        (_, Some(highest)) => {
            let (levels, clipped) = quantize::levels(film, output, highest);
            Encoded { bytes: encode::levels(&levels, [film.width(), film.height()], format)?, clipped }
        }
    })
}

/// A PNG with 8 bits a channel from the levels of each pixel, row by row from the top.
///
/// # Errors
/// Those of the encoder.
pub fn png_of_levels(levels: &[u8], size: [u32; 2]) -> Result<Vec<u8>, EncodeError> {
    Ok(encode::bytes_of(levels, size, Format::Png8)?)
}

/// Writes a picture with layers beside it into memory, as OpenEXR.
///
/// # Errors
/// Those of the encoder.
pub fn with_layers(film: &Film, layers: Vec<ExrLayer>) -> Result<Encoded, EncodeError> {
    Ok(Encoded { bytes: exr::exr(film, layers)?, clipped: Clipped::default() })
}
