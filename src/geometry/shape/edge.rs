//! On which side of an edge a ray's line passes, with the right sign.
//!
//! The edge function is the triple product of the ray's direction with the edge's two ends as seen from its origin (Plücker's
//! side operator; Shoemake, Ray Tracing News 11, 1998). Exchanging the ends negates a cross product and its dot product bit
//! by bit, for rounding to nearest is the same above and below zero: an edge that two surfaces share gives exactly opposite
//! values in both. Where rounding leaves a sign in doubt the triple product is taken without error, so that the signs are
//! those of one line in all surfaces around a corner too. So no ray slips between two of them.

use crate::geometry::doubled::{Doubled3, exponent};
use crate::geometry::exact::triple_product;
use crate::geometry::ray::Ray;
use glam::DVec3;

/// A bound of the error of an edge function in squares of the greatest coordinate of the ends as seen from the origin. Each
/// of its six products of three numbers errs by at most seven roundings: two of differences, one of the direction, two of
/// products, and two of sums; together they are at most 2·(|d_x| + |d_y| + |d_z|) ≤ 2·√3 such squares. 6·3.5·2⁻⁵³·7/6 is
/// less than 14·2⁻⁵², and the rest is for what the roundings do to each other.
pub(super) const OF_EDGE: f64 = 16.0 * f64::EPSILON;

/// Below this the products of an edge function lose digits at the lower end of f64.
pub(super) const LEAST_SIZE: f64 = 1e-140;

/// d · (from × to)
#[inline]
pub(super) fn edge_function(direction: DVec3, from: DVec3, to: DVec3) -> f64 {
    direction.dot(from.cross(to))
}

/// The edges of an outline that a half plane crosses, and whether its signs had to be decided without error.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Crossings {
    /// How many.
    pub count: u32,
    /// Whether a sign was in doubt.
    pub in_doubt: bool,
}

/// A half plane that begins at a ray's line and depends on the ray alone. A line passes inside a closed outline if the half plane
/// crosses an odd number of its edges (Shimrat, 1962, seen along the ray).
///
/// An end lies above the line, or else below: an edge has its lower end and not its upper one. A line that meets an edge passes
/// left of it, whichever way round the edge is run. So no corner is counted twice, and of the surfaces around an edge or
/// a corner as many are met as the line would meet beside it.
pub(super) struct HalfPlane<'a> {
    ray: &'a Ray,
    /// The axis that the ray is least along.
    axis: DVec3,
    /// The heights above the line are measured along this.
    up: DVec3,
    /// Whether a sign in doubt is decided.
    certifies: bool,
}

/// An end of an edge, as seen from the ray's origin.
#[derive(Clone, Copy)]
struct End {
    corner: DVec3,
    seen: DVec3,
    /// The greatest coordinate.
    size: f64,
    is_above: bool,
}

impl<'a> HalfPlane<'a> {
    /// The half plane of a ray.
    #[inline]
    pub fn of(ray: &'a Ray, certifies: bool) -> HalfPlane<'a> {
        let size = ray.direction.abs();
        let axis = match size.min_element() {
            least if least == size.x => DVec3::X,
            least if least == size.y => DVec3::Y,
            _ => DVec3::Z,
        };
        HalfPlane { ray, axis, up: axis.cross(ray.direction), certifies }
    }

    /// Of the closed outline with these corners.
    #[inline]
    pub fn crossings(&self, corners: &[DVec3]) -> Crossings {
        let mut crossings = Crossings { count: 0, in_doubt: false };
        let Some(last) = corners.last() else { return crossings };
        let mut from = self.end(*last, &mut crossings.in_doubt);
        for corner in corners {
            let to = self.end(*corner, &mut crossings.in_doubt);
            crossings.count += u32::from(self.crosses(&from, &to, &mut crossings.in_doubt));
            from = to;
        }
        crossings
    }

    #[inline]
    fn end(&self, corner: DVec3, in_doubt: &mut bool) -> End {
        /// Each of the two products errs by four roundings: of a difference, of the direction, of the product and of the sum.
        const OF_HEIGHT: f64 = 6.0 * f64::EPSILON;
        let seen = corner - self.ray.origin;
        let size = seen.abs().max_element();
        let mut height = self.up.dot(seen);
        if self.certifies && !(height.abs() > OF_HEIGHT * size && size > LEAST_SIZE) {
            *in_doubt = true;
            height = exact(self.ray, [Doubled3::difference(corner, self.ray.origin), self.axis.into()]);
        }
        End { corner, seen, size, is_above: height > 0.0 }
    }

    #[inline]
    fn crosses(&self, from: &End, to: &End, in_doubt: &mut bool) -> bool {
        if from.is_above == to.is_above {
            return false;
        }
        let size = from.size.max(to.size);
        let mut area = edge_function(self.ray.direction, from.seen, to.seen);
        if self.certifies && !(area.abs() > OF_EDGE * size * size && size > LEAST_SIZE) {
            *in_doubt = true;
            area = exact(self.ray, [from.corner, to.corner].map(|end| Doubled3::difference(end, self.ray.origin)));
        }
        if to.is_above { area > 0.0 } else { area < 0.0 }
    }
}

/// The triple product of the ray's vector with two others, with its right sign.
#[cold]
#[inline(never)]
fn exact(ray: &Ray, factors: [Doubled3; 2]) -> f64 {
    // Powers of two keep the products in range.
    let [p, q] = factors.map(|factor| factor.scaled(-exponent(factor.size())));
    triple_product(ray.vector, p, q)
}
