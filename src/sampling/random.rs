//! Samples anywhere in the pixel, each by itself (Ramos, section 1.4.2; Dippé and Wold, "Antialiasing through stochastic
//! sampling", 1985). The plain Monte Carlo method, by which the others are measured. The numbers themselves are in
//! [`crate::random`].

use super::stochastic::mean_of;
use crate::probe::Probe;
use crate::random::Arrangement;
use crate::scene::{Color, Scene};

/// The mean of n rays.
pub fn pixel<P: Probe>(scene: &Scene, n: u32, pixel: [u32; 2], probe: &mut P) -> Color {
    mean_of(scene, n, Arrangement::Independent, pixel, probe)
}
