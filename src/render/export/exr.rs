//! OpenEXR: the traced values as f32, and layers beside them as channels `layer.channel`.

use super::picture::{Channels, Picture, PictureError, Samples, check_size};
use crate::files::escape::shortened;
use crate::render::Film;
use exr::meta::MetaData;
use exr::meta::header::Header;
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, ReadChannels, ReadLayers,
    ReadSpecificChannel, SmallVec, Vec2, WritableImage,
};
use std::io::Cursor;

/// Numbers beside a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrLayer {
    /// What they show.
    pub name: String,
    /// The numbers.
    pub channels: Vec<Channel>,
}

/// A number a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// What it is called in its layer.
    pub name: &'static str,
    /// The numbers, row by row from the top.
    pub values: Vec<f32>,
}

/// Writes a picture and its layers into memory.
///
/// # Errors
/// Those of the encoder.
pub fn exr(film: &Film, layers: Vec<ExrLayer>) -> Result<Vec<u8>, exr::error::Error> {
    let color = |name: &str, axis: usize| {
        AnyChannel::new(name, FlatSamples::F32(film.pixels().iter().map(|pixel| pixel[axis] as f32).collect()))
    };
    let mut channels: SmallVec<[AnyChannel<FlatSamples>; 4]> = SmallVec::new();
    channels.extend([color("R", 0), color("G", 1), color("B", 2)]);
    for ExrLayer { name, channels: of_layer } in layers {
        let named =
            |channel: Channel| AnyChannel::new(&*format!("{name}.{}", channel.name), FlatSamples::F32(channel.values));
        channels.extend(of_layer.into_iter().map(named));
    }
    let size = (film.width() as usize, film.height() as usize);
    // Run lengths are packed in the same way on every machine.
    let attributes = LayerAttributes { software_name: Some("raywalk".into()), ..LayerAttributes::default() };
    let layer = Layer::new(size, attributes, Encoding::SMALL_FAST_LOSSLESS, AnyChannels::sort(channels));
    let mut bytes = Cursor::new(Vec::new());
    Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes)?;
    Ok(bytes.into_inner())
}

/// Reads a picture of at most `most` pixels: of several layers the first with red, green and blue, or else the first with a luminance,
/// which is grey.
///
/// # Errors
/// [`PictureError`].
pub(super) fn read(bytes: &[u8], most: u64) -> Result<Picture, PictureError> {
    check_attributes(bytes)?;
    let headers = MetaData::read_from_buffered(Cursor::new(bytes), false)?.headers;
    headers.iter().try_for_each(|header| {
        check_size([header.layer_size.width(), header.layer_size.height()].map(|side| side as u64))
    })?;
    check_packing(&headers, bytes.len())?;
    if headers.iter().any(|header| header.layer_size.area() as u64 > most) {
        return Err(PictureError::Memory);
    }
    let reader = || exr::prelude::read().no_deep_data().largest_resolution_level();
    match colors_of(&headers)?.1 {
        RGB => {
            let channels =
                reader().rgb_channels(Pixels::<3>::new, |pixels, place, (r, g, b)| pixels.put(place, [r, g, b]));
            let layer = channels.first_valid_layer().all_attributes().non_parallel();
            Ok(layer.from_buffered(Cursor::new(bytes))?.layer_data.channel_data.pixels.into_picture(Channels::Rgb))
        }
        _ => {
            let channel = reader().specific_channels().required("Y");
            let channel =
                channel.collect_pixels(Pixels::<1>::new, |pixels, place, (y,): (f32,)| pixels.put(place, [y]));
            let layer = channel.first_valid_layer().all_attributes().non_parallel();
            Ok(layer.from_buffered(Cursor::new(bytes))?.layer_data.channel_data.pixels.into_picture(Channels::Grey))
        }
    }
}

/// The most attributes in the headers of an OpenEXR file. The decoder keeps all of them, in two kilobytes each.
pub const MAX_ATTRIBUTES: usize = 1 << 14;

