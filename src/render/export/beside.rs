//! What an OpenEXR file has beside its colours: channels in layers, as numbers to be compared.

use super::exr::colors_of;
use super::picture::{PictureError, check_size, with_room_for};
use crate::files::PictureKind;
use exr::block::samples::Sample;
use exr::image::{AnyChannel, FlatSamples};
use exr::meta::MetaData;
use exr::meta::header::Header;
use exr::prelude::{ReadChannels, ReadLayers, Vec2};
use std::collections::HashMap;
use std::io::Cursor;

/// Channels of a picture's file that are no colours.
#[derive(Clone, Debug, PartialEq)]
pub struct Beside {
    /// What the channels' names have before their last dot; the whole name of a channel without one. As the file has it.
    pub name: String,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// In the order of their names.
    pub channels: Vec<Numbers>,
}

/// The numbers of a channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Numbers {
    /// What the channel's name has behind its last dot, as the file has it.
    pub name: String,
    samples: FlatSamples,
}

impl Numbers {
    /// The number of a pixel, row by row from the top; 0 where there is none.
    pub fn at(&self, pixel: usize) -> f64 {
        if pixel >= self.samples.len() {
            return 0.0;
        }
        match self.samples.value_by_flat_index(pixel) {
            Sample::F16(number) => number.to_f64(),
            Sample::F32(number) => number.into(),
            Sample::U32(number) => number.into(),
        }
    }
}

/// The layers of a picture's file beside the colours that [`read`](super::read()) gives and their alpha, which is no part of the comparison, in
/// the order of the file; `None` of what is no OpenEXR, and can have none.
///
/// # Errors
/// [`PictureError`].
pub fn beside(bytes: &[u8]) -> Result<Option<Vec<Beside>>, PictureError> {
    const BYTES_PER_NUMBER: usize = 4;
    const ALPHA: &str = "A";
    if PictureKind::of(bytes) != Some(PictureKind::Exr) {
        return Ok(None);
    }
    let headers = MetaData::read_from_buffered(Cursor::new(bytes), false)?.headers;
    let (colored, colors) = colors_of(&headers)?;
    let is_color = |part: usize, name: &str| part == colored && (colors.contains(&name) || name == ALPHA);
    let has_more = |(part, header): (usize, &Header)| {
        header.channels.list.iter().any(|channel| !is_color(part, &channel.name.to_string()))
    };
    if !headers.iter().enumerate().any(has_more) {
        return Ok(Some(Vec::new()));
    }
    if headers.iter().flat_map(|header| &header.channels.list).any(|channel| channel.sampling != Vec2(1, 1)) {
        return Err(PictureError::Kind("an OpenEXR with fewer numbers than pixels in a channel".to_owned()));
    }
    let mut numbers = 0;
    for header in &headers {
        let size = header.layer_size;
        check_size([size.width(), size.height()].map(|side| side as u64))?;
        numbers += size.area() * header.channels.list.len();
    }
    drop(with_room_for::<u8>(numbers * BYTES_PER_NUMBER)?);
    let reader = exr::prelude::read().no_deep_data().largest_resolution_level().all_channels();
    let image = reader.all_layers().all_attributes().non_parallel().from_buffered(Cursor::new(bytes))?;
    let mut found: Vec<Beside> = Vec::new();
    let mut places = HashMap::new();
    for (part, layer) in image.layer_data.into_iter().enumerate() {
        let size = [layer.size.width() as u32, layer.size.height() as u32];
        // The part with the colours is the picture itself.
        let of_part = layer.attributes.layer_name.as_ref().filter(|_| part != colored);
        let of_part = of_part.map_or_else(String::new, |name| format!("{name}."));
        for AnyChannel { name, sample_data: samples, .. } in layer.channel_data.list {
            let name = name.to_string();
            if is_color(part, &name) {
                continue;
            }
            let whole = format!("{of_part}{name}");
            let (layer, channel) = whole.rsplit_once('.').unwrap_or((&whole, &name));
            let numbers = Numbers { name: channel.to_owned(), samples };
            let at = *places.entry((layer.to_owned(), size)).or_insert(found.len());
            if at == found.len() {
                found.push(Beside { name: layer.to_owned(), size, channels: Vec::new() });
            }
            found[at].channels.push(numbers);
        }
    }
    Ok(Some(found))
}
