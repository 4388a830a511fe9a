//! The box along the axes, as the common part of three slabs (Kay and Kajiya, 1986; Williams et al., 2005).
//!
//! Along an axis to which the ray is perpendicular both quotients are endless and count as the greatest number of their sign,
//! so that such a slab holds the whole ray or nothing of it. On the very plane of a face 0⊘0 counts as 0: a direction +0
//! counts as one that just enters at the lesser face, −0 as one that enters at the greater one. So of two boxes that
//! share a face exactly one is met by a ray that runs in it.

use super::flat::toward;
use super::roots::{Root, Roots};
use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::{Doubled, length};
use crate::geometry::ray::{Crossing, Leaving, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// A box. Its front is the outside; its faces are numbered −x, +x, −y, +y, −z, +z from 0.
#[derive(Clone, Debug, PartialEq)]
pub struct Cuboid {
    min: DVec3,
    max: DVec3,
}

/// The part of the ray's line inside the box, and the faces at its ends.
struct Span {
    entry: f64,
    entry_face: u32,
    exit: f64,
    exit_face: u32,
}

impl Cuboid {
    /// The box between the corner of the least and that of the greatest coordinates.
    pub fn new(min: DVec3, max: DVec3) -> Cuboid {
        Cuboid { min, max }
    }

    /// Where the ray's line enters and leaves all three slabs; the entry lies behind the exit if it passes beside the box.
    #[inline]
    fn span<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Span {
        let to_min = probe.note(Name::BoxToMin, components_over(self.min - ray.origin, ray.direction));
        let to_max = probe.note(Name::BoxToMax, components_over(self.max - ray.origin, ray.direction));
        let (enters, leaves) = (to_min.min(to_max), to_min.max(to_max));
        let entry = probe.note(Name::BoxEntry, enters.max_element());
        let exit = probe.note(Name::BoxExit, leaves.min_element());
        Span {
            entry,
            entry_face: face(enters.max_position(), ray.direction, Side::Front),
            exit,
            exit_face: face(leaves.min_position(), ray.direction, Side::Back),
        }
    }

    /// Both roots, if there are any. A ray that leaves the box inward is at its entry, and can't meet the face again that it
    /// leaves.
    #[inline]
    fn roots<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Roots> {
        let span = self.span(ray, probe);
        let is_inside = approach.leaving.is_some() || Bounds { min: self.min, max: self.max }.contains(ray.origin);
        probe.mark(if is_inside { Decision::Inside } else { Decision::Outside });
        if span.entry > span.exit {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        }
        let left = ray.leaving.filter(|_| approach.leaving.is_some()).map(|leaving| leaving.primitive);
        let [entry_is_left, exit_is_left] = match left {
            None => [false, false],
            // The root nearest to 0.
            Some(Leaving::ANY_PRIMITIVE) if span.exit.abs() < span.entry.abs() => [false, true],
            Some(Leaving::ANY_PRIMITIVE) => [true, false],
            Some(face) => [true, face == span.exit_face],
        };
        if entry_is_left && exit_is_left {
            probe.mark(Decision::Miss { why: Miss::BeginsThere });
            return None;
        }
        // Numbers near the greatest one may have no point.
        let has_point = |t: f64| (ray.origin + ray.direction * t).is_finite();
        let root = |t: f64, primitive: u32, is_left: bool, name: Name| {
            let is_on_surface = !is_left && has_point(t);
            Root { t, primitive, is_on_surface, name }
        };
        Some(Roots {
            entry: root(span.entry, span.entry_face, entry_is_left, Name::BoxTEntry),
            exit: root(span.exit, span.exit_face, exit_is_left, Name::BoxTExit),
            outer: Side::Front,
        })
    }
}

impl Kernel for Cuboid {
    fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::BoxMin, self.min);
        probe.given(Name::BoxMax, self.max);
    }

    #[inline]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let at_an_end = |crossing| self.at_an_end(ray, approach, crossing);
        self.roots(ray, approach, probe)?.first(ray, without_leaving(approach), at_an_end, probe)
    }

    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        let Some(roots) = self.roots(ray, approach, probe) else { return };
        roots.all(ray, without_leaving(approach), |crossing| self.at_an_end(ray, approach, crossing), found, probe);
    }

    #[inline]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
        let outward = face_normal(crossing.primitive);
        probe.given(Name::BoxFaceNormal, outward);
        let normal = toward(crossing.side, outward, Name::HitNormalBox, Name::HitNormalBoxBack, probe);
        Surface::plain(point, normal, crossing.side)
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(Bounds { min: self.min, max: self.max })
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        let axis = crossing.primitive as usize / 2;
        let corner = if crossing.primitive.is_multiple_of(2) { self.min } else { self.max };
        let to_face = Doubled::sum(corner[axis], -ray.origin[axis]);
        to_face * length(ray.vector) / Doubled::from(ray.vector[axis])
    }

    fn can_self_intersect(&self, sets_off: Side) -> bool {
        sets_off == Side::Back
    }
}

/// The roots know already which face is left, so the rule of the nearest one isn't needed.
fn without_leaving(approach: Approach) -> Approach {
    Approach { leaving: None, ..approach }
}

