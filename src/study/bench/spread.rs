//! A figure that was measured several times.

use serde::Serialize;

/// The median of several measurements, and how far they are apart.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Spread {
    /// Half of the measurements are at most this.
    pub median: f64,
    /// A quarter of the measurements are at most this.
    pub lower: f64,
    /// Three quarters of the measurements are at most this.
    pub upper: f64,
    /// The least of them.
    pub least: f64,
    /// The greatest of them.
    pub greatest: f64,
    /// How many there are.
    pub count: usize,
}

impl Spread {
    /// The spread of these measurements; of none all is 0.
    pub fn of(mut values: Vec<f64>) -> Spread {
        values.sort_by(f64::total_cmp);
        let part = |quarter: usize| {
            let place = values.len().saturating_sub(1) as f64 * quarter as f64 / 4.0;
            let (below, beyond) = (place.floor(), place - place.floor());
            let value = |place: f64| values.get(place as usize).copied().unwrap_or_default();
            value(below) + beyond * (value(place.ceil()) - value(below))
        };
        Spread {
            median: part(2),
            lower: part(1),
            upper: part(3),
            least: part(0),
            greatest: part(4),
            count: values.len(),
        }
    }

    /// The spread of `whole` over each of the values, such as that of speeds from that of times.
    #[must_use]
    pub fn under(self, whole: f64) -> Spread {
        let Spread { median, lower, upper, least, greatest, count } = self.map(|value| whole / value);
        Spread { median, lower: upper, upper: lower, least: greatest, greatest: least, count }
    }

    /// The spread of the values times a positive number.
    #[must_use]
    pub fn times(self, factor: f64) -> Spread {
        self.map(|value| value * factor)
    }

    fn map(self, f: impl Fn(f64) -> f64) -> Spread {
        let Spread { median, lower, upper, least, greatest, count } = self;
        let [median, lower, upper, least, greatest] = [median, lower, upper, least, greatest].map(f);
        Spread { median, lower, upper, least, greatest, count }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_lie_between_the_values() {
        let spread = Spread::of(vec![5.0, 1.0, 2.0, 4.0, 3.0]);
        assert_eq!(
            (spread.least, spread.lower, spread.median, spread.upper, spread.greatest),
            (1.0, 2.0, 3.0, 4.0, 5.0)
        );
        let spread = Spread::of(vec![1.0, 2.0]);
        assert_eq!((spread.lower, spread.median, spread.upper), (1.25, 1.5, 1.75));
        assert_eq!(Spread::of(vec![7.0]).median, 7.0);
        assert_eq!(Spread::of(Vec::new()).count, 0);
    }

    #[test]
    fn fast_is_the_other_end_of_long() {
        let speeds = Spread::of(vec![1.0, 2.0, 4.0]).under(8.0);
        assert_eq!((speeds.least, speeds.median, speeds.greatest), (2.0, 4.0, 8.0));
        assert!(speeds.lower < speeds.upper);
    }
}
