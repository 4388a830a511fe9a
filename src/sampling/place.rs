//! Where in its pixel a sample lies, and the ray through there.

use crate::log::{Name, Step};
use crate::probe::Probe;
use crate::random::{Dimension, Draws, Pick, Stratum};
use crate::scene::{Color, Scene};
use crate::trace::{Seen, see};

/// What the ray through a place of the picture sees, in pixels from the picture's top left corner. `draws` are the random
/// numbers of the sample.
///
/// Every camera ray of every method but `none` comes through here.
pub fn ray_through<P: Probe>(scene: &Scene, place: [f64; 2], _draws: &Draws, probe: &mut P) -> Seen {
    probe.aim(place);
    let seen = see(scene, |probe| scene.camera.ray(place, probe), probe);
    probe.aimed();
    seen
}

/// A sample at a random point of a pixel's stratum, as a node of its own; the number counts from 1.
pub fn sample<P: Probe>(scene: &Scene, pixel: [u32; 2], number: u32, draws: &Draws, probe: &mut P) -> Color {
    sample_at(scene, pixel, number, draws.pick(Dimension::Pixel), draws, probe)
}

/// A sample at a point of a pixel, as a node of its own; the number counts from 1.
pub fn sample_at<P: Probe>(
    scene: &Scene,
    [column, row]: [u32; 2],
    number: u32,
    pick: Pick,
    draws: &Draws,
    probe: &mut P,
) -> Color {
    probe.within(Step::Sample { number }, |probe| {
        let [x, y] = place_in_pixel(pick, probe);
        probe.given(Name::PixelLeft, f64::from(column));
        let across = probe.note(Name::PixelColumnSampled, f64::from(column) + x);
        probe.given(Name::PixelTop, f64::from(row));
        let down = probe.note(Name::PixelRowSampled, f64::from(row) + y);
        ray_through(scene, [across, down], draws, probe).color
    })
}

/// The point of a stratum, with what it was made of.
fn place_in_pixel<P: Probe>(Pick { stratum, jitter }: Pick, probe: &mut P) -> [f64; 2] {
    if stratum == Stratum::WHOLE {
        probe.given(Name::SampleX, jitter[0]);
        probe.given(Name::SampleY, jitter[1]);
        return jitter;
    }
    let [x, y] = stratum.at(jitter);
    probe.given(Name::SampleColumn, f64::from(stratum.column));
    probe.given(Name::SampleJitterX, jitter[0]);
    probe.given(Name::SampleAcross, f64::from(stratum.across));
    let x = probe.note(Name::SampleX, x);
    probe.given(Name::SampleAbove, f64::from(stratum.above));
    probe.given(Name::SampleJitterY, jitter[1]);
    probe.given(Name::SampleCount, f64::from(stratum.count));
    let y = probe.note(Name::SampleY, y);
    [x, y]
}
