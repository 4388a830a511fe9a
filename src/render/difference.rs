//! How far two pictures are apart.

use super::export::{self, EncodeError, Picture};

/// How far two pictures of the same size are apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The root of the mean of the squared differences of all channels.
    pub rmse: f64,
    /// The largest difference of a channel; `None` if all are 0.
    pub largest: Option<Largest>,
    /// How many pixels differ by more than is let pass.
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
