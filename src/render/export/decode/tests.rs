use super::*;
use crate::files::PictureKind;
use crate::render::export::{Format, MAX_WEBP_SIDE, encode, png_of_levels, read};
use flate2::write::ZlibEncoder;
use flate2::{Compression, Crc};
use image::codecs::tiff::TiffEncoder;
use image::{ExtendedColorType, ImageEncoder};
use proptest::prelude::*;
use proptest::sample::select;
use std::io::Write;

/// A PNG of these chunks; the data of `IDAT` are packed by the way.
fn png_of(chunks: &[(&[u8; 4], &[u8])]) -> Vec<u8> {
    let mut out = b"\x89PNG\r\n\x1a\n".to_vec();
    for (name, data) in chunks.iter().chain(&[(b"IEND", &[][..])]) {
        let data = if *name == b"IDAT" { packed(data) } else { data.to_vec() };
        let mut crc = Crc::new();
        crc.update(*name);
        crc.update(&data);
        out.extend((data.len() as u32).to_be_bytes());
        out.extend_from_slice(*name);
        out.extend(data);
        out.extend(crc.sum().to_be_bytes());
    }
    out
}

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// The header of a PNG that isn't interlaced.
fn header([width, height]: [u32; 2], depth: u8, color: u8) -> Vec<u8> {
    [&width.to_be_bytes()[..], &height.to_be_bytes(), &[depth, color, 0, 0, 0]].concat()
}

const GREY: u8 = 0;
const RGB: u8 = 2;
const PALETTE: u8 = 3;
const GREY_ALPHA: u8 = 4;
const RGBA: u8 = 6;

/// Levels as they are read, and the highest.
#[track_caller]
fn levels(bytes: &[u8]) -> (Vec<u16>, u16) {
    match read(bytes).unwrap().samples {
        Samples::Levels { levels, highest } => (levels, highest),
        Samples::Floats(_) => panic!("levels"),
    }
}

#[test]
fn every_kind_of_png_is_read() {
    let kinds: [(u8, u8, &[u8], &[u16], _); 11] = [
        (GREY, 1, &[0b0100_0000], &[0, 255], 255),
        (GREY, 2, &[0b0110_0000], &[85, 170], 255),
        (GREY, 4, &[0x1f], &[17, 255], 255),
        (GREY, 8, &[7, 9], &[7, 9], 255),
        (GREY, 16, &[1, 2, 3, 4], &[258, 772], 65535),
        (GREY_ALPHA, 8, &[7, 0, 9, 255], &[7, 9], 255),
        (PALETTE, 1, &[0b0100_0000], &[1, 2, 3, 4, 5, 6], 255),
        (PALETTE, 8, &[1, 0], &[4, 5, 6, 1, 2, 3], 255),
        (RGB, 8, &[1, 2, 3, 4, 5, 6], &[1, 2, 3, 4, 5, 6], 255),
        (RGBA, 8, &[1, 2, 3, 0, 4, 5, 6, 128], &[1, 2, 3, 4, 5, 6], 255),
        (RGB, 16, &[0, 1, 0, 2, 0, 3, 1, 4, 1, 5, 1, 6], &[1, 2, 3, 260, 261, 262], 65535),
    ];
    for (color, depth, data, expected, highest) in kinds {
        let header = header([2, 1], depth, color);
        let row = [&[0], data].concat();
        let palette: &[(&[u8; 4], &[u8])] = if color == PALETTE { &[(b"PLTE", &[1, 2, 3, 4, 5, 6])] } else { &[] };
        let bytes = png_of(&[&[(b"IHDR", &header[..])], palette, &[(b"IDAT", &row)]].concat());
        assert_eq!(levels(&bytes), (expected.to_vec(), highest), "{color} {depth}");
    }
}

#[test]
fn a_palette_that_ends_within_a_colour() {
    let (header, row) = (header([1, 1], 8, PALETTE), [0, 0]);
    let bytes = png_of(&[(b"IHDR", &header), (b"PLTE", &[1, 2, 3, 4]), (b"IDAT", &row)]);
    assert!(matches!(read(&bytes), Err(PictureError::Header("a palette of whole colours"))));
}

#[test]
fn what_unpacks_to_too_much_is_not_begun() {
    // A few bytes whose header says that they are this many pixels.
    let claim = |side: u32| read(&png_of(&[(b"IHDR", &header([side, side], 8, RGB)), (b"IDAT", &[])]));
    assert!(matches!(claim(1 << 30), Err(PictureError::TooManyPixels { .. })));
    assert!(matches!(claim((1 << 31) - 1), Err(PictureError::TooManyPixels { .. })));
    // They could be held, and aren't there.
    assert!(matches!(claim(1 << 14), Err(PictureError::Header("a size that fits the bytes behind it"))));
    // What is all black is packed to a thousandth.
    let black = png_of_levels(&vec![0; 3 << 20], [1 << 10, 1 << 10]).expect("a PNG");
    assert!(black.len() < 50_000 && levels(&black) == (vec![0; 3 << 20], 255));
}

