//! As many samples as the pixel needs, by a test of their mean (Ramos, section 1.4.2; Lee, Redner and Uselton, "Statistically
//! optimized sampling for distributed ray tracing", 1985).
//!
//! Samples are points of a scrambled Sobol sequence, doubled until Student's interval of the mean is narrow enough. Of 2^k
//! points every one of 2^(k−1) near-square strata has two, from whose difference the variance of the mean is estimated; the
//! degrees of freedom are Satterthwaite's ("An approximate distribution of estimates of variance components", 1946), so that
//! few strata that an edge crosses count as few. Of the variances from horizontal and from vertical strata the greater one counts; where no two
//! in a stratum differ though samples do, all are one stratum. Neighbouring points of a scrambled net repel each other, which makes
//! all of these err on the side of too large a variance.
//!
//! Stopping when the samples look good is biased: a pixel whose first samples agree by chance keeps their value.
//! `docs/sampling.md` has how often that happens. Where samples draw a lens, a time, lights or lobes, chance has many more ways that
//! a few that agree aren't enough.

use super::mean::{self, Sum};
use super::place::samples;
use super::sobol::arrangement;
use super::stochastic::draws;
use super::student;
use crate::log::{Acceptance, Decision, Name};
use crate::probe::Probe;
use crate::random::Pick;
use crate::scene::file::validate::limits::MIN_STATISTICAL;
use crate::scene::{Color, Scene, Statistical};
use crate::trace::Seen;

/// A sample that was taken: where in the pixel, and its colour.
struct Taken {
    place: [f64; 2],
    color: Color,
}

/// The mean of as many samples as are wanted.
pub fn pixel<P: Probe>(scene: &Scene, wanted: Statistical, pixel: [u32; 2], probe: &mut P) -> Color {
    let mut taken = Vec::new();
    let mut sum = Sum::ZERO;
    let mut until = wanted.min.max(MIN_STATISTICAL).next_power_of_two();
    let mut draws_more = scene.effects.of_the_eye();
    loop {
        let numbers = taken.len() as u32..until.min(wanted.max);
        let place = draws(scene, arrangement(scene), pixel);
        let seen = |pick: Pick, Seen { color, object }| {
            draws_more |= object.is_some() && scene.effects.of_surfaces();
            sum.add(color);
            taken.push(Taken { place: pick.point(), color });
        };
        samples(scene, pixel, numbers, place, seen, probe);
        let count = taken.len() as u32;
        let mean = mean::of_pixel(Name::StatisticalMean, sum, f64::from(count), probe);
        let verdict = match taken.iter().all(|sample| sample.color == taken[0].color) {
            true if draws_more => enough_alike(wanted, count, probe),
            true => Some(Acceptance::Alike),
            false => verdict(scene, wanted, &taken, probe),
        };
        if let Some(why) = verdict.or((count >= wanted.max).then_some(Acceptance::Max)) {
            probe.mark(Decision::Accepted { cell: None, why });
            return mean;
        }
        until *= 2;
        probe.mark(Decision::MoreSamples { from: count, to: until.min(wanted.max) });
    }
}

/// Whether this many samples that are alike are enough where they draw more than their place: what a lens, a shutter, a light or a lobe
/// shows with a probability of the tolerance or more is then seen by one of them with the confidence, as (1 − ε_m)ⁿ ≤ 1 − γ_m.
fn enough_alike<P: Probe>(wanted: Statistical, count: u32, probe: &mut P) -> Option<Acceptance> {
    probe.given(Name::StatisticalConfidence, wanted.confidence);
    probe.given(Name::StatisticalTolerance, wanted.tolerance);
    let needed = libm::log1p(-wanted.confidence) / libm::log1p(-wanted.tolerance.min(1.0));
    // No finite number of samples is enough for a tolerance of 0.
    let needed = probe.note(Name::StatisticalAlike, libm::ceil(needed).min(f64::MAX));
    (f64::from(count) >= needed).then_some(Acceptance::Alike)
}

/// Why samples that differ are enough; `None` if they aren't.
fn verdict<P: Probe>(scene: &Scene, wanted: Statistical, taken: &[Taken], probe: &mut P) -> Option<Acceptance> {
    // The last samples may be no power of two, and then have no pairs.
    let spread = if taken.len().is_power_of_two() { Spread::of_samples(taken) } else { Spread::of_one_stratum(taken) };
    // The quantile isn't recorded, and takes longer than most samples.
    if P::IS_SILENT
        && let Some(is_narrow) = spread.is_surely_narrow(wanted.confidence, wanted.tolerance * scene.output.white)
    {
        return is_narrow.then_some(Acceptance::Interval);
    }
    let standard_error = probe.note(Name::StatisticalError, spread.standard_error);
    let freedom = probe.note(Name::StatisticalFreedom, spread.degrees_of_freedom);
    probe.given(Name::StatisticalConfidence, wanted.confidence);
    let quantile = probe.note(Name::StatisticalQuantile, quantiles(wanted.confidence, freedom));
    let half_width = probe.note(Name::StatisticalHalfWidth, (quantile * standard_error).min(Color::MAX));
    let widest = probe.note(Name::StatisticalWidest, half_width.max_element());
    probe.given(Name::StatisticalTolerance, wanted.tolerance);
    probe.given(Name::OutputWhite, scene.output.white);
    let limit = probe.note(Name::StatisticalLimit, (wanted.tolerance * scene.output.white).min(f64::MAX));
    (widest <= limit).then_some(Acceptance::Interval)
}

