//! Which rays make a pixel: one file a method. `docs/sampling.md` compares them.

pub mod adaptive;
pub mod ellipse;
pub mod guided;
pub mod mean;
pub mod outline;
pub mod place;
pub mod random;
pub mod regular;
pub mod shared;
pub mod small_objects;
pub mod sobol;
pub mod statistical;
pub mod stochastic;
pub mod student;
pub mod together;

use crate::probe::Probe;
use crate::random::{Arrangement, Draws};
use crate::scene::{Color, Sampling, Scene};
use place::ray_through;

/// The colour of a pixel, by column and row from the top left: its mean over the pixel's own square.
pub fn pixel<P: Probe>(scene: &Scene, pixel: [u32; 2], probe: &mut P) -> Color {
    match scene.sampling {
        Sampling::Center {} => through_center(scene, pixel, probe),
        _ => mean_of_samples(scene, pixel, probe),
    }
}

/// The mean of the samples that the scene's method takes.
// Kept out of the way of one ray a pixel.
#[inline(never)]
fn mean_of_samples<P: Probe>(scene: &Scene, pixel: [u32; 2], probe: &mut P) -> Color {
    match scene.sampling {
        Sampling::Center {} => through_center(scene, pixel, probe),
        Sampling::Regular { n } => regular::pixel(scene, n, pixel, probe),
        Sampling::Shared { n } => shared::pixel(scene, n, pixel, probe),
        Sampling::Adaptive { threshold, depth } => adaptive::pixel(scene, threshold, depth, pixel, probe),
        Sampling::Stochastic { n } => stochastic::pixel(scene, n, pixel, probe),
        Sampling::Random { n } => random::pixel(scene, n, pixel, probe),
        Sampling::Sobol { n } => sobol::pixel(scene, n, pixel, probe),
        Sampling::Guided(wanted) => guided::pixel(scene, wanted, pixel, probe),
        Sampling::Statistical(wanted) => statistical::pixel(scene, wanted, pixel, probe),
    }
}

/// One ray through the pixel's centre, whatever the scene's method. What else a sample decides is random all the same.
#[inline(always)]
pub fn through_center<P: Probe>(scene: &Scene, [column, row]: [u32; 2], probe: &mut P) -> Color {
    let center = [f64::from(column) + 0.5, f64::from(row) + 0.5];
    let draws = Draws::of_pixel(scene.seed, [column, row], 0, Arrangement::Independent);
    ray_through(scene, center, &draws, probe).color
}
