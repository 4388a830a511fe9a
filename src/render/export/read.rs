//! Pictures read back: by the crate `image` what it knows, PPM, PGM and PFM with the places of what is wrong in their text, and OpenEXR.

use super::picture::{MAX_PICTURE_BYTES, Picture, PictureError};
use super::{decode, exr, netpbm};
use crate::files::PictureKind;

/// Reads a picture. Transparency is left out: colours are those that the file has.
///
/// # Errors
/// [`PictureError`].
pub fn read(bytes: &[u8]) -> Result<Picture, PictureError> {
    match PictureKind::of(bytes).ok_or(PictureError::Unknown)? {
        PictureKind::Exr => {
            const BYTES_PER_PIXEL: u64 = 12;
            exr::read(bytes, MAX_PICTURE_BYTES * 2 / BYTES_PER_PIXEL)
        }
        PictureKind::Netpbm(kind) => netpbm::read(bytes, kind),
        PictureKind::Image(kind) => decode::read(bytes, kind),
    }
}
