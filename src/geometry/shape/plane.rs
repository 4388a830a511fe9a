//! The plane A·x + B·y + C·z + D = 0 (Ramos, section 1.3, steps 2 and 3).

use super::flat::{HALF, Sum, is_distance_in_doubt};
use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::bvh::Shaft;
use crate::geometry::doubled::{Doubled, length};
use crate::geometry::exact::dot;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// An infinite plane. Its front is the side its normal points to.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    pub(super) normal: DVec3,
    pub(super) offset: f64,
    unit_normal: DVec3,
    /// The least |V_o| that certainly keeps its digits. Of an axial plane it is a difference of two terms, and V_d is one product;
    /// of others nothing is known beforehand.
    certain_from: f64,
}

impl Plane {
    /// The plane with the coefficients A, B, C, of which not all are zero, and D.
    pub fn new([a, b, c, d]: [f64; 4]) -> Plane {
        let normal = DVec3::new(a, b, c);
        let size = normal.abs().element_sum();
        let is_axial = normal.abs().max_element() == size;
        let certain_from = if is_axial { 2.0 * d.abs() } else { f64::INFINITY };
        Plane { normal, offset: d, unit_normal: normal / normal.length(), certain_from }
    }

    /// Whether a segment of the shaft can cross it: not if all of them lie on one side, farther away than roundings can tell.
    pub(super) fn can_be_crossed_in(&self, shaft: &Shaft) -> bool {
        /// Far more than all roundings, as a part of all coordinates.
        const MARGIN: f64 = 1e-9;
        let (center, radius) = shaft.ball;
        let (near, far) = (self.height(shaft.point), self.height(center));
        let margin = MARGIN * (shaft.point.abs() + center.abs()).element_sum() + MARGIN * self.size();
        let is_off = |height: f64| height > margin;
        let is_before = is_off(near) && is_off(far - radius);
        let is_behind = is_off(-near) && is_off(-far - radius);
        !(is_before || is_behind)
    }

    /// How far a point lies before the plane; negative behind it.
    pub fn height(&self, point: DVec3) -> f64 {
        (self.normal.dot(point) + self.offset) / self.normal.length()
    }
}

impl Kernel for Plane {
    fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::PlaneNormal, self.normal);
        probe.given(Name::PlaneOffset, self.offset);
    }

    /// Neither V_d nor V_o needs a unit normal: their quotient is the same.
    #[inline(always)]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let v_d = probe.dot(self.normal, ray.direction);
        let v_o = -(probe.dot(self.normal, ray.origin) + self.offset);
        if probe.certifies() && self.is_in_doubt(ray, v_d, v_o) {
            return self.doubled_crossing(ray, approach, probe);
        }
        let v_d = probe.note(Name::PlaneVd, v_d);
        // Parallel, or so nearly that the distance is no number.
        if v_d == 0.0 || !(v_o / v_d).is_finite() {
            probe.mark(Decision::Miss { why: Miss::Parallel });
            return None;
        }
        let v_o = probe.note(Name::PlaneVo, v_o);
        let t = probe.note(Name::PlaneT, v_o / v_d);
        let crossing = Crossing { t, side: side(v_d), primitive: 0 };
        self.decide(ray, approach, crossing, probe)
    }

    #[inline(always)]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
        let normal = match crossing.side {
            Side::Front => probe.note(Name::HitNormalPlane, self.unit_normal),
            Side::Back => probe.note(Name::HitNormalPlaneBack, -self.unit_normal),
        };
        Surface::plain(point, normal, crossing.side)
    }

    fn bounds(&self) -> Option<Bounds> {
        None
    }

    /// Its distance from the coordinates' origin.
    fn size(&self) -> f64 {
        self.offset.abs() / self.normal.length()
    }

    fn refined(&self, ray: &Ray, _crossing: Crossing) -> Doubled {
        let (v_d, v_o) = self.doubled_sums(ray);
        v_o * length(ray.vector) / v_d
    }
}

impl Plane {
    /// Whether the distance has lost digits that are wanted. For most planes that isn't hard to see: the terms of a sum are together
    /// no more than the normal's size times the largest of the other's components.
    #[inline(always)]
    fn is_in_doubt(&self, ray: &Ray, v_d: f64, v_o: f64) -> bool {
        if v_o.abs() >= self.certain_from {
            return false;
        }
        let size = self.normal.abs().element_sum();
        let of_offset = size * ray.origin.abs().max_element() + self.offset.abs();
        let has_half = v_d.abs() >= HALF * size && v_o.abs() >= HALF * of_offset;
        if has_half && ray.is_settled_by_half(v_o / v_d) {
            return false;
        }
        let normal = self.normal.abs();
        let along = Sum { value: v_d, terms: normal.dot(ray.direction.abs()) };
        let above = Sum { value: v_o, terms: normal.dot(ray.origin.abs()) + self.offset.abs() };
        is_distance_in_doubt(above, along, ray)
    }

    /// V_d for the ray's vector and V_o, with all their digits.
    fn doubled_sums(&self, ray: &Ray) -> (Doubled, Doubled) {
        (dot(self.normal, ray.vector, 0.0), -dot(self.normal, ray.origin, self.offset))
    }

    /// The crossing, both sums with all their digits.
    #[cold]
    #[inline(never)]
    fn doubled_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        probe.fallback();
        let (v_d, v_o) = self.doubled_sums(ray);
        let t = (v_o * length(ray.vector)).quotient(v_d);
        probe.note(Name::PlaneVd, self.normal.dot(ray.direction));
        if v_d.head == 0.0 || !t.is_finite() {
            probe.mark(Decision::Miss { why: Miss::Parallel });
            return None;
        }
        probe.note(Name::PlaneVo, -(self.normal.dot(ray.origin) + self.offset));
        let t = probe.note(Name::PlaneTDoubled, t);
        let crossing = Crossing { t, side: side(v_d.head), primitive: 0 };
        self.decide(ray, approach, crossing, probe)
    }
}

/// The side on which a ray arrives that goes along the normal by this much.
#[inline]
fn side(v_d: f64) -> Side {
    if v_d < 0.0 { Side::Front } else { Side::Back }
}