/// The differences between the two samples of each of this many strata across and down.
fn differences(taken: &[Taken], [across, down]: [u32; 2]) -> Vec<Color> {
    let mut first: Vec<Option<Color>> = vec![None; taken.len() / 2];
    let mut differences = Vec::with_capacity(taken.len() / 2);
    for Taken { place: [x, y], color } in taken {
        let stratum = (y * f64::from(down)) as u32 * across + (x * f64::from(across)) as u32;
        match first[stratum as usize].take() {
            None => first[stratum as usize] = Some(*color),
            Some(other) => differences.push(*color - other),
        }
    }
    differences
}

/// How far the mean of the samples may be from the pixel's colour, per channel.
struct Spread {
    standard_error: Color,
    degrees_of_freedom: Color,
}

impl Spread {
    /// From the samples, a power of two: per channel the greater of two stratifications, or that of all as one stratum where
    /// these see nothing.
    fn of_samples(taken: &[Taken]) -> Spread {
        let halvings = (taken.len() / 2).trailing_zeros();
        let (more, fewer) = (1_u32 << halvings.div_ceil(2), 1_u32 << (halvings / 2));
        let [lying, standing] =
            [[fewer, more], [more, fewer]].map(|strata| Spread::of(&differences(taken, strata), taken.len()));
        lying.or_greater(&standing).or_greater_where_zero(|| Spread::of_one_stratum(taken))
    }

    /// Whether the interval is at most as wide as the limit to either side, where that can be told without its quantile.
    fn is_surely_narrow(&self, confidence: f64, limit: f64) -> Option<bool> {
        let Spread { standard_error: error, degrees_of_freedom: freedom } = self;
        let is_same_as_red = |k: usize| k > 0 && error[k] == error.x && freedom[k] == freedom.x;
        let mut is_narrow = Some(true);
        for k in (0..3).filter(|k| error[*k] > 0.0 && !is_same_as_red(*k)) {
            let quotient = limit / error[k];
            if !(LEAST_QUOTIENT..MOST_QUOTIENT).contains(&quotient) {
                return None;
            }
            match student::is_at_most(quotient, confidence, freedom[k]) {
                Some(true) => {}
                Some(false) => return Some(false),
                None => is_narrow = None,
            }
        }
        is_narrow
    }

    /// Per channel the one with the greater standard error.
    fn or_greater(&self, other: &Spread) -> Spread {
        let takes_other = other.standard_error.cmpgt(self.standard_error);
        Spread {
            standard_error: Color::select(takes_other, other.standard_error, self.standard_error),
            degrees_of_freedom: Color::select(takes_other, other.degrees_of_freedom, self.degrees_of_freedom),
        }
    }

    /// Another one for the channels that have no error.
    fn or_greater_where_zero(&self, other: impl FnOnce() -> Spread) -> Spread {
        let is_zero = self.standard_error.cmpeq(Color::ZERO);
        if !is_zero.any() {
            return Spread { ..*self };
        }
        let other = other();
        Spread {
            standard_error: Color::select(is_zero, other.standard_error, self.standard_error),
            degrees_of_freedom: Color::select(is_zero, other.degrees_of_freedom, self.degrees_of_freedom),
        }
    }

    /// The textbook's: s²/n, with n − 1 degrees of freedom.
    fn of_one_stratum(taken: &[Taken]) -> Spread {
        let n = taken.len() as f64;
        let mut sum = Sum::ZERO;
        taken.iter().for_each(|sample| sum.add(sample.color));
        let mean = sum.over(n);
        let greatest = taken.iter().fold(Color::ZERO, |greatest, sample| greatest.max((sample.color - mean).abs()));
        let unit = or_one(greatest);
        let squares = taken.iter().map(|sample| (sample.color - mean) / unit).map(|off| off * off).sum::<Color>();
        Spread {
            standard_error: (unit * root(squares / (n - 1.0) / n)).min(Color::MAX),
            degrees_of_freedom: Color::splat(n - 1.0),
        }
    }

