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
        let (ray, length) = self.ray(scene);
        let hit = closest_hit(scene, &ray, &mut Silent)?;
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
        is_any_hit(scene, &self.ray(scene).0, &mut Silent)
    }

    /// The ray with a unit direction, and the length of the direction as given.
    pub fn ray(&self, scene: &Scene) -> (Ray, f64) {
        let (direction, vector, length) = unit(self.direction);
        let leaving = self.from.map(|(object, primitive)| {
            let side = scene.objects[object as usize].shape.returning_side();
            Leaving { object, primitive, side }
        });
        let (t_min, t_max) = (self.t_min * length, self.t_max * length);
        let time = scene.camera.opening();
        (Ray { vector, leaving, t_min, t_max, time, ..Ray::new(self.origin, direction) }, length)
    }
}
