//! Where in its pixel a sample lies, and the ray through there.

use crate::log::{Name, Step};
use crate::probe::Probe;
use crate::random::{Dimension, Draws, Pick};
use crate::scene::square::place_in_square;
use crate::scene::{Color, Scene};
use crate::trace::{Seen, see};

/// What the ray through a place of the picture sees, in pixels from the picture's top left corner. `draws` are the random
/// numbers of the sample.
///
/// Every camera ray of every method comes through here.
// A part of each of them: a call would cost one ray a pixel more than all that methods share.
#[inline(always)]
pub fn ray_through<P: Probe>(scene: &Scene, place: [f64; 2], draws: &Draws, probe: &mut P) -> Seen {
    probe.aim(place);
    let seen = see(scene, draws, |probe| scene.camera.sampled_ray(place, draws, probe), probe);
    probe.aimed();
    seen
}

/// A sample at a random point of a pixel's stratum, as a node of its own; the number counts from 1.
pub fn sample<P: Probe>(scene: &Scene, pixel: [u32; 2], number: u32, draws: &Draws, probe: &mut P) -> Color {
    sample_at(scene, pixel, number, draws.pick(Dimension::Pixel), draws, probe).color
}

/// A sample at a point of a pixel, as a node of its own; the number counts from 1.
pub fn sample_at<P: Probe>(
    scene: &Scene,
    [column, row]: [u32; 2],
    number: u32,
    pick: Pick,
    draws: &Draws,
    probe: &mut P,
) -> Seen {
    probe.within(Step::Sample { number }, |probe| {
        let [x, y] = place_in_square(pick, probe);
        probe.given(Name::PixelLeft, f64::from(column));
        let across = probe.note(Name::PixelColumnSampled, f64::from(column) + x);
        probe.given(Name::PixelTop, f64::from(row));
        let down = probe.note(Name::PixelRowSampled, f64::from(row) + y);
        ray_through(scene, [across, down], draws, probe)
    })
}
