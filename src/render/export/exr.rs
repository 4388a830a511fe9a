//! OpenEXR: the traced values as f32, and layers beside them as channels `layer.channel`.

use crate::render::Film;
use exr::meta::MetaData;
use exr::meta::header::Header;
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, ReadChannels, ReadLayers, SmallVec,
    Vec2, WritableImage,
};
use std::io::Cursor;

/// Numbers beside a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct ExrLayer {
    /// What they show.
    pub name: &'static str,
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

/// Width, height, and red, green and blue of each pixel, row by row from the top; `None` where its header asks for more pixels than
/// `most`.
///
/// # Errors
/// Those of the decoder.
pub(super) fn read(bytes: &[u8], most: u64) -> Result<Option<(u32, u32, Vec<f32>)>, exr::error::Error> {
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false)?;
    let is_small = |header: &Header| (header.layer_size.area() as u64) <= most;
    if !meta.headers.iter().all(is_small) {
        return Ok(None);
    }
    let create = |size: Vec2<usize>, _: &_| (size.width(), vec![0.0_f32; size.area() * 3]);
    let set = |(width, floats): &mut (usize, Vec<f32>), place: Vec2<usize>, (r, g, b): (f32, f32, f32)| {
        let first = (place.y() * *width + place.x()) * 3;
        floats[first..first + 3].copy_from_slice(&[r, g, b]);
    };
    let wanted = exr::prelude::read().no_deep_data().largest_resolution_level().rgb_channels(create, set);
    let image = wanted.first_valid_layer().all_attributes().non_parallel().from_buffered(Cursor::new(bytes))?;
    let size = image.layer_data.size;
    Ok(Some((size.width() as u32, size.height() as u32, image.layer_data.channel_data.pixels.1)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::scene::Color;
    use exr::prelude::read;

    #[test]
    fn every_number_is_read_back() {
        let mut film = Film::new([5, 7, 8, 9]);
        let colors: Vec<Color> = (0..6).map(|k| Color::new(f64::from(k), 1e30, -0.1)).collect();
        film.put([5, 7, 8, 9], &colors);
        let values = vec![0.0, 1.5, f32::INFINITY, f32::NAN, -2.0, 3.0];
        let layers = vec![ExrLayer { name: "depth", channels: vec![Channel { name: "Z", values: values.clone() }] }];
        let bytes = exr(&film, layers).unwrap();
        assert_eq!(
            bytes,
            exr(&film, vec![ExrLayer { name: "depth", channels: vec![Channel { name: "Z", values: values.clone() }] }])
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

    #[test]
    fn a_picture_reads_back_and_damage_is_told() {
        let mut film = Film::new([0, 0, 40, 30]);
        let colors: Vec<Color> = (0..1200).map(|k| Color::new(f64::from(k % 7), f64::from(k) * 0.5, -1.0)).collect();
        film.put([0, 0, 40, 30], &colors);
        let depth = vec![Channel { name: "Z", values: (0..1200).map(|k| k as f32 * 0.1).collect() }];
        let bytes = exr(&film, vec![ExrLayer { name: "depth", channels: depth }]).unwrap();
        let (width, height, floats) = super::read(&bytes, 1200).unwrap().unwrap();
        assert_eq!((width, height), (40, 30));
        let expected: Vec<f32> = colors.iter().flat_map(|color| color.to_array()).map(|x| x as f32).collect();
        assert_eq!(floats, expected);
        assert_eq!(super::read(&bytes, 1199).unwrap(), None, "too many pixels");
        for length in (0..bytes.len()).step_by(37) {
            assert!(super::read(&bytes[..length], 1200).is_err(), "{length}");
        }
        // Whatever byte changes, it is read or refused.
        let mut refused = 0;
        for at in 0..bytes.len().min(600) {
            let mut changed = bytes.clone();
            changed[at] ^= 0xff;
            refused += u32::from(!matches!(super::read(&changed, 1200), Ok(Some(_))));
        }
        assert!(refused > 50, "{refused}");
    }
}
