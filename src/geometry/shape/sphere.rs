//! The sphere, by the geometric method of the source text (Ramos, section 1.3, step 5) and by a robust one.
//!
//! The geometric method loses digits where r², L2oc and T_A² nearly cancel. The robust one takes the half chord from the
//! vector OC − T_A·d, and the near root from the product of the roots (Haines et al., Ray Tracing Gems, chapter 7).

use super::doubled_chord::{DoubledChord, corrected, is_side_in_doubt, is_touch_in_doubt};
use super::{Approach, Kernel, decide};
use crate::geometry::area_normal::length;
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// The largest square of the factor by which the root shows the error of the way to the line, that is let pass.
const STEEPEST: f64 = 4.0;

/// The same where half of the digits are enough: eight roundings of |OC|, times the root of this, are 2⁻²².
const HALF_STEEP: f64 = (1_u64 << 56) as f64;

/// The least part of L2oc that may be left of L2oc − r².
const LEAST_DIFFERENCE: f64 = 0.5;

/// The least part of L2oc left of L2oc − r² with which a distance can be corrected.
const LEAST_TO_CORRECT: f64 = 1.0 / (1 << 20) as f64;

/// A sphere. Its front is the outside, unless it is `inward`.
#[derive(Clone, Debug, PartialEq)]
pub struct Sphere {
    center: DVec3,
    radius: f64,
    radius_squared: f64,
    /// 1/r²
    per_radius_squared: f64,
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
    /// Where the line enters and leaves, where that was computed with twice the digits.
    doubled: Option<[f64; 2]>,
}

impl Sphere {
    /// The sphere with this centre and positive radius; `inward` makes the inside its front.
    pub fn new(center: DVec3, radius: f64, inward: bool, method: SphereMethod) -> Sphere {
        let outer = if inward { Side::Back } else { Side::Front };
        let radius_squared = radius * radius;
        Sphere { center, radius, radius_squared, per_radius_squared: 1.0 / radius_squared, method, outer }
    }

    /// The chord, unless the ray's line passes beside the sphere or the sphere lies behind the origin.
    #[inline(always)]
    fn chord<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Option<Chord> {
        let oc = probe.note(Name::SphereOc, self.center - ray.origin);
        let l2_oc = probe.note(Name::SphereL2oc, oc.dot(oc));
        let t_a = probe.note(Name::SphereTa, oc.dot(ray.direction));
        let is_robust = self.method == SphereMethod::Robust;
        if is_robust && probe.certifies() && is_side_in_doubt(l2_oc, self.radius_squared) {
            return self.doubled_chord(ray, probe);
        }
        let is_origin_outside = l2_oc > self.radius_squared;
        probe.mark(if is_origin_outside { Decision::Outside } else { Decision::Inside });
        if is_origin_outside && t_a < 0.0 {
            probe.mark(Decision::Miss { why: Miss::Behind });
            return None;
        }
        let t2_a = if is_robust {
            let to_chord = oc - ray.direction * t_a;
            let t2_a = self.radius_squared - to_chord.dot(to_chord);
            if probe.certifies() && is_touch_in_doubt(t2_a, l2_oc, self.radius_squared) {
                return self.doubled_chord(ray, probe);
            }
            probe.note(Name::SphereT2aRobust, t2_a)
        } else {
            probe.note(Name::SphereT2a, self.radius_squared - l2_oc + t_a * t_a)
        };
        // A line that only touches has one point in common with the sphere, unless it is at the ray's own origin.
        let touches_origin = t2_a == 0.0 && t_a == 0.0;
        if t2_a < 0.0 || touches_origin {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        }
        Some(Chord { l2_oc, t_a, t2_a, is_origin_outside, doubled: None })
    }