#[test]
fn a_profile_of_colours_may_be_long_but_not_unpack_to_all_memory() {
    let (header, row) = (header([1, 1], 8, RGB), [0, 1, 2, 3]);
    let of_profile = |bytes: usize| {
        let profile = [&b"a\0\0"[..], &packed(&vec![0; bytes])].concat();
        png_of(&[(b"IHDR", &header), (b"iCCP", &profile), (b"IDAT", &row)])
    };
    for bytes in [1 << 16, MOST_BESIDE as usize + (1 << 20)] {
        assert_eq!(levels(&of_profile(bytes)), (vec![1, 2, 3], 255), "{bytes}");
    }
}

/// The header of each format, whose bytes say that it has this many pixels along a side.
fn claim(kind: ImageKind, side: u16) -> Vec<u8> {
    let ([low, high], long) = (side.to_le_bytes(), u32::from(side));
    let (le, be) = (long.to_le_bytes(), long.to_be_bytes());
    match kind {
        ImageKind::Png => png_of(&[(b"IHDR", &header([long; 2], 8, RGB)), (b"IDAT", &[])]),
        ImageKind::Bmp => {
            let dib = [&40_u32.to_le_bytes()[..], &le, &le, &[1, 0, 24, 0], &[0; 24]].concat();
            [&b"BM"[..], &[0; 8], &54_u32.to_le_bytes(), &dib, &[0; 30]].concat()
        }
        ImageKind::Tga => {
            [&[0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, low, high, low, high, 24, 0x20][..], &[0x80; 40]].concat()
        }
        ImageKind::Qoi => [&b"qoif"[..], &be, &be, &[3, 0], &[0xfd; 40], &[0, 0, 0, 0, 0, 0, 0, 1]].concat(),
        ImageKind::Tiff => {
            let entry = |tag: u16, value: u32| {
                [&tag.to_le_bytes()[..], &4_u16.to_le_bytes(), &1_u32.to_le_bytes(), &value.to_le_bytes()].concat()
            };
            // Width, height, bits, no packing, black is 0, where, rows, bytes.
            let tags = [(256, long), (257, long), (258, 8), (259, 1), (262, 1), (273, 8), (278, long), (279, 64)];
            let directory = tags.map(|(tag, value)| entry(tag, value)).concat();
            [&b"II*\0"[..], &8_u32.to_le_bytes(), &8_u16.to_le_bytes(), &directory, &[0; 64]].concat()
        }
        ImageKind::Jpeg => {
            let good = encode::levels(&[0; 3 * 64], [8, 8], Format::Jpeg).unwrap();
            let frame = good.windows(2).position(|two| two == [0xff, 0xc0]).unwrap();
            let mut changed = good;
            changed[frame + 5..frame + 9].copy_from_slice(&[high, low, high, low]);
            changed
        }
        ImageKind::Webp => {
            let size = u64::from(side - 1) | u64::from(side - 1) << 14;
            let bits = [&[0x2f][..], &(size as u32).to_le_bytes(), &[0; 11]].concat();
            [&b"RIFF\x1c\0\0\0WEBPVP8L"[..], &(bits.len() as u32).to_le_bytes(), &bits].concat()
        }
    }
}

#[test]
fn more_pixels_than_a_picture_may_have() {
    for kind in [ImageKind::Png, ImageKind::Bmp, ImageKind::Tga, ImageKind::Qoi, ImageKind::Tiff, ImageKind::Jpeg] {
        let error = read(&claim(kind, 65535)).unwrap_err();
        assert!(matches!(error, PictureError::TooManyPixels { size: [65535, 65535] }), "{kind:?}: {error}");
    }
    for text in ["P2 65535 65535 255 0", "P6 65535 65535 255\n", "PF 65535 65535 1\n", "Pf 4294967295 4294967295 1\n"] {
        let error = read(text.as_bytes()).unwrap_err();
        assert!(matches!(error, PictureError::TooManyPixels { .. }), "{text}: {error}");
    }
    // An OpenEXR says twice what it is.
    let mut exr =
        crate::render::export::with_layers(&crate::render::Film::new([0, 0, 16, 12]), Vec::new()).unwrap().bytes;
    let window = |right: i32, bottom: i32| [0, 0, right, bottom].map(i32::to_le_bytes).concat();
    let (small, large) = (window(15, 11), window(65534, 65534));
    for at in 0..exr.len() - large.len() {
        if exr[at..].starts_with(&small) {
            exr[at..at + large.len()].copy_from_slice(&large);
        }
    }
    let error = read(&exr).unwrap_err();
    assert!(matches!(error, PictureError::TooManyPixels { size: [65535, 65535] }), "{error}");
}

#[test]
fn a_header_that_asks_for_more_than_its_bytes_hold() {
    for kind in [
        ImageKind::Png,
        ImageKind::Bmp,
        ImageKind::Tga,
        ImageKind::Qoi,
        ImageKind::Tiff,
        ImageKind::Jpeg,
        ImageKind::Webp,
    ] {
        let bytes = claim(kind, 16_000);
        assert_eq!(PictureKind::of(&bytes), Some(PictureKind::Image(kind)));
        let error = read(&bytes).unwrap_err();
        assert!(matches!(error, PictureError::Header("a size that fits the bytes behind it")), "{kind:?}: {error}");
    }
}

