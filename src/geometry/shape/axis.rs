//! What cylinder and cone share: an axis with an end at either side, and the slab between the ends.

use super::flat::refined;
use super::roots::{Root, Roots, noted};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::Name;
use crate::probe::Probe;
use glam::DVec3;

/// The axis of a solid of revolution that is cut off flat at both ends.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    pub base: DVec3,
    pub apex: DVec3,
    /// The unit vector from the base to the apex.
    pub direction: DVec3,
    pub length: f64,
}

/// A ray as the axis sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxialRay {
    /// How far along the axis the origin lies, from the base.
    pub origin_along: f64,
    /// What the ray gains along the axis per unit of t.
    pub along: f64,
    /// Origin and direction seen along the axis: their components across it, turned by a right angle. A cross product is
    /// exactly zero for a parallel ray, and what it loses doesn't point along the axis.
    pub origin_across: DVec3,
    pub across: DVec3,
}

/// A point of the surface as the axis sees it.
#[derive(Clone, Copy, Debug)]
pub(super) struct AxialPoint {
    /// The point, from the base.
    pub from_base: DVec3,
    /// How far along the axis it lies.
    pub along: f64,
    /// Its component across the axis.
    pub across: DVec3,
}

/// A part of a line, between two of its distances.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub start: End,
    pub end: End,
}

/// An end of a [`Span`]: the distance, the part of the surface, the name of the distance when it is chosen.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    pub t: f64,
    pub primitive: u32,
    pub name: Name,
}

/// The lateral surface.
pub(super) const LATERAL: u32 = 0;
/// The flat cap at the base.
pub(super) const BASE_CAP: u32 = 1;
/// The flat cap at the apex.
pub(super) const APEX_CAP: u32 = 2;

impl Axis {
    /// The axis between two different points.
    pub fn new(base: DVec3, apex: DVec3) -> Axis {
        let along = apex - base;
        let length = along.length();
        Axis { base, apex, direction: along / length, length }
    }

    pub fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::AxisBase, self.base);
        probe.given(Name::AxisApex, self.apex);
        probe.given(Name::AxisDirection, self.direction);
        probe.given(Name::AxisLength, self.length);
    }

    /// The ray from `origin`, a point of it seen from the base.
    #[inline]
    pub fn see<P: Probe>(&self, origin: DVec3, ray: &Ray, probe: &mut P) -> AxialRay {
        AxialRay {
            origin_along: probe.note(Name::AxisOriginAlong, probe.dot(origin, self.direction)),
            along: probe.note(Name::AxisRayAlong, probe.dot(ray.direction, self.direction)),
            origin_across: probe.note(Name::AxisOriginAcross, origin.cross(self.direction)),
            across: probe.note(Name::AxisRayAcross, ray.direction.cross(self.direction)),
        }
    }

    /// The part of the line between the planes of the two ends; `None` if it runs beside them. `names` are those of the
    /// distances to the base and to the apex.
    #[inline]
    pub fn between_ends<P: Probe>(&self, ray: &AxialRay, names: [Name; 2], probe: &mut P) -> Option<Span> {
        let end = |t, primitive, name| End { t, primitive, name };
        let [base_name, apex_name] = names;
        if ray.along == 0.0 {
            let is_between = 0.0 <= ray.origin_along && ray.origin_along <= self.length;
            return is_between.then(|| Span::line(base_name));
        }
        let t_base = noted(Name::AxisTBase, -ray.origin_along / ray.along, probe);
        let t_apex = noted(Name::AxisTApex, (self.length - ray.origin_along) / ray.along, probe);
        let (base, apex) = (end(t_base, BASE_CAP, base_name), end(t_apex, APEX_CAP, apex_name));
        Some(if ray.along > 0.0 { Span { start: base, end: apex } } else { Span { start: apex, end: base } })
    }

    /// The distance to the plane of a cap with twice the digits.
    pub fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        let corner = if crossing.primitive == APEX_CAP { self.apex } else { self.base };
        refined(ray, self.apex - self.base, corner)
    }

    #[inline]
    pub fn point<P: Probe>(&self, ray: &Ray, t: f64, probe: &mut P) -> AxialPoint {
        let from_base = probe.note(Name::AxisPoint, ray.origin - self.base + ray.direction * t);
        let along = probe.note(Name::AxisPointAlong, probe.dot(from_base, self.direction));
        let across = probe.note(Name::AxisPointAcross, from_base - self.direction * along);
        AxialPoint { from_base, along, across }
    }

    /// The surface of a cap. The point is put back onto its plane. `is_outer` tells the side that faces out of the solid.
    #[inline]
    pub fn cap<P: Probe>(&self, point: &AxialPoint, crossing: Crossing, is_outer: bool, probe: &mut P) -> Surface {
        let is_apex = crossing.primitive == APEX_CAP;
        let point = if is_apex {
            probe.note(Name::HitPointApexCap, self.apex + point.across)
        } else {
            probe.note(Name::HitPointBaseCap, self.base + point.across)
        };
        Surface::plain(point, self.normal(is_apex == is_outer, probe), crossing.side)
    }

    /// The surface at a point on the axis itself, the tip of a cone, where it has no tangent plane.
    pub fn tip<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
        let normal = self.normal(ray.direction.dot(self.direction) < 0.0, probe);
        Surface::plain(point, normal, crossing.side)
    }

    #[inline]
    fn normal<P: Probe>(&self, is_along: bool, probe: &mut P) -> DVec3 {
        if is_along {
            probe.note(Name::HitNormalAlongAxis, self.direction)
        } else {
            probe.note(Name::HitNormalAgainstAxis, -self.direction)
        }
    }

    /// The box around the disks at the two ends. A disk reaches radius·√(1 − wᵢ²) from its centre along an axis of space.
    pub fn bounds(&self, base_radius: f64, apex_radius: f64) -> Bounds {
        let square = self.direction * self.direction;
        let reach =
            DVec3::new((square.y + square.z).sqrt(), (square.z + square.x).sqrt(), (square.x + square.y).sqrt());
        let disk = |center: DVec3, radius: f64| Bounds { min: center - reach * radius, max: center + reach * radius };
        disk(self.base, base_radius).union(disk(self.apex, apex_radius))
    }

    /// The size of the numbers that define the solid with this greatest radius. Roundings of the ends turn a short axis, and that
    /// moves a wide cap by more than themselves.
    pub fn size(&self, radius: f64) -> f64 {
        let ends = self.base.abs().max(self.apex.abs()).max_element();
        ends * (1.0 + radius / self.length) + radius
    }

    /// The corners of the squares around the circles at both ends.
    pub fn corners(&self, base_radius: f64, apex_radius: f64) -> [DVec3; 8] {
        let across = self.direction.any_orthonormal_vector();
        let other = self.direction.cross(across);
        let square = |center: DVec3, radius: f64| {
            [across + other, across - other, other - across, -across - other].map(|corner| center + corner * radius)
        };
        let ([a, b, c, d], [e, f, g, h]) = (square(self.base, base_radius), square(self.apex, apex_radius));
        [a, b, c, d, e, f, g, h]
    }
}

