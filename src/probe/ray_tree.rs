//! The probe that distinguishes ray trees.

use super::position::{mixed_with, words};
use super::{Probe, Quantity, forward};
use crate::log::{Decision, Name, Step};

/// A digest of what is traced, decided and computed in which order, whatever the values are; values and events go on to `probe`.
///
/// What happens inside intersection tests isn't part of it: which objects are tested, and why one is missed, changes
/// nothing by itself. What the tests come to is: the nearest object, the background, what blocks the light.
#[derive(Clone, Debug, Default)]
pub struct RayTree<P> {
    /// Who sees the computation too.
    pub probe: P,
    digest: u64,
    /// How many of the open nodes are tests or lie in one.
    tests: u32,
}

impl<P> RayTree<P> {
    /// Before the computation.
    pub fn before(probe: P) -> RayTree<P> {
        RayTree { probe, digest: 0, tests: 0 }
    }

    /// Equal for equal ray trees, and for different ones by a chance of 2⁻⁶⁴.
    pub fn digest(&self) -> u64 {
        self.digest
    }

    fn take(&mut self, words: impl IntoIterator<Item = u64>) {
        if self.tests == 0 {
            self.digest = words.into_iter().fold(self.digest, mixed_with);
        }
    }
}

impl<P: Probe> Probe for RayTree<P> {
    forward!(self => Probe of self.probe; given bounds_tested rays_saved certifies slack decimals_of_products fallback);

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        self.take([20, name as u64]);
        self.probe.note(name, value)
    }

    fn mark(&mut self, decision: Decision) {
        self.take(words_of(decision));
        self.probe.mark(decision);
    }

    fn enter(&mut self, step: Step) {
        if self.tests > 0 || matches!(step, Step::Test { .. } | Step::Motion { .. }) {
            self.tests += 1;
        }
        self.take(words(step));
        self.probe.enter(step);
    }

    fn leave(&mut self) {
        self.take([21]);
        self.tests = self.tests.saturating_sub(1);
        self.probe.leave();
    }
}

/// Above the numbers of steps and of what else a digest is made of.
const DECISIONS: u64 = 64;

/// A decision as numbers, less what it doesn't decide: see [`is_same`].
fn words_of(decision: Decision) -> [u64; 3] {
    let [one, other] = match decision {
        Decision::Hit
        | Decision::Outside
        | Decision::Inside
        | Decision::Background
        | Decision::Free
        | Decision::Occluded { .. }
        | Decision::TotalInternalReflection => [0, 0],
        Decision::Miss { why } => [why as u64, 0],
        Decision::Nearest { object } | Decision::Immersed { object } | Decision::Attenuated { object, .. } => {
            [object.into(), 0]
        }
        Decision::Coincident { object, triangle } => {
            [object.into(), triangle.map_or(0, |number| u64::from(number) + 1)]
        }
        Decision::Undefined { quantity } => [quantity as u64, 0],
        Decision::Bent { what }
        | Decision::DepthLimit { what }
        | Decision::LeakGuard { what }
        | Decision::Rejected { what } => [what as u64, 0],
        Decision::Skipped { what, why } => [what as u64, why as u64],
        Decision::Subdivided { cell, why, .. } => [word_of(cell), why as u64],
        Decision::Accepted { cell, why } => [cell.map_or(0, word_of), why as u64],
        Decision::Asked { light, why, points, .. } => [u64::from(light) << 32 | u64::from(points), why as u64],
        Decision::MoreSamples { from, to } => [from.into(), to.into()],
    };
    [DECISIONS + decision.number(), one, other]
}

/// A cell as a number: its sides are fractions of a pixel with few digits, so that no two have the same.
fn word_of(cell: [f64; 3]) -> u64 {
    let [left, top, side] = cell.map(f64::to_bits);
    left ^ top.rotate_left(21) ^ side.rotate_left(42)
}

/// Whether two decisions are the same. Which of several opaque objects blocks the light first depends on the order of the
/// tests, and decides nothing; a factor is a value.
pub fn is_same(one: Decision, other: Decision) -> bool {
    words_of(one) == words_of(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probe::Silent;

    fn digest(run: impl FnOnce(&mut RayTree<Silent>)) -> u64 {
        let mut tree = RayTree::before(Silent);
        run(&mut tree);
        tree.digest()
    }

    fn test(tree: &mut RayTree<Silent>, decision: Decision) {
        tree.within(Step::Test { object: 3, triangle: None }, |tree| {
            tree.note(Name::PlaneT, 1.0);
            tree.mark(decision);
        });
    }

    #[test]
    fn what_is_nearest_counts_and_how_it_was_found_does_not() {
        let nearest = |object| Decision::Nearest { object };
        let plain = digest(|tree| tree.mark(nearest(1)));
        assert_ne!(plain, digest(|tree| tree.mark(nearest(2))));
        let tested = digest(|tree| {
            test(tree, Decision::Hit);
            tree.mark(nearest(1));
        });
        assert_eq!(plain, tested);
    }

    #[test]
    fn values_do_not_count_and_names_do() {
        let noted = |name, x: f64| digest(|tree| _ = tree.note(name, x));
        assert_eq!(noted(Name::PlaneT, 1.0), noted(Name::PlaneT, 2.0));
        assert_ne!(noted(Name::PlaneT, 1.0), noted(Name::SphereT, 1.0));
    }
}