/// Refuses a file with more attributes than that, before any is kept. Whatever else is wrong with the headers the decoder says.
///
/// Behind the magic number and the version each header is a list of attributes: name and type, each ended by a zero, the value's length in four
/// bytes, and the value. An empty name ends the list, another one the headers of a file with several parts.
fn check_attributes(bytes: &[u8]) -> Result<(), PictureError> {
    const VERSION: usize = 8;
    let mut rest = bytes.get(VERSION..).unwrap_or_default();
    let text = |rest: &mut &[u8]| -> Option<usize> {
        let length = memchr::memchr(0, rest)?;
        *rest = &rest[length + 1..];
        Some(length)
    };
    let mut is_behind_header = true;
    for count in 0.. {
        let Some(name) = text(&mut rest) else { return Ok(()) };
        if name == 0 {
            if is_behind_header {
                return Ok(());
            }
            is_behind_header = true;
            continue;
        }
        if count > MAX_ATTRIBUTES {
            return Err(PictureError::Header("at most 16384 attributes in all"));
        }
        is_behind_header = false;
        let value = text(&mut rest).and_then(|_| rest.split_first_chunk());
        let Some((length, behind)) = value else { return Ok(()) };
        let Some(behind) = behind.get(u32::from_le_bytes(*length) as usize..) else { return Ok(()) };
        rest = behind;
    }
    Ok(())
}

/// Refuses a file whose headers ask for more than the bytes behind them can hold.
fn check_packing(headers: &[Header], length: usize) -> Result<(), PictureError> {
    /// A block has its place in a table and begins with its own place and length, 16 bytes and more.
    const BYTES_PER_BLOCK: usize = 16;
    /// As many bytes come from one at most: a match of 258 bytes takes 2 bits or more (RFC 1951), and every other method that is read packs
    /// less.
    const RATIO: usize = 1032;
    let blocks = headers.iter().fold(0, |sum: usize, header| sum.saturating_add(header.chunk_count));
    let bytes = |header: &Header| header.layer_size.area().saturating_mul(header.channels.bytes_per_pixel);
    let unpacked = headers.iter().fold(0, |sum: usize, header| sum.saturating_add(bytes(header)));
    if blocks.saturating_mul(BYTES_PER_BLOCK) > length || unpacked / (2 * RATIO) > length {
        return Err(PictureError::Header("a size that fits the bytes behind it"));
    }
    Ok(())
}

/// The channels of a coloured picture, and of a grey one.
const RGB: &[&str] = &["R", "G", "B"];
const GREY: &[&str] = &["Y"];

/// The channels that are the colours of a file with these parts, and which part has them.
pub(super) fn colors_of(layers: &[Header]) -> Result<(usize, &'static [&'static str]), PictureError> {
    const SHOWN: usize = 80;
    let has = |header: &Header, name: &str| header.channels.list.iter().any(|channel| channel.name.eq(name));
    let find = |names: &'static [&str]| {
        let has_all = |layer: &Header| names.iter().all(|name| has(layer, name));
        layers.iter().position(has_all).map(|part| (part, names))
    };
    let found = find(RGB).or_else(|| find(GREY));
    // The decoder takes every channel to have as many samples as the picture has pixels.
    let is_whole = |layer: &Header| layer.channels.list.iter().all(|channel| channel.sampling == Vec2(1, 1));
    // With chroma beside it a luminance is half of a coloured picture.
    let is_colored = |layer: &Header| has(layer, "RY") || has(layer, "BY");
    let is_read = |part: usize, names| is_whole(&layers[part]) && (names == RGB || !is_colored(&layers[part]));
    if let Some(found) = found.filter(|(part, names)| is_read(*part, *names)) {
        return Ok(found);
    }
    let names: Vec<_> = layers.iter().flat_map(|layer| &layer.channels.list).map(|one| one.name.to_string()).collect();
    Err(PictureError::Channels { found: shortened(&names.join(", "), SHOWN) })
}

