//! The sphere, by the geometric method of the source text (Ramos, section 1.3, step 5) and by a robust one.
//!
//! The geometric method loses digits where r², L2oc and T_A² nearly cancel. The robust one takes the half chord from the
//! vector OC − T_A·d, and the near root from the product of the roots (Haines et al., Ray Tracing Gems, chapter 7).

use super::doubled_chord::{DoubledChord, Doubt, LEAST_DIFFERENCE, LEAST_TO_CORRECT, corrected};
use super::sphere_method::SphereMethod;
use super::{Approach, Kernel, decide};
use crate::geometry::bounds::Bounds;
use crate::geometry::bvh::Form;
use crate::geometry::doubled::Doubled;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::geometry::size::length;
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use arrayvec::ArrayVec;
use glam::DVec3;

/// The largest square of the factor by which the root shows the error of the way to the line, that is tolerated.
const STEEPEST: f64 = 2.0;

/// The same where half of the digits are enough: eight roundings of |OC|, times the root of this, are 2⁻²².
const HALF_STEEP: f64 = (1_u64 << 56) as f64;

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

/// The part of the ray's line inside the sphere: from `t_a − √t2_a` to `t_a + √t2_a`.
#[derive(Clone, Copy)]
struct Chord {
    l2_oc: f64,
    t_a: f64,
    t2_a: f64,
    is_origin_outside: bool,
}

