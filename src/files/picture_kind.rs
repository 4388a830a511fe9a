//! What kind of picture a file is, by its first bytes.

use super::source::without_mark;

/// The kinds of picture that are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureKind {
    /// OpenEXR.
    Exr,
    /// PPM, PGM or PFM.
    Netpbm(Netpbm),
    /// What the crate `image` reads.
    Image(ImageKind),
}

/// A format of Netpbm: how many channels it has, and how they are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Netpbm {
    /// Whether it has three channels, and not one for all colours.
    pub is_colored: bool,
    /// How numbers are written.
    pub notation: Notation,
}

/// How the numbers of a Netpbm picture are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// As digits.
    Ascii,
    /// As bytes.
    Binary,
    /// As numbers of 32 bits.
    Float,
}

/// The formats of the crate `image`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum ImageKind {
    Png,
    Bmp,
    Tga,
    Qoi,
    Tiff,
    Jpeg,
    Webp,
}

/// What files begin with that nothing else begins with.
const MAGIC: [(&[u8], PictureKind); 6] = [
    (b"\x76\x2f\x31\x01", PictureKind::Exr),
    (b"\x89PNG", PictureKind::Image(ImageKind::Png)),
    (b"\xff\xd8\xff", PictureKind::Image(ImageKind::Jpeg)),
    (b"qoif", PictureKind::Image(ImageKind::Qoi)),
    (b"II*\0", PictureKind::Image(ImageKind::Tiff)),
    (b"MM\0*", PictureKind::Image(ImageKind::Tiff)),
];

impl PictureKind {
    /// The kind of what begins like this.
    pub fn of(beginning: &[u8]) -> Option<PictureKind> {
        if let Some((_, kind)) = MAGIC.iter().find(|(magic, _)| beginning.starts_with(magic)) {
            return Some(*kind);
        }
        if let Some(netpbm) = netpbm(beginning) {
            return Some(PictureKind::Netpbm(netpbm));
        }
        let is_webp = beginning.starts_with(b"RIFF") && at(beginning, 8) == Some(*b"WEBP");
        let kinds =
            [(is_webp, ImageKind::Webp), (is_bmp(beginning), ImageKind::Bmp), (is_tga(beginning), ImageKind::Tga)];
        kinds.into_iter().find(|(is_it, _)| *is_it).map(|(_, kind)| PictureKind::Image(kind))
    }
}

fn netpbm(beginning: &[u8]) -> Option<Netpbm> {
    let (magic, rest) = without_mark(beginning).split_at_checked(2)?;
    let (is_colored, notation) = match magic {
        b"P2" => (false, Notation::Ascii),
        b"P3" => (true, Notation::Ascii),
        b"P5" => (false, Notation::Binary),
        b"P6" => (true, Notation::Binary),
        b"Pf" => (false, Notation::Float),
        b"PF" => (true, Notation::Float),
        _ => return None,
    };
    let is_word = rest.first().is_none_or(|byte| matches!(byte, b' ' | b'\t' | b'\n' | 0x0b | 0x0c | b'\r' | b'#'));
    is_word.then_some(Netpbm { is_colored, notation })
}

/// This many bytes from there on.
fn at<const N: usize>(bytes: &[u8], place: usize) -> Option<[u8; N]> {
    bytes.get(place..).and_then(|rest| rest.first_chunk()).copied()
}

/// A text may begin with `BM`, too: behind it is the length of one of the headers that there are.
fn is_bmp(beginning: &[u8]) -> bool {
    const LENGTHS: [u32; 7] = [12, 40, 52, 56, 64, 108, 124];
    beginning.starts_with(b"BM")
        && at(beginning, 14).is_some_and(|length| LENGTHS.contains(&u32::from_le_bytes(length)))
}

/// TGA begins with no word of its own, but few files have a header that makes sense as one.
fn is_tga(beginning: &[u8]) -> bool {
    let Some([_, map, kind, map_rest @ .., width_low, width_high, height_low, height_high, depth, descriptor]) =
        at::<18>(beginning, 0)
    else {
        return false;
    };
    let [_, _, _, _, map_depth, ..]: [u8; 9] = map_rest;
    let is_map_right = match map {
        0 => map_rest[..5] == [0; 5] && !matches!(kind, 1 | 9),
        1 => matches!(map_depth, 15 | 16 | 24 | 32),
        _ => false,
    };
    let is_depth_right = match kind {
        1 | 9 => matches!(depth, 8 | 16),
        2 | 10 => matches!(depth, 15 | 16 | 24 | 32),
        3 | 11 => matches!(depth, 8 | 16),
        _ => false,
    };
    let has_size = (width_low | width_high) != 0 && (height_low | height_high) != 0;
    is_map_right && is_depth_right && has_size && descriptor & 0xc0 == 0
}
