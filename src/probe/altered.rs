//! Probes that alter what the computation goes on with: other arithmetics, with or without a recording.

use super::{Probe, Quantity};
use crate::log::{Decision, Name, Step};

/// Alters every named quantity, then shows it to `probe`.
#[derive(Clone, Debug, Default)]
pub struct Altered<A, P> {
    /// What is done to the quantities.
    pub alteration: A,
    /// Who sees them then.
    pub probe: P,
}

/// What is done to every named quantity.
pub trait Alteration {
    /// The value that the computation goes on with instead.
    fn alter<Q: Quantity>(&mut self, name: Name, value: Q) -> Q;

    /// A node begins.
    fn enter(&mut self, _step: Step) {}

    /// The latest node ends.
    fn leave(&mut self) {}

    /// The ray through this place of the picture begins.
    fn aim(&mut self, _place: [f64; 2]) {}

    /// All that it brings is there.
    fn aimed(&mut self) {}
}

impl<A: Alteration, P: Probe> Probe for Altered<A, P> {
    fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        self.probe.given(name, value);
    }

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let altered = self.alteration.alter(name, value);
        self.probe.note(name, altered)
    }

    fn mark(&mut self, decision: Decision) {
        self.probe.mark(decision);
    }

    fn bounds_tested(&mut self, count: u64) {
        self.probe.bounds_tested(count);
    }

    fn certifies(&self) -> bool {
        false
    }

    fn aim(&mut self, place: [f64; 2]) {
        self.alteration.aim(place);
        self.probe.aim(place);
    }

    fn aimed(&mut self) {
        self.probe.aimed();
        self.alteration.aimed();
    }

    fn enter(&mut self, step: Step) {
        self.alteration.enter(step);
        self.probe.enter(step);
    }

    fn leave(&mut self) {
        self.probe.leave();
        self.alteration.leave();
    }
}

/// Arithmetic by hand: every named quantity is rounded to a number of decimals.
#[derive(Clone, Copy, Debug)]
pub struct Decimal {
    digits: u32,
}

impl Decimal {
    /// How many decimals there may be.
    pub const MAX_DIGITS: u32 = 15;

    /// Arithmetic with this many decimals, at most [`Decimal::MAX_DIGITS`].
    pub fn new(digits: u32) -> Decimal {
        Decimal { digits: digits.min(Decimal::MAX_DIGITS) }
    }
}

impl Alteration for Decimal {
    fn alter<Q: Quantity>(&mut self, _name: Name, value: Q) -> Q {
        value.map(|_, x| round_half_away(x, self.digits))
    }
}

/// Rounds to a number of decimals as one does by hand: half away from zero, and `-0` becomes `0`.
///
/// An f64 holds a decimal such as 1.0005 only nearly, and a product of decimals has a rounding error. What lies within
/// a few such errors of a half therefore counts as a half, as it is on paper.
pub fn round_half_away(x: f64, digits: u32) -> f64 {
    // Exact: every power of ten up to 10^22 is an f64.
    let scale = (0..digits).fold(1.0, |scale, _| scale * 10.0);
    let scaled = x.abs() * scale;
    // From 2^52 on every f64 is a whole number; so is what overflows.
    if scaled >= 4_503_599_627_370_496.0 {
        return x;
    }
    let below = scaled.floor();
    let paper_noise = (scaled * NOISE).min(1e-6);
    let rounded = if scaled - below >= 0.5 - paper_noise { below + 1.0 } else { below };
    let magnitude = rounded / scale;
    if magnitude == 0.0 { 0.0 } else { magnitude.copysign(x) }
}

/// 2⁻⁴⁸, sixteen times the rounding error of one operation.
const NOISE: f64 = 16.0 * f64::EPSILON;

/// What single precision would do: every named quantity is rounded to f32, and to the greatest one where it would overflow,
/// since a log holds finite numbers only.
#[derive(Clone, Copy, Debug, Default)]
pub struct Single;

impl Alteration for Single {
    fn alter<Q: Quantity>(&mut self, _name: Name, value: Q) -> Q {
        value.map(|_, x| f64::from((x as f32).clamp(f32::MIN, f32::MAX)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn rounds(x: f64, digits: u32, expected: f64) {
        assert_eq!(round_half_away(x, digits).to_bits(), expected.to_bits(), "{x} to {digits} decimals");
    }

    #[test]
    fn halves_go_away_from_zero() {
        rounds(0.5, 0, 1.0);
        rounds(-0.5, 0, -1.0);
        rounds(1.0005, 3, 1.001);
        rounds(-1.0005, 3, -1.001);
        rounds(0.001 * 0.5, 3, 0.001);
        rounds(2.675, 2, 2.68);
    }

    #[test]
    fn the_rest_goes_to_the_nearest() {
        rounds(0.2317254, 3, 0.232);
        rounds(0.231_499_999, 3, 0.231);
        rounds(-12.0, 3, -12.0);
        rounds(1.0 / 3.0, 15, 0.333333333333333);
    }

    #[test]
    fn zero_has_no_sign() {
        rounds(-0.0, 3, 0.0);
        rounds(-0.0004, 3, 0.0);
    }

    #[test]
    fn what_has_no_decimals_stays() {
        rounds(1e300, 3, 1e300);
        rounds(-9_007_199_254_740_993.0, 3, -9_007_199_254_740_993.0);
    }
}
