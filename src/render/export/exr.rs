//! OpenEXR: the traced values as f32, and layers beside them as channels `layer.channel`.

use crate::render::Film;
use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, SmallVec, WritableImage,
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

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::scene::Color;
    use exr::prelude::*;

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
}
