//! Quantiles of Student's t distribution (Student, "The probable error of a mean", 1908).

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// The t for which a variable of Student's distribution lies between −t and t with this probability, above 0 and below 1. The
/// degrees of freedom are 1 or more, whole or not. It errs by less than 10⁻⁹ of its value.
///
/// With x = ν/(ν + t²) the probability outside is the incomplete beta function I_x(ν/2, 1/2) (DLMF 8.17). Its logarithm is
/// nearly straight over that of t, so Newton's method takes a few steps; a bracket keeps it from going astray.
pub fn quantile(probability: f64, degrees_of_freedom: f64) -> f64 {
    let wanted = libm::log1p(-probability);
    let scale = BetaScale::new(degrees_of_freedom);
    let mut bracket = [-40.0, 800.0];
    let mut log_t = 0.5;
    for _ in 0..MOST_STEPS {
        let [log_outside, slope] = scale.log_outside(libm::exp(log_t));
        let above = log_outside - wanted;
        if above > 0.0 {
            bracket[0] = log_t;
        } else {
            bracket[1] = log_t;
        }
        let newton = log_t - above / slope;
        let next = if bracket[0] < newton && newton < bracket[1] { newton } else { (bracket[0] + bracket[1]) / 2.0 };
        if (next - log_t).abs() < 1e-13 * log_t.abs().max(1.0) {
            break;
        }
        log_t = next;
    }
    libm::exp(log_t)
}

/// Whether the quantile is no greater than t ≥ 0, where that can be told without it; `None` where it is so near to t that only
/// itself can tell. Says what [`quantile`] says, in a fraction of its time.
pub fn is_at_most(t: f64, probability: f64, degrees_of_freedom: f64) -> Option<bool> {
    if probability < LEAST_PROBABILITY {
        // Nobody asks for such a low confidence; closed forms lose digits there.
        return None;
    }
    // The quantile falls with the degrees of freedom, from Cauchy's at 1 to the normal distribution's. So those of few degrees bound
    // it: at 1 it is tan(πp/2) ≤ 2/(π(1 − p)), at 2 and 4 it has closed forms.
    let above = match degrees_of_freedom {
        freedom if freedom >= 4.0 => with_four(probability),
        freedom if freedom >= 2.0 => with_two(probability),
        _ => FRAC_2_PI / (1.0 - probability),
    };
    if t > above * (1.0 + SURELY) {
        return Some(true);
    }
    let below = match degrees_of_freedom {
        freedom if freedom <= 2.0 => with_two(probability),
        freedom if freedom <= 4.0 => with_four(probability),
        // The probability between −z and z is at most √(1 − exp(−2z²/π)) (Pólya, "Remarks on computing the probability integral", 1949).
        _ => (-FRAC_PI_2 * libm::log1p(-probability * probability)).sqrt(),
    };
    if t < below * (1.0 - SURELY) {
        return Some(false);
    }
    // Then the probability outside t tells, unless t is the quantile by a step of Newton's method that is less than its error.
    let [log_outside, slope] = BetaScale::new(degrees_of_freedom).log_outside(t);
    let newton = (log_outside - libm::log1p(-probability)) / slope;
    (newton.abs() > SURELY).then_some(newton > 0.0)
}

/// Below this probability [`is_at_most`] tells nothing.
const LEAST_PROBABILITY: f64 = 0.1;

/// More than the error of a quantile, and of the logarithm of a probability, by far.
const SURELY: f64 = 1e-6;

/// The quantile at two degrees of freedom.
fn with_two(probability: f64) -> f64 {
    probability * (2.0 / ((1.0 - probability) * (1.0 + probability))).sqrt()
}

/// The quantile at four degrees of freedom (Shaw, "Sampling Student's T distribution", 2006, section 2.3).
fn with_four(probability: f64) -> f64 {
    let root = ((1.0 - probability) * (1.0 + probability)).sqrt();
    (4.0 * (libm::cos(libm::acos(root) / 3.0) / root - 1.0)).max(0.0).sqrt()
}

/// Newton's method needs about six, halving of the bracket alone sixty.
const MOST_STEPS: usize = 80;

/// What doesn't change with t.
struct BetaScale {
    freedom: f64,
    /// −ln B(ν/2, 1/2)
    log_scale: f64,
}

impl BetaScale {
    fn new(freedom: f64) -> BetaScale {
        // Γ(1/2) = √π
        let log_beta = libm::lgamma(freedom / 2.0) + 0.5 * libm::log(std::f64::consts::PI);
        BetaScale { freedom, log_scale: libm::lgamma((freedom + 1.0) / 2.0) - log_beta }
    }

    /// The logarithm of the probability outside −t and t, and its slope over the logarithm of t.
    fn log_outside(&self, t: f64) -> [f64; 2] {
        let a = self.freedom / 2.0;
        // x and 1 − x, neither by subtraction. t² may overflow; t/√ν doesn't.
        let ratio = t / libm::sqrt(self.freedom);
        let (x, rest) = if ratio > 1e150 {
            (0.0, 1.0)
        } else {
            (1.0 / (1.0 + ratio * ratio), ratio * ratio / (1.0 + ratio * ratio))
        };
        let log_x = if ratio > 1e150 { -2.0 * libm::log(ratio) } else { -libm::log1p(ratio * ratio) };
        let log_front = self.log_scale + a * log_x + 0.5 * libm::log(rest);
        // The continued fraction converges quickly on this side of the mean, and beyond it for 1 − I.
        let log_outside = if x < (a + 1.0) / (a + 2.5) {
            log_front + libm::log(fraction(x, a, 0.5) / a)
        } else {
            libm::log1p(-libm::exp(log_front) * fraction(rest, 0.5, a) / 0.5)
        };
        [log_outside, -2.0 * libm::exp(log_front - log_outside)]
    }
}

