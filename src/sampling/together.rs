//! Pixels of a row whose few samples are traced together: what the rays of neighbours hit is found faster so. Each pixel gets the bits that it gets
//! alone.

use super::mean::{self, Sum};
use super::place::place_of_sample;
use super::{regular, sobol, stochastic};
use crate::geometry::{PACKET, Ray};
use crate::log::Name;
use crate::probe::Silent;
use crate::random::{Arrangement, Draws, Pick};
use crate::scene::{Color, Sampling, Scene};
use crate::trace::{Seen, see_together};
use arrayvec::ArrayVec;
use std::ops::Range;

/// How many samples each pixel has, where they are so few that those of several are traced together, and that saves time.
pub fn few_samples(scene: &Scene) -> Option<u32> {
    let count = match scene.sampling {
        Sampling::Center {} => 1,
        Sampling::Regular { n } => n.saturating_mul(n),
        Sampling::Stochastic { n } | Sampling::Random { n } | Sampling::Sobol { n } => n,
        // Of all others the number, or the places, depend on the pixel or its neighbours; and a new method is right without this.
        _ => return None,
    };
    pays(scene, count).then_some(count)
}

/// Whether it saves time that this many samples of a pixel are traced together with those of its neighbours.
pub(super) fn pays(scene: &Scene, count: u32) -> bool {
    2 * u64::from(count) <= PACKET as u64 && scene.index.has_large_trees()
}

/// The colours of the pixels in these columns of a row, which have this many samples each, as [`few_samples`] says.
pub fn row(scene: &Scene, row: u32, columns: Range<u32>, count: u32, colors: &mut Vec<Color>) {
    let (mut sum, mut seen_so_far) = (Sum::ZERO, 0);
    let take = |seen: Seen| {
        if matches!(scene.sampling, Sampling::Center {}) {
            return colors.push(seen.color);
        }
        sum.add(seen.color);
        seen_so_far += 1;
        if seen_so_far == count {
            colors.push(mean::of_pixel(Name::PixelMean, sum, f64::from(count), &mut Silent));
            (sum, seen_so_far) = (Sum::ZERO, 0);
        }
    };
    samples_of_row(scene, row, columns, count, |pixel, number| sample(scene, pixel, number), take);
}

/// Shows `take` what the samples of the pixels in these columns of a row see, in their order. Each pixel has this many, of which `sample` gives the
/// random numbers and the place in the pixel by its number; it has none where the ray goes through the centre.
pub(super) fn samples_of_row(
    scene: &Scene,
    row: u32,
    mut columns: Range<u32>,
    count: u32,
    sample: impl Fn([u32; 2], u32) -> (Draws, Option<Pick>),
    mut take: impl FnMut(Seen),
) {
    while !columns.is_empty() {
        let mut draws: ArrayVec<Draws, PACKET> = ArrayVec::new();
        let mut aimed: ArrayVec<Option<Ray>, PACKET> = ArrayVec::new();
        let pixels = columns.by_ref().take(PACKET / count as usize).map(|column| [column, row]);
        for (pixel, number) in pixels.flat_map(|pixel| (0..count).map(move |number| (pixel, number))) {
            let (draw, pick) = sample(pixel, number);
            let place = match pick {
                Some(pick) => place_of_sample(pixel, pick, &mut Silent),
                None => pixel.map(|along| f64::from(along) + 0.5),
            };
            aimed.push(scene.camera.sampled_ray(place, &draw, &mut Silent));
            draws.push(draw);
        }
        see_together(scene, &draws, &aimed, &mut take, &mut Silent);
    }
}

/// The random numbers of a sample, and its place in the pixel.
fn sample(scene: &Scene, pixel: [u32; 2], number: u32) -> (Draws, Option<Pick>) {
    let (draws, pick) = match scene.sampling {
        Sampling::Regular { n } => regular::sample(scene, n, pixel, number),
        Sampling::Stochastic { n } => stochastic::draws(scene, Arrangement::Stratified { count: n }, pixel)(number),
        Sampling::Random { .. } => stochastic::draws(scene, Arrangement::Independent, pixel)(number),
        Sampling::Sobol { .. } => stochastic::draws(scene, sobol::arrangement(scene), pixel)(number),
        _ => {
            let draws = Draws::of_pixel(scene.seed, pixel, 0, Arrangement::Independent);
            return (draws, None);
        }
    };
    (draws, Some(pick))
}

#[cfg(test)]
mod tests {
    use super::super::pixel;
    use super::*;

    #[test]
    fn pixels_of_a_row_get_the_bits_that_they_get_alone() {
        let mut scene = Scene::built_in("mesh").expect("a scene with a mesh");
        let samplings = [
            Sampling::Center {},
            Sampling::Regular { n: 1 },
            Sampling::Regular { n: 2 },
            Sampling::Stochastic { n: 2 },
            Sampling::Random { n: 3 },
            Sampling::Sobol { n: 4 },
        ];
        for sampling in samplings {
            scene.sampling = sampling;
            let count = few_samples(&scene).expect("few samples");
            let y = scene.camera.resolution[1] / 2;
            let columns = scene.camera.resolution[0] / 3..scene.camera.resolution[0] / 2;
            let mut colors = Vec::new();
            row(&scene, y, columns.clone(), count, &mut colors);
            let alone: Vec<_> = columns.map(|x| pixel(&scene, [x, y], &mut Silent)).collect();
            assert_eq!(colors, alone, "{sampling}");
            assert!(colors.iter().any(|color| *color != colors[0]), "something to see");
        }
        for sampling in [Sampling::Sobol { n: 5 }, Sampling::Shared { n: 1 }] {
            scene.sampling = sampling;
            assert_eq!(few_samples(&scene), None);
        }
    }
}
