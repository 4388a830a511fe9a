//! As many samples as small pilots in the pixels around ask for.
//!
//! A pilot is the beginning of a pixel's own scrambled Sobol sequence. What the pilots of the eight pixels around saw says how
//! many points of the pixel's sequence follow: the mean of their variances tells of edges and noise within pixels, the contrast of their means
//! of edges that a pilot of few samples has missed. A pixel whose error falls as σ·n^−p has its share of the rays where all samples
//! together err least when n ∝ σ^(2/(2p + 1)). Sobol points have a p from about 2/3 at edges to 3/2 where all is smooth, and pilots tell σ in the
//! rough only: a power of 3/4 and a quarter of the contrast measured best on five scenes, though neither matters much (`docs/sampling.md`).
//!
//! A pixel's own pilot has no say, and nothing is looked at again: pixels draw independent numbers, so a mean knows nothing of how many samples it
//! was to have, and has no bias. (With a say of its own a pixel keeps small bright objects where its pilot meets them and loses them where it
//! doesn't: 40 % of the light of a dot was left.) The pilots that decide are traced in f64 before nobody, whatever the arithmetic of the pixel is, so that
//! a pixel takes the same samples in each.

use super::mean::{self, Sum};
use super::place::samples;
use super::sobol::arrangement;
use super::stochastic::draws;
use super::together;
use crate::log::{Acceptance, Decision, Name};
use crate::probe::{Probe, Silent};
use crate::random::Pick;
use crate::scene::{Color, Guided, Scene};
use crate::trace::Seen;
use std::ops::Range;

/// How much of the contrast of the pilots' means counts as an error.
const OF_CONTRAST: f64 = 0.25;

/// The power of the error that the number of samples grows with.
const POWER: f64 = 0.75;

/// The greatest colour of a sample that counts, as a part of white: squares of it stay finite.
const GREATEST_PART: f64 = 1e100;

/// What the first samples of a pixel have seen.
#[derive(Clone, Copy, Debug)]
pub struct Pilot {
    /// Their sum, to which the samples that follow are added.
    pub sum: Sum,
    /// Their mean, as a part of white.
    mean: Color,
    /// The variance of a sample as a part of the square of white, in the mean over the channels.
    variance: f64,
}

/// What the pilots around a pixel say of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guide {
    /// The mean of the variances of the pilots' samples, as a part of the square of white.
    pub variance: f64,
    /// The greatest difference of two pilots' means in a channel, as a part of white.
    pub contrast: f64,
}

/// The pixel with samples that its own neighbourhood decides.
pub fn pixel<P: Probe>(scene: &Scene, wanted: Guided, pixel: [u32; 2], probe: &mut P) -> Color {
    guided(scene, wanted, pixel, guide(scene, wanted, pixel), None, probe)
}

/// What the pilots around a pixel say, each of which is traced for it.
fn guide(scene: &Scene, wanted: Guided, pixel: [u32; 2]) -> Guide {
    let [left, top, right, bottom] = around(scene, [pixel[0], pixel[1], pixel[0] + 1, pixel[1] + 1]);
    let pixels = (top..bottom).flat_map(|row| (left..right).map(move |column| [column, row]));
    let neighbors = pixels.filter(|other| *other != pixel || is_alone(scene));
    let pilots: Vec<_> = neighbors.map(|pixel| pilot(scene, wanted, pixel, &mut Silent)).collect();
    Guide::of(&pilots)
}

/// Whether there are no neighbours, so that a pixel's own pilot must decide.
pub fn is_alone(scene: &Scene) -> bool {
    scene.camera.resolution == [1, 1]
}

/// The pixels whose pilots decide for those of an area (left, top, right and bottom, the last two exclusive): it and one pixel around, within the
/// picture.
pub fn around(scene: &Scene, [left, top, right, bottom]: [u32; 4]) -> [u32; 4] {
    let [width, height] = scene.camera.resolution;
    [left.saturating_sub(1), top.saturating_sub(1), (right + 1).min(width), (bottom + 1).min(height)]
}

/// The first samples of a pixel.
pub fn pilot<P: Probe>(scene: &Scene, wanted: Guided, pixel: [u32; 2], probe: &mut P) -> Pilot {
    let mut colors = Vec::new();
    take(scene, pixel, 0..wanted.pilot(), |color| colors.push(color), probe);
    Pilot::of(&colors, scene.output.white)
}

/// The same without a recording, for the pixels in these columns of a row, whose samples are traced together where that saves time.
pub fn pilots_of_row(scene: &Scene, wanted: Guided, row: u32, columns: Range<u32>, mut found: impl FnMut(Pilot)) {
    let count = wanted.pilot();
    if !together::pays(scene, count) {
        columns.for_each(|column| found(pilot(scene, wanted, [column, row], &mut Silent)));
        return;
    }
    let sample = |pixel, number| {
        let (draws, pick) = draws(scene, arrangement(scene), pixel)(number);
        (draws, Some(pick))
    };
    let mut colors = Vec::new();
    let take = |seen: Seen| {
        colors.push(seen.color);
        if colors.len() == count as usize {
            found(Pilot::of(&colors, scene.output.white));
            colors.clear();
        }
    };
    together::samples_of_row(scene, row, columns, count, sample, take);
}

/// The samples with these numbers, from 0.
fn take<P: Probe>(scene: &Scene, pixel: [u32; 2], numbers: Range<u32>, mut seen: impl FnMut(Color), probe: &mut P) {
    let place = draws(scene, arrangement(scene), pixel);
    samples(scene, pixel, numbers, place, |_: Pick, Seen { color, .. }| seen(color), probe);
}

