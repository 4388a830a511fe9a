//! A picture as its file has it, and why it may not be read.

use crate::scene::file::validate::limits::MAX_PIXELS;
use std::ops::Range;

/// The largest picture file that is read: 1 GiB.
pub const MAX_PICTURE_BYTES: u64 = 1 << 30;

/// The formats that are read, as a sentence has them.
pub const READABLE: &str = "PNG, BMP, TGA, QOI, TIFF, JPEG, WebP, PPM (P3, P6), PGM (P2, P5), PFM (PF, Pf) or OpenEXR";

/// A picture as its file has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) channels: Channels,
    pub(super) samples: Samples,
}

/// How many numbers a pixel has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channels {
    /// One, for all three colours.
    Grey = 1,
    /// Red, green and blue.
    Rgb = 3,
}

/// The numbers of each pixel, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Samples {
    /// Levels from 0 to the highest.
    Levels { levels: Vec<u16>, highest: u16 },
    /// The traced values.
    Floats(Vec<f32>),
}

/// Why a picture can't be read.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// It begins with something else.
    #[error("expected a picture as {READABLE}")]
    Unknown,
    /// Its header makes no sense.
    #[error("the header of the picture is damaged: expected {0}")]
    Header(&'static str),
    /// A word of its text makes no sense.
    #[error("expected {expected}, found {found}")]
    Word {
        /// Where it is among the bytes of the file.
        place: Range<usize>,
        /// What should be there.
        expected: String,
        /// The word, safe to print.
        found: String,
    },
    /// There are fewer or more samples than its header says.
    #[error("the picture is damaged: expected {expected} {unit} behind the header, found {found}")]
    Length {
        /// The number that the header asks for.
        expected: u64,
        /// The number that there is.
        found: u64,
        /// What is counted.
        unit: &'static str,
    },
    /// A level is above the highest that its header allows: its colour would be beyond white.
    #[error("the picture is damaged: its highest level is {highest}, found {found}")]
    Level {
        /// The highest that may be.
        highest: u16,
        /// The first above it.
        found: u16,
    },
    /// It has more pixels than any picture may have.
    #[error("the picture has {} x {} pixels, expected at most {MAX_PIXELS} in all", size[0], size[1])]
    TooManyPixels {
        /// Width and height.
        size: [u64; 2],
    },
    /// An OpenEXR file without colours.
    #[error("expected an OpenEXR with the channels R, G and B, or Y alone for grey; found {found}")]
    Channels {
        /// Its channels, safe to print.
        found: String,
    },
    /// An OpenEXR file that can't be decoded.
    #[error("the picture is damaged: {0}")]
    Exr(#[from] ::exr::error::Error),
    /// What its decoder says of a picture that can't be decoded, safe to print.
    #[error("the picture is damaged: {0}")]
    Damaged(String),
    /// What its decoder says of a picture that is whole, but of a kind that it doesn't read, safe to print.
    #[error("the picture is of a kind that isn't read: {0}")]
    Kind(String),
    /// There is no memory for it.
    #[error("no memory for the picture")]
    Memory,
}

impl Picture {
    /// Width and height in pixels.
    pub fn size(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// Whether it holds the traced values, and not levels from black to white.
    pub fn is_float(&self) -> bool {
        matches!(self.samples, Samples::Floats(_))
    }

    /// Red, green and blue of a pixel by column and row from the top left: levels from 0 to 1 as they are encoded, or the floating-point
    /// values themselves. A pixel outside the picture is black.
    pub fn pixel(&self, [x, y]: [u32; 2]) -> [f64; 3] {
        let (place, count) = (y as usize * self.width as usize + x as usize, self.channels as usize);
        [0, 1, 2].map(|channel| {
            let sample = place * count + channel.min(count - 1);
            match &self.samples {
                Samples::Levels { levels, highest } => {
                    levels.get(sample).map_or(0.0, |level| f64::from(*level) / f64::from(*highest))
                }
                Samples::Floats(floats) => floats.get(sample).map_or(0.0, |x| f64::from(*x)),
            }
        })
    }
}

/// Refuses a size before anything is asked for because of it.
pub(super) fn check_size(size: [u64; 2]) -> Result<(), PictureError> {
    match size[0].saturating_mul(size[1]) > MAX_PIXELS {
        true => Err(PictureError::TooManyPixels { size }),
        false => Ok(()),
    }
}

/// An empty list with room for `count` samples: in the middle of the work it could only abort.
pub(super) fn with_room_for<T>(count: usize) -> Result<Vec<T>, PictureError> {
    let mut list = Vec::new();
    raywalk_guard::attempt(|| list.try_reserve_exact(count)).map_err(|_| PictureError::Memory)?;
    Ok(list)
}