#[test]
fn every_length_of_a_file_is_read_or_refused() {
    let picture: Vec<u16> = (0..7 * 5 * 3).map(|k| k * 97 % 256).collect();
    for format in [Format::Png8, Format::Bmp, Format::Tga, Format::Qoi, Format::Tiff, Format::Jpeg, Format::Webp] {
        let bytes = encode::levels(&picture, [7, 5], format).unwrap();
        for length in 0..bytes.len() {
            if let Ok(picture) = read(&bytes[..length]) {
                assert_eq!(picture.size(), [7, 5], "{format:?} {length}");
            }
        }
        assert!(read(&bytes[..bytes.len() / 4]).is_err(), "{format:?}");
    }
}

/// Red, green and blue of pixels side by side, and their size.
fn pictures() -> impl Strategy<Value = (Vec<u16>, [u32; 2])> {
    // Runs of equal pixels and all others.
    let level = || prop_oneof![Just(0), Just(255), 0..=255_u16];
    [1..20_u32, 1..20].prop_flat_map(move |[width, height]| {
        (prop::collection::vec(level(), (width * height * 3) as usize), Just([width, height]))
    })
}

proptest! {
    #[test]
    fn what_is_written_without_loss_is_read_back(
        (picture, size) in pictures(),
        format in select(vec![Format::Png8, Format::Ppm, Format::Bmp, Format::Tga, Format::Qoi, Format::Tiff, Format::Webp]),
    ) {
        let bytes = encode::levels(&picture, size, format).unwrap();
        prop_assert!(PictureKind::of(&bytes[..bytes.len().min(512)]).is_some());
        let found = read(&bytes).unwrap();
        prop_assert_eq!((found.size(), found.is_float()), (size, false));
        prop_assert_eq!(levels(&bytes), (picture, 255));
    }

    #[test]
    fn sixteen_bits_are_read_back((picture, size) in pictures(), factor in 1..=257_u16) {
        let picture: Vec<u16> = picture.into_iter().map(|level| level * factor).collect();
        let bytes = encode::levels(&picture, size, Format::Png16).unwrap();
        prop_assert_eq!(levels(&bytes), (picture, 65535));
    }

    /// One colour has means alone: a mean is rounded to eighths of its divisor, 2, so it errs by 1/8; the turns from RGB and back, in whole
    /// levels, by 1/2 each, times 1.772 for what chroma adds to blue.
    #[test]
    fn a_jpeg_of_one_colour_is_near(color in [0..=255_u16, 0..=255, 0..=255], size in [1..20_u32, 1..20]) {
        let picture = color.repeat((size[0] * size[1]) as usize);
        let (found, highest) = levels(&encode::levels(&picture, size, Format::Jpeg).unwrap());
        prop_assert_eq!((found.len(), highest), (picture.len(), 255));
        for (found, level) in found.iter().zip(&picture) {
            prop_assert!(found.abs_diff(*level) <= 3, "{} {}", found, level);
        }
    }
}

#[test]
fn floats_of_a_tiff_are_values() {
    let floats = [0.0_f32, 1.5, -2.0, 3e30, 0.1, f32::MIN_POSITIVE];
    let mut out = Cursor::new(Vec::new());
    let bytes: Vec<u8> = floats.iter().flat_map(|float| float.to_ne_bytes()).collect();
    TiffEncoder::new(&mut out).write_image(&bytes, 2, 1, ExtendedColorType::Rgb32F).unwrap();
    let picture = read(out.get_ref()).unwrap();
    assert!(picture.is_float());
    assert_eq!([[0, 0], [1, 0]].map(|place| picture.pixel(place)).as_flattened(), floats.map(f64::from));
}

#[test]
fn the_longest_side_of_a_webp() {
    let side = MAX_WEBP_SIDE as usize;
    let row = encode::levels(&vec![0; side * 3], [MAX_WEBP_SIDE, 1], Format::Webp).unwrap();
    assert_eq!(read(&row).unwrap().size(), [MAX_WEBP_SIDE, 1]);
    // What is all of one colour takes few bytes, and isn't taken for a header that lies.
    let black = encode::levels(&vec![0; 3 << 22], [1 << 11, 1 << 11], Format::Webp).unwrap();
    assert!(black.len() as u64 * PIXELS_PER_BYTE > 1 << 22, "{}", black.len());
}

#[test]
fn other_files_are_no_pictures() {
    let others: [&[u8]; 8] = [
        b"",
        b"BM 1 2 3 is a line of text and no bitmap",
        b"RIFF\0\0\0\0WAVEfmt ",
        b"II*",
        b"{\0\n\0 \0 \0\"\0f\0o\0r\0m\0a\0t\0\"\0",
        b"\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
        b"glTF\x02\0\0\0\0\0\0\0\0\0\0\0JSON",
    ];
    for other in others {
        assert!(PictureKind::of(other).is_none(), "{other:?}");
        assert!(matches!(read(other), Err(PictureError::Unknown)));
    }
}