impl Pilot {
    /// A place for a pilot that is to come.
    pub const NONE: Pilot = Pilot { sum: Sum::ZERO, mean: Color::ZERO, variance: 0.0 };

    /// From the colours of its samples, two or more.
    fn of(colors: &[Color], white: f64) -> Pilot {
        let mut sum = Sum::ZERO;
        colors.iter().for_each(|color| sum.add(*color));
        let part = |color: &Color| (*color / white).clamp(Color::splat(-GREATEST_PART), Color::splat(GREATEST_PART));
        let n = colors.len() as f64;
        let mean = colors.iter().map(part).sum::<Color>() / n;
        let squares = colors.iter().map(|color| part(color) - mean).map(|off| off * off).sum::<Color>();
        Pilot { sum, mean, variance: (squares / (n - 1.0)).element_sum() / 3.0 }
    }
}

impl Guide {
    /// From the pilots around a pixel, one or more, row by row.
    pub fn of<'p>(pilots: impl IntoIterator<Item = &'p Pilot>) -> Guide {
        let (mut count, mut variance) = (0.0, 0.0);
        let (mut least, mut greatest) = (Color::INFINITY, Color::NEG_INFINITY);
        for pilot in pilots {
            count += 1.0;
            variance += pilot.variance;
            (least, greatest) = (least.min(pilot.mean), greatest.max(pilot.mean));
        }
        Guide { variance: variance / count, contrast: (greatest - least).max_element() }
    }
}

/// The mean of as many samples as the pilots ask for. `begun` is the sum of the pixel's pilot, if it is traced already before a probe like this.
pub fn guided<P: Probe>(
    scene: &Scene,
    wanted: Guided,
    pixel: [u32; 2],
    guide: Guide,
    begun: Option<Sum>,
    probe: &mut P,
) -> Color {
    let pilot = wanted.pilot();
    let mut sum = begun.unwrap_or(Sum::ZERO);
    if begun.is_none() {
        take(scene, pixel, 0..pilot, |color| sum.add(color), probe);
    }
    let asked = asked(wanted, guide, probe);
    let count = wanted.samples(asked);
    if count > pilot {
        probe.mark(Decision::MoreSamples { from: pilot, to: count });
        take(scene, pixel, pilot..count, |color| sum.add(color), probe);
    }
    let mean = mean::of_pixel(Name::PixelMean, sum, f64::from(count), probe);
    let why = if asked > f64::from(count) { Acceptance::Max } else { Acceptance::Guided };
    probe.mark(Decision::Accepted { cell: None, why });
    mean
}

/// How many samples the pilots ask for, which is no whole number.
fn asked<P: Probe>(wanted: Guided, guide: Guide, probe: &mut P) -> f64 {
    probe.given(Name::GuidedVariance, guide.variance);
    probe.given(Name::GuidedContrast, guide.contrast);
    let of_contrast = OF_CONTRAST * guide.contrast;
    let error = probe.note(Name::GuidedError, (guide.variance + of_contrast * of_contrast).sqrt());
    probe.given(Name::GuidedTolerance, wanted.tolerance);
    probe.given(Name::PixelSamples, f64::from(wanted.pilot()));
    probe.note(Name::GuidedAsked, libm::pow(error / wanted.tolerance, POWER).min(f64::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    const WANTED: Guided = Guided { tolerance: 0.01, min: 3, max: 100 };

    fn pilot(mean: [f64; 3], variance: f64) -> Pilot {
        Pilot { sum: Sum::ZERO, mean: Color::from_array(mean), variance }
    }

    #[test]
    fn a_guide_is_the_mean_variance_and_the_greatest_contrast() {
        let pilots = [pilot([0.5, 0.25, 0.0], 0.5), pilot([0.25, 1.0, 0.5], 0.25), pilot([0.75, 0.5, 0.25], 0.0)];
        // Red differs by 0.5 at most, green by 0.75, blue by 0.5.
        assert_eq!(Guide::of(&pilots), Guide { variance: 0.25, contrast: 0.75 });
        assert_eq!(Guide::of(&pilots[..1]), Guide { variance: 0.5, contrast: 0.0 });
    }

    #[test]
    fn samples_grow_with_the_power_of_the_error() {
        let of = |variance, contrast| asked(WANTED, Guide { variance, contrast }, &mut Silent);
        assert_eq!(of(0.0, 0.0), 0.0);
        assert!((of(0.01 * 0.01, 0.0) - 1.0).abs() < 1e-12, "the tolerance is the error for which one is enough");
        // 16^(3/4) is 8 and 81^(3/4) is 27, and of a contrast a quarter counts: squares of 0.08 and 0.06 make that of 0.1.
        assert!((of(0.16 * 0.16, 0.0) - 8.0).abs() < 1e-9);
        assert!((of(0.0, 4.0 * 0.81) - 27.0).abs() < 1e-9);
        assert!((of(0.08 * 0.08, 0.24) - libm::pow(10.0, 0.75)).abs() < 1e-9);
        assert!(of(f64::INFINITY, 0.0) <= f64::MAX);
    }

    #[test]
    fn counts_are_powers_of_two_within_bounds() {
        let asked_and_taken =
            [(0.0, 4), (4.0, 4), (4.1, 8), (33.0, 64), (64.0, 64), (64.5, 100), (1e300, 100), (f64::NAN, 100)];
        for (asked, taken) in asked_and_taken {
            assert_eq!(WANTED.samples(asked), taken, "{asked}");
        }
        let pilot = |min, max| Guided { tolerance: 1.0, min, max }.pilot();
        assert_eq!(
            [pilot(1, 64), pilot(2, 64), pilot(3, 64), pilot(5, 6), pilot(1 << 20, 1 << 20)],
            [2, 2, 4, 6, 1 << 20]
        );
    }
}
