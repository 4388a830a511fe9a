//! The sphere by the geometric method of the source text (Ramos, section 1.3, step 5).
//!
//! It loses digits where r², L2oc and T_A² nearly cancel.

use super::{Chord, Method, Sphere};
use crate::geometry::ray::{Crossing, Ray, Surface};
use crate::log::Name;
use crate::probe::Probe;

/// The formulas of the source text.
pub(super) struct Geometric;

impl Method for Geometric {
    #[inline(always)]
    fn near<P: Probe>(_sphere: &Sphere, _ray: &Ray, chord: &Chord, probe: &mut P) -> f64 {
        probe.note(Name::SphereT, chord.t_a - chord.t2_a.sqrt())
    }

    #[inline(always)]
    fn far<P: Probe>(_sphere: &Sphere, _ray: &Ray, chord: &Chord, probe: &mut P) -> f64 {
        probe.note(Name::SphereTFar, chord.t_a + chord.t2_a.sqrt())
    }
}

impl Sphere {
    /// The chord, unless the ray's line passes beside the sphere or the sphere lies behind the origin.
    #[inline(always)]
    pub(super) fn geometric_chord<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Option<Chord> {
        let view = self.view(ray, probe);
        if self.is_behind(&view, probe) {
            return None;
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
