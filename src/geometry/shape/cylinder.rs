//! The cylinder: a quadratic equation for its lateral surface, cut off between two planes.
//!
//! By Lagrange's identity the discriminant b² − a·c is r²·|d'|² − |o' × d'|² (d' and o' the ray's direction and origin as
//! seen along the axis), where a far origin doesn't cancel.

use super::axis::{Axis, LATERAL, Span};
use super::doubled_chord::DoubledChord;
use super::roots::{Quadratic, Roots};
use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::{Doubled, Doubled3, exponent, length, scaled};
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// A cylinder, open or with caps. Its front is the outside, unless it is `inward`.
#[derive(Clone, Debug, PartialEq)]
pub struct Cylinder {
    pub(super) axis: Axis,
    pub(super) radius: f64,
    radius_squared: f64,
    has_caps: bool,
    /// The side that faces outward.
    outer: Side,
}

impl Cylinder {
    /// The cylinder between two different points, with a positive radius; `inward` makes the inside its front.
    pub fn new(base: DVec3, apex: DVec3, radius: f64, caps: bool, inward: bool) -> Cylinder {
        let outer = if inward { Side::Back } else { Side::Front };
        Cylinder { axis: Axis::new(base, apex), radius, radius_squared: radius * radius, has_caps: caps, outer }
    }

    /// The side on which the solid lies; open at its ends it is none.
    pub(super) fn solid_side(&self) -> Option<Side> {
        self.has_caps.then(|| self.outer.opposite())
    }

    /// Points whose convex hull holds it.
    pub fn corners(&self) -> [DVec3; 8] {
        self.axis.corners(self.radius, self.radius)
    }

    #[inline]
    fn roots<P: Probe>(&self, whole: &Ray, probe: &mut P) -> Option<Roots> {
        let origin = probe.note(Name::AxisOrigin, whole.origin - self.axis.base);
        let ray = self.axis.see(origin, whole, probe);
        let a = probe.note(Name::CylinderA, probe.dot(ray.across, ray.across));
        let c = probe.note(Name::CylinderC, probe.dot(ray.origin_across, ray.origin_across) - self.radius_squared);
        let lateral = if a == 0.0 {
            // Parallel to the axis: all of the line is inside, or nothing.
            (c <= 0.0 && self.has_caps).then(|| Span::line(Name::CylinderT1)).ok_or(Miss::Parallel)
        } else {
            let b = probe.note(Name::CylinderB, probe.dot(ray.origin_across, ray.across));
            let distance = ray.origin_across.cross(ray.across);
            let discriminant = self.radius_squared * a - distance.dot(distance);
            let discriminant = probe.note(Name::CylinderDiscriminant, discriminant);
            let equation = Quadratic { a, b, c, discriminant };
            let far = origin.dot(origin);
            let doubt = OF_DISCRIMINANT * a.sqrt() * (far + self.radius_squared);
            if discriminant.abs() <= doubt && probe.certifies() {
                self.doubled_span(whole, probe)
            } else {
                let names = [Name::CylinderT1, Name::CylinderT2];
                let roots = (discriminant >= 0.0).then(|| equation.roots(names, probe)).flatten();
                roots.map(Span::between).ok_or(Miss::Beside)
            }
        };
        let roots = lateral.and_then(|lateral| {
            let ends = self.axis.between_ends(&ray, [Name::CylinderTBase, Name::CylinderTApex], probe);
            ends.and_then(|ends| lateral.cut(ends, self.has_caps, self.outer)).ok_or(Miss::Beside)
        });
        roots.inspect_err(|why| probe.mark(Decision::Miss { why: *why })).ok()
    }

    /// The part of the line inside the lateral surface, with twice the digits.
    #[cold]
    #[inline(never)]
    fn doubled_span<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Result<Span, Miss> {
        probe.fallback();
        let chord = self.doubled_chord(ray).filter(|chord| !chord.is_beside).ok_or(Miss::Beside)?;
        let [near, far] = [chord.near, chord.far].map(Doubled::value);
        Ok(Span::between([(near, Name::CylinderTDoubled), (far, Name::CylinderTDoubledFar)]))
    }

    /// Seen along the axis w, of any length, the cylinder is a circle of the radius r·|w|, and the ray's vector v × w. `None` for a
    /// ray along the axis.
    fn doubled_chord(&self, ray: &Ray) -> Option<DoubledChord> {
        let axis = Doubled3::difference(self.axis.apex, self.axis.base);
        let axis = axis.scaled(-exponent(axis.size()));
        let to_base = Doubled3::difference(self.axis.base, ray.origin);
        // Powers of two keep the products of lengths in range.
        let size = exponent(to_base.size().max(self.radius));
        let center = to_base.scaled(-size).cross(axis);
        let vector = Doubled3::from(ray.vector).cross(axis);
        let radius = scaled(self.radius, -size);
        let radius_squared = Doubled::product(radius, radius) * axis.dot(axis);
        let c = center.dot(center) - radius_squared;
        (vector.size() > 0.0)
            .then(|| DoubledChord::in_sphere(center, vector, c, radius_squared, length(ray.vector)).scaled(size))
    }
}

/// A bound of the error of the discriminant in parts of √a·(|o|² + r²), o the origin from the base, √a the part of the direction that is
/// across the axis and errs by roundings of its whole. Of 2⁻⁵³, five for each component of the vectors across (one of the difference,
/// two of the product, one of the axis, one of the ray), so that their cross product errs by ten of |o|·|d'| and its square by twenty and
/// five for its own sum; r²·a by twelve.
const OF_DISCRIMINANT: f64 = 24.0 * f64::EPSILON;

impl Kernel for Cylinder {
    fn give<P: Probe>(&self, probe: &mut P) {
        self.axis.give(probe);
        probe.given(Name::CylinderRadius, self.radius);
        probe.given(Name::CylinderRadiusSquared, self.radius_squared);
    }

    #[inline]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        self.roots(ray, probe)?.first(ray, approach, |crossing| self.at_an_end(ray, approach, crossing), probe)
    }

    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        if let Some(roots) = self.roots(ray, probe) {
            roots.all(ray, approach, |crossing| self.at_an_end(ray, approach, crossing), found, probe);
        }
    }

    /// Puts the point back onto the surface, from which rounding took it.
    #[inline]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let is_outer = crossing.side == self.outer;
        let at = self.axis.point(ray, crossing.t, probe);
        if crossing.primitive != LATERAL {
            return self.axis.cap(&at, crossing, is_outer, probe);
        }
        let distance = at.across.length();
        if distance == 0.0 {
            // Arithmetic with few digits can round the radius away.
            return self.axis.tip(ray, crossing, probe);
        }
        let point = self.axis.base + self.axis.direction * at.along + at.across * (self.radius / distance);
        let point = probe.note(Name::HitPointCylinder, point);
        let normal = if is_outer {
            probe.note(Name::HitNormalCylinder, at.across / distance)
        } else {
            probe.note(Name::HitNormalCylinderBack, -at.across / distance)
        };
        Surface::plain(point, normal, crossing.side)
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(self.axis.bounds(self.radius, self.radius))
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        if crossing.primitive != LATERAL {
            return self.axis.refined(ray, crossing);
        }
        let Some(chord) = self.doubled_chord(ray) else { return Doubled::from(crossing.t) };
        if crossing.side == self.outer { chord.near } else { chord.far }
    }

    fn size(&self) -> f64 {
        self.axis.size(self.radius)
    }

    fn can_self_intersect(&self, sets_off: Side) -> bool {
        sets_off != self.outer
    }
}
