//! When two values count as different.

use crate::log::Value;
use crate::probe::round_half_away;

/// What difference is tolerated. Components are compared one by one: a and b differ if |a − b| is greater than the absolute
/// tolerance *and* greater than the relative one times the size of the values, which is the largest component of both: beside the
/// others of its vector a component that is nearly 0 says nothing. A tolerance that isn't given asks for nothing: without any, every
/// difference counts. 0 and −0 are the same, and so are two values that are no numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Tolerance {
    /// Values are rounded to this many decimals before they are compared, half away from zero, as the views for people round them.
    pub digits: Option<u32>,
    /// The absolute tolerance, in the value's own unit.
    pub absolute: Option<f64>,
    /// The relative tolerance.
    pub relative: Option<f64>,
    /// Whether what only one log has is tolerated, as where one tracer records fewer quantities than the other.
    pub is_of_common: bool,
}

/// How far two values are apart.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Distance {
    /// The largest |a − b| of a component.
    pub absolute: f64,
    /// The same, over the largest component of both; from 0 to 2.
    pub relative: f64,
}

impl Tolerance {
    /// Whether two values differ by more than is tolerated.
    pub fn tells_apart(&self, a: &Value, b: &Value) -> bool {
        let rounded = |value: &Value| value.map(|x| self.digits.map_or(x, |digits| round_half_away(x, digits)));
        let (a, b) = (rounded(a), rounded(b));
        let scale = scale(&a, &b);
        let (a, b) = (a.components(), b.components());
        a.len() != b.len() || a.iter().zip(b).any(|(a, b)| self.tells_numbers_apart(*a, *b, scale))
    }

    fn tells_numbers_apart(&self, a: f64, b: f64, scale: f64) -> bool {
        if a == b || (a.is_nan() && b.is_nan()) {
            return false;
        }
        // Without bounds, or no number: beyond every tolerance.
        if !a.is_finite() || !b.is_finite() {
            return true;
        }
        // Between finite numbers a quarter of the distance doesn't overflow, nor does such a part of the scale.
        let exceeds = |tolerance: f64, scale: f64| match scale > f64::MAX / 4.0 {
            true => (a / 4.0 - b / 4.0).abs() > tolerance * (scale / 4.0),
            false => (a - b).abs() > tolerance * scale,
        };
        self.absolute.is_none_or(|tolerance| exceeds(tolerance, 1.0))
            && self.relative.is_none_or(|tolerance| exceeds(tolerance, scale))
    }
}

/// The size of the largest component of two values.
fn scale(a: &Value, b: &Value) -> f64 {
    a.components().iter().chain(b.components()).fold(0.0, |largest, x| x.abs().max(largest))
}

/// How far two values are apart; of a number and a triple, infinitely.
pub fn distance(a: &Value, b: &Value) -> Distance {
    let scale = scale(a, b);
    let (a, b) = (a.components(), b.components());
    if a.len() != b.len() {
        return Distance { absolute: f64::INFINITY, relative: 2.0 };
    }
    let farthest =
        |part: f64| a.iter().zip(b).fold(0.0, |farthest: f64, (a, b)| farthest.max((a * part - b * part).abs()));
    let absolute = farthest(1.0);
    let relative = match scale {
        0.0 => 0.0,
        // Of numbers so large a quarter doesn't overflow.
        _ if scale > f64::MAX / 4.0 && scale.is_finite() => farthest(0.25) / (scale / 4.0),
        _ => absolute / scale,
    };
    Distance { absolute, relative }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn differ(tolerance: Tolerance, a: f64, b: f64, expected: bool) {
        assert_eq!(tolerance.tells_apart(&Value::Number(a), &Value::Number(b)), expected);
        assert_eq!(tolerance.tells_apart(&Value::Number(b), &Value::Number(a)), expected);
    }

    const EXACT: Tolerance = Tolerance { digits: None, absolute: None, relative: None, is_of_common: false };

    #[test]
    fn without_tolerance_the_last_bit_counts() {
        differ(EXACT, 0.1 + 0.2, 0.3, true);
        differ(EXACT, 0.3, 0.3, false);
        differ(EXACT, 0.0, -0.0, false);
        differ(EXACT, f64::NAN, f64::NAN, false);
        differ(EXACT, f64::NAN, 1.0, true);
    }

    #[test]
    fn what_differs_exceeds_each_given_tolerance() {
        let absolute = Tolerance { absolute: Some(0.5), ..EXACT };
        differ(absolute, 1.0, 1.5, false);
        differ(absolute, 1.0, 1.75, true);
        let relative = Tolerance { relative: Some(0.25), ..EXACT };
        differ(relative, 100.0, 75.0, false);
        differ(relative, 100.0, 74.0, true);
        let both = Tolerance { absolute: Some(0.5), ..relative };
        differ(both, 0.25, 0.5, false);
        differ(both, 100.0, 99.0, false);
        differ(both, 100.0, 70.0, true);
    }

    #[test]
    fn the_largest_numbers_overflow_nothing() {
        const LARGE: f64 = 1.5e308;
        let relative = |relative| Tolerance { relative: Some(relative), ..EXACT };
        differ(relative(1e-6), LARGE, 1.4e308, true);
        differ(relative(0.1), LARGE, 1.4e308, false);
        differ(relative(1.5), LARGE, -LARGE, true);
        differ(relative(2.0), LARGE, -LARGE, false);
        differ(relative(1e308), LARGE, 1.0, false);
        differ(relative(2.0), f64::INFINITY, 1.0, true);
        differ(relative(2.0), f64::INFINITY, f64::NEG_INFINITY, true);
        differ(relative(2.0), f64::INFINITY, f64::INFINITY, false);
        let absolute = Tolerance { absolute: Some(1e307), ..EXACT };
        differ(absolute, LARGE, 1.4e308, false);
        differ(absolute, LARGE, 1.3e308, true);
        differ(absolute, LARGE, -LARGE, true);
        assert_eq!(distance(&Value::Number(LARGE), &Value::Number(-LARGE)).relative, 2.0);
    }

    #[test]
    fn digits_are_those_of_the_views() {
        let digits = Tolerance { digits: Some(3), ..EXACT };
        differ(digits, 12.689, 12.688_577, false);
        differ(digits, 12.685, 12.688_577, true);
        // Half away from zero, on either side.
        differ(digits, 1.0005, 1.001, false);
        differ(digits, -1.0005, -1.0, true);
        differ(digits, 0.000_4, -0.000_4, false);
    }

    #[test]
    fn a_triple_is_as_far_as_its_farthest_component() {
        let (a, b) = (Value::Triple([1.0, 10.0, 0.0]), Value::Triple([1.0, -12.5, 0.25]));
        assert_eq!(distance(&a, &b), Distance { absolute: 22.5, relative: 1.8 });
        // Beside 13, 0 and 0.002 are much alike.
        let relative = Tolerance { relative: Some(0.001), ..EXACT };
        assert!(!relative.tells_apart(&Value::Triple([13.0, 3.0, 0.002]), &Value::Triple([13.0, 3.0, 0.0])));
        assert!(relative.tells_apart(&Value::Number(0.002), &Value::Number(0.0)));
        let tolerance = Tolerance { absolute: Some(1.0), ..EXACT };
        assert!(tolerance.tells_apart(&Value::Triple([0.0, 0.0, 3.0]), &Value::Triple([0.0; 3])));
        assert!(!tolerance.tells_apart(&Value::Triple([1.0, -1.0, 0.5]), &Value::Triple([0.0; 3])));
    }
}
