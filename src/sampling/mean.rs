//! Sums and means whose error doesn't grow with the number of values.

use crate::geometry::doubled::Doubled;
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
        Color::from_array(self.channels.map(|sum| {
            let mean = (sum / Doubled::from(count)).value();
            // Near the greatest numbers products can't be split; sums that overflow are infinite, not undefined.
            if mean.is_finite() { mean } else { sum.head / count }
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
