//! Numbers with few decimals: as in calculations by hand, and as snapshots hold them.

#[cfg(test)]
use super::Name;
use super::{Decision, Log, Value, What};

/// Rounds to a number of decimals as one does by hand: half away from zero, and `-0` becomes `0`.
///
/// An f64 holds a decimal such as 1.0005 only nearly, and a product of decimals has a rounding error. What lies within
/// a few such errors of a half therefore counts as a half, as it is on paper.
pub fn round_half_away(x: f64, digits: u32) -> f64 {
    // Exact: every power of ten up to 10^22 is an f64.
    let scale = (0..digits).fold(1.0, |scale, _| scale * 10.0);
    let scaled = x.abs() * scale;
    // From 2^52 on every f64 is a whole number; so is what overflows. What isn't a number stays none.
    if scaled.is_nan() || scaled >= 4_503_599_627_370_496.0 {
        return x;
    }
    // The whole part: quicker than `floor`, which baseline x86-64 has no instruction for.
    let below = scaled as i64 as f64;
    let paper_noise = (scaled * NOISE).min(1e-6);
    let rounded = if scaled - below >= 0.5 - paper_noise { below + 1.0 } else { below };
    let magnitude = rounded / scale;
    if magnitude == 0.0 { 0.0 } else { magnitude.copysign(x) }
}

/// 2⁻⁴⁸, sixteen times the rounding error of one operation.
const NOISE: f64 = 16.0 * f64::EPSILON;

impl Log {
    /// The same log with every number rounded half away from zero to this many decimals, at most 22: for snapshots, which other compilers
    /// and machines are to reproduce, and in which people see what changed. What the header says stays as it is.
    #[must_use]
    pub fn rounded(&self, digits: u32) -> Log {
        let mut events = self.events.clone();
        events.map_given(|value| rounded_value(value, digits));
        for event in &mut events {
            event.what = rounded_event(event.what.clone(), digits);
        }
        Log { header: self.header.clone(), events }
    }
}

fn rounded_event(what: What, digits: u32) -> What {
    let three = |numbers: [f64; 3]| numbers.map(|x| round_half_away(x, digits));
    match what {
        What::Note { name, value } => What::Note { name, value: rounded_value(value, digits) },
        What::Result { color } => What::Result { color: three(color) },
        What::Mark(decision) => What::Mark(match decision {
            Decision::Attenuated { object, factor } => Decision::Attenuated { object, factor: three(factor) },
            Decision::Subdivided { cell, why, object } => Decision::Subdivided { cell: three(cell), why, object },
            Decision::Accepted { cell, why } => Decision::Accepted { cell: cell.map(three), why },
            other => other,
        }),
        other => other,
    }
}

fn rounded_value(value: Value, digits: u32) -> Value {
    value.map(|x| round_half_away(x, digits))
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

    #[test]
    fn every_number_of_a_log_is_rounded() {
        let third = Value::Number(1.0 / 3.0);
        let what = [
            What::Note { name: Name::RayLength, value: third },
            What::Mark(Decision::Attenuated { object: 0, factor: [0.12345, 1.0, -0.0004] }),
            What::Mark(Decision::Hit),
            What::Result { color: [2.0005, 1e300, 0.0] },
        ];
        let rounded = what.map(|what| rounded_event(what, 3));
        assert_eq!(rounded[0], What::Note { name: Name::RayLength, value: Value::Number(0.333) });
        assert_eq!(rounded[1], What::Mark(Decision::Attenuated { object: 0, factor: [0.123, 1.0, 0.0] }));
        assert_eq!(rounded[2], What::Mark(Decision::Hit));
        assert_eq!(rounded[3], What::Result { color: [2.001, 1e300, 0.0] });
    }
}
