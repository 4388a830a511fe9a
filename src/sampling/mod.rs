//! Which rays make a pixel: one file a method.

pub mod mean;
pub mod shared;

use crate::probe::Probe;
use crate::scene::{Color, Sampling, Scene};
use crate::trace::camera_ray;

/// The colour of a pixel, by column and row from the top left.
pub fn pixel<P: Probe>(scene: &Scene, pixel: [u32; 2], probe: &mut P) -> Color {
    match scene.sampling {
        Sampling::Center => through_center(scene, pixel, probe),
        Sampling::Shared { n } => shared::pixel(scene, n, pixel, probe),
    }
}

/// One ray through the pixel's centre.
fn through_center<P: Probe>(scene: &Scene, [column, row]: [u32; 2], probe: &mut P) -> Color {
    let center = [f64::from(column) + 0.5, f64::from(row) + 0.5];
    camera_ray(scene, |probe| scene.camera.ray(center, probe), probe)
}
