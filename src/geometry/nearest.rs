//! The nearest crossing of a ray, while it is searched for.

use super::ray::{Crossing, Ray, Side};
use crate::probe::Probe;

/// A crossing with an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The object, by its number in the scene.
    pub object: u32,
    /// Where the ray crosses its surface.
    pub crossing: Crossing,
}

impl Hit {
    /// What orders coincident surfaces.
    pub fn rank(&self) -> (u32, u32) {
        (self.object, self.crossing.primitive)
    }
}

/// The nearest crossing of a ray so far, and the crossings that may coincide.
///
/// Crossings whose distances differ by less than rounding errors coincide: there the first object in the scene
/// is the nearer one, then the lowest primitive (see [`Nearest::place`]).
// The others take one word, as there are hardly ever any.
#[derive(Clone, Debug)]
#[expect(clippy::box_collection, reason = "a word instead of three")]
pub struct Nearest {
    pub(super) hit: Option<Hit>,
    limit: f64,
    pub(super) others: Option<Box<Vec<Hit>>>,
}

impl Nearest {
    /// No crossing, and an empty range of distances.
    pub const NONE: Nearest = Nearest { hit: None, limit: f64::NEG_INFINITY, others: None };

    /// Nothing so far.
    #[inline(always)]
    pub fn of(ray: &Ray) -> Nearest {
        Nearest { limit: ray.t_max, ..Nearest::NONE }
    }

    /// Takes a crossing into account.
    #[inline(always)]
    pub fn offer<P: Probe>(&mut self, object: u32, Crossing { t, side, primitive }: Crossing, ray: &Ray, probe: &P) {
        if let Some(Hit { crossing: Crossing { t: best, .. }, .. }) = self.hit {
            if t > self.limit {
                return;
            }
            if (t - best).abs() <= closeness(best, ray, probe) {
                self.push(object, t, side, primitive);
            }
            if t >= best {
                return;
            }
        }
        self.hit = Some(Hit { object, crossing: Crossing { t, side, primitive } });
        self.limit = (t + closeness(t, ray, probe)).min(ray.t_max);
    }

    /// Takes into account what a search found in an object's own frame, where distances are the same.
    pub fn join<P: Probe>(&mut self, found: Nearest, ray: &Ray, probe: &P) {
        let Some(Hit { object, crossing }) = found.hit else { return };
        if let Some(others) = found.others {
            self.others.get_or_insert_default().extend(*others);
        }
        self.offer(object, crossing, ray, probe);
    }

    /// The nearest crossing by its distance.
    #[inline(always)]
    pub fn hit(&self) -> Option<Hit> {
        self.hit
    }

    /// Whether no other crossing is close to the nearest one.
    #[inline(always)]
    pub fn is_alone(&self) -> bool {
        self.others.is_none()
    }

    /// How far a search must look: crossings a little beyond the nearest one count, too, as they may coincide.
    #[inline(always)]
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// Keeps the nearest crossing so far and another one, which is close to it. Its arguments fit into registers: a crossing that was put in
    /// memory for this call would be taken from there on the way without it, too.
    #[cold]
    #[inline(never)]
    fn push(&mut self, object: u32, t: f64, side: Side, primitive: u32) {
        let hit = Hit { object, crossing: Crossing { t, side, primitive } };
        self.others.get_or_insert_default().extend(self.hit.into_iter().chain([hit]));
    }
}

/// By how much the distances of coincident crossings may differ.
#[inline(always)]
fn closeness<P: Probe>(nearest: f64, ray: &Ray, probe: &P) -> f64 {
    /// Far more than roundings, so that a ray at a grazing angle to two coincident surfaces sees them as one: there
    /// their distances differ by more than the surfaces do.
    const CLOSE: f64 = 1.0 / (1 << 20) as f64;
    /// The same for arithmetics of few digits, in bounds of their roundings.
    const FLAT: f64 = 64.0;
    let size = nearest + ray.origin.abs().element_sum();
    CLOSE * size + FLAT * probe.slack(size)
}