/// Pixels of N channels, as the decoder gives them: in any order.
struct Pixels<const N: usize> {
    size: Vec2<usize>,
    floats: Vec<f32>,
}

impl<const N: usize> Pixels<N> {
    fn new<T>(size: Vec2<usize>, _: &T) -> Pixels<N> {
        Pixels { size, floats: vec![0.0; size.area() * N] }
    }

    fn put(&mut self, place: Vec2<usize>, pixel: [f32; N]) {
        let first = (place.y() * self.size.width() + place.x()) * N;
        self.floats[first..first + N].copy_from_slice(&pixel);
    }

    fn into_picture(self, channels: Channels) -> Picture {
        let [width, height] = [self.size.width() as u32, self.size.height() as u32];
        Picture { width, height, channels, samples: Samples::Floats(self.floats) }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::scene::Color;
    use exr::prelude::read;

    #[test]
    fn attributes_are_counted_before_they_are_kept() {
        let whole = exr(&Film::new([0, 0, 1, 1]), Vec::new()).unwrap();
        let with = |count: usize| {
            let attributes: Vec<u8> = (0..count)
                .flat_map(|number| [format!("z{number}\0int\0").as_bytes(), &4_u32.to_le_bytes(), &[0; 4]].concat())
                .collect();
            [&whole[..8], &attributes, &whole[8..]].concat()
        };
        // The table of blocks has their places from the beginning of the file, which nobody asks.
        assert!(check_attributes(&with(MAX_ATTRIBUTES - 100)).is_ok());
        assert!(check_attributes(&whole).is_ok());
        let refused = super::read(&with(MAX_ATTRIBUTES + 1), 100);
        assert!(matches!(refused, Err(PictureError::Header("at most 16384 attributes in all"))), "{refused:?}");
        for length in 0..whole.len() {
            assert!(check_attributes(&whole[..length]).is_ok(), "{length}");
        }
    }

    #[test]
    fn every_number_is_read_back() {
        let mut film = Film::new([5, 7, 8, 9]);
        let colors: Vec<Color> = (0..6).map(|k| Color::new(f64::from(k), 1e30, -0.1)).collect();
        film.put([5, 7, 8, 9], &colors);
        let values = vec![0.0, 1.5, f32::INFINITY, f32::NAN, -2.0, 3.0];
        let layers =
            vec![ExrLayer { name: "depth".to_owned(), channels: vec![Channel { name: "Z", values: values.clone() }] }];
        let bytes = exr(&film, layers).unwrap();
        assert_eq!(
            bytes,
            exr(
                &film,
                vec![ExrLayer {
                    name: "depth".to_owned(),
                    channels: vec![Channel { name: "Z", values: values.clone() }]
                }]
            )
            .unwrap()
        );
        let image =
            read().no_deep_data().largest_resolution_level().all_channels().first_valid_layer().all_attributes();
        let image = image.from_buffered(Cursor::new(bytes)).unwrap();
        let found = |name: &str| {
            let channel = image.layer_data.channel_data.list.iter().find(|channel| channel.name.eq(name)).unwrap();
            channel.sample_data.values_as_f32().map(f32::to_bits).collect::<Vec<_>>()
        };
        assert_eq!(image.layer_data.size, Vec2(3, 2));
        assert_eq!(found("R"), [0.0_f32, 1.0, 2.0, 3.0, 4.0, 5.0].map(f32::to_bits));
        assert_eq!(found("B"), [-0.1_f32; 6].map(f32::to_bits));
        assert_eq!(found("depth.Z"), values.iter().map(|x| x.to_bits()).collect::<Vec<_>>());
    }

    /// A file of two by one pixels with these channels, the numbers of each counting on from those of the one before.
    fn with_channels(names: &[&str]) -> Vec<u8> {
        let channel = |(number, name): (usize, &&str)| {
            let first = 2.0 * number as f32;
            AnyChannel::new(*name, FlatSamples::F32(vec![first, first + 1.0]))
        };
        let channels = names.iter().enumerate().map(channel).collect();
        let layer = Layer::new((2, 1), LayerAttributes::default(), Encoding::UNCOMPRESSED, AnyChannels::sort(channels));
        let mut bytes = Cursor::new(Vec::new());
        Image::from_layer(layer).write().non_parallel().to_buffered(&mut bytes).unwrap();
        bytes.into_inner()
    }

    #[test]
    fn the_channels_decide_what_is_read() {
        #[track_caller]
        fn reads(names: &[&str], channels: Channels, floats: &[f32]) {
            let expected = Picture { width: 2, height: 1, channels, samples: Samples::Floats(floats.to_vec()) };
            assert_eq!(super::read(&with_channels(names), 2).unwrap(), expected, "{names:?}");
        }
        #[track_caller]
        fn refuses(names: &[&str], found: &str) {
            let error = super::read(&with_channels(names), 2).unwrap_err();
            assert_eq!(error.to_string().split_once("; found ").unwrap().1, found);
        }
        reads(&["Y"], Channels::Grey, &[0.0, 1.0]);
        reads(&["A", "Y"], Channels::Grey, &[2.0, 3.0]);
        reads(&["Y", "Z", "depth.Y"], Channels::Grey, &[0.0, 1.0]);
        reads(&["A", "B", "G", "R", "Y"], Channels::Rgb, &[6.0, 4.0, 2.0, 7.0, 5.0, 3.0]);
        refuses(&["A", "Z\u{7}"], "A, Z\\u{7}");
        refuses(&["B", "R"], "B, R");
        refuses(&["BY", "RY", "Y"], "BY, RY, Y");
    }

    #[test]
    fn a_header_that_asks_for_more_than_there_is() {
        let bytes = with_channels(&["B", "G", "R"]);
        let window = [0_i32, 0, 1, 0].map(i32::to_le_bytes).concat();
        let places: Vec<_> = (0..bytes.len() - 16).filter(|at| bytes[*at..].starts_with(&window)).collect();
        assert!(!places.is_empty());
        let mut asks = bytes.clone();
        for at in places {
            asks[at + 8..at + 16].copy_from_slice(&[9999_i32, 9999].map(i32::to_le_bytes).concat());
        }
        let refused = super::read(&asks, 1 << 28).unwrap_err().to_string();
        assert!(refused.ends_with("expected a size that fits the bytes behind it"), "{refused}");
    }

    #[test]
    fn a_picture_reads_back_and_damage_is_reported() {
        let mut film = Film::new([0, 0, 40, 30]);
        let colors: Vec<Color> = (0..1200).map(|k| Color::new(f64::from(k % 7), f64::from(k) * 0.5, -1.0)).collect();
        film.put([0, 0, 40, 30], &colors);
        let depth = vec![Channel { name: "Z", values: (0..1200).map(|k| k as f32 * 0.1).collect() }];
        let bytes = exr(&film, vec![ExrLayer { name: "depth".to_owned(), channels: depth }]).unwrap();
        let floats = colors.iter().flat_map(|color| color.to_array()).map(|x| x as f32).collect();
        let expected = Picture { width: 40, height: 30, channels: Channels::Rgb, samples: Samples::Floats(floats) };
        assert_eq!(super::read(&bytes, 1200).unwrap(), expected);
        assert!(matches!(super::read(&bytes, 1199), Err(PictureError::Memory)), "too many pixels");
        for length in (0..bytes.len()).step_by(37) {
            assert!(super::read(&bytes[..length], 1200).is_err(), "{length}");
        }
        // Whatever byte changes, it is read or refused.
        let mut refused = 0;
        for at in 0..bytes.len().min(600) {
            let mut changed = bytes.clone();
            changed[at] ^= 0xff;
            refused += u32::from(super::read(&changed, 1200).is_err());
        }
        assert!(refused > 50, "{refused}");
    }
}