/// The continued fraction of the incomplete beta function (DLMF 8.17.22) by Lentz's method.
fn fraction(x: f64, a: f64, b: f64) -> f64 {
    const TINY: f64 = 1e-300;
    let away_from_zero = |value: f64| if value.abs() < TINY { TINY } else { value };
    let mut c = 1.0;
    let mut d = 1.0 / away_from_zero(1.0 - (a + b) * x / (a + 1.0));
    let mut result = d;
    for m in 1..1000 {
        let m = f64::from(m);
        let even = m * (b - m) * x / ((a + 2.0 * m - 1.0) * (a + 2.0 * m));
        let odd = -(a + m) * (a + b + m) * x / ((a + 2.0 * m) * (a + 2.0 * m + 1.0));
        let mut change = 1.0;
        for term in [even, odd] {
            d = 1.0 / away_from_zero(1.0 + term * d);
            c = away_from_zero(1.0 + term / c);
            change = d * c;
            result *= change;
        }
        if (change - 1.0).abs() < 1e-15 {
            break;
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn is(probability: f64, freedom: f64, expected: f64) {
        let found = quantile(probability, freedom);
        assert!((found / expected - 1.0).abs() < 5e-9, "{probability}, {freedom}: {found}, expected {expected}");
    }

    #[test]
    fn what_is_reported_without_the_quantile_is_what_it_says() {
        let mut told = 0;
        for probability in [0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95, 0.999, 1.0 - 1e-9] {
            for freedom in (0..60).map(|k| 1.0 + f64::from(k * k) * 0.0618) {
                let exact = quantile(probability, freedom);
                for step in -40..=40_i32 {
                    let t = exact * libm::exp(f64::from(step) * f64::from(step.abs()) * 0.003);
                    if let Some(is_at_most) = is_at_most(t, probability, freedom) {
                        assert_eq!(is_at_most, exact <= t, "{probability}, {freedom}: {t}, {exact}");
                        told += 1;
                    } else {
                        assert_eq!(step, 0, "{probability}, {freedom}: {t}, {exact}");
                    }
                }
                for t in [0.0, 1e-300, 1e300, f64::INFINITY] {
                    assert_eq!(is_at_most(t, probability, freedom), Some(t > 1.0), "{probability}, {freedom}: {t}");
                }
            }
        }
        assert_eq!(is_at_most(1.0, 0.01, 3.0), None);
        assert!(told >= 9 * 60 * 80);
    }

    /// One degree of freedom is Cauchy's distribution: t = tan(πp/2); two: t = p·√(2/(1 − p²)).
    #[test]
    fn one_and_two_degrees_have_closed_forms() {
        for probability in [1e-6, 0.1, 0.5, 0.9, 0.95, 0.99, 0.999_999] {
            is(probability, 1.0, libm::tan(std::f64::consts::PI * probability / 2.0));
            is(probability, 2.0, probability * libm::sqrt(2.0 / ((1.0 - probability) * (1.0 + probability))));
        }
    }

    /// NIST/SEMATECH e-Handbook of Statistical Methods, table 1.3.6.7.2, three decimals.
    #[test]
    fn the_table_of_the_handbook() {
        for (probability, freedom, expected) in [
            (0.95, 3.0, 3.182),
            (0.95, 4.0, 2.776),
            (0.95, 7.0, 2.365),
            (0.95, 10.0, 2.228),
            (0.95, 30.0, 2.042),
            (0.95, 100.0, 1.984),
            (0.90, 5.0, 2.015),
            (0.99, 5.0, 4.032),
            (0.99, 15.0, 2.947),
            (0.998, 8.0, 4.501),
            (0.80, 12.0, 1.356),
        ] {
            let found = quantile(probability, freedom);
            assert!((found - expected).abs() <= 0.000_51, "{probability}, {freedom}: {found}, expected {expected}");
        }
    }

    /// With many degrees of freedom the distribution is the normal one.
    #[test]
    fn many_degrees_of_freedom() {
        let found = quantile(0.95, 1e6);
        assert!((found - 1.959_966_4).abs() < 1e-6, "{found}");
    }

    /// Integrating the density from −t to t gives the probability back, for degrees that no table has.
    #[test]
    fn what_is_no_whole_number() {
        for (probability, freedom) in [(0.95, 1.5), (0.9, 2.75), (0.5, 3.3), (0.99, 7.7), (0.3, 40.5)] {
            let t = quantile(probability, freedom);
            let log_scale = libm::lgamma((freedom + 1.0) / 2.0) - libm::lgamma(freedom / 2.0);
            let scale = libm::exp(log_scale) / libm::sqrt(freedom * std::f64::consts::PI);
            let density = |x: f64| scale * libm::pow(1.0 + x * x / freedom, -(freedom + 1.0) / 2.0);
            // Simpson's rule.
            let steps = 20_000;
            let step = t / f64::from(steps);
            let weight = |k: i32| if k == 0 || k == steps { 1.0 } else { 2.0 + 2.0 * f64::from(k % 2) };
            let inside: f64 = (0..=steps).map(|k| weight(k) * density(f64::from(k) * step)).sum::<f64>() * step / 3.0;
            assert!((2.0 * inside - probability).abs() < 1e-9, "{probability}, {freedom}: {}", 2.0 * inside);
        }
    }

    #[test]
    fn the_utmost_probabilities_have_finite_quantiles() {
        for (probability, freedom) in [(1.0 - f64::EPSILON / 2.0, 1.0), (f64::MIN_POSITIVE, 1.0), (0.95, 524_288.0)] {
            assert!(quantile(probability, freedom).is_finite(), "{probability}, {freedom}");
        }
    }
}