    /// From the differences d of the pairs of n samples: the mean's variance is Σ d²/n², as each pair's mean has the variance
    /// d²/4 and the weight 2/n; Satterthwaite's degrees of freedom are (Σ d²)²/Σ d⁴, one for each pair if all differ alike.
    fn of(differences: &[Color], n: usize) -> Spread {
        let greatest = differences.iter().fold(Color::ZERO, |greatest, difference| greatest.max(difference.abs()));
        // Relative to the greatest, so that no square over- or underflows.
        let unit = or_one(greatest);
        let (mut squares, mut fourths) = (Color::ZERO, Color::ZERO);
        for difference in differences {
            let relative = *difference / unit;
            squares += relative * relative;
            fourths += relative * relative * relative * relative;
        }
        let freedom = |k: usize| match squares[k] {
            0.0 => differences.len() as f64,
            square => (square * square / fourths[k]).max(1.0),
        };
        Spread {
            standard_error: (unit * root(squares) / n as f64).min(Color::MAX),
            degrees_of_freedom: Color::new(freedom(0), freedom(1), freedom(2)),
        }
    }
}

/// Between this quotient of limit and standard error and [`MOST_QUOTIENT`] nothing over- or underflows.
const LEAST_QUOTIENT: f64 = 1e-100;

/// See [`LEAST_QUOTIENT`].
const MOST_QUOTIENT: f64 = 1e100;

/// What channels are divided by, but never zero.
fn or_one(greatest: Color) -> Color {
    Color::select(greatest.cmpgt(Color::ZERO), greatest, Color::ONE)
}

fn root(square: Color) -> Color {
    Color::new(square.x.sqrt(), square.y.sqrt(), square.z.sqrt())
}

/// Student's quantile of each channel; channels often have the same degrees of freedom.
fn quantiles(confidence: f64, freedom: Color) -> Color {
    let red = student::quantile(confidence, freedom.x);
    let green = if freedom.y == freedom.x { red } else { student::quantile(confidence, freedom.y) };
    let blue = if freedom.z == freedom.x {
        red
    } else if freedom.z == freedom.y {
        green
    } else {
        student::quantile(confidence, freedom.z)
    };
    Color::new(red, green, blue)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Arrangement, Dimension, Draws, Partner};

    fn taken(n: u32, color: impl Fn([f64; 2]) -> f64) -> Vec<Taken> {
        let draws = |number| Draws::of_pixel(1, [2, 3], number, Arrangement::Sobol { partner: Partner::Nothing });
        let place = |number| draws(number).pick(Dimension::Pixel).point();
        (0..n).map(|number| Taken { place: place(number), color: Color::splat(color(place(number))) }).collect()
    }

    #[test]
    fn every_stratum_has_a_pair() {
        for k in 2..12 {
            assert_eq!(differences(&taken(1 << k, |[x, _]| x), [2, 1 << (k - 2)]).len(), 1 << (k - 1));
        }
    }

    #[test]
    fn a_slope_has_the_variance_of_its_strata() {
        // Two uniform samples in a stratum of width w differ by w²/6 in the mean square; the variance of the mean is Σ d²/n².
        for k in [4, 8, 10] {
            let n = 1_u32 << k;
            let strata = |n: u32| [1 << (n.trailing_zeros() - 1).div_ceil(2), 1 << ((n.trailing_zeros() - 1) / 2)];
            let width = 1.0 / f64::from(strata(n)[0]);
            let expected = libm::sqrt(f64::from(n / 2) * width * width / 6.0) / f64::from(n);
            let spread = Spread::of(&differences(&taken(n, |[x, _]| x), strata(n)), n as usize);
            let ratio = spread.standard_error.x / expected;
            assert!((0.7..1.5).contains(&ratio), "{n}: {ratio}");
            assert!(spread.degrees_of_freedom.x > f64::from(n) / 8.0);
        }
    }

    #[test]
    fn few_strata_that_differ_are_few_degrees_of_freedom() {
        let alike = Color::splat(0.0);
        let differences = [alike, Color::splat(2.0), alike, Color::splat(-2.0), alike, alike, alike, alike];
        let spread = Spread::of(&differences, 16);
        assert_eq!(spread.degrees_of_freedom, Color::splat(2.0));
        assert!((spread.standard_error.x - libm::sqrt(8.0) / 16.0).abs() < 1e-15);
    }

    #[test]
    fn samples_that_differ_between_strata_only_are_one_stratum() {
        let samples = taken(8, |[x, _]| if x < 0.5 { 0.0 } else { 1.0 });
        let spread = Spread::of_samples(&samples);
        assert_eq!(spread.degrees_of_freedom, Color::splat(7.0));
        assert!((spread.standard_error.x - libm::sqrt(2.0 / 7.0 / 8.0)).abs() < 1e-15);
    }

    #[test]
    fn numbers_near_the_greatest_have_a_spread() {
        let spread = Spread::of(&[Color::splat(1e300), Color::splat(-1e300)], 4);
        assert!(spread.standard_error.is_finite() && spread.degrees_of_freedom == Color::splat(2.0));
    }
}
