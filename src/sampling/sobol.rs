//! Samples at the points of Sobol's sequence, scrambled by Owen's method (Sobol, 1967; Owen, "Monte Carlo variance of
//! scrambled net quadrature", 1997). The points are in [`crate::random::sobol`].

use super::stochastic::mean_of;
use crate::probe::Probe;
use crate::random::Arrangement;
use crate::scene::{Color, Scene};

/// The mean of the first n points.
pub fn pixel<P: Probe>(scene: &Scene, n: u32, pixel: [u32; 2], probe: &mut P) -> Color {
    mean_of(scene, n, arrangement(scene), pixel, probe)
}

/// How Sobol samples of this scene are arranged.
#[inline]
pub(super) fn arrangement(scene: &Scene) -> Arrangement {
    Arrangement::Sobol { partner: scene.effects.partner() }
}
