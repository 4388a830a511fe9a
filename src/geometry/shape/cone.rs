//! The cone, or the part of one between two circles: a quadratic equation for its lateral surface, cut off between two
//! planes.
//!
//! Its radius is ρ = r_b + k·z at the height z, so the surface is |p|² = ρ² with p across the axis, and a ray has ρ_o + ρ_d·t.
//! The discriminant b² − a·c is taken as |o'·ρ_d − d'·ρ_o|² − |o' × d'|² (Lagrange's identity with a minus sign for the axis),
//! which keeps its digits. b and c would cancel for a far origin, so a ray is computed from its point nearest to the base. The
//! equation knows both halves of the double cone; only the one with ρ ≥ 0 counts.

use super::axis::{APEX_CAP, AxialRay, Axis, BASE_CAP, End, LATERAL, Span};
use super::roots::{Quadratic, Roots};
use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::{Doubled, Doubled3, exponent, scaled};
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// A cone or frustum, open or with caps. Its front is the outside, unless it is `inward`.
#[derive(Clone, Debug, PartialEq)]
pub struct Cone {
    pub(super) axis: Axis,
    pub(super) base_radius: f64,
    pub(super) apex_radius: f64,
    /// What the radius gains per unit along the axis.
    slope: f64,
    has_caps: bool,
    /// The side that faces outward.
    outer: Side,
}

impl Cone {
    /// The cone between two circles, given by their centres, which differ, and radii, not both of which are 0; `inward`
    /// makes the inside its front.
    pub fn new(base: (DVec3, f64), apex: (DVec3, f64), caps: bool, inward: bool) -> Cone {
        let outer = if inward { Side::Back } else { Side::Front };
        let axis = Axis::new(base.0, apex.0);
        let slope = (apex.1 - base.1) / axis.length;
        Cone { axis, base_radius: base.1, apex_radius: apex.1, slope, has_caps: caps, outer }
    }

    /// The side on which the solid lies; open at its ends it is none.
    pub(super) fn solid_side(&self) -> Option<Side> {
        self.has_caps.then(|| self.outer.opposite())
    }

    /// Points whose convex hull holds it.
    pub fn corners(&self) -> [DVec3; 8] {
        self.axis.corners(self.base_radius, self.apex_radius)
    }

    #[inline]
    fn roots<P: Probe>(&self, whole: &Ray, probe: &mut P) -> Option<Roots> {
        let from_base = whole.origin - self.axis.base;
        let t_near = -probe.dot(from_base, whole.direction) / probe.dot(whole.direction, whole.direction);
        let t_near = probe.note(Name::ConeTNear, t_near);
        let origin = probe.note(Name::AxisOriginNear, from_base + whole.direction * t_near);
        let ray = self.axis.see(origin, whole, probe);
        let origin_radius = probe.note(Name::ConeOriginRadius, self.base_radius + self.slope * ray.origin_along);
        let ray_radius = probe.note(Name::ConeRayRadius, self.slope * ray.along);
        let a = probe.note(Name::ConeA, probe.dot(ray.across, ray.across) - ray_radius * ray_radius);
        let b = probe.note(Name::ConeB, probe.dot(ray.origin_across, ray.across) - origin_radius * ray_radius);
        let across = probe.dot(ray.origin_across, ray.origin_across);
        let c = probe.note(Name::ConeC, across - origin_radius * origin_radius);
        let lean = ray.origin_across * ray_radius - ray.across * origin_radius;
        let distance = ray.origin_across.cross(ray.across);
        let mut discriminant = probe.note(Name::ConeDiscriminant, lean.dot(lean) - distance.dot(distance));
        if probe.certifies() {
            let reach = from_base.length() * (1.0 + self.slope.abs()) + self.base_radius;
            let doubt = OF_DISCRIMINANT * reach;
            if discriminant.abs() <= doubt * (lean.length() + distance.length() + doubt) {
                probe.fallback();
                discriminant = probe.note(Name::ConeDiscriminantDoubled, self.doubled_discriminant(whole));
            }
        }
        let equation = Quadratic { a, b, c, discriminant };
        let inside = self.inside(equation, origin_radius, ray_radius, probe);
        let roots = inside.and_then(|lateral| {
            let ends = self.between_ends(&ray, probe)?;
            lateral.later_by(t_near).cut(ends.later_by(t_near), self.has_caps, self.outer)
        });
        if roots.is_none() {
            probe.mark(Decision::Miss { why: Miss::Beside });
        }
        roots
    }

    /// The discriminant with twice the digits.
    ///
    /// With the axis w from base to apex in its own length instead of a unit vector no root is left: o × w, v × w, |w|²·ρ and
    /// the discriminant times |w|⁶·|v|² are sums of products.
    #[cold]
    #[inline(never)]
    fn doubled_discriminant(&self, ray: &Ray) -> f64 {
        let axis = Doubled3::difference(self.axis.apex, self.axis.base);
        let axis_size = exponent(axis.size());
        let axis = axis.scaled(-axis_size);
        let origin = Doubled3::difference(ray.origin, self.axis.base);
        // Powers of two keep the products of lengths in range.
        let size = exponent(origin.size().max(self.base_radius).max(self.apex_radius));
        let origin = origin.scaled(-size);
        let vector = Doubled3::from(ray.vector);
        let squared = axis.dot(axis);
        let gain = Doubled::sum(self.apex_radius, -self.base_radius).scaled(-axis_size);
        let origin_radius = Doubled::from(scaled(self.base_radius, -size)) * squared + gain * origin.dot(axis);
        let ray_radius = gain * vector.dot(axis);
        let (origin_across, across) = (origin.cross(axis), vector.cross(axis));
        let lean = origin_across.times(ray_radius) - across.times(origin_radius);
        let distance = origin_across.cross(across);
        let discriminant = lean.dot(lean) - squared * distance.dot(distance);
        let unit = squared * squared * squared * vector.dot(vector);
        scaled(discriminant.quotient(unit), 2 * size)
    }

