//! Where in its pixel a sample lies, and the ray through there.

use crate::geometry::{PACKET, Ray};
use crate::log::{Name, Step};
use crate::probe::Probe;
use crate::random::{Draws, Pick, Stratum};
use crate::scene::Scene;
use crate::scene::square::place_in_square;
use crate::trace::{Seen, see, see_together};
use arrayvec::ArrayVec;
use std::ops::Range;

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

/// The point of Sobol's sequence with this number, from 0, in the part of the square that it has for itself among those that
/// double the samples, from 2^k to 2^(k+1): each takes one of 2^k near-square parts. The point stays the same to the last bit, as the
/// parts are powers of two.
pub fn in_own_part(pick: Pick, number: u32) -> Pick {
    let halvings = number.max(1).ilog2();
    let (across, down) = (1_u32 << (halvings / 2), 1_u32 << halvings.div_ceil(2));
    let [x, y] = pick.point();
    let (along, below) = (x * f64::from(across), y * f64::from(down));
    let (column, row) = (along as u32, below as u32);
    let stratum = Stratum { column, across, above: row * across, count: across * down };
    Pick { stratum, jitter: [along - f64::from(column), below - f64::from(row)] }
}

/// A sample at a point of a pixel, as a node of its own; the number counts from 1.
pub fn sample_at<P: Probe>(
    scene: &Scene,
    pixel: [u32; 2],
    number: u32,
    pick: Pick,
    draws: &Draws,
    probe: &mut P,
) -> Seen {
    probe.within(Step::Sample { number }, |probe| {
        let place = place_of_sample(pixel, pick, probe);
        ray_through(scene, place, draws, probe)
    })
}

/// The place of a point of a pixel in the picture.
#[inline(always)]
pub(super) fn place_of_sample<P: Probe>([column, row]: [u32; 2], pick: Pick, probe: &mut P) -> [f64; 2] {
    let [x, y] = place_in_square(pick, probe);
    probe.given(Name::PixelLeft, f64::from(column));
    let across = probe.note(Name::PixelColumnSampled, f64::from(column) + x);
    probe.given(Name::PixelTop, f64::from(row));
    let down = probe.note(Name::PixelRowSampled, f64::from(row) + y);
    [across, down]
}

/// The samples of a pixel with these numbers, from 0: `place` gives the random numbers of each and its point, `seen` is shown what each sees,
/// in their order.
///
/// Where nothing is recorded, their rays are traced together: they are neighbours, and what they hit is found faster so.
#[inline(always)]
pub fn samples<P: Probe>(
    scene: &Scene,
    pixel: [u32; 2],
    mut numbers: Range<u32>,
    mut place: impl FnMut(u32) -> (Draws, Pick),
    mut seen: impl FnMut(Pick, Seen),
    probe: &mut P,
) {
    let walk_together = P::IS_SILENT && scene.index.has_large_trees();
    while !numbers.is_empty() {
        if !walk_together || numbers.len() == 1 {
            for number in numbers.by_ref() {
                let (draws, pick) = place(number);
                seen(pick, sample_at(scene, pixel, number + 1, pick, &draws, probe));
            }
            return;
        }
        let (mut draws, mut picks): (ArrayVec<Draws, PACKET>, ArrayVec<Pick, PACKET>) = Default::default();
        let mut aimed: ArrayVec<Option<Ray>, PACKET> = ArrayVec::new();
        for number in numbers.by_ref().take(PACKET) {
            let (draw, pick) = place(number);
            aimed.push(scene.camera.sampled_ray(place_of_sample(pixel, pick, probe), &draw, probe));
            draws.push(draw);
            picks.push(pick);
        }
        let mut picks = picks.into_iter();
        see_together(scene, &draws, &aimed, |sees| picks.by_ref().take(1).for_each(|pick| seen(pick, sees)), probe);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Arrangement, Dimension, Partner};

    #[test]
    fn each_point_of_a_doubling_has_a_part_for_itself() {
        let arrangement = Arrangement::Sobol { partner: Partner::Nothing };
        let pick = |number| Draws::of_pixel(3, [4, 5], number, arrangement).pick(Dimension::Pixel);
        for count in [1_u32, 2, 4, 8, 128] {
            let mut taken: Vec<_> = (count..2 * count)
                .map(|number| {
                    let own = in_own_part(pick(number), number);
                    assert_eq!(own.point().map(f64::to_bits), pick(number).point().map(f64::to_bits), "{number}");
                    assert_eq!(own.stratum.at(own.jitter), pick(number).point());
                    assert_eq!(own.stratum.count, count);
                    own.stratum.above + own.stratum.column
                })
                .collect();
            taken.sort_unstable();
            assert_eq!(taken, (0..count).collect::<Vec<_>>());
        }
        assert_eq!(in_own_part(pick(0), 0), pick(0));
    }
}
