//! Pictures read back: by the crate `image` what it knows, PPM, PGM and PFM with the places of what is wrong in their text, and OpenEXR.

use super::picture::{EXR, MAX_PICTURE_BYTES, Picture, PictureError};
use super::{decode, exr, netpbm};

/// Whether what begins like this is a picture that can be read.
pub fn is_picture(beginning: &[u8]) -> bool {
    beginning.starts_with(EXR) || netpbm::kind(beginning).is_some() || decode::Kind::of(beginning).is_some()
}

/// Reads a picture. Transparency is left out: colours are those that the file has.
///
/// # Errors
/// [`PictureError`].
pub fn read(bytes: &[u8]) -> Result<Picture, PictureError> {
    if bytes.starts_with(EXR) {
        const BYTES_PER_PIXEL: u64 = 12;
        return exr::read(bytes, MAX_PICTURE_BYTES * 2 / BYTES_PER_PIXEL);
    }
    match (netpbm::kind(bytes), decode::Kind::of(bytes)) {
        (Some(kind), _) => netpbm::read(bytes, kind),
        (None, Some(kind)) => decode::read(bytes, kind),
        (None, None) => Err(PictureError::Unknown),
    }
}
