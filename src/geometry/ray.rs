//! A ray, and what it hits.

use super::unit::unit;
use crate::probe::{Probe, ROUNDINGS};
use glam::DVec3;

/// A half line from `origin` along `direction`; hits with `t_min < t < t_max` count.
///
/// Distances `t` are in units of the direction, which the tracer keeps at unit length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it begins.
    pub origin: DVec3,
    /// Where it goes.
    pub direction: DVec3,
    /// The direction without the rounding error of a unit length, where it is known: the vector that was normalised to
    /// `direction`, scaled by a power of two to a moderate size. Decisions that f64 leaves in doubt are taken with it.
    pub vector: DVec3,
    /// The surface that it leaves, which it can't hit again at its origin.
    pub leaving: Option<Leaving>,
    /// How far rounding may have moved the origin, in units of length: the ray begins on every surface so near, and doesn't
    /// cross it there. 0 for an origin that was given: it is exact.
    pub slack: f64,
    /// Hits lie beyond this distance.
    pub t_min: f64,
    /// Hits lie before this distance.
    pub t_max: f64,
    /// Whether the distance of a hit is asked for, or only whether there is one.
    pub wants_distance: bool,
    /// The time, which moving objects depend on.
    pub time: f64,
}

/// The surface that a ray leaves. There is no epsilon: a ray knows its own primitive instead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Leaving {
    /// The object, by its number in the scene.
    pub object: u32,
    /// Which part of it (see [`Crossing::primitive`]).
    pub primitive: u32,
    /// The side of the surface on which the ray sets off.
    pub side: Side,
}

impl Leaving {
    /// The primitive of a ray that leaves an unknown part of a closed shape: the part where the ray begins.
    pub const ANY_PRIMITIVE: u32 = u32::MAX;
}

/// A side of a surface: the front is where its outward normal points.
// As wide as its neighbours in crossings and hits: then these are copied as a whole, and not in overlapping pieces, which make the processor
// wait for the stores before them.
#[repr(u32)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The side of the outward normal.
    Front,
    /// The other side, the inside of a closed shape.
    Back,
}

/// A point of a ray where it crosses a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The distance along the ray, in units of its direction.
    pub t: f64,
    /// The side from which the ray arrives.
    pub side: Side,
    /// Which part of the surface: the triangle of a mesh, a face, a cap; else 0.
    pub primitive: u32,
}

/// A surface as the arriving ray sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// The point.
    pub point: DVec3,
    /// The unit normal that light is computed with, on the side of the arriving ray.
    pub normal: DVec3,
    /// The unit normal of the surface itself, on the side of the arriving ray, where `normal` is another one,
    /// interpolated.
    pub beneath: Option<DVec3>,
    /// The side from which the ray arrives.
    pub side: Side,
}

impl Surface {
    /// A surface whose normal isn't interpolated.
    pub fn plain(point: DVec3, normal: DVec3, side: Side) -> Surface {
        Surface { point, normal, beneath: None, side }
    }

    /// A surface with an interpolated normal and its own.
    pub fn interpolated(point: DVec3, normal: DVec3, geometric_normal: DVec3, side: Side) -> Surface {
        let beneath = (normal != geometric_normal).then_some(geometric_normal);
        Surface { point, normal, beneath, side }
    }

    /// The unit normal of the surface itself, on the side of the arriving ray.
    pub fn geometric_normal(&self) -> DVec3 {
        self.beneath.unwrap_or(self.normal)
    }
}

impl Ray {
    /// A ray at time 0 that leaves no surface and ends nowhere.
    pub fn new(origin: DVec3, direction: DVec3) -> Ray {
        Ray {
            origin,
            direction,
            vector: direction,
            leaving: None,
            slack: 0.0,
            t_min: 0.0,
            t_max: f64::INFINITY,
            wants_distance: true,
            time: 0.0,
        }
    }

    /// A ray along a vector of any length but zero.
    pub fn along(origin: DVec3, vector: DVec3) -> Ray {
        let (direction, vector, _) = unit(vector);
        Ray { vector, ..Ray::new(origin, direction) }
    }

    /// How far rounding may have moved a point that was found on this ray, in units of length. The point is off by the roundings of its
    /// distance, of the product and the sum, and of the surface that it was put back onto.
    pub fn slack_at<P: Probe>(&self, point: DVec3, probe: &P) -> f64 {
        probe.slack(2.0 * (self.origin.abs() + point.abs()).element_sum())
    }

    /// Whether a distance needs no more digits if half of them are right: it is certainly not that of a hit, or only a hit
    /// was asked for.
    #[inline]
    pub fn is_settled_by_half(&self, t: f64) -> bool {
        /// A few more than half of the digits of an f64.
        const HALF: f64 = 1.0 / (1 << 20) as f64;
        if t < 0.0 {
            return self.t_min >= 0.0;
        }
        let is_within = t > self.t_min * (1.0 + HALF) && t < self.t_max * (1.0 - HALF);
        t > self.t_max * (1.0 + HALF) || (is_within && !self.wants_distance)
    }

    /// Whether a crossing at this distance counts, but is so near to an end of the ray, its origin or the light, that it may be that end
    /// itself, seen at an angle that rounding can still tell from 0.
    #[inline(always)]
    pub(crate) fn is_near_an_end(&self, t: f64) -> bool {
        const FLATTEST: f64 = (1_u64 << 40) as f64;
        let near = FLATTEST * self.slack;
        self.reaches(t) && (t <= near || self.t_max - t <= near)
    }

    /// Whether an end of the ray may lie on a surface at this distance from it. `size` is that of the numbers that define the surface.
    pub(crate) fn holds(&self, distance: f64, size: f64) -> bool {
        self.slack > 0.0 && distance.abs() <= self.slack + ROUNDINGS * size
    }

    /// Whether a hit at this distance counts.
    #[inline]
    pub fn reaches(&self, t: f64) -> bool {
        self.t_min < t && t < self.t_max
    }
}

impl Side {
    /// The other side.
    pub fn opposite(self) -> Side {
        match self {
            Side::Front => Side::Back,
            Side::Back => Side::Front,
        }
    }
}
