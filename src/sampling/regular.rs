//! A regular grid of samples: supersampling (Ramos, section 1.4.2; Whitted, "An improved illumination model for shaded
//! display", 1980).

use super::mean::{self, Sum};
use super::place::sample_at;
use crate::log::Name;
use crate::probe::Probe;
use crate::random::{Arrangement, Draws, Pick, Stratum};
use crate::scene::{Color, Scene};

/// The mean of rays through the centres of n × n cells, row by row. What isn't the place in the pixel is stratified.
pub fn pixel<P: Probe>(scene: &Scene, n: u32, pixel: [u32; 2], probe: &mut P) -> Color {
    let count = n * n;
    let mut sum = Sum::ZERO;
    for number in 0..count {
        let draws = Draws::of_pixel(scene.seed, pixel, number, Arrangement::Stratified { count });
        let cell = Stratum { column: number % n, across: n, above: number / n * n, count };
        let pick = Pick { stratum: cell, jitter: [0.5; 2] };
        sum.add(sample_at(scene, pixel, number + 1, pick, &draws, probe).color);
    }
    mean::of_pixel(Name::PixelMean, sum, f64::from(count), probe)
}
