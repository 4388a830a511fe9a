//! One jittered sample in each stratum (Ramos, section 1.5; Cook, Porter and Carpenter, "Distributed ray tracing", 1984;
//! Cook, "Stochastic sampling in computer graphics", 1986).

use super::mean::{self, Sum};
use super::place::{in_own_part, samples};
use crate::log::Name;
use crate::probe::Probe;
use crate::random::{Arrangement, Draws, OfPixel, Pick};
use crate::scene::{Color, Scene};

/// The mean of n rays, one in each of n near-square strata of the same area, row by row.
pub fn pixel<P: Probe>(scene: &Scene, n: u32, pixel: [u32; 2], probe: &mut P) -> Color {
    mean_of(scene, n, Arrangement::Stratified { count: n }, pixel, probe)
}

/// The random numbers of the samples of a pixel in this arrangement, of each by its number from 0, and its point in the pixel.
#[inline]
pub(super) fn draws(scene: &Scene, arrangement: Arrangement, pixel: [u32; 2]) -> impl Fn(u32) -> (Draws, Pick) {
    let of_pixel = OfPixel::new(scene.seed, pixel, arrangement);
    let is_sobol = matches!(arrangement, Arrangement::Sobol { .. });
    #[inline(always)]
    move |number| {
        let (draws, pick) = of_pixel.sample(number);
        (draws, if is_sobol { in_own_part(pick, number) } else { pick })
    }
}

/// The mean of n samples in this arrangement.
pub(super) fn mean_of<P: Probe>(
    scene: &Scene,
    n: u32,
    arrangement: Arrangement,
    pixel: [u32; 2],
    probe: &mut P,
) -> Color {
    let mut sum = Sum::ZERO;
    samples(scene, pixel, 0..n, draws(scene, arrangement, pixel), |_, seen| sum.add(seen.color), probe);
    mean::of_pixel(Name::PixelMean, sum, f64::from(n), probe)
}