    /// The chord with twice the digits.
    #[cold]
    #[inline(never)]
    fn doubled_chord<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Option<Chord> {
        probe.fallback();
        let found = DoubledChord::of(self.center, self.radius, ray);
        probe.mark(if found.is_origin_outside { Decision::Outside } else { Decision::Inside });
        probe.note(Name::SphereT2aDoubled, found.t2_a);
        let why = match () {
            _ if found.is_origin_outside && found.t_a < 0.0 => Miss::Behind,
            _ if found.is_beside => Miss::Beside,
            _ => {
                let DoubledChord { t_a, t2_a, is_origin_outside, near, far, .. } = found;
                let doubled = Some([near.value(), far.value()]);
                return Some(Chord { l2_oc: 0.0, t_a, t2_a, is_origin_outside, doubled });
            }
        };
        probe.mark(Decision::Miss { why });
        None
    }

    #[inline(always)]
    fn near<P: Probe>(&self, ray: &Ray, chord: &Chord, probe: &mut P) -> Crossing {
        let t = match (self.method, chord.doubled) {
            (_, Some([near, _])) => probe.note(Name::SphereTDoubled, near),
            (SphereMethod::Geometric, _) => probe.note(Name::SphereT, chord.t_a - chord.t2_a.sqrt()),
            (SphereMethod::Robust, _) => {
                let t = (chord.l2_oc - self.radius_squared) / (chord.t_a + chord.t2_a.sqrt());
                let has_its_digits = self.has_its_digits(chord, t) && self.keeps(chord, LEAST_DIFFERENCE);
                self.settled(ray, chord, has_its_digits, (Name::SphereTNearRobust, t), probe)
            }
        };
        Crossing { t, side: self.outer, primitive: 0 }
    }

    #[inline(always)]
    fn far<P: Probe>(&self, ray: &Ray, chord: &Chord, probe: &mut P) -> Crossing {
        let t = match (self.method, chord.doubled) {
            (_, Some([_, far])) => probe.note(Name::SphereTDoubled, far),
            (SphereMethod::Geometric, _) => probe.note(Name::SphereTFar, chord.t_a + chord.t2_a.sqrt()),
            (SphereMethod::Robust, _) if chord.t_a < 0.0 => {
                let t = (self.radius_squared - chord.l2_oc) / (chord.t2_a.sqrt() - chord.t_a);
                let has_its_digits = self.has_its_digits(chord, t) && self.keeps(chord, LEAST_DIFFERENCE);
                self.settled(ray, chord, has_its_digits, (Name::SphereTFarRobust, t), probe)
            }
            (SphereMethod::Robust, _) => {
                let t = chord.t_a + chord.t2_a.sqrt();
                self.settled(ray, chord, self.has_its_digits(chord, t), (Name::SphereTFar, t), probe)
            }
        };
        Crossing { t, side: self.outer.opposite(), primitive: 0 }
    }

    /// The distance as it is, or with twice the digits where too few of it are right.
    #[inline(always)]
    fn settled<P: Probe>(
        &self,
        ray: &Ray,
        chord: &Chord,
        has_its_digits: bool,
        (name, t): (Name, f64),
        probe: &mut P,
    ) -> f64 {
        if has_its_digits || !probe.certifies() || self.is_settled_by_half(ray, chord, t) {
            return probe.note(name, t);
        }
        probe.fallback();
        let t = self.corrected(ray, chord, t);
        probe.note(Name::SphereTDoubled, t)
    }

    /// The distance with all of its digits.
    #[cold]
    #[inline(never)]
    fn corrected(&self, ray: &Ray, chord: &Chord, t: f64) -> f64 {
        // At the surface itself the distance is made of errors, and a correction of it would be, too.
        if self.keeps(chord, LEAST_TO_CORRECT) {
            return corrected(self.center, self.radius, ray, t);
        }
        let DoubledChord { near, far, .. } = DoubledChord::of(self.center, self.radius, ray);
        let [near, far] = [near.value(), far.value()];
        if (t - near).abs() < (t - far).abs() { near } else { far }
    }