impl Span {
    /// The whole line. Its ends are never chosen, whatever they are called.
    pub fn line(name: Name) -> Span {
        let end = |t| End { t, primitive: LATERAL, name };
        Span { start: end(f64::NEG_INFINITY), end: end(f64::INFINITY) }
    }

    /// The part between two crossings of the lateral surface, in any order.
    #[inline]
    pub fn between([first, second]: [(f64, Name); 2]) -> Span {
        let end = |(t, name)| End { t, primitive: LATERAL, name };
        let (start, stop) = if first.0 < second.0 { (first, second) } else { (second, first) };
        Span { start: end(start), end: end(stop) }
    }

    /// The same part, if distances begin so much later.
    #[inline]
    pub fn later_by(self, t: f64) -> Span {
        let later = |end: End| End { t: t + end.t, ..end };
        Span { start: later(self.start), end: later(self.end) }
    }

    /// The roots of the surface whose lateral part, had it no ends, would cut this span out of the line. With caps they are
    /// those of the solid; without, each must lie between the ends. `None` if the line passes beside.
    #[inline]
    pub fn cut(self, between_ends: Span, has_caps: bool, outer: Side) -> Option<Roots> {
        let (first, last) = (between_ends.start, between_ends.end);
        let root = |End { t, primitive, name }: End, is_on_surface| Root { t, primitive, is_on_surface, name };
        if !has_caps {
            let is_on_surface = |end: End| end.t.is_finite() && first.t <= end.t && end.t <= last.t;
            let (entry, exit) = (root(self.start, is_on_surface(self.start)), root(self.end, is_on_surface(self.end)));
            return Some(Roots { entry, exit, outer });
        }
        let entry = if first.t > self.start.t { first } else { self.start };
        let exit = if last.t < self.end.t { last } else { self.end };
        let crosses = entry.t <= exit.t;
        crosses.then(|| Roots { entry: root(entry, entry.t.is_finite()), exit: root(exit, exit.t.is_finite()), outer })
    }
}
