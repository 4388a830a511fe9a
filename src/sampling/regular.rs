//! A regular grid of samples: supersampling (Ramos, section 1.4.2; Whitted, "An improved illumination model for shaded
//! display", 1980).

use super::mean::{self, Sum};
use super::place::samples;
use crate::log::Name;
use crate::probe::Probe;
use crate::random::{Arrangement, Draws, Pick, Stratum};
use crate::scene::{Color, Scene};

/// The mean of rays through the centres of n × n cells, row by row. What isn't the place in the pixel is stratified.
pub fn pixel<P: Probe>(scene: &Scene, n: u32, pixel: [u32; 2], probe: &mut P) -> Color {
    let count = n * n;
    let mut sum = Sum::ZERO;
    samples(scene, pixel, 0..count, |number| sample(scene, n, pixel, number), |_, seen| sum.add(seen.color), probe);
    mean::of_pixel(Name::PixelMean, sum, f64::from(count), probe)
}

/// The random numbers of a sample of n × n, its number from 0, and its point in the pixel.
#[inline]
pub(super) fn sample(scene: &Scene, n: u32, pixel: [u32; 2], number: u32) -> (Draws, Pick) {
    let count = n * n;
    let draws = Draws::of_pixel(scene.seed, pixel, number, Arrangement::Stratified { count });
    let cell = Stratum { column: number % n, across: n, above: number / n * n, count };
    (draws, Pick { stratum: cell, jitter: [0.5; 2] })
}
