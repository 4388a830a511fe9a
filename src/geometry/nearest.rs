//! Which of the crossings of a ray are in the same place.

use super::ray::{Crossing, Ray};
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

/// Crossings of a ray that may be in the same place as its nearest one, kept while that is searched for.
///
/// Crossings whose distances differ by less than rounding can tell are in the same place: there the first object in the scene
/// is the nearer one, then the lowest primitive (see [`Contenders::place`]).
// A word, as there are hardly ever any.
#[derive(Clone, Debug, Default)]
#[expect(clippy::box_collection, reason = "a word instead of three")]
pub struct Contenders(Option<Box<Vec<Hit>>>);

impl Contenders {
    /// Whether no other crossing is close to the nearest one.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.0.is_none()
    }

    /// Adds a hit and the nearest one so far, which are close to each other.
    #[cold]
    #[inline(never)]
    pub fn push(&mut self, nearest: Hit, hit: Hit) {
        self.0.get_or_insert_default().extend([nearest, hit]);
    }

    /// The surfaces in the same place as the nearest of all hits, in the order of the scene: the first is the one that the ray hits.
    /// `shape` gives the shape of an object.
    pub fn place<'s, P: Probe>(self, nearest: Hit, ray: &Ray, shape: impl Fn(u32) -> &'s Shape, probe: &P) -> Vec<Hit> {
        let Some(mut hits) = self.0.map(|hits| *hits) else { return vec![nearest] };
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

/// Whether two distances are so close that the crossings may be in the same place.
#[inline(always)]
pub fn is_close<P: Probe>(t: f64, nearest: f64, ray: &Ray, probe: &P) -> bool {
    (t - nearest).abs() <= closeness(nearest, ray, probe)
}

/// How far a search must look beyond the nearest distance so far: crossings that may be in the same place count, too.
#[inline(always)]
pub fn limit<P: Probe>(nearest: f64, ray: &Ray, probe: &P) -> f64 {
    (nearest + closeness(nearest, ray, probe)).min(ray.t_max)
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