/// An end of the chord, as f64 has it.
#[derive(Clone, Copy)]
struct End {
    name: Name,
    t: f64,
    side: Side,
    /// Whether its digits are enough, or no more are wanted.
    is_settled: bool,
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
        let doubt = match method {
            SphereMethod::Robust => Doubt::of_radius(radius_squared),
            SphereMethod::Geometric => Doubt::NONE,
        };
        Sphere { center, radius, radius_squared, per_radius_squared: 1.0 / radius_squared, doubt, method, outer }
    }

    /// What a tree knows of it. The method of the source text may err by more than a tree allows for.
    pub(super) fn form(&self) -> Option<Form> {
        match self.method {
            SphereMethod::Robust => Some(Form::Sphere { center: self.center, radius: self.radius }),
            SphereMethod::Geometric => self.bounds().map(Form::Within),
        }
    }

    /// The chord, unless the ray's line passes beside the sphere or the sphere lies behind the origin.
    #[inline(always)]
    fn chord<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Line {
        let oc = probe.note(Name::SphereOc, self.center - ray.origin);
        let l2_oc = probe.note(Name::SphereL2oc, probe.dot(oc, oc));
        let t_a = probe.note(Name::SphereTa, probe.dot(oc, ray.direction));
        if self.doubt.has_side(l2_oc, self.radius_squared) && probe.certifies() {
            return Line::InDoubt;
        }
        let is_origin_outside = l2_oc > self.radius_squared;
        if is_origin_outside && t_a < 0.0 {
            probe.mark(Decision::Outside);
            probe.mark(Decision::Miss { why: Miss::Behind });
            return Line::Misses;
        }
        let (name, t2_a) = match self.method {
            SphereMethod::Robust => {
                let to_chord = oc - ray.direction * t_a;
                (Name::SphereT2aRobust, self.radius_squared - to_chord.dot(to_chord))
            }
            SphereMethod::Geometric => (Name::SphereT2a, self.radius_squared - l2_oc + t_a * t_a),
        };
        if self.doubt.has_touch(t2_a, l2_oc, self.radius_squared) && probe.certifies() {
            return Line::InDoubt;
        }
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

    /// The crossings with twice the digits, from the first to the last one that is on the side that the ray is on; not noted yet, since a
    /// log has the distances that count.
    #[cold]
    #[inline(never)]
    fn doubled_crossings<P: Probe>(&self, ray: &Ray, probe: &mut P) -> ArrayVec<Crossing, 2> {
        probe.fallback();
        let found = DoubledChord::of(self.center, self.radius, ray);
        probe.mark(if found.is_origin_outside { Decision::Outside } else { Decision::Inside });
        probe.note(Name::SphereT2aDoubled, found.t2_a);
        let mut crossings = ArrayVec::new();
        if found.is_beside || (found.is_origin_outside && found.t_a < 0.0) {
            let why = if found.is_beside { Miss::Beside } else { Miss::Behind };
            probe.mark(Decision::Miss { why });
            return crossings;
        }
        if found.is_origin_outside {
            crossings.push(Crossing { t: found.near.value(), side: self.outer, primitive: 0 });
        }
        crossings.push(Crossing { t: found.far.value(), side: self.outer.opposite(), primitive: 0 });
        crossings
    }

    /// Notes a distance that was computed with twice the digits.
    fn note_doubled<P: Probe>(&self, crossing: Crossing, probe: &mut P) -> Crossing {
        let name = if crossing.side == self.outer { Name::SphereTDoubled } else { Name::SphereTDoubledFar };
        Crossing { t: probe.note(name, crossing.t), ..crossing }
    }

    #[cold]
    #[inline(never)]
    fn first_doubled<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let crossings = self.doubled_crossings(ray, probe);
        let last = crossings.last().copied()?;
        // A ray that is asked to begin later (t_min), or begins at the entry, begins inside.
        let is_first = |crossing: &Crossing| {
            approach.shows(crossing.side)
                && crossing.t > ray.t_min
                && self.is_end_of(ray, approach, *crossing) != Some(Miss::BeginsThere)
        };
        let first = self.note_doubled(crossings.into_iter().find(is_first).unwrap_or(last), probe);
        decide(ray, approach, first, self.is_end_of(ray, approach, first), probe)
    }

    /// Whether an end of the chord is an end of the ray. A ray begins at the nearer one, so that one that sets off inward doesn't begin where it
    /// comes out, however flat it is.
    fn is_end_of(&self, ray: &Ray, approach: Approach, end: Crossing) -> Option<Miss> {
        let is_nearer = || end.side == self.outer || (self.center - ray.origin).dot(ray.direction) < 0.0;
        let at_an_end = if ray.is_near_an_end(end.t) { self.at_an_end(ray, approach, end) } else { None };
        at_an_end.filter(|why| *why != Miss::BeginsThere || is_nearer())
    }

    /// Where the chord begins.
    #[inline(always)]
    fn near<P: Probe>(&self, ray: &Ray, chord: &Chord, probe: &P) -> End {
        let (name, t, has_its_digits) = match self.method {
            SphereMethod::Geometric => (Name::SphereT, chord.t_a - chord.t2_a.sqrt(), true),
            SphereMethod::Robust => {
                let t = (chord.l2_oc - self.radius_squared) / (chord.t_a + chord.t2_a.sqrt());
                let has_its_digits =
                    self.is_steep_at_most(chord, t, STEEPEST) && self.keeps(chord.l2_oc, LEAST_DIFFERENCE);
                (Name::SphereTNearRobust, t, has_its_digits)
            }
        };
        let is_settled = has_its_digits || self.is_settled_by_half(ray, chord, t) || !probe.certifies();
        End { name, t, side: self.outer, is_settled }
    }

    /// Where the chord ends.
    #[inline(always)]
    fn far<P: Probe>(&self, ray: &Ray, chord: &Chord, probe: &P) -> End {
        let (name, t, has_its_digits) = match self.method {
            SphereMethod::Geometric => (Name::SphereTFar, chord.t_a + chord.t2_a.sqrt(), true),
            SphereMethod::Robust if chord.t_a < 0.0 => {
                let t = (self.radius_squared - chord.l2_oc) / (chord.t2_a.sqrt() - chord.t_a);
                let has_its_digits =
                    self.is_steep_at_most(chord, t, STEEPEST) && self.keeps(chord.l2_oc, LEAST_DIFFERENCE);
                (Name::SphereTFarRobust, t, has_its_digits)
            }
            SphereMethod::Robust => {
                let t = chord.t_a + chord.t2_a.sqrt();
                (Name::SphereTFar, t, self.is_steep_at_most(chord, t, STEEPEST))
            }
        };
        let is_settled = has_its_digits || self.is_settled_by_half(ray, chord, t) || !probe.certifies();
        End { name, t, side: self.outer.opposite(), is_settled }
    }

    /// The crossing at an end of the chord, with more digits where too few of the distance are right.
    #[inline]
    fn crossing<P: Probe>(&self, ray: &Ray, l2_oc: f64, end: End, probe: &mut P) -> Crossing {
        let End { name, t, side, is_settled } = end;
        if is_settled {
            return Crossing { t: probe.note(name, t), side, primitive: 0 };
        }
        probe.fallback();
        self.note_doubled(Crossing { t: self.corrected(ray, l2_oc, t), side, primitive: 0 }, probe)
    }

    /// The first crossing, where the end that it is at needs care.
    #[cold]
    #[inline(never)]
    fn first_with_care<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        chord: Chord,
        end: End,
        probe: &mut P,
    ) -> Option<Crossing> {
        let crossing = self.crossing(ray, chord.l2_oc, end, probe);
        let at_an_end = self.is_end_of(ray, approach, crossing);
        if end.side == self.outer && (crossing.t <= ray.t_min || at_an_end == Some(Miss::BeginsThere)) {
            let far = self.crossing(ray, chord.l2_oc, self.far(ray, &chord, probe), probe);
            return decide(ray, approach, far, self.is_end_of(ray, approach, far), probe);
        }
        decide(ray, approach, crossing, at_an_end, probe)
    }

    /// The distance with all of its digits.
    #[cold]
    #[inline(never)]
    fn corrected(&self, ray: &Ray, l2_oc: f64, t: f64) -> f64 {
        // At the surface itself the distance is made of errors, and a correction of it would be, too.
        if self.keeps(l2_oc, LEAST_TO_CORRECT) {
            return corrected(self.center, self.radius, ray, t);
        }
        let DoubledChord { near, far, .. } = DoubledChord::of(self.center, self.radius, ray);
        let [near, far] = [near.value(), far.value()];
        if (t - near).abs() < (t - far).abs() { near } else { far }
    }

    /// Whether a distance of this chord has lost no more than a bit or two by the way p from the centre to the line, which errs
    /// by roundings of |OC|: √T2_A shows them p/√T2_A times as large. That is so if the square of that factor is [`STEEPEST`] at most.
    #[inline(always)]
    fn is_steep_at_most(&self, chord: &Chord, t: f64, most: f64) -> bool {
        let p2 = self.radius_squared - chord.t2_a;
        // Parts of r², whose products with squares stay in range.
        let (of_way, of_chord) = (p2 * self.per_radius_squared, chord.t2_a * self.per_radius_squared);
        of_way * chord.l2_oc <= most * of_chord * (t * t)
    }

    /// Whether so much of L2oc is left of L2oc − r².
    #[inline(always)]
    fn keeps(&self, l2_oc: f64, least: f64) -> bool {
        (l2_oc - self.radius_squared).abs() >= l2_oc * least
    }

    /// Whether the distance has half of its digits, and they are enough.
    #[inline]
    fn is_settled_by_half(&self, ray: &Ray, chord: &Chord, t: f64) -> bool {
        ray.is_settled_by_half(t)
            && self.is_steep_at_most(chord, t, HALF_STEEP)
            && self.keeps(chord.l2_oc, LEAST_TO_CORRECT)
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

/// Whether the distance of an end has too few digits, or it may be an end of the ray.
#[inline(always)]
fn needs_care(ray: &Ray, end: &End) -> bool {
    !end.is_settled || ray.is_near_an_end(end.t)
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
        let chord = match self.chord(ray, probe) {
            Line::Crosses(chord) => chord,
            Line::Misses => return None,
            Line::InDoubt => return self.first_doubled(ray, approach, probe),
        };
        if chord.is_origin_outside && approach.shows(self.outer) {
            let near = self.near(ray, &chord, probe);
            if needs_care(ray, &near) {
                return self.first_with_care(ray, approach, chord, near, probe);
            }
            let t = probe.note(near.name, near.t);
            // Only a ray that is asked to begin later (t_min) can begin inside.
            if t > ray.t_min {
                return decide(ray, approach, Crossing { t, side: near.side, primitive: 0 }, None, probe);
            }
        }
        let far = self.far(ray, &chord, probe);
        if needs_care(ray, &far) {
            return self.first_with_care(ray, approach, chord, far, probe);
        }
        let t = probe.note(far.name, far.t);
        decide(ray, approach, Crossing { t, side: far.side, primitive: 0 }, None, probe)
    }

    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        if approach.leaving.is_some() {
            return found.extend(self.other_end(ray, approach, probe));
        }
        let chord = match self.chord(ray, probe) {
            Line::Crosses(chord) => chord,
            Line::Misses => return,
            Line::InDoubt => {
                let crossings = self.doubled_crossings(ray, probe);
                let decided = |end| {
                    let end = self.note_doubled(end, probe);
                    decide(ray, approach, end, self.is_end_of(ray, approach, end), probe)
                };
                return found.extend(crossings.into_iter().filter_map(decided));
            }
        };
        if chord.is_origin_outside {
            let near = self.crossing(ray, chord.l2_oc, self.near(ray, &chord, probe), probe);
            found.extend(decide(ray, approach, near, self.is_end_of(ray, approach, near), probe));
        }
        let far = self.crossing(ray, chord.l2_oc, self.far(ray, &chord, probe), probe);
        found.extend(decide(ray, approach, far, self.is_end_of(ray, approach, far), probe));
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

    fn can_self_intersect(&self, sets_off: Side) -> bool {
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
