//! How many digits several perturbed runs have in common.

/// How many runs there are.
///
/// With 5 the factor √N/τ of the formula is 0.81, so that it tells the digits of one run's value, less a tenth; with the 3 of
/// CADNA it is 0.40, which withholds nearly half a digit, and with 8 or more it exceeds 1, because then the mean is better
/// than any of the runs.
pub const RUNS: usize = 5;

/// Student's τ for [`RUNS`] − 1 degrees of freedom: 95 % lie between −τ and τ.
const STUDENT: f64 = 2.776_445;

/// The most digits that are reported: 53·log₁₀ 2, those of an f64.
pub const ALL_DIGITS: f64 = 15.95;

/// The number of significant decimal digits, from 0 to [`ALL_DIGITS`], in hundredths: C = log₁₀(√N·|mean|/(σ·τ)) (Vignes 1993,
/// the formula of CESTAC; CADNA uses it with N = 3). Equal values have all digits, also if they are 0.
pub fn significant(values: &[f64; RUNS]) -> f64 {
    if values.iter().all(|x| x == &values[0]) {
        return ALL_DIGITS;
    }
    // As parts of the greatest, so that no square over- or underflows, and from the first on, so that the differences
    // of neighbours are exact.
    let greatest = values.iter().fold(0.0, |greatest: f64, x| greatest.max(x.abs()));
    let ways = values.map(|x| (x - values[0]) / greatest);
    let count = RUNS as f64;
    let mean_way = ways.iter().sum::<f64>() / count;
    let variance = ways.iter().map(|way| (way - mean_way) * (way - mean_way)).sum::<f64>() / (count - 1.0);
    let mean = values[0] / greatest + mean_way;
    let digits = libm::log10(count.sqrt() * mean.abs() / (variance.sqrt() * STUDENT));
    // Not a number where the differences overflow: then they are as large as the values.
    let digits = if digits.is_nan() { 0.0 } else { digits.clamp(0.0, ALL_DIGITS) };
    (digits * 100.0 + 1e-9).floor() / 100.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn has(values: [f64; RUNS], expected: f64) {
        assert_eq!(significant(&values), expected, "{values:?}");
    }

    #[test]
    fn equal_values_have_all_digits() {
        has([0.0; 5], 15.95);
        has([-3.0e-200; 5], 15.95);
    }

    /// The mean is 1, the variance 10·e²/4, the digits log₁₀(√5/(√2.5·2.776·e)) = −log₁₀ e − 0.293.
    #[test]
    fn the_formula() {
        let spread = |e: f64| [1.0 - 2.0 * e, 1.0 - e, 1.0, 1.0 + e, 1.0 + 2.0 * e];
        has(spread(1e-3), 2.70);
        has(spread(1e-12), 11.70);
        has(spread(1e-3).map(|x| x * 1e300), 2.70);
        has(spread(1e-3).map(|x| x * -1e-300), 2.70);
    }

    #[test]
    fn what_has_no_digits_has_none() {
        has([1.0, -1.0, 2.0, -2.0, 0.0], 0.0);
        has([1.0, -3.0, 2.0, -2.5, 4.0], 0.0);
        has([1.7e308, -1.7e308, 1.7e308, 1.0, 2.0], 0.0);
    }

    #[test]
    fn an_ulp_leaves_nearly_all() {
        let ulp = f64::EPSILON;
        has([1.5 + ulp, 1.5 - ulp, 1.5 + ulp, 1.5 - ulp, 1.5 + ulp], 15.69);
    }
}
