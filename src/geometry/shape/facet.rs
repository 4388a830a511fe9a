//! Stand-in for the kernel of a triangle.

use super::{Approach, decide};
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// Three corners.
pub(super) struct Facet {
    pub a: DVec3,
    pub b: DVec3,
    pub c: DVec3,
}

impl Facet {
    pub fn give<P: Probe>(&self, _probe: &mut P) {}

    fn weights(&self, ray: &Ray) -> [f64; 3] {
        let [a, b, c] = [self.a, self.b, self.c].map(|corner| corner - ray.origin);
        let d = ray.direction;
        [d.dot(c.cross(b)), d.dot(a.cross(c)), d.dot(b.cross(a))]
    }

    pub fn crossing<P: Probe>(&self, ray: &Ray, approach: Approach, primitive: u32, probe: &mut P) -> Option<Crossing> {
        let weights = self.weights(ray);
        let is_inside = weights.iter().all(|w| *w >= 0.0) || weights.iter().all(|w| *w <= 0.0);
        if !is_inside {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        }
        let normal = (self.b - self.a).cross(self.c - self.a);
        let v_d = normal.dot(ray.direction);
        if v_d == 0.0 {
            probe.mark(Decision::Miss { why: Miss::Parallel });
            return None;
        }
        let t = probe.note(Name::PlaneT, normal.dot(self.a - ray.origin) / v_d);
        let side = if v_d < 0.0 { Side::Front } else { Side::Back };
        decide(ray, approach, Crossing { t, side, primitive }, probe)
    }

    pub fn surface<P: Probe>(
        &self,
        normals: Option<&[DVec3; 3]>,
        ray: &Ray,
        crossing: Crossing,
        probe: &mut P,
    ) -> Surface {
        let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
        let across = (self.b - self.a).cross(self.c - self.a);
        let sign = if crossing.side == Side::Front { 1.0 } else { -1.0 };
        let geometric_normal = across / across.length() * sign;
        let mut surface = Surface::plain(point, geometric_normal, crossing.side);
        if let Some(&[na, nb, nc]) = normals {
            let [u, v, w] = self.weights(ray);
            let blended = (na * u + nb * v + nc * w) / (u + v + w);
            surface.normal = blended / blended.length() * sign;
        }
        surface
    }
}
