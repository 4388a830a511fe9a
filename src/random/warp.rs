//! Ways to bend the unit square, so that uniform points in it become uniform on something else. Each keeps strata together and
//! of equal probability.

use std::f64::consts::{FRAC_PI_4, PI};

/// A point of the unit disc: the concentric map (Shirley and Chiu, "A low distortion map between disk and square", 1997).
pub fn disc([x, y]: [f64; 2]) -> [f64; 2] {
    let (a, b) = (2.0 * x - 1.0, 2.0 * y - 1.0);
    // In each of the four wedges about the axes the angle from its axis is an eighth of the circle at most. Which axis it is no
    // processor can guess: it picks a place, not a branch.
    let along = usize::from(a.abs() <= b.abs());
    let radius = [a, b][along];
    if radius == 0.0 {
        return [0.0, 0.0];
    }
    let sine = sine_of_quarter([b, a][along] / radius);
    let mut point = [radius * sine; 2];
    point[along] = radius * (1.0 - sine * sine).sqrt();
    point
}

/// sin(π/4·x) for |x| ≤ 1: the first nine terms of its series about 0, of which the next is below 10⁻¹⁹. They are added in pairs, so that
/// few of the operations wait for another.
fn sine_of_quarter(x: f64) -> f64 {
    // (−1)ᵏ/(2k + 1)!, k from 1.
    const TERMS: [f64; 8] = [
        -1.0 / 6.0,
        1.0 / 120.0,
        -1.0 / 5_040.0,
        1.0 / 362_880.0,
        -1.0 / 39_916_800.0,
        1.0 / 6_227_020_800.0,
        -1.0 / 1_307_674_368_000.0,
        1.0 / 355_687_428_096_000.0,
    ];
    let angle = FRAC_PI_4 * x;
    let square = angle * angle;
    let fourth = square * square;
    let pair = |k: usize| TERMS[k] + TERMS[k + 1] * square;
    let sum = (pair(0) + pair(2) * fourth) + (pair(4) + pair(6) * fourth) * (fourth * fourth);
    angle + angle * square * sum
}

/// A point of the unit sphere: heights are uniform (Archimedes).
pub fn sphere([x, y]: [f64; 2]) -> [f64; 3] {
    let height = 1.0 - 2.0 * y;
    // √(1 − height²), which keeps its digits near the poles.
    let radius = (4.0 * y * (1.0 - y)).sqrt();
    let angle = 2.0 * PI * x;
    [radius * libm::cos(angle), radius * libm::sin(angle), height]
}

/// A direction of the lobe cosⁿ about z, n ≥ 0: its density by solid angle is (n + 1)/2π·cosⁿθ. Rows of the square are rings about
/// the axis, columns are sectors.
///
/// Outside the angle θ lies the part cosⁿ⁺¹θ of the lobe, so cos θ = (1 − y)^(1/(n + 1)); the sine is taken from the logarithm of its
/// square, since near the axis the cosine has lost it.
pub fn lobe(exponent: f64, [x, y]: [f64; 2]) -> [f64; 3] {
    let log_cosine = libm::log1p(-y) / (exponent + 1.0);
    let sine = (-libm::expm1(2.0 * log_cosine)).sqrt();
    let angle = 2.0 * PI * x;
    [sine * libm::cos(angle), sine * libm::sin(angle), libm::exp(log_cosine)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid(n: u32) -> impl Iterator<Item = [f64; 2]> {
        let at = move |k: u32| (f64::from(k) + 0.5) / f64::from(n);
        (0..n * n).map(move |k| [at(k % n), at(k / n)])
    }

    #[test]
    fn a_disc_is_filled_evenly() {
        let inside =
            |r: f64| grid(400).filter(|p| libm::hypot(disc(*p)[0], disc(*p)[1]) < r).count() as f64 / 160_000.0;
        for r in [0.1, 0.5, 0.9] {
            assert!((inside(r) - r * r).abs() < 2e-3, "{r}: {}", inside(r));
        }
        assert_eq!(disc([0.5, 0.5]), [0.0, 0.0]);
    }

    #[test]
    fn a_disc_has_the_sines_and_cosines_of_its_map() {
        for [x, y] in grid(301) {
            let (a, b) = (2.0 * x - 1.0, 2.0 * y - 1.0);
            let [radius, angle] =
                if a.abs() > b.abs() { [a, FRAC_PI_4 * b / a] } else { [b, 2.0 * FRAC_PI_4 - FRAC_PI_4 * a / b] };
            let right =
                if a == 0.0 && b == 0.0 { [0.0; 2] } else { [radius * libm::cos(angle), radius * libm::sin(angle)] };
            let off = [0, 1].map(|axis| (disc([x, y])[axis] - right[axis]).abs());
            assert!(off.iter().all(|off| *off < 4e-16), "{x} {y}: {off:?}");
        }
    }

    #[test]
    fn a_sphere_is_covered_evenly() {
        let mean = |of: &dyn Fn([f64; 3]) -> f64| grid(200).map(|p| of(sphere(p))).sum::<f64>() / 40_000.0;
        for axis in 0..3 {
            assert!(mean(&|p| p[axis]).abs() < 1e-9);
            assert!((mean(&|p| p[axis] * p[axis]) - 1.0 / 3.0).abs() < 1e-4);
        }
    }

    #[test]
    fn a_sharp_lobe_is_its_axis() {
        assert_eq!(lobe(f64::INFINITY, [0.3, 0.9]), [0.0, 0.0, 1.0]);
        let [x, y, z] = lobe(1e20, [0.3, 0.9]);
        assert!(z == 1.0 && libm::hypot(x, y) < 1e-9 && libm::hypot(x, y) > 0.0);
    }
}
