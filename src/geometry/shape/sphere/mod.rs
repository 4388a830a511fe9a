//! The sphere, by the geometric method of the source text (Ramos, section 1.3, step 5) or by a robust one.
//!
//! Both look for the chord that the sphere cuts out of the ray's line and take its first end that the ray reaches. They differ in the
//! formulas of the chord and of its ends, which are in a file each.

mod geometric;
mod robust;

use super::doubled_chord::Doubt;
use super::sphere_method::SphereMethod;
use super::{Approach, Kernel, decide};
use crate::geometry::bounds::Bounds;
use crate::geometry::bvh::Form;
use crate::geometry::doubled::Doubled;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// A sphere. Its front is the outside, unless it is `inward`.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere {
    pub(super) center: DVec3,
    pub(super) radius: f64,
    radius_squared: f64,
    /// 1/r²
    per_radius_squared: f64,
    doubt: Doubt,
    method: SphereMethod,
    /// The side that faces outward.
    pub(super) outer: Side,
}

/// What a ray's origin and line are to the sphere.
#[derive(Clone, Copy)]
struct View {
    /// The vector from the origin to the centre.
    oc: DVec3,
    l2_oc: f64,
    /// The distance of the line's point that is nearest to the centre.
    t_a: f64,
}

/// The part of the ray's line inside the sphere: from `t_a − √t2_a` to `t_a + √t2_a`.
#[derive(Clone, Copy)]
struct Chord {
    l2_oc: f64,
    t_a: f64,
    t2_a: f64,
    is_origin_outside: bool,
}

/// What the line has in common with the sphere, as far as f64 can tell.
enum Line {
    Crosses(Chord),
    Misses,
    InDoubt,
}

impl Sphere {
    /// The sphere with this centre and positive radius; `inward` makes the inside its front.
    pub fn new(center: DVec3, radius: f64, inward: bool, method: SphereMethod) -> Sphere {
        let outer = if inward { Side::Back } else { Side::Front };
        let radius_squared = radius * radius;
        let doubt = Doubt::of_radius(radius_squared);
        Sphere { center, radius, radius_squared, per_radius_squared: 1.0 / radius_squared, doubt, method, outer }
    }

    /// What a tree knows of it. The method of the source text may err by more than a tree allows for.
    pub(super) fn form(&self) -> Option<Form> {
        match self.method {
            SphereMethod::Robust => Some(Form::Sphere { center: self.center, radius: self.radius }),
            SphereMethod::Geometric => self.bounds().map(Form::Within),
        }
    }

    #[inline(always)]
    fn line<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Line {
        match self.method {
            SphereMethod::Robust => self.robust_line(ray, probe),
            SphereMethod::Geometric => self.geometric_line(ray, probe),
        }
    }

    /// Where the chord begins.
    #[inline(always)]
    fn near<P: Probe>(&self, ray: &Ray, chord: &Chord, probe: &mut P) -> f64 {
        match self.method {
            SphereMethod::Robust => self.robust_near(ray, chord, probe),
            SphereMethod::Geometric => probe.note(Name::SphereT, chord.t_a - chord.t2_a.sqrt()),
        }
    }

    /// Where it ends.
    #[inline(always)]
    fn far<P: Probe>(&self, ray: &Ray, chord: &Chord, probe: &mut P) -> f64 {
        match self.method {
            SphereMethod::Robust => self.robust_far(ray, chord, probe),
            SphereMethod::Geometric => probe.note(Name::SphereTFar, chord.t_a + chord.t2_a.sqrt()),
        }
    }

    #[inline(always)]
    fn view<P: Probe>(&self, ray: &Ray, probe: &mut P) -> View {
        let oc = probe.note(Name::SphereOc, self.center - ray.origin);
        let l2_oc = probe.note(Name::SphereL2oc, probe.dot(oc, oc));
        let t_a = probe.note(Name::SphereTa, probe.dot(oc, ray.direction));
        View { oc, l2_oc, t_a }
    }

    /// Whether the sphere lies behind an origin outside of it.
    #[inline(always)]
    fn is_behind<P: Probe>(&self, view: &View, probe: &mut P) -> bool {
        let is_behind = view.l2_oc > self.radius_squared && view.t_a < 0.0;
        if is_behind {
            probe.mark(Decision::Outside);
            probe.mark(Decision::Miss { why: Miss::Behind });
        }
        is_behind
    }

