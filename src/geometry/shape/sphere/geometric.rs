//! The sphere by the geometric method of the source text (Ramos, section 1.3, step 5).
//!
//! It loses digits where r², L2oc and T_A² nearly cancel.

use super::{Line, Sphere};
use crate::geometry::ray::{Crossing, Ray, Surface};
use crate::log::Name;
use crate::probe::Probe;

impl Sphere {
    /// The chord, unless the ray's line passes beside the sphere or the sphere lies behind the origin.
    #[inline(always)]
    pub(super) fn geometric_line<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Line {
        let view = self.view(ray, probe);
        if self.is_behind(&view, probe) {
            return Line::Misses;
        }
        let t2_a = self.radius_squared - view.l2_oc + view.t_a * view.t_a;
        self.chord(view, (Name::SphereT2a, t2_a), probe)
    }

    #[inline(always)]
    pub(super) fn geometric_surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
        let normal = if crossing.side == self.outer {
            probe.note(Name::HitNormalSphere, (point - self.center) / self.radius)
        } else {
            probe.note(Name::HitNormalSphereBack, (self.center - point) / self.radius)
        };
        Surface::plain(point, normal, crossing.side)
    }
}
