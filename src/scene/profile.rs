//! How an area light's weight falls from its centre to its rim.

use crate::log::Name;
use crate::probe::Probe;
use std::f64::consts::FRAC_PI_2;

/// The weight ∝ cos^p(π/2·ρ) over a disk or a rectangle, ρ from 0 at the centre to 1 at the rim.
///
/// In both the part of the area within ρ is ρ². So a point that is uniform by area becomes one by area and weight when it is drawn
/// toward the centre from ρ₀ to the ρ within which the part ρ₀² of the weight lies: W(ρ) = ∫₀^ρ x·cos^p(π/2·x) dx over the same up to
/// 1. Shadow rays then count alike, and a light that nothing hides has no noise from its profile.
#[derive(Clone, Debug, PartialEq)]
pub struct CosineProfile {
    power: f64,
    /// How wide a cell of the table is.
    step: f64,
    /// W at the sides of the cells, the last of which is 1.
    within: Vec<f64>,
    /// The mean of cos^p(π/2·ρ) over the surface.
    mean: f64,
}

/// Cells of the table. In each the integral is right to 10⁻¹² of the whole.
const CELLS: usize = 256;

/// What lies beyond this many powers of e below the centre's weight is less than f64 can tell.
const FAINT: f64 = 40.0;

impl CosineProfile {
    /// The profile with a power above 0.
    pub fn new(power: f64) -> CosineProfile {
        // cos(π/2·ρ) ≤ exp(−(π/2·ρ)²/2): of a large power only the middle counts.
        let end = (2.0 * FAINT / power).sqrt() / FRAC_PI_2;
        let step = end.min(1.0) / CELLS as f64;
        let mut profile = CosineProfile { power, step, within: vec![0.0], mean: 1.0 };
        let mut sum = 0.0;
        for cell in 0..CELLS {
            sum += profile.part(cell as f64 * step, (cell + 1) as f64 * step);
            profile.within.push(sum);
        }
        profile.within.iter_mut().for_each(|within| *within /= sum);
        // Over the area, whose element is 2ρ·dρ.
        profile.mean = (2.0 * sum).max(f64::MIN_POSITIVE);
        profile
    }

    /// The mean over the surface of the profile before it is scaled, cos^p(π/2·ρ).
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// The weight of the point at ρ, whose mean by area is 1.
    pub fn weigh<P: Probe>(&self, rho: f64, probe: &mut P) -> f64 {
        let cosine = libm::cos(FRAC_PI_2 * rho).max(0.0);
        probe.given(Name::LightProfileCosine, cosine);
        probe.given(Name::LightProfilePower, self.power);
        probe.given(Name::LightProfileMean, self.mean);
        probe.note(Name::LightWeight, libm::pow(cosine, self.power) / self.mean)
    }

    /// x·cos^p(π/2·x). Near the centre the power is taken from the sine, where the cosine has lost the angle.
    fn density(&self, x: f64) -> f64 {
        let sine = libm::sin(FRAC_PI_2 * x);
        x * libm::exp(0.5 * self.power * libm::log1p(-(sine * sine)))
    }

    /// The integral of the density by Gauss's rule of three points.
    fn part(&self, from: f64, to: f64) -> f64 {
        const NODE: f64 = 0.774_596_669_241_483_4;
        let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
        let ends = self.density(middle - half * NODE) + self.density(middle + half * NODE);
        half * (5.0 * ends + 8.0 * self.density(middle)) / 9.0
    }

    /// How much nearer to the centre a point at ρ₀ comes, ρ/ρ₀.
    pub fn spread(&self, rho: f64) -> f64 {
        let wanted = rho * rho;
        let cell = self.within.partition_point(|within| *within <= wanted).clamp(1, CELLS) - 1;
        let [below, above] = [self.within[cell], self.within[cell + 1]];
        let from = cell as f64 * self.step;
        let whole = self.part(from, from + self.step);
        if rho == 0.0 || whole == 0.0 || above == below {
            return (from / rho.max(f64::MIN_POSITIVE)).min(1.0);
        }
        let part = (wanted - below) / (above - below);
        let wanted = part * whole;
        // Newton's method in a bracket, from where the answer would be if the weight were the same all over the cell.
        let end = from + self.step;
        let mut x = ((from * from + part * (end * end - from * from)).sqrt() - from).clamp(0.0, self.step);
        let mut bracket = [0.0, self.step];
        for _ in 0..MOST_STEPS {
            let above = self.part(from, from + x) - wanted;
            bracket[usize::from(above > 0.0)] = x;
            let newton = x - above / self.density(from + x);
            let next =
                if bracket[0] <= newton && newton <= bracket[1] { newton } else { (bracket[0] + bracket[1]) / 2.0 };
            let step = (next - x).abs();
            x = next;
            if step <= 1e-14 * self.step {
                break;
            }
        }
        (from + x) / rho
    }
}

/// Newton's method needs three or four; halvings of the bracket alone leave nothing that f64 can tell after fifty.
const MOST_STEPS: u32 = 50;

#[cfg(test)]
mod tests {
    use super::*;

    /// ∫₀^ρ x·cos²(π/2·x) dx = ρ²/4 + ρ·sin(πρ)/(2π) + (cos(πρ) − 1)/(2π²).
    #[test]
    fn the_square_of_the_cosine_has_a_closed_form() {
        let pi = std::f64::consts::PI;
        let within =
            |x: f64| x * x / 4.0 + x * libm::sin(pi * x) / (2.0 * pi) + (libm::cos(pi * x) - 1.0) / (2.0 * pi * pi);
        let profile = CosineProfile::new(2.0);
        for k in 1..100 {
            let rho = f64::from(k) / 100.0;
            let found = within(rho * profile.spread(rho)) / within(1.0);
            assert!((found - rho * rho).abs() < 1e-11, "{rho}: {found}");
        }
        assert!((profile.mean() - 2.0 * within(1.0)).abs() < 1e-12);
    }

    #[test]
    fn any_power_keeps_the_centre_and_the_order() {
        for power in [1e-300, 1e-3, 1.0, 30.0, 1e6, 1e100] {
            let profile = CosineProfile::new(power);
            let mut last = 0.0;
            for k in 0..=1000 {
                let rho = f64::from(k) / 1000.0;
                let moved = rho * profile.spread(rho);
                assert!(moved >= last && moved <= rho * (1.0 + 1e-9), "{power}, {rho}: {moved} after {last}");
                last = moved;
            }
        }
        assert!((CosineProfile::new(1e-9).spread(0.5) - 1.0).abs() < 1e-8);
    }
}