    /// The chord whose half has this square, if it is one.
    #[inline(always)]
    fn chord<P: Probe>(&self, View { l2_oc, t_a, .. }: View, (name, t2_a): (Name, f64), probe: &mut P) -> Line {
        let is_origin_outside = l2_oc > self.radius_squared;
        probe.mark(if is_origin_outside { Decision::Outside } else { Decision::Inside });
        let t2_a = probe.note(name, t2_a);
        // A line that only touches has one point in common with the sphere, unless it is at the ray's own origin.
        let touches_origin = t2_a == 0.0 && t_a == 0.0;
        if t2_a < 0.0 || touches_origin {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return Line::Misses;
        }
        Line::Crosses(Chord { l2_oc, t_a, t2_a, is_origin_outside })
    }

    #[inline(always)]
    fn decide_end<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        (t, side): (f64, Side),
        probe: &mut P,
    ) -> Option<Crossing> {
        let at_an_end = self.at_an_end_of(ray, approach, t, side);
        decide(ray, approach, Crossing { t, side, primitive: 0 }, at_an_end, probe)
    }

    /// Whether an end of the chord is an end of the ray. A ray begins at the nearer one, so that one that sets off inward doesn't begin where it
    /// comes out, however flat it is.
    #[inline(always)]
    fn at_an_end_of(&self, ray: &Ray, approach: Approach, t: f64, side: Side) -> Option<Miss> {
        if !ray.is_near_an_end(t) {
            return None;
        }
        let is_nearer = || side == self.outer || (self.center - ray.origin).dot(ray.direction) < 0.0;
        let at_an_end = self.at_a_near_end(ray, approach, t, side, 0);
        at_an_end.filter(|why| *why != Miss::BeginsThere || is_nearer())
    }

    /// The other end of the chord of a ray that sets off inward from the sphere itself: one root is 0, the other 2·T_A.
    fn other_end<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let oc = probe.note(Name::SphereOc, self.center - ray.origin);
        let t_a = probe.note(Name::SphereTa, probe.dot(oc, ray.direction));
        probe.mark(Decision::Inside);
        let t = probe.note(Name::SphereTLeaving, 2.0 * t_a);
        self.decide(ray, approach, Crossing { t, side: self.outer.opposite(), primitive: 0 }, probe)
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
        let chord = match self.line(ray, probe) {
            Line::Crosses(chord) => chord,
            Line::Misses => return None,
            Line::InDoubt => return self.first_doubled(ray, approach, probe),
        };
        if chord.is_origin_outside && approach.shows(self.outer) {
            let (t, side) = (self.near(ray, &chord, probe), self.outer);
            let at_an_end = self.at_an_end_of(ray, approach, t, side);
            // A ray that is asked to begin later (t_min), or begins at the entry, begins inside.
            if t > ray.t_min && at_an_end != Some(Miss::BeginsThere) {
                return decide(ray, approach, Crossing { t, side, primitive: 0 }, at_an_end, probe);
            }
        }
        let t = self.far(ray, &chord, probe);
        self.decide_end(ray, approach, (t, self.outer.opposite()), probe)
    }

    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        if approach.leaving.is_some() {
            return found.extend(self.other_end(ray, approach, probe));
        }
        let chord = match self.line(ray, probe) {
            Line::Crosses(chord) => chord,
            Line::Misses => return,
            Line::InDoubt => return self.all_doubled(ray, approach, found, probe),
        };
        if chord.is_origin_outside {
            let near = (self.near(ray, &chord, probe), self.outer);
            found.extend(self.decide_end(ray, approach, near, probe));
        }
        let far = (self.far(ray, &chord, probe), self.outer.opposite());
        found.extend(self.decide_end(ray, approach, far, probe));
    }

    #[inline(always)]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        match self.method {
            SphereMethod::Robust => self.robust_surface(ray, crossing, probe),
            SphereMethod::Geometric => self.geometric_surface(ray, crossing, probe),
        }
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(Bounds { min: self.center - self.radius, max: self.center + self.radius })
    }

    fn can_self_intersect(&self, sets_off: Side) -> bool {
        sets_off != self.outer
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        match self.method {
            SphereMethod::Robust if ray.leaving.is_none() => self.doubled_end(ray, crossing.side),
            _ => Doubled::from(crossing.t),
        }
    }
}
