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

/// The surfaces in the nearest place.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The first, which the ray hits.
    pub hit: Hit,
    /// All of them in the order of the scene, if there are several.
    #[expect(clippy::box_collection, reason = "a word instead of three")]
    pub all: Option<Box<Vec<Hit>>>,
}

impl Contenders {
    /// The nearer of two hits, of which there may be no other yet. If they are close to each other both contend.
    #[inline(always)]
    pub fn nearer<P: Probe>(&mut self, best: Option<Hit>, hit: Hit, ray: &Ray, probe: &P) -> Hit {
        let Some(best) = best else { return hit };
        if is_close(hit.crossing.t, best.crossing.t, ray, probe) {
            self.push(best);
            self.push(hit);
        }
        if hit.crossing.t < best.crossing.t { hit } else { best }
    }

    #[cold]
    #[inline(never)]
    fn push(&mut self, hit: Hit) {
        self.0.get_or_insert_default().push(hit);
    }

    /// What a ray hits whose nearest hit is this one. `shape` gives the shape of an object.
    #[inline(always)]
    pub fn place<'s, P: Probe>(self, hit: Hit, ray: &Ray, shape: impl Fn(u32) -> &'s Shape, probe: &P) -> Found {
        let Some(contenders) = self.0 else { return Found { hit, all: None } };
        let of_points = |t: f64| probe.slack(2.0 * (ray.origin.abs().element_sum() + t));
        settled(contenders, hit, ray, of_points, shape)
    }
}

/// Whether two distances are so close that the crossings may be in the same place.
#[inline(always)]
fn is_close<P: Probe>(t: f64, nearest: f64, ray: &Ray, probe: &P) -> bool {
    /// Far more than roundings, so that a ray that runs flat along two surfaces in the same place knows them for one: there
    /// their distances differ by more than the surfaces do.
    const CLOSE: f64 = 1.0 / (1 << 20) as f64;
    /// The same for arithmetics of few digits, in bounds of their roundings.
    const FLAT: f64 = 64.0;
    let size = nearest + ray.origin.abs().element_sum();
    (t - nearest).abs() <= CLOSE * size + FLAT * probe.slack(size)
}

/// The contenders that are in the same place as the nearest one. `of_points` bounds the roundings of a point of the ray at a distance.
#[cold]
#[inline(never)]
#[expect(clippy::box_collection, reason = "handed on as it is")]
fn settled<'s>(
    mut contenders: Box<Vec<Hit>>,
    nearest: Hit,
    ray: &Ray,
    of_points: impl Fn(f64) -> f64,
    shape: impl Fn(u32) -> &'s Shape,
) -> Found {
    // Of several at the same distance it is the one that was found first.
    let by_distance =
        |one: &Hit, other: &Hit| one.crossing.t.total_cmp(&other.crossing.t).then(one.rank().cmp(&other.rank()));
    let nearest = contenders
        .iter()
        .copied()
        .min_by(by_distance)
        .filter(|hit| hit.crossing.t <= nearest.crossing.t)
        .unwrap_or(nearest);
    let slope = |hit: &Hit| shape(hit.object).slope(ray, hit.crossing);
    let (its_slope, its_size) = (slope(&nearest), shape(nearest.object).size(nearest.crossing.primitive));
    let is_here = |hit: &Hit| {
        let shape = shape(hit.object);
        if hit.object == nearest.object && shape.are_neighbours(hit.crossing.primitive, nearest.crossing.primitive) {
            return false;
        }
        let gap = (hit.crossing.t - nearest.crossing.t) * its_slope.max(slope(hit));
        gap <= of_points(hit.crossing.t) + ROUNDINGS * (its_size + shape.size(hit.crossing.primitive))
    };
    contenders.retain(|hit| *hit != nearest && is_here(hit));
    contenders.push(nearest);
    contenders.sort_by_key(Hit::rank);
    contenders.dedup();
    let hit = contenders[0];
    Found { hit, all: (contenders.len() > 1).then_some(contenders) }
}
