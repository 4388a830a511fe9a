//! The cylinder: a quadratic equation for its lateral surface, cut off between two planes.
//!
//! By Lagrange's identity the discriminant b² − a·c is r²·|d'|² − |o' × d'|² (d' and o' the ray's direction and origin as
//! seen along the axis), where a far origin doesn't cancel.

use super::axis::{Axis, LATERAL, Span};
use super::roots::{Quadratic, Roots};
use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// A cylinder, open or with caps. Its front is the outside, unless it is `inward`.
#[derive(Clone, Debug, PartialEq)]
pub struct Cylinder {
    axis: Axis,
    radius: f64,
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

    #[inline]
    fn roots<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Option<Roots> {
        let origin = probe.note(Name::AxisOrigin, ray.origin - self.axis.base);
        let ray = self.axis.see(origin, ray, probe);
        let a = probe.note(Name::CylinderA, ray.across.dot(ray.across));
        let c = probe.note(Name::CylinderC, ray.origin_across.dot(ray.origin_across) - self.radius_squared);
        let lateral = if a == 0.0 {
            // Parallel to the axis: all of the line is inside, or nothing.
            (c <= 0.0 && self.has_caps).then(|| Span::line(Name::CylinderT1)).ok_or(Miss::Parallel)
        } else {
            let b = probe.note(Name::CylinderB, ray.origin_across.dot(ray.across));
            let distance = ray.origin_across.cross(ray.across);
            let discriminant = self.radius_squared * a - distance.dot(distance);
            let discriminant = probe.note(Name::CylinderDiscriminant, discriminant);
            let equation = Quadratic { a, b, c, discriminant };
            let names = [Name::CylinderT1, Name::CylinderT2];
            let roots = (discriminant >= 0.0).then(|| equation.roots(names, probe)).flatten();
            roots.map(Span::between).ok_or(Miss::Beside)
        };
        let roots = lateral.and_then(|lateral| {
            let ends = self.axis.between_ends(&ray, [Name::CylinderTBase, Name::CylinderTApex], probe);
            ends.and_then(|ends| lateral.cut(ends, self.has_caps, self.outer)).ok_or(Miss::Beside)
        });
        roots.inspect_err(|why| probe.mark(Decision::Miss { why: *why })).ok()
    }
}

impl Kernel for Cylinder {
    fn give<P: Probe>(&self, probe: &mut P) {
        self.axis.give(probe);
        probe.given(Name::CylinderRadius, self.radius);
        probe.given(Name::CylinderRadiusSquared, self.radius_squared);
    }

    #[inline]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        self.roots(ray, probe)?.first(ray, approach, probe)
    }

    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        if let Some(roots) = self.roots(ray, probe) {
            roots.all(ray, approach, found, probe);
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

    fn can_be_met_again(&self, sets_off: Side) -> bool {
        sets_off != self.outer
    }
}
