//! Single ray queries: what a ray meets, without any shading, at the time when the shutter opens.

use super::visibility::{closest_hit, is_any_hit};
use crate::geometry::ray::unit;
use crate::geometry::{Leaving, Ray, Side};
use crate::probe::Silent;
use crate::scene::Scene;
use glam::DVec3;

/// A question about one ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Query {
    /// Where the ray begins.
    pub origin: DVec3,
    /// Where it goes; of any length but zero, and `t` is in units of it.
    pub direction: DVec3,
    /// Hits lie beyond this distance.
    pub t_min: f64,
    /// Hits lie before this distance.
    pub t_max: f64,
    /// The object and the primitive that the ray leaves.
    pub from: Option<(u32, u32)>,
}

/// What a ray meets first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer {
    /// The object.
    pub object: u32,
    /// The triangle, for a mesh; else the part of the surface.
    pub primitive: u32,
    /// The distance, in units of the direction as given.
    pub t: f64,
    /// The point.
    pub point: DVec3,
    /// The geometric unit normal of the front.
    pub normal: DVec3,
    /// The side from which the ray arrives.
    pub side: Side,
}

/// More than the roundings of a distance that is brought from one unit to another and back.
const MARGIN: f64 = 4.0 * f64::EPSILON;

impl Query {
    /// What is wrong with the numbers of this query, if anything is.
    pub fn check(&self) -> Result<(), &'static str> {
        match () {
            _ if !self.origin.is_finite() => Err("o: expected finite numbers"),
            _ if !self.direction.is_finite() => Err("d: expected finite numbers"),
            _ if self.direction == DVec3::ZERO => Err("d: expected a direction that is not zero"),
            _ => Ok(()),
        }
    }

    /// The nearest hit.
    pub fn nearest(&self, scene: &Scene) -> Option<Answer> {
        let (mut ray, length) = self.ray(scene);
        let hit = loop {
            let hit = closest_hit(scene, &ray, &mut Silent)?;
            match hit.crossing.t / length {
                t if t <= self.t_min => ray.t_min = hit.crossing.t,
                t if t >= self.t_max => return None,
                _ => break hit,
            }
        };
        let surface = scene.objects[hit.object as usize].shape.surface(&ray, hit.crossing, &mut Silent);
        let normal = match surface.side {
            Side::Front => surface.geometric_normal(),
            Side::Back => -surface.geometric_normal(),
        };
        Some(Answer {
            object: hit.object,
            primitive: hit.crossing.primitive,
            t: hit.crossing.t / length,
            point: surface.point,
            // −0 turned over and back is +0.
            normal: normal + DVec3::ZERO,
            side: surface.side,
        })
    }

    /// Whether there is any hit.
    pub fn is_occluded(&self, scene: &Scene) -> bool {
        let is_bounded = self.t_min != 0.0 || self.t_max.is_finite();
        if is_bounded { self.nearest(scene).is_some() } else { is_any_hit(scene, &self.ray(scene).0, &mut Silent) }
    }

    /// The ray with a unit direction, and the length of the direction as given. Its ends are a little beyond those of the query, because
    /// they aren't in the same units: what counts is the distance in units of the direction as given.
    pub fn ray(&self, scene: &Scene) -> (Ray, f64) {
        let (direction, vector, length) = unit(self.direction);
        let leaving = self.from.map(|(object, primitive)| {
            let side = scene.objects[object as usize].shape.returning_side();
            Leaving { object, primitive, side }
        });
        let (t_min, t_max) = (self.t_min * length, self.t_max * length);
        let t_min = t_min - t_min.abs() * MARGIN;
        let t_max = if t_max.is_finite() { t_max + t_max.abs() * MARGIN } else { t_max };
        let time = scene.camera.opening();
        (Ray { vector, leaving, t_min, t_max, time, ..Ray::new(self.origin, direction) }, length)
    }
}