    /// Whether a distance of this chord has lost no more than a bit or two by the way p from the centre to the line, which errs
    /// by roundings of |OC|: √T2_A shows them p/√T2_A times as large.
    #[inline(always)]
    fn has_its_digits(&self, chord: &Chord, t: f64) -> bool {
        self.is_steep_at_most(chord, t, STEEPEST)
    }

    #[inline(always)]
    fn is_steep_at_most(&self, chord: &Chord, t: f64, most: f64) -> bool {
        let p2 = self.radius_squared - chord.t2_a;
        // Parts of r², whose products with squares stay in range.
        let (of_way, of_chord) = (p2 * self.per_radius_squared, chord.t2_a * self.per_radius_squared);
        of_way * chord.l2_oc <= most * of_chord * (t * t)
    }

    /// Whether so much of L2oc is left of L2oc − r².
    #[inline(always)]
    fn keeps(&self, chord: &Chord, least: f64) -> bool {
        (chord.l2_oc - self.radius_squared).abs() >= chord.l2_oc * least
    }

    /// Whether the distance has half of its digits, and they are enough.
    #[inline]
    fn is_settled_by_half(&self, ray: &Ray, chord: &Chord, t: f64) -> bool {
        ray.is_settled_by_half(t) && self.is_steep_at_most(chord, t, HALF_STEEP) && self.keeps(chord, LEAST_TO_CORRECT)
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
            let near = self.near(ray, &chord, probe);
            // Only a ray that is asked to begin later (t_min) can begin inside.
            if near.t > ray.t_min {
                return decide(ray, approach, near, probe);
            }
        }
        let far = self.far(ray, &chord, probe);
        decide(ray, approach, far, probe)
    }

    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        if approach.leaving.is_some() {
            return found.extend(self.other_end(ray, approach, probe));
        }
        let Some(chord) = self.chord(ray, probe) else { return };
        if chord.is_origin_outside {
            let near = self.near(ray, &chord, probe);
            found.extend(decide(ray, approach, near, probe));
        }
        let far = self.far(ray, &chord, probe);
        found.extend(decide(ray, approach, far, probe));
    }

    /// The robust method puts the point back onto the sphere, from which rounding took it, and looks at it from the centre: a scene
    /// that is moved keeps its normals.
    #[inline(always)]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let is_outer = crossing.side == self.outer;
        if self.method == SphereMethod::Geometric {
            let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
            let normal = if is_outer {
                probe.note(Name::HitNormalSphere, (point - self.center) / self.radius)
            } else {
                probe.note(Name::HitNormalSphereBack, (self.center - point) / self.radius)
            };
            return Surface::plain(point, normal, crossing.side);
        }
        let from_center = ray.origin - self.center + ray.direction * crossing.t;
        let from_center = probe.note(Name::SphereFromCenter, from_center);
        let distance = length(from_center);
        if distance == 0.0 {
            // Only where few digits are left: there is no direction to put the point back along.
            let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
            let normal = probe.note(Name::HitNormalFacing, -ray.direction);
            return Surface::plain(point, normal, crossing.side);
        }
        let point = probe.note(Name::HitPointSphere, self.center + from_center * (self.radius / distance));
        let normal = if is_outer {
            probe.note(Name::HitNormalOnSphere, from_center / distance)
        } else {
            probe.note(Name::HitNormalOnSphereBack, -from_center / distance)
        };
        Surface::plain(point, normal, crossing.side)
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(Bounds { min: self.center - self.radius, max: self.center + self.radius })
    }

    fn can_be_met_again(&self, sets_off: Side) -> bool {
        sets_off != self.outer
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        if self.method == SphereMethod::Geometric || ray.leaving.is_some() {
            return Doubled::from(crossing.t);
        }
        let chord = DoubledChord::of(self.center, self.radius, ray);
        if crossing.side == self.outer { chord.near } else { chord.far }
    }
}
