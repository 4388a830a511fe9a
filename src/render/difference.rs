//! How far two pictures are apart.

use super::export::{self, Beside, EncodeError, Numbers, Picture};
use std::collections::{HashMap, HashSet};

/// How far two pictures of the same size are apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The root of the mean of the squared differences of all channels.
    pub rmse: f64,
    /// The largest difference of a channel; `None` if all are 0.
    pub largest: Option<Largest>,
    /// How many pixels differ by more than is tolerated.
    pub differing: u64,
}

/// The channel in which two pictures differ most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Largest {
    /// Column and row from the top left.
    pub pixel: [u32; 2],
    /// 0 is red, 1 green, 2 blue.
    pub channel: usize,
    /// The absolute difference.
    pub difference: f64,
    /// The first picture's value.
    pub a: f64,
    /// The second picture's value.
    pub b: f64,
}

/// Compares two pictures of the same size; `differs` says whether two values of a channel count as different.
pub fn difference(a: &Picture, b: &Picture, differs: impl Fn(f64, f64) -> bool) -> Difference {
    let (mut squares, mut largest, mut differing) = (0.0, None::<Largest>, 0);
    let [width, height] = a.size();
    for y in 0..height {
        // Added row by row, so that few roundings pile up in a large picture.
        let mut of_row = 0.0;
        for x in 0..width {
            let (ours, theirs) = (a.pixel([x, y]), b.pixel([x, y]));
            for channel in 0..3 {
                let distance = apart(ours[channel], theirs[channel]);
                of_row += distance * distance;
                if distance > largest.map_or(0.0, |largest| largest.difference) {
                    let (a, b) = (ours[channel], theirs[channel]);
                    largest = Some(Largest { pixel: [x, y], channel, difference: distance, a, b });
                }
            }
            differing += u64::from(ours.iter().zip(theirs).any(|(a, b)| differs(*a, b)));
        }
        squares += of_row;
    }
    let channels = f64::from(width) * f64::from(height) * 3.0;
    Difference { rmse: if channels > 0.0 { (squares / channels).sqrt() } else { 0.0 }, largest, differing }
}

/// The absolute difference of two values; infinite where only one is a number.
fn apart(a: f64, b: f64) -> f64 {
    match (a.is_nan(), b.is_nan()) {
        (true, true) => 0.0,
        (false, false) if a == b => 0.0,
        (false, false) => (a - b).abs(),
        _ => f64::INFINITY,
    }
}

impl Difference {
    /// Where the two pictures differ, as a PNG: a pixel's largest channel difference, from black (none) over red and yellow to
    /// white (the largest of all).
    ///
    /// # Errors
    /// Those of the encoder.
    pub fn heat_map(&self, a: &Picture, b: &Picture) -> Result<Vec<u8>, EncodeError> {
        let most = self.largest.map_or(1.0, |largest| largest.difference);
        let [width, height] = a.size();
        let mut levels = Vec::with_capacity(width as usize * height as usize * 3);
        for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
            let (ours, theirs) = (a.pixel(pixel), b.pixel(pixel));
            let distance = (0..3).map(|channel| apart(ours[channel], theirs[channel])).fold(0.0, f64::max);
            let heat = if distance == most { 1.0 } else { distance / most };
            // Each of the three thirds of the way to white fills a channel.
            levels.extend([0.0, 1.0, 2.0].map(|third| ((heat * 3.0 - third).clamp(0.0, 1.0) * 255.0 + 0.5) as u8));
        }
        export::png_of_levels(&levels, [width, height])
    }
}

/// How far the layers beside the colours of two pictures are apart.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LayerDifferences {
    /// The layers that both have.
    pub of_both: Vec<LayerDifference>,
    /// The names of the layers, or of single channels of a layer, that only the first one has.
    pub only_in_a: Vec<String>,
    /// Those that only the second one has.
    pub only_in_b: Vec<String>,
}

