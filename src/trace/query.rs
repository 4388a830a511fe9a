//! Single ray queries: what a ray meets, without any shading.

use super::visibility::{closest_hit, is_any_hit};
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
    fn ray(&self, scene: &Scene) -> (Ray, f64) {
        let (direction, length) = unit(self.direction);
        let leaving = self.from.map(|(object, primitive)| {
            let side = scene.objects[object as usize].shape.returning_side();
            Leaving { object, primitive, side }
        });
        let ray =
            Ray { origin: self.origin, direction, leaving, t_min: self.t_min * length, t_max: self.t_max * length };
        (ray, length)
    }
}

/// The unit vector along a vector, and its length. Scaling by a power of two, which is exact, keeps the squares of very
/// long and very short vectors in range.
fn unit(vector: DVec3) -> (DVec3, f64) {
    let largest = vector.abs().max_element();
    let exponent = if (1e-100..=1e100).contains(&largest) { 0 } else { libm::ilogb(largest) };
    let scaled = DVec3::from_array(vector.to_array().map(|x| libm::scalbn(x, -exponent)));
    let length = scaled.dot(scaled).sqrt();
    (scaled / length, libm::scalbn(length, exponent))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_vectors_of_any_length() {
        for exponent in [-1000, -300, 0, 300, 1000] {
            let scale = libm::scalbn(1.0, exponent);
            let (direction, length) = unit(DVec3::new(3.0, 0.0, 4.0) * scale);
            assert_eq!(direction, DVec3::new(0.6, 0.0, 0.8));
            assert_eq!(length, 5.0 * scale);
        }
    }
}
