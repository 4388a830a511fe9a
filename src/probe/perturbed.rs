//! The probe of CESTAC: every named quantity is moved by one ulp, up or down at random.

use super::position::{Position, mixed_with};
use super::{Alteration, Quantity, ROUNDINGS};
use crate::log::{Name, Step};
use crate::random::{GOLDEN, mix};

/// Moves every named quantity to one of its two neighbours among the f64 (Vignes 1993: random rounding). What differs
/// between runs of several seeds is what rounding makes of the result.
///
/// The choice is a hash of the seed, the place in the picture, the place in the tree and the component, so that neither
/// threads nor the crop change it. Zeros are exact and stay, and so do counts; inputs are never altered.
#[derive(Clone, Debug)]
pub struct Perturbed {
    seed: u64,
    position: Position,
}

/// Whole numbers that f64 computes without rounding, and on which a decision rests that rounding can't touch.
const COUNTS: [Name; 4] = [Name::PatternAxes, Name::PatternCell, Name::PatternSum, Name::PatternParity];

impl Perturbed {
    /// Perturbs the computation of this pixel.
    pub fn new(seed: u64, pixel: [u32; 2]) -> Perturbed {
        Perturbed { seed, position: Position::new(key_of(seed, pixel.map(u64::from))) }
    }

    /// The seed of a further run of the same computation; run 0 has `seed` itself.
    pub fn seed_of_run(seed: u64, run: u64) -> u64 {
        if run == 0 { seed } else { mix(seed.wrapping_add(run.wrapping_mul(GOLDEN))) }
    }
}

fn key_of(seed: u64, [x, y]: [u64; 2]) -> u64 {
    mixed_with(mixed_with(mix(seed), x), y)
}

impl Alteration for Perturbed {
    fn alter<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let key = self.position.next(name);
        if COUNTS.contains(&name) {
            return value;
        }
        value.map(|component, x| neighbor(x, mixed_with(key, component as u64) & 1 == 1))
    }

    /// An ulp up or down is twice the error of rounding to the nearest.
    fn slack(&self, size: f64) -> f64 {
        2.0 * ROUNDINGS * size
    }

    fn enter(&mut self, step: Step) {
        self.position.enter(step);
    }

    /// A ray has the same choices whether its sample is one of a pixel's or, as a corner that pixels share, traced alone.
    fn aim(&mut self, place: [f64; 2]) {
        self.position.enter_at(key_of(self.seed, place.map(f64::to_bits)));
    }

    fn aimed(&mut self) {
        self.position.leave();
    }

    fn leave(&mut self) {
        self.position.leave();
    }
}

/// The next f64 above or below. A zero stays, and so does what has no finite neighbour there.
fn neighbor(x: f64, above: bool) -> f64 {
    let moved = if above { x.next_up() } else { x.next_down() };
    if x == 0.0 || !moved.is_finite() { x } else { moved }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn zeros_and_the_greatest_numbers_stay() {
        for above in [false, true] {
            assert_eq!(neighbor(0.0, above).to_bits(), 0.0_f64.to_bits());
            assert_eq!(neighbor(-0.0, above).to_bits(), (-0.0_f64).to_bits());
        }
        assert_eq!(neighbor(f64::MAX, true), f64::MAX);
        assert_eq!(neighbor(1.0, true), 1.0 + f64::EPSILON);
        assert_eq!(neighbor(1.0, false), 1.0 - f64::EPSILON / 2.0);
    }

    /// How many of the components of many quantities went up.
    fn ups(seed: u64) -> usize {
        let mut perturbed = Perturbed::new(seed, [0, 0]);
        let altered = (0..1000).map(|_| perturbed.alter(Name::HitPoint, DVec3::splat(3.0)).to_array());
        altered.flatten().inspect(|x| assert!((x - 3.0).abs() == 2.0 * f64::EPSILON)).filter(|x| *x > 3.0).count()
    }

    #[test]
    fn every_component_moves_by_an_ulp_either_way() {
        // 3000 throws: the mean is 1500, the standard deviation 27.
        for seed in [0, 1, u64::MAX] {
            assert!((1360..1640).contains(&ups(seed)), "seed {seed}: {}", ups(seed));
        }
    }

    #[test]
    fn a_ray_is_perturbed_by_its_place() {
        let throws = |mut perturbed: Perturbed, place: [f64; 2]| -> Vec<f64> {
            perturbed.aim(place);
            let thrown = (0..64).map(|_| perturbed.alter(Name::PlaneT, 1.0)).collect();
            perturbed.aimed();
            thrown
        };
        let mut in_sample = Perturbed::new(5, [20, 40]);
        in_sample.enter(Step::Sample { number: 6 });
        let expected = throws(Perturbed::new(5, [21, 40]), [21.0, 40.5]);
        assert_eq!(throws(in_sample, [21.0, 40.5]), expected);
        assert_ne!(throws(Perturbed::new(5, [21, 40]), [21.0, 41.0]), expected);
        assert_ne!(throws(Perturbed::new(6, [21, 40]), [21.0, 40.5]), expected);
    }

    #[test]
    fn counts_stay() {
        let mut perturbed = Perturbed::new(0, [0, 0]);
        assert_eq!(perturbed.alter(Name::PatternSum, 8.0), 8.0);
    }
}
