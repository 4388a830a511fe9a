//! Pictures read back: PNG, binary PPM, PFM and OpenEXR.

use super::png::Decoded;

/// The largest picture file that is read: 1 GiB.
pub const MAX_PICTURE_BYTES: u64 = 1 << 30;

/// A picture as its file has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    width: u32,
    height: u32,
    samples: Samples,
}

/// Red, green and blue of each pixel, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
enum Samples {
    /// Levels from 0 to the highest.
    Levels {
        levels: Vec<u16>,
        highest: u16,
    },
    Floats(Vec<f32>),
}

/// Why a picture can't be read.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// It begins with something else.
    #[error("expected a PNG, a binary PPM (P6), a PFM or an OpenEXR file")]
    Unknown,
    /// Its header makes no sense.
    #[error("the header of the picture is damaged: expected {0}")]
    Header(&'static str),
    /// There are fewer or more bytes than its header says.
    #[error("the picture is damaged: expected {expected} bytes behind the header, found {found}")]
    Length {
        /// As many should be there.
        expected: u64,
        /// As many are.
        found: u64,
    },
    /// A level is above the highest that its header allows: its colour would be beyond white.
    #[error("the picture is damaged: its highest level is {highest}, found {found}")]
    Level {
        /// The highest that may be.
        highest: u16,
        /// The first above it.
        found: u16,
    },
    /// An OpenEXR file that can't be decoded.
    #[error("the picture is damaged: {0}")]
    Exr(::exr::error::Error),
    /// A PNG that can't be decoded.
    #[error("the picture is damaged: {0}")]
    Png(::png::DecodingError),
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
        let first = (y as usize * self.width as usize + x as usize) * 3;
        [0, 1, 2].map(|channel| match &self.samples {
            Samples::Levels { levels, highest } => {
                levels.get(first + channel).map_or(0.0, |level| f64::from(*level) / f64::from(*highest))
            }
            Samples::Floats(floats) => floats.get(first + channel).map_or(0.0, |x| f64::from(*x)),
        })
    }
}

/// What an OpenEXR file begins with.
const EXR: &[u8] = b"\x76\x2f\x31\x01";

/// Whether what begins like this is a picture that can be read.
pub fn is_picture(beginning: &[u8]) -> bool {
    [EXR, b"\x89PNG", b"P6", b"PF\n", b"PF ", b"PF\r", b"Pf\n", b"Pf ", b"Pf\r"]
        .iter()
        .any(|magic| beginning.starts_with(magic))
}

/// Reads a picture. Grey ones have three equal channels; transparency is left out.
///
/// # Errors
/// [`PictureError`].
pub fn read(bytes: &[u8]) -> Result<Picture, PictureError> {
    match bytes {
        [0x89, b'P', b'N', b'G', ..] => png(bytes),
        [b'P', b'6', ..] => ppm(bytes),
        [b'P', b'F', ..] => pfm(bytes, 3),
        [b'P', b'f', ..] => pfm(bytes, 1),
        _ if bytes.starts_with(EXR) => exr(bytes),
        _ => Err(PictureError::Unknown),
    }
}

fn png(bytes: &[u8]) -> Result<Picture, PictureError> {
    let Decoded { size: [width, height], levels, highest } = super::png::decode(bytes)?;
    Ok(Picture { width, height, samples: Samples::Levels { levels, highest } })
}

/// Of several layers the first that has red, green and blue.
fn exr(bytes: &[u8]) -> Result<Picture, PictureError> {
    const BYTES_PER_PIXEL: u64 = 12;
    let read = super::exr::read(bytes, MAX_PICTURE_BYTES * 2 / BYTES_PER_PIXEL).map_err(PictureError::Exr)?;
    let (width, height, floats) = read.ok_or(PictureError::Memory)?;
    Ok(Picture { width, height, samples: Samples::Floats(floats) })
}

fn ppm(bytes: &[u8]) -> Result<Picture, PictureError> {
    let (words, body) = header::<3>(&bytes[2..])?;
    let [width, height] = size(words[0], words[1])?;
    let highest: u16 = words[2]
        .parse()
        .ok()
        .filter(|highest| *highest > 0)
        .ok_or(PictureError::Header("a highest level from 1 to 65535"))?;
    let each = if highest > 255 { 2 } else { 1 };
    check_length(body, [width, height], 3 * each)?;
    let levels = match each {
        1 => body.iter().map(|level| u16::from(*level)).collect::<Vec<_>>(),
        _ => body.as_chunks().0.iter().map(|level| u16::from_be_bytes(*level)).collect(),
    };
    if let Some(found) = levels.iter().copied().find(|level| *level > highest) {
        return Err(PictureError::Level { highest, found });
    }
    Ok(Picture { width, height, samples: Samples::Levels { levels, highest } })
}

/// PFM of three channels or one; the sign of its scale is the order of bytes, and rows go from the bottom up.
fn pfm(bytes: &[u8], channels: u64) -> Result<Picture, PictureError> {
    let (words, body) = header::<3>(&bytes[2..])?;
    let [width, height] = size(words[0], words[1])?;
    let scale: f64 = words[2]
        .parse()
        .ok()
        .filter(|scale: &f64| scale.is_finite() && *scale != 0.0)
        .ok_or(PictureError::Header("a scale that isn't 0"))?;
    check_length(body, [width, height], 4 * channels)?;
    let float = |four: &[u8; 4]| if scale < 0.0 { f32::from_le_bytes(*four) } else { f32::from_be_bytes(*four) };
    let mut floats = Vec::new();
    floats.try_reserve_exact(width as usize * height as usize * 3).map_err(|_| PictureError::Memory)?;
    let copies = if channels == 1 { 3 } else { 1 };
    for row in body.as_chunks::<4>().0.chunks(width as usize * channels as usize).rev() {
        floats.extend(row.iter().flat_map(|four| std::iter::repeat_n(float(four), copies)));
    }
    Ok(Picture { width, height, samples: Samples::Floats(floats) })
}

/// The words of a header, each behind white space or a comment, and what stands behind the one white space after the last.
fn header<const N: usize>(bytes: &[u8]) -> Result<([&str; N], &[u8]), PictureError> {
    const MISSING: PictureError = PictureError::Header("width, height and a number behind them");
    let (mut words, mut rest) = ([""; N], bytes);
    for word in &mut words {
        rest = rest.trim_ascii_start();
        while rest.starts_with(b"#") {
            let end = rest.iter().position(|byte| *byte == b'\n').ok_or(MISSING)?;
            rest = rest[end..].trim_ascii_start();
        }
        let end = rest.iter().position(u8::is_ascii_whitespace).ok_or(MISSING)?;
        *word = std::str::from_utf8(&rest[..end]).map_err(|_| MISSING)?;
        rest = &rest[end..];
    }
    Ok((words, &rest[1..]))
}

fn size(width: &str, height: &str) -> Result<[u32; 2], PictureError> {
    let side = |word: &str| word.parse().ok().filter(|side: &u32| *side > 0);
    side(width)
        .zip(side(height))
        .map(|(width, height)| [width, height])
        .ok_or(PictureError::Header("width and height from 1 on"))
}

fn check_length(body: &[u8], [width, height]: [u32; 2], each: u64) -> Result<(), PictureError> {
    let expected = (u64::from(width) * u64::from(height)).saturating_mul(each);
    let found = body.len() as u64;
    if expected == found { Ok(()) } else { Err(PictureError::Length { expected, found }) }
}