/// a ⊘ b: component by component; what isn't finite counts as the greatest number of its sign, 0⊘0 as 0.
fn components_over(a: DVec3, b: DVec3) -> DVec3 {
    let over = |a: f64, b: f64| {
        let quotient = a / b;
        if quotient.is_nan() { 0.0 } else { quotient.clamp(-f64::MAX, f64::MAX) }
    };
    DVec3::new(over(a.x, b.x), over(a.y, b.y), over(a.z, b.z))
}

/// The face across this axis that faces a ray of this direction with its front or its back. −0 is a direction downward.
fn face(axis: usize, direction: DVec3, side: Side) -> u32 {
    let goes_up = direction[axis].is_sign_positive();
    let is_upper = goes_up == (side == Side::Back);
    2 * axis as u32 + u32::from(is_upper)
}

fn face_normal(face: u32) -> DVec3 {
    let axis = DVec3::AXES[(face / 2) as usize % 3];
    if face.is_multiple_of(2) { -axis } else { axis }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::ray::Leaving;
    use crate::probe::Silent;

    fn cuboid() -> Cuboid {
        Cuboid::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(2.0, 4.0, 6.0))
    }

    fn meet(cuboid: &Cuboid, origin: [f64; 3], direction: [f64; 3]) -> Option<Crossing> {
        let ray = Ray::new(origin.into(), direction.into());
        cuboid.first_crossing(&ray, Approach { leaving: None, one_sided: false }, &mut Silent)
    }

    #[track_caller]
    fn finds(origin: [f64; 3], direction: [f64; 3], t: f64, primitive: u32, side: Side) {
        assert_eq!(meet(&cuboid(), origin, direction), Some(Crossing { t, side, primitive }));
    }

    #[test]
    fn every_face_has_its_number() {
        finds([0.0, 3.0, 4.0], [1.0, 0.0, 0.0], 1.0, 0, Side::Front);
        finds([4.0, 3.0, 4.0], [-1.0, 0.0, 0.0], 2.0, 1, Side::Front);
        finds([1.5, 0.0, 4.0], [-0.0, 1.0, -0.0], 2.0, 2, Side::Front);
        finds([1.5, 9.0, 4.0], [0.0, -1.0, 0.0], 5.0, 3, Side::Front);
        finds([1.5, 3.0, 0.0], [-0.0, 0.0, 1.0], 3.0, 4, Side::Front);
        finds([1.5, 3.0, 9.0], [0.0, -0.0, -1.0], 3.0, 5, Side::Front);
    }

    #[test]
    fn from_inside_the_exit_counts() {
        finds([1.5, 3.0, 4.0], [1.0, 0.0, 0.0], 0.5, 1, Side::Back);
        finds([1.5, 3.0, 4.0], [0.0, 0.0, -1.0], 1.0, 4, Side::Back);
        // On a face, inward.
        finds([1.0, 3.0, 4.0], [1.0, 0.0, 0.0], 1.0, 1, Side::Back);
    }

    #[test]
    fn on_a_face_and_outward_nothing_is_met() {
        assert_eq!(meet(&cuboid(), [1.0, 3.0, 4.0], [-1.0, 0.0, 0.0]), None);
        assert_eq!(meet(&cuboid(), [2.0, 3.0, 4.0], [1.0, 0.0, 0.0]), None);
    }

    #[test]
    fn a_ray_along_a_shared_face_meets_one_of_two_boxes() {
        let one = Cuboid::new(DVec3::ZERO, DVec3::ONE);
        let other = Cuboid::new(DVec3::X, DVec3::ONE + DVec3::X);
        for zero in [0.0, -0.0] {
            let met = [&one, &other].map(|cuboid| meet(cuboid, [1.0, 0.5, -3.0], [zero, 0.0, 1.0]).is_some());
            assert_eq!(met, if zero.is_sign_negative() { [true, false] } else { [false, true] });
        }
    }

    #[test]
    fn beside_and_behind_nothing_is_hit() {
        assert_eq!(meet(&cuboid(), [0.0, 5.0, 4.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(meet(&cuboid(), [9.0, 3.0, 4.0], [1.0, 0.0, 0.0]), None);
        assert_eq!(meet(&cuboid(), [0.0, 0.0, 0.0], [0.6, 0.0, 0.8]), None);
    }

    #[test]
    fn a_ray_that_leaves_a_face_meets_others_only() {
        let leaving = |face, side| Some(Leaving { object: 0, primitive: face, side });
        let approach = Approach { leaving: Some(Side::Back), one_sided: false };
        let meet = |face, direction: DVec3| {
            // Just outside the face, as rounding may have it.
            let origin = DVec3::new(1.0_f64.next_down(), 3.0, 4.0);
            let ray = Ray { leaving: leaving(face, Side::Back), ..Ray::new(origin, direction) };
            cuboid().first_crossing(&ray, approach, &mut Silent).map(|crossing| crossing.primitive)
        };
        assert_eq!(meet(0, DVec3::X), Some(1));
        assert_eq!(meet(0, DVec3::new(0.1, 0.0, 1.0)), Some(5));
        // Along the face, and even a little outward.
        assert_eq!(meet(0, DVec3::new(-1e-17, 0.0, 1.0)), None);
        assert!(!cuboid().can_self_intersect(Side::Front));
    }
}
