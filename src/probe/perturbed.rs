//! The probe of CESTAC: every named quantity is moved by one ulp, up or down at random.

use super::position::{GOLDEN, Position, mixed, mixed_with};
use super::{Alteration, Quantity};
use crate::log::{Name, Step};

/// Moves every named quantity to one of its two neighbours among the f64 (Vignes 1993: random rounding). What differs
/// between runs of several seeds is what rounding makes of the result.
///
/// The choice is a hash of the seed, the place in the picture, the place in the tree and the component, so that neither
/// threads nor the crop change it. Zeros are exact and stay, and so do counts; inputs are never altered.
#[derive(Clone, Debug)]
pub struct Perturbed {
    seed: u64,
    places: Places,
    position: Position,
}

/// The places in the picture of a computation's samples, each a point of a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct Places {
    /// That of the first sample, or of the only one.
    pub first: [u32; 2],
    /// How many samples stand side by side; 0 is one.
    pub across: u32,
}

/// Whole numbers that f64 computes without rounding, and on which a decision rests that rounding can't touch.
const COUNTS: [Name; 4] = [Name::PatternAxes, Name::PatternCell, Name::PatternSum, Name::PatternParity];

impl Perturbed {
    /// Perturbs a computation of these places.
    pub fn new(seed: u64, places: Places) -> Perturbed {
        Perturbed { seed, places, position: Position::new(key_of(seed, places.first)) }
    }

    /// The seed of a further run of the same computation; run 0 has `seed` itself.
    pub fn seed_of_run(seed: u64, run: u64) -> u64 {
        if run == 0 { seed } else { mixed(seed.wrapping_add(run.wrapping_mul(GOLDEN))) }
    }
}

/// A sample has the same choices whether it is one of a pixel's or, as a corner that pixels share, traced alone.
fn key_of(seed: u64, [x, y]: [u32; 2]) -> u64 {
    mixed_with(mixed_with(mixed(seed), x.into()), y.into())
}

impl Places {
    /// The place of a sample, by its number from 1.
    fn of_sample(self, number: u32) -> [u32; 2] {
        let (index, across) = (number.saturating_sub(1), self.across.max(1));
        [self.first[0] + index % across, self.first[1] + index / across]
    }
}

impl Alteration for Perturbed {
    fn alter<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let key = self.position.next(name);
        if COUNTS.contains(&name) {
            return value;
        }
        value.map(|component, x| neighbour(x, mixed_with(key, component as u64) & 1 == 1))
    }

    fn enter(&mut self, step: Step) {
        match step {
            Step::Sample { number } => self.position.enter_at(key_of(self.seed, self.places.of_sample(number))),
            _ => self.position.enter(step),
        }
    }

    fn leave(&mut self) {
        self.position.leave();
    }
}

/// The next f64 above or below. A zero stays, and so does what has no finite neighbour there.
fn neighbour(x: f64, above: bool) -> f64 {
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
            assert_eq!(neighbour(0.0, above).to_bits(), 0.0_f64.to_bits());
            assert_eq!(neighbour(-0.0, above).to_bits(), (-0.0_f64).to_bits());
        }
        assert_eq!(neighbour(f64::MAX, true), f64::MAX);
        assert_eq!(neighbour(1.0, true), 1.0 + f64::EPSILON);
        assert_eq!(neighbour(1.0, false), 1.0 - f64::EPSILON / 2.0);
    }

    /// How many of the components of many quantities went up.
    fn ups(seed: u64) -> usize {
        let mut perturbed = Perturbed::new(seed, Places::default());
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
    fn a_sample_is_perturbed_by_its_place() {
        let throws =
            |perturbed: &mut Perturbed| -> Vec<f64> { (0..64).map(|_| perturbed.alter(Name::PlaneT, 1.0)).collect() };
        let mut pixel = Perturbed::new(5, Places { first: [20, 40], across: 3 });
        pixel.enter(Step::Sample { number: 6 });
        let mut corner = Perturbed::new(5, Places { first: [22, 41], across: 0 });
        assert_eq!(throws(&mut pixel), throws(&mut corner));
        let mut elsewhere = Perturbed::new(5, Places { first: [22, 42], across: 0 });
        let mut otherwise = Perturbed::new(6, Places { first: [22, 41], across: 0 });
        let expected = throws(&mut Perturbed::new(5, Places { first: [22, 41], across: 0 }));
        assert_ne!(throws(&mut elsewhere), expected);
        assert_ne!(throws(&mut otherwise), expected);
    }

    #[test]
    fn counts_stay() {
        let mut perturbed = Perturbed::new(0, Places::default());
        assert_eq!(perturbed.alter(Name::PatternSum, 8.0), 8.0);
    }
}