    /// The part of the line inside the half of the double cone where the radius isn't negative.
    #[inline]
    fn inside<P: Probe>(
        &self,
        equation: Quadratic,
        origin_radius: f64,
        ray_radius: f64,
        probe: &mut P,
    ) -> Option<Span> {
        let Quadratic { a, b, c, discriminant } = equation;
        // Only a line that is flatter than the cone can pass beside it: otherwise rounding made the discriminant negative.
        if a > 0.0 && discriminant < 0.0 {
            return None;
        }
        let line = Span::line(Name::ConeT1);
        let Some(roots) = equation.roots([Name::ConeT1, Name::ConeT2], probe) else {
            // Parallel to the axis of equal circles: all of the line is inside, or nothing.
            return (c <= 0.0).then_some(line);
        };
        let Span { start, end } = Span::between(roots);
        let (span, is_right_half) = if a > 0.0 {
            let radius = origin_radius + ray_radius * (start.t * 0.5 + end.t * 0.5);
            (Span { start, end }, radius >= 0.0)
        } else if a == 0.0 && b < 0.0 {
            // Parallel to a line of the cone, which it crosses once; the other root is infinite.
            (Span { start: finite(start, end), ..line }, ray_radius >= 0.0)
        } else if a == 0.0 {
            (Span { end: finite(start, end), ..line }, ray_radius <= 0.0)
        } else if ray_radius > 0.0 {
            // The line crosses both halves.
            (Span { start: end, ..line }, true)
        } else {
            (Span { end: start, ..line }, true)
        };
        is_right_half.then_some(span)
    }

    /// The part of the line between the two circles. A circle without radius, a tip, cuts nothing off.
    #[inline]
    fn between_ends<P: Probe>(&self, ray: &AxialRay, probe: &mut P) -> Option<Span> {
        let Span { start, end } = self.axis.between_ends(ray, [Name::ConeTBase, Name::ConeTApex], probe)?;
        let is_tip = |end: End| match end.primitive {
            BASE_CAP => self.base_radius == 0.0,
            APEX_CAP => self.apex_radius == 0.0,
            _ => false,
        };
        let line = Span::line(Name::ConeT1);
        Some(Span {
            start: if is_tip(start) { line.start } else { start },
            end: if is_tip(end) { line.end } else { end },
        })
    }
}

/// A bound of the errors of o'·ρ_d − d'·ρ_o and o' × d', whose squares the discriminant is made of, in parts of |o|·(1 + |k|) + r_b, o
/// the origin from the base. Of 2⁻⁵³, eight of |o| for o', four for d', twelve of |k|·|o| + r_b for ρ_o, six of |k| for ρ_d; in
/// all 34 and the product's own three. The squares err by twice that.
const OF_DISCRIMINANT: f64 = 40.0 * f64::EPSILON;

/// The one of two that isn't infinite.
#[inline]
fn finite(first: End, second: End) -> End {
    if first.t.is_finite() { first } else { second }
}

impl Kernel for Cone {
    fn give<P: Probe>(&self, probe: &mut P) {
        self.axis.give(probe);
        probe.given(Name::ConeBaseRadius, self.base_radius);
        probe.given(Name::ConeSlope, self.slope);
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

    /// Puts the point back onto the surface, from which rounding took it: along the normal, by its distance.
    #[inline]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let is_outer = crossing.side == self.outer;
        let at = self.axis.point(ray, crossing.t, probe);
        if crossing.primitive != LATERAL {
            return self.axis.cap(&at, crossing, is_outer, probe);
        }
        let distance = at.across.length();
        if distance == 0.0 {
            return self.axis.tip(ray, crossing, probe);
        }
        let offset = probe.note(Name::ConeOffset, distance - (self.base_radius + self.slope * at.along));
        let gradient = at.across / distance - self.axis.direction * self.slope;
        let gradient = probe.note(Name::ConeGradient, gradient);
        let step = gradient * (offset / probe.dot(gradient, gradient));
        let point = probe.note(Name::HitPointCone, self.axis.base + (at.from_base - step));
        let normal = if is_outer {
            probe.note(Name::HitNormalCone, gradient / gradient.length())
        } else {
            probe.note(Name::HitNormalConeBack, -gradient / gradient.length())
        };
        Surface::plain(point, normal, crossing.side)
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(self.axis.bounds(self.base_radius, self.apex_radius))
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        match crossing.primitive {
            LATERAL => Doubled::from(crossing.t),
            _ => self.axis.refined(ray, crossing),
        }
    }

    fn size(&self) -> f64 {
        self.axis.size(self.base_radius.max(self.apex_radius))
    }

    fn can_self_intersect(&self, sets_off: Side) -> bool {
        sets_off != self.outer
    }
}
