//! Which rays make a pixel.

use crate::probe::Probe;
use crate::scene::{Color, Scene};
use crate::trace::camera_ray;

/// The colour of a pixel, by column and row from the top left: one ray through its centre.
// Once for each probe: copies at every caller keep the compiler from inlining what the recursion consists of.
#[inline(never)]
pub fn pixel<P: Probe>(scene: &Scene, [column, row]: [u32; 2], probe: &mut P) -> Color {
    let center = [f64::from(column) + 0.5, f64::from(row) + 0.5];
    camera_ray(scene, |probe| scene.camera.ray(center, probe), probe)
}
