//! Which of the crossings of a ray are in the same place.

use super::ray::{Crossing, Ray, Side};
use super::shape::Shape;
use crate::probe::{Probe, ROUNDINGS};

/// A crossing with an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The object, by its number in the scene.
    pub object: u32,
    /// Where the ray crosses its surface.
    pub crossing: Crossing,
}

impl Hit {
    /// What orders surfaces in the same place.
    pub fn rank(&self) -> (u32, u32) {
        (self.object, self.crossing.primitive)
    }
}

/// The nearest crossing of a ray so far, and the crossings that may be in the same place.
///
/// Crossings whose distances differ by less than rounding can tell are in the same place: there the first object in the scene
/// is the nearer one, then the lowest primitive (see [`Nearest::place`]).
// The others are a word, as there are hardly ever any.
#[derive(Clone, Debug)]
#[expect(clippy::box_collection, reason = "a word instead of three")]
pub struct Nearest {
    hit: Option<Hit>,
    limit: f64,
    others: Option<Box<Vec<Hit>>>,
}

impl Nearest {
    /// Nothing, and nowhere to look for it.
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

    /// How far a search must look: crossings a little beyond the nearest one count, too, as they may be in the same place.
    #[inline(always)]
    pub fn limit(&self) -> f64 {
        self.limit
    }

    /// Keeps the nearest crossing so far and another one, which is close to it. Called with what fits into registers: a crossing that was put in
    /// memory for this call would be taken from there on the way without it, too.
    #[cold]
    #[inline(never)]
    fn push(&mut self, object: u32, t: f64, side: Side, primitive: u32) {
        let hit = Hit { object, crossing: Crossing { t, side, primitive } };
        self.others.get_or_insert_default().extend(self.hit.into_iter().chain([hit]));
    }

    /// The surfaces in the same place as the nearest of all crossings, in the order of the scene: the first is the one that the ray hits.
    /// `shape` gives the shape of an object.
    pub fn place<'s, P: Probe>(self, ray: &Ray, shape: impl Fn(u32) -> &'s Shape, probe: &P) -> Vec<Hit> {
        let Some(nearest) = self.hit else { return Vec::new() };
        let Some(mut hits) = self.others.map(|hits| *hits) else { return vec![nearest] };
        // Of several at the same distance it is the one that was found first.
        hits.sort_by(|one, other| one.crossing.t.total_cmp(&other.crossing.t).then(one.rank().cmp(&other.rank())));
        let nearest = hits.first().copied().filter(|hit| hit.crossing.t <= nearest.crossing.t).unwrap_or(nearest);
        let slope = |hit: &Hit| shape(hit.object).slope(ray, hit.crossing);
        let size = |hit: &Hit| shape(hit.object).size(hit.crossing.primitive);
        let (its_slope, its_size) = (slope(&nearest), size(&nearest));
        // An edge or a corner is crossed once, on the triangle that is met first.
        let are_neighbours = |one: &Hit, other: &Hit| {
            let [one_part, other_part] = [one, other].map(|hit| hit.crossing.primitive);
            one.object == other.object && shape(one.object).are_neighbours(one_part, other_part)
        };
        let is_here = |hit: &Hit| {
            let gap = (hit.crossing.t - nearest.crossing.t) * its_slope.max(slope(hit));
            let points = 2.0 * (ray.origin.abs().element_sum() + hit.crossing.t);
            gap <= probe.slack(points) + ROUNDINGS * (its_size + size(hit))
        };
        let mut here = vec![nearest];
        for hit in hits.iter().filter(|hit| is_here(hit)) {
            if !here.iter().any(|kept| kept == hit || are_neighbours(kept, hit)) {
                here.push(*hit);
            }
        }
        here.sort_by_key(Hit::rank);
        here
    }
}

/// By how much the distances of crossings in the same place may differ.
#[inline(always)]
fn closeness<P: Probe>(nearest: f64, ray: &Ray, probe: &P) -> f64 {
    /// Far more than roundings, so that a ray that runs flat along two surfaces in the same place knows them for one: there
    /// their distances differ by more than the surfaces do.
    const CLOSE: f64 = 1.0 / (1 << 20) as f64;
    /// The same for arithmetics of few digits, in bounds of their roundings.
    const FLAT: f64 = 64.0;
    let size = nearest + ray.origin.abs().element_sum();
    CLOSE * size + FLAT * probe.slack(size)
}