/// How far a layer of two pictures is apart.
#[derive(Clone, Debug, PartialEq)]
pub struct LayerDifference {
    /// Its name.
    pub name: String,
    /// How many pixels it has.
    pub pixels: u64,
    /// How many of them differ in some channel by more than is tolerated.
    pub differing: u64,
    /// The largest difference of a channel; `None` if all are 0.
    pub largest: Option<LargestOfLayer>,
}

/// The number in which a layer of two pictures differs most.
#[derive(Clone, Debug, PartialEq)]
pub struct LargestOfLayer {
    /// Column and row from the top left.
    pub pixel: [u32; 2],
    /// The channel's name in the layer.
    pub channel: String,
    /// The absolute difference.
    pub difference: f64,
    /// The first picture's number.
    pub a: f64,
    /// The second picture's number.
    pub b: f64,
}

impl LayerDifferences {
    /// Compares the layers of two pictures; `differs` says whether two numbers count as different.
    pub fn of(a: &[Beside], b: &[Beside], differs: impl Fn(f64, f64) -> bool) -> LayerDifferences {
        let mut found = LayerDifferences::default();
        let key = |layer: &'_ Beside| (layer.name.clone(), layer.size);
        let of_b: HashMap<_, _> = b.iter().map(|layer| (key(layer), layer)).collect();
        for ours in a {
            match of_b.get(&key(ours)) {
                None => found.only_in_a.push(ours.name.clone()),
                Some(theirs) => {
                    found.only_in_a.extend(lacking(ours, theirs));
                    found.only_in_b.extend(lacking(theirs, ours));
                    found.of_both.push(LayerDifference::of(ours, theirs, &differs));
                }
            }
        }
        let of_a: HashSet<_> = a.iter().map(key).collect();
        let of_b_alone = b.iter().filter(|theirs| !of_a.contains(&key(theirs)));
        found.only_in_b.extend(of_b_alone.map(|layer| layer.name.clone()));
        found
    }

    /// Whether nothing counts as different.
    pub fn is_same(&self) -> bool {
        self.only_in_a.is_empty() && self.only_in_b.is_empty() && self.of_both.iter().all(|layer| layer.differing == 0)
    }

    /// Whether neither picture has a layer.
    pub fn is_empty(&self) -> bool {
        *self == LayerDifferences::default()
    }
}

/// The channels that only the first of two layers has.
fn lacking<'l>(layer: &'l Beside, other: &'l Beside) -> impl Iterator<Item = String> + 'l {
    let theirs: HashSet<&str> = other.channels.iter().map(|channel| channel.name.as_str()).collect();
    layer
        .channels
        .iter()
        .filter(move |channel| !theirs.contains(channel.name.as_str()))
        .map(|channel| format!("{}.{}", layer.name, channel.name))
}

impl LayerDifference {
    /// Compares the channels that both have.
    fn of(a: &Beside, b: &Beside, differs: impl Fn(f64, f64) -> bool) -> LayerDifference {
        let of_b: HashMap<&str, &Numbers> = b.channels.iter().map(|channel| (channel.name.as_str(), channel)).collect();
        let pairs: Vec<_> = a.channels.iter().filter_map(|ours| Some((ours, *of_b.get(ours.name.as_str())?))).collect();
        let [width, height] = a.size;
        let (mut largest, mut differing) = (None::<LargestOfLayer>, 0);
        for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
            let place = pixel[1] as usize * width as usize + pixel[0] as usize;
            let mut is_different = false;
            for (ours, theirs) in &pairs {
                let (a, b) = (ours.at(place), theirs.at(place));
                let difference = apart(a, b);
                is_different |= differs(a, b);
                if difference > largest.as_ref().map_or(0.0, |largest| largest.difference) {
                    largest = Some(LargestOfLayer { pixel, channel: ours.name.clone(), difference, a, b });
                }
            }
            differing += u64::from(is_different);
        }
        LayerDifference { name: a.name.clone(), pixels: u64::from(width) * u64::from(height), differing, largest }
    }
}
