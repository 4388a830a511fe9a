//! The plane A·x + B·y + C·z + D = 0 (Ramos, section 1.3, steps 2 and 3).

use super::flat::{Sum, is_distance_in_doubt};
use super::{Approach, Kernel, decide};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::length;
use crate::geometry::exact::dot;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// An infinite plane. Its front is the side its normal points to.
#[derive(Clone, Debug, PartialEq)]
pub struct Plane {
    normal: DVec3,
    offset: f64,
    unit_normal: DVec3,
}

impl Plane {
    /// The plane with the coefficients A, B, C, of which not all are zero, and D.
    pub fn new([a, b, c, d]: [f64; 4]) -> Plane {
        let normal = DVec3::new(a, b, c);
        Plane { normal, offset: d, unit_normal: normal / normal.length() }
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
        let v_d = self.normal.dot(ray.direction);
        let v_o = -(self.normal.dot(ray.origin) + self.offset);
        let normal = self.normal.abs();
        let along = Sum { value: v_d, terms: normal.dot(ray.direction.abs()) };
        let above = Sum { value: v_o, terms: normal.dot(ray.origin.abs()) + self.offset.abs() };
        if probe.certifies() && is_distance_in_doubt(above, along, ray) {
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
        decide(ray, approach, Crossing { t, side: side(v_d), primitive: 0 }, probe)
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
}

impl Plane {
    /// The crossing, both sums with all their digits.
    #[cold]
    #[inline(never)]
    fn doubled_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        probe.fallback();
        let v_d = dot(self.normal, ray.vector, 0.0);
        let v_o = -dot(self.normal, ray.origin, self.offset);
        let t = (v_o * length(ray.vector)).quotient(v_d);
        probe.note(Name::PlaneVd, self.normal.dot(ray.direction));
        if v_d.head == 0.0 || !t.is_finite() {
            probe.mark(Decision::Miss { why: Miss::Parallel });
            return None;
        }
        let t = probe.note(Name::PlaneTDoubled, t);
        decide(ray, approach, Crossing { t, side: side(v_d.head), primitive: 0 }, probe)
    }
}

/// The side on which a ray arrives that goes along the normal by this much.
#[inline]
fn side(v_d: f64) -> Side {
    if v_d < 0.0 { Side::Front } else { Side::Back }
}
