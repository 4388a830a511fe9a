//! The formats of pictures: their endings, what they hold, and how large they may be.

use crate::files::one_of;

/// A picture format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// PNG with 8 bits a channel.
    Png8,
    /// PNG with 16 bits a channel.
    Png16,
    /// Binary PPM with 8 bits a channel.
    Ppm,
    /// Windows bitmap, 8 bits a channel, not packed.
    Bmp,
    /// Truevision TGA, 8 bits a channel, packed by run lengths.
    Tga,
    /// QOI, 8 bits a channel.
    Qoi,
    /// TIFF, 8 bits a channel, not packed.
    Tiff,
    /// JPEG, which doesn't keep every level.
    Jpeg,
    /// WebP, 8 bits a channel, without loss.
    Webp,
    /// PFM, 32-bit floating point.
    Pfm,
    /// OpenEXR, 32-bit floating point.
    Exr,
}

/// What names end in, in lower case. Of several endings of a format the first is the one that is listed.
const NAMES: [(&str, Format); 12] = [
    ("png", Format::Png8),
    ("ppm", Format::Ppm),
    ("bmp", Format::Bmp),
    ("tga", Format::Tga),
    ("qoi", Format::Qoi),
    ("tiff", Format::Tiff),
    ("tif", Format::Tiff),
    ("jpg", Format::Jpeg),
    ("jpeg", Format::Jpeg),
    ("webp", Format::Webp),
    ("pfm", Format::Pfm),
    ("exr", Format::Exr),
];

/// The most pixels along a side of a WebP, as its specification's own program has it: readers take one more for none.
pub const MAX_WEBP_SIDE: u32 = 16_383;

impl Format {
    /// The format that a file's ending stands for; PNG with 16 bits if asked for.
    pub fn of_ending(ending: &str, png16: bool) -> Option<Format> {
        let ending = ending.to_ascii_lowercase();
        let (_, format) = NAMES.iter().find(|(name, _)| *name == ending)?;
        Some(if png16 && *format == Format::Png8 { Format::Png16 } else { *format })
    }

    /// The endings that are known, one a format, as a sentence has them: `.png, .ppm … or .exr`.
    pub fn endings() -> String {
        let mut known: Vec<Format> = Vec::new();
        let mut listed: Vec<String> = Vec::new();
        for (name, format) in NAMES {
            if !known.contains(&format) {
                known.push(format);
                listed.push(format!(".{name}"));
            }
        }
        one_of(listed)
    }

    /// The level of full white; `None` where a format holds the traced values themselves.
    pub fn highest(self) -> Option<u16> {
        match self {
            Format::Png16 => Some(u16::MAX),
            Format::Pfm | Format::Exr => None,
            _ => Some(u8::MAX.into()),
        }
    }

    /// The most pixels that the format can have along a side; `None` if no picture has too many.
    pub fn longest_side(self) -> Option<u32> {
        (self == Format::Webp).then_some(MAX_WEBP_SIDE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ending_is_known_in_any_case() {
        let of = |ending| Format::of_ending(ending, false);
        assert_eq!((of("png"), Format::of_ending("PNG", true)), (Some(Format::Png8), Some(Format::Png16)));
        assert_eq!((of("JPG"), of("jpeg")), (Some(Format::Jpeg), Some(Format::Jpeg)));
        assert_eq!((of("tif"), Format::of_ending("tiff", true)), (Some(Format::Tiff), Some(Format::Tiff)));
        assert_eq!((of(""), of("gif"), of("png ")), (None, None, None));
        assert_eq!(Format::endings(), ".png, .ppm, .bmp, .tga, .qoi, .tiff, .jpg, .webp, .pfm or .exr");
    }
}
