//! The sphere, by the geometric method of the source text (Ramos, section 1.3, step 5) and by a robust one.
//!
//! The geometric method loses digits where r², L2oc and T_A² nearly cancel. The robust one takes the half chord from the
//! vector OC − T_A·d, and the near root from the product of the roots (Haines et al., Ray Tracing Gems, chapter 7).

use super::{Approach, Kernel, decide};
use crate::geometry::bounds::Bounds;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// A sphere. Its front is the outside, unless it is `inward`.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere {
    center: DVec3,
    radius: f64,
    radius_squared: f64,
    method: SphereMethod,
    /// The side that faces outward.
    outer: Side,
}

/// By which formulas a sphere is met.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SphereMethod {
    /// Those that keep their digits.
    Robust,
    /// Those of the source text.
    Geometric,
}

impl SphereMethod {
    /// The word for it in scene files and logs.
    pub fn word(self) -> &'static str {
        match self {
            SphereMethod::Robust => "robust",
            SphereMethod::Geometric => "geometric",
        }
    }
}

/// The part of the ray's line inside the sphere: from `t_a − √t2_a` to `t_a + √t2_a`.
struct Chord {
    l2_oc: f64,
    t_a: f64,
    t2_a: f64,
    is_origin_outside: bool,
}

impl Sphere {
    /// The sphere with this centre and positive radius; `inward` makes the inside its front.
    pub fn new(center: DVec3, radius: f64, inward: bool, method: SphereMethod) -> Sphere {
        let outer = if inward { Side::Back } else { Side::Front };
        Sphere { center, radius, radius_squared: radius * radius, method, outer }
    }

    /// The chord, unless the ray's line passes beside the sphere or the sphere lies behind the origin.
    #[inline]
    fn chord<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Option<Chord> {
        let oc = probe.note(Name::SphereOc, self.center - ray.origin);
        let l2_oc = probe.note(Name::SphereL2oc, oc.dot(oc));
        let t_a = probe.note(Name::SphereTa, oc.dot(ray.direction));
        let is_origin_outside = l2_oc > self.radius_squared;
        probe.mark(if is_origin_outside { Decision::Outside } else { Decision::Inside });
        if is_origin_outside && t_a < 0.0 {
            probe.mark(Decision::Miss { why: Miss::Behind });
            return None;
        }
        let t2_a = match self.method {
            SphereMethod::Geometric => probe.note(Name::SphereT2a, self.radius_squared - l2_oc + t_a * t_a),
            SphereMethod::Robust => {
                let to_chord = oc - ray.direction * t_a;
                probe.note(Name::SphereT2aRobust, self.radius_squared - to_chord.dot(to_chord))
            }
        };
        // A line that only touches has one point in common with the sphere, unless it is at the ray's own origin.
        let touches_origin = t2_a == 0.0 && t_a == 0.0;
        if t2_a < 0.0 || touches_origin {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        }
        Some(Chord { l2_oc, t_a, t2_a, is_origin_outside })
    }

    #[inline]
    fn near<P: Probe>(&self, chord: &Chord, probe: &mut P) -> Crossing {
        let t = match self.method {
            SphereMethod::Geometric => probe.note(Name::SphereT, chord.t_a - chord.t2_a.sqrt()),
            SphereMethod::Robust => {
                let t = (chord.l2_oc - self.radius_squared) / (chord.t_a + chord.t2_a.sqrt());
                probe.note(Name::SphereTNearRobust, t)
            }
        };
        Crossing { t, side: self.outer, primitive: 0 }
    }

    #[inline]
    fn far<P: Probe>(&self, chord: &Chord, probe: &mut P) -> Crossing {
        let cancels = chord.t_a < 0.0 && self.method == SphereMethod::Robust;
        let t = if cancels {
            let t = (self.radius_squared - chord.l2_oc) / (chord.t2_a.sqrt() - chord.t_a);
            probe.note(Name::SphereTFarRobust, t)
        } else {
            probe.note(Name::SphereTFar, chord.t_a + chord.t2_a.sqrt())
        };
        Crossing { t, side: self.outer.opposite(), primitive: 0 }
    }

    /// The other end of the chord of a ray that sets off inward from the sphere itself: one root is 0, the other 2·T_A.
    fn other_end<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let oc = probe.note(Name::SphereOc, self.center - ray.origin);
        let t_a = probe.note(Name::SphereTa, oc.dot(ray.direction));
        probe.mark(Decision::Inside);
        let t = probe.note(Name::SphereTLeaving, 2.0 * t_a);
        decide(ray, approach, Crossing { t, side: self.outer.opposite(), primitive: 0 }, probe)
    }
}

impl Kernel for Sphere {
    fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::SphereCenter, self.center);
        probe.given(Name::SphereRadius, self.radius);
        probe.given(Name::SphereRadiusSquared, self.radius_squared);
    }

    #[inline(always)]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        if approach.leaving.is_some() {
            return self.other_end(ray, approach, probe);
        }
        let chord = self.chord(ray, probe)?;
        if chord.is_origin_outside && approach.shows(self.outer) {
            let near = self.near(&chord, probe);
            // Only a ray that is asked to begin later (t_min) can begin inside.
            if near.t > ray.t_min {
                return decide(ray, approach, near, probe);
            }
        }
        let far = self.far(&chord, probe);
        decide(ray, approach, far, probe)
    }

    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        if approach.leaving.is_some() {
            return found.extend(self.other_end(ray, approach, probe));
        }
        let Some(chord) = self.chord(ray, probe) else { return };
        if chord.is_origin_outside {
            let near = self.near(&chord, probe);
            found.extend(decide(ray, approach, near, probe));
        }
        let far = self.far(&chord, probe);
        found.extend(decide(ray, approach, far, probe));
    }

    /// The robust method puts the point back onto the sphere, from which rounding took it.
    #[inline(always)]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let along_ray = ray.origin + ray.direction * crossing.t;
        let point = match self.method {
            SphereMethod::Geometric => probe.note(Name::HitPoint, along_ray),
            SphereMethod::Robust => {
                let from_center = along_ray - self.center;
                let distance = from_center.length();
                if distance == 0.0 {
                    // Only where few digits are left: there is no direction to put the point back along.
                    probe.note(Name::HitPoint, along_ray)
                } else {
                    probe.note(Name::HitPointSphere, self.center + from_center * (self.radius / distance))
                }
            }
        };
        let normal = if crossing.side == self.outer {
            probe.note(Name::HitNormalSphere, (point - self.center) / self.radius)
        } else {
            probe.note(Name::HitNormalSphereBack, (self.center - point) / self.radius)
        };
        Surface::plain(point, normal, crossing.side)
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(Bounds { min: self.center - self.radius, max: self.center + self.radius })
    }

    fn can_be_met_again(&self, sets_off: Side) -> bool {
        sets_off != self.outer
    }
}
