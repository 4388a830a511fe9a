//! Sums and means whose error doesn't grow with the number of values.

use crate::geometry::doubled::Doubled;
use crate::log::Name;
use crate::probe::Probe;
use crate::scene::Color;

/// A sum of colours, kept with twice the digits: the error of the mean of n values is that of its last rounding and n·2⁻¹⁰⁴
/// parts of the sum of their magnitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sum {
    channels: [Doubled; 3],
}

impl Sum {
    /// The sum of nothing.
    pub const ZERO: Sum = Sum { channels: [Doubled::ZERO; 3] };

    /// Adds a colour.
    #[inline]
    pub fn add(&mut self, color: Color) {
        for (sum, value) in self.channels.iter_mut().zip(color.to_array()) {
            *sum = *sum + Doubled::from(value);
        }
    }

    /// The sum over a number that isn't zero.
    pub fn over(&self, count: f64) -> Color {
        if is_power_of_two(count) && self.channels.iter().all(|sum| is_middling(sum.head)) {
            // Nothing is rounded by a power of two, so that what long division gives is known without it.
            return Color::from_array(self.channels.map(|sum| sum.value() / count));
        }
        Color::from_array(self.channels.map(|sum| {
            let mean = (sum / Doubled::from(count)).value();
            // Near the greatest numbers products can't be split; sums that overflow are infinite, not undefined.
            if mean.is_finite() { mean } else { sum.head / count }
        }))
    }
}

/// The mean of this many samples, the colour of a pixel, as the quantity that it is.
#[inline]
pub fn of_pixel<P: Probe>(name: Name, sum: Sum, count: f64, probe: &mut P) -> Color {
    probe.given(Name::PixelSamples, count);
    probe.note(name, sum.over(count))
}

/// Whether a number is zero, or so far from the least and the greatest numbers that no step of a division goes beyond those.
fn is_middling(x: f64) -> bool {
    x == 0.0 || (1e-200..1e200).contains(&x.abs())
}

/// Whether a number is a power of two that isn't too large for a count: it has no digits after its first.
fn is_power_of_two(count: f64) -> bool {
    (1.0..=LARGEST_COUNT).contains(&count) && count.to_bits() << 12 == 0
}

/// 2³²
const LARGEST_COUNT: f64 = 4_294_967_296.0;

#[cfg(test)]
mod tests {
    use super::*;

    /// The shorter way for powers of two gives the bits of the long division.
    #[test]
    fn a_power_of_two_divides_as_any_number_does() {
        for k in 0..1000_u64 {
            let mut sum = Sum::ZERO;
            for part in 0..k % 7 {
                let digits = |axis: u64| crate::random::unit(crate::random::hash(k << 8 | part, axis));
                sum.add(Color::new(digits(0), digits(1) * 1e-30, digits(2) * 1e30 * (digits(3) - 0.5)));
            }
            let count = f64::from(1_u32 << (k % 20));
            let long = sum.channels.map(|sum| (sum / Doubled::from(count)).value());
            assert_eq!(sum.over(count).to_array().map(f64::to_bits), long.map(f64::to_bits), "{k}");
        }
    }

    #[test]
    fn small_values_are_not_lost_beside_large_ones() {
        let mut sum = Sum::ZERO;
        sum.add(Color::splat(1e20));
        (0..1000).for_each(|_| sum.add(Color::ONE));
        sum.add(Color::splat(-1e20));
        assert_eq!(sum.over(1000.0), Color::ONE);
    }

    /// The exact sum of 10⁶ whole numbers of 52 bits is compared with the mean in whole numbers too.
    #[test]
    fn the_mean_of_a_million_values_errs_by_less_than_a_unit_in_the_last_place() {
        let n = 1_000_000_u64;
        let bits = |k: u64| (crate::random::hash(1, k) >> 12) + (1 << 50);
        let mut sum = Sum::ZERO;
        (0..n).for_each(|k| sum.add(Color::splat(bits(k) as f64)));
        let exact: u128 = (0..n).map(|k| u128::from(bits(k))).sum();
        let mean = sum.over(n as f64).x;
        // The mean lies between 2⁵¹ and 2⁵², where a unit in the last place is 1/2.
        assert!((1_u64 << 51..1 << 52).contains(&(mean as u64)));
        let twice = (2.0 * mean) as u128;
        assert!((twice * u128::from(n)).abs_diff(2 * exact) <= u128::from(n) / 2, "{mean}: the nearest number");
    }

    #[test]
    fn the_mean_of_equal_values_is_that_value() {
        let mut sum = Sum::ZERO;
        let color = Color::new(0.1, 254.99999, 1e-300);
        (0..4096).for_each(|_| sum.add(color));
        assert_eq!(sum.over(4096.0), color);
    }
}
