//! What cutoffs lost at most: an upper bound of what the bounces that they left out could have added.

use crate::log::Step;
use crate::scene::Color;
use crate::scene::ceiling::rounded_up;
use serde::Serialize;
use std::fmt;

/// Adds up the bounds of a picture's samples.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Losses {
    /// The sample so far, and above it the zones that the computation is inside.
    open: Vec<Part>,
    /// The bound of the decision that comes next.
    next: Option<Color>,
    /// Whether there was a cutoff at all.
    any: bool,
    /// Whether one has no bound.
    unbounded: bool,
    largest: Color,
    sum: Color,
}

/// A sample or a zone: bounds of what belongs to it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Part {
    /// All but the latest lobe's.
    settled: Color,
    /// Of the zones of the latest lobe the largest, which is no less than their mean.
    lobe: Color,
}

/// Upper bounds of what cutoffs lost; absent where there is no bound.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Lost {
    /// Of any pixel, per channel.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub largest: Option<[f64; 3]>,
    /// Of all pixels together.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sum: Option<[f64; 3]>,
}

impl Losses {
    /// The bound of the cutoff that is marked next.
    pub fn give(&mut self, bound: Color) {
        self.next = Some(bound);
    }

    /// A bounce was left out.
    pub fn cut_off(&mut self) {
        self.any = true;
        match (self.next.take(), self.open.last_mut()) {
            (Some(bound), Some(part)) => part.settled += bound,
            _ => self.unbounded = true,
        }
    }

    /// A sample or a zone begins.
    pub fn enter(&mut self, step: Step) {
        if let (Step::Zone { number: 1, .. }, Some(part)) = (step, self.open.last_mut()) {
            *part = Part { settled: part.settled + part.lobe, lobe: Color::ZERO };
        }
        self.open.push(Part::default());
    }

    /// The latest zone ends, or the sample.
    pub fn leave(&mut self) {
        let Some(Part { settled, lobe }) = self.open.pop() else { return };
        let whole = settled + lobe;
        match self.open.last_mut() {
            Some(around) => around.lobe = around.lobe.max(whole),
            None => {
                self.largest = self.largest.max(whole);
                self.sum += whole;
            }
        }
    }

    /// Adds what another part of the picture lost.
    pub fn add(&mut self, other: &Losses) {
        self.any |= other.any;
        self.unbounded |= other.unbounded;
        self.largest = self.largest.max(other.largest);
        self.sum += other.sum;
    }

    /// The bounds, if there was a cutoff. A pixel is a mean of samples, so that the largest of a sample holds for pixels too; over all
    /// pixels a sample counts for `share` at most.
    pub fn lost(&self, share: f64) -> Option<Lost> {
        let bound = |bound: Color| (!self.unbounded).then(|| rounded_up(bound).to_array());
        self.any.then(|| Lost { largest: bound(self.largest), sum: bound(self.sum * share) })
    }
}

impl fmt::Display for Lost {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let (Some(largest), Some(sum)) = (self.largest, self.sum) else {
            return write!(f, "lost by cutoffs: no bound, since a surface makes more of the light that passes");
        };
        // Away from zero, so that a bound stays one.
        let triple = |bound: [f64; 3]| {
            let [r, g, b] = bound.map(|x| (x * 1e6).ceil() / 1e6);
            format!("({r:.6}, {g:.6}, {b:.6})")
        };
        write!(f, "lost by cutoffs: at most {} in a pixel, {} in all", triple(largest), triple(sum))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::{RayKind, Term};

    const SAMPLE: Step = Step::Ray { kind: RayKind::Camera, depth: 0, split: 0 };

    fn zone(number: u32) -> Step {
        Step::Zone { what: Term::Reflected, number }
    }

    fn lose(losses: &mut Losses, bound: f64) {
        losses.give(Color::splat(bound));
        losses.cut_off();
    }

    #[track_caller]
    fn is_about(bound: Option<[f64; 3]>, expected: f64) {
        let [bound, ..] = bound.expect("a bound");
        assert!(expected <= bound && bound < expected * 1.00001, "{bound}");
    }

    #[test]
    fn samples_add_up_and_the_largest_is_kept() {
        let mut losses = Losses::default();
        for bounds in [&[1.0, 2.0][..], &[], &[0.5]] {
            losses.enter(SAMPLE);
            bounds.iter().for_each(|bound| lose(&mut losses, *bound));
            losses.leave();
        }
        let lost = losses.lost(0.25).expect("a loss");
        is_about(lost.largest, 3.0);
        is_about(lost.sum, 3.5 / 4.0);
    }

    #[test]
    fn of_the_zones_of_a_lobe_the_largest_counts() {
        let mut losses = Losses::default();
        losses.enter(SAMPLE);
        for lobe in [[1.0, 3.0], [4.0, 2.0]] {
            for (number, bound) in (1..).zip(lobe) {
                losses.enter(zone(number));
                lose(&mut losses, bound);
                losses.leave();
            }
        }
        lose(&mut losses, 10.0);
        losses.leave();
        is_about(losses.lost(1.0).expect("a loss").largest, 17.0);
    }

    #[test]
    fn without_a_cutoff_nothing_is_said_and_without_a_bound_that() {
        let mut losses = Losses::default();
        assert_eq!(losses.lost(1.0), None);
        losses.enter(SAMPLE);
        losses.cut_off();
        losses.leave();
        assert_eq!(losses.lost(1.0), Some(Lost::default()));
    }
}
