//! The sphere by a method that keeps its digits (Haines et al., Ray Tracing Gems, chapter 7).
//!
//! It takes the half chord from the vector OC − T_A·d, and the near root from the product of the roots. Where f64 can't tell how the line
//! lies to the sphere, or how far an end is, it goes on in double-double arithmetic.

use super::super::Approach;
use super::super::doubled_chord::{DoubledChord, LEAST_DIFFERENCE, LEAST_TO_CORRECT, corrected};
use super::{Chord, Line, Sphere};
use crate::geometry::doubled::Doubled;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::geometry::size::length;
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use arrayvec::ArrayVec;

/// The largest square of the factor by which the root shows the error of the way to the line, that is tolerated.
const STEEPEST: f64 = 2.0;

/// The same where half of the digits are enough: eight roundings of |OC|, times the root of this, are 2⁻²².
const HALF_STEEP: f64 = (1_u64 << 56) as f64;

impl Sphere {
    /// The chord, unless f64 leaves it in doubt, the ray's line passes beside the sphere or the sphere lies behind the origin.
    #[inline(always)]
    pub(super) fn robust_line<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Line {
        let view = self.view(ray, probe);
        if self.doubt.has_side(view.l2_oc, self.radius_squared) && probe.certifies() {
            return Line::InDoubt;
        }
        if self.is_behind(&view, probe) {
            return Line::Misses;
        }
        let to_chord = view.oc - ray.direction * view.t_a;
        let t2_a = self.radius_squared - to_chord.dot(to_chord);
        if self.doubt.has_touch(t2_a, view.l2_oc, self.radius_squared) && probe.certifies() {
            return Line::InDoubt;
        }
        self.chord(view, (Name::SphereT2aRobust, t2_a), probe)
    }

    #[inline(always)]
    pub(super) fn robust_near<P: Probe>(&self, ray: &Ray, chord: &Chord, probe: &mut P) -> f64 {
        let t = (chord.l2_oc - self.radius_squared) / (chord.t_a + chord.t2_a.sqrt());
        let has_its_digits = self.has_digits_of_quotient(chord, t);
        self.distance(ray, chord, (Name::SphereTNearRobust, Name::SphereTDoubled), (t, has_its_digits), probe)
    }

    #[inline(always)]
    pub(super) fn robust_far<P: Probe>(&self, ray: &Ray, chord: &Chord, probe: &mut P) -> f64 {
        let (name, t, has_its_digits) = if chord.t_a < 0.0 {
            let t = (self.radius_squared - chord.l2_oc) / (chord.t2_a.sqrt() - chord.t_a);
            (Name::SphereTFarRobust, t, self.has_digits_of_quotient(chord, t))
        } else {
            let t = chord.t_a + chord.t2_a.sqrt();
            (Name::SphereTFar, t, self.is_steep_at_most(chord, t, STEEPEST))
        };
        self.distance(ray, chord, (name, Name::SphereTDoubledFar), (t, has_its_digits), probe)
    }

    /// Notes the distance of an end, with more digits and another name where too few of it are right.
    #[inline(always)]
    fn distance<P: Probe>(
        &self,
        ray: &Ray,
        chord: &Chord,
        (name, doubled): (Name, Name),
        (t, has_its_digits): (f64, bool),
        probe: &mut P,
    ) -> f64 {
        if has_its_digits || self.is_settled_by_half(ray, chord, t) || !probe.certifies() {
            return probe.note(name, t);
        }
        probe.fallback();
        probe.note(doubled, self.corrected(ray, chord.l2_oc, t))
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

    /// Whether a distance that is a quotient of L2oc − r² has its digits.
    #[inline(always)]
    fn has_digits_of_quotient(&self, chord: &Chord, t: f64) -> bool {
        self.is_steep_at_most(chord, t, STEEPEST) && self.keeps(chord.l2_oc, LEAST_DIFFERENCE)
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

    /// The ends of the chord in double-double arithmetic, from the first to the last one that is on the side that the ray is on; not noted yet,
    /// since a log has the distances that count.
    #[cold]
    #[inline(never)]
    fn doubled_ends<P: Probe>(&self, ray: &Ray, probe: &mut P) -> ArrayVec<(f64, Side), 2> {
        probe.fallback();
        let found = DoubledChord::of(self.center, self.radius, ray);
        probe.mark(if found.is_origin_outside { Decision::Outside } else { Decision::Inside });
        probe.note(Name::SphereT2aDoubled, found.t2_a);
        let mut ends = ArrayVec::new();
        if found.is_beside || (found.is_origin_outside && found.t_a < 0.0) {
            let why = if found.is_beside { Miss::Beside } else { Miss::Behind };
            probe.mark(Decision::Miss { why });
            return ends;
        }
        if found.is_origin_outside {
            ends.push((found.near.value(), self.outer));
        }
        ends.push((found.far.value(), self.outer.opposite()));
        ends
    }

    /// The first crossing of a ray whose line f64 leaves in doubt.
    #[cold]
    #[inline(never)]
    pub(super) fn first_doubled<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let ends = self.doubled_ends(ray, probe);
        let last = ends.last().copied()?;
        // A ray that is asked to begin later (t_min), or begins at the entry, begins inside.
        let is_first = |(t, side): &(f64, Side)| {
            approach.shows(*side)
                && *t > ray.t_min
                && self.at_an_end_of(ray, approach, *t, *side) != Some(Miss::BeginsThere)
        };
        self.decide_doubled(ray, approach, ends.into_iter().find(is_first).unwrap_or(last), probe)
    }

    /// All crossings of such a ray.
    #[cold]
    #[inline(never)]
    pub(super) fn all_doubled<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        found: &mut Vec<Crossing>,
        probe: &mut P,
    ) {
        let ends = self.doubled_ends(ray, probe);
        found.extend(ends.into_iter().filter_map(|end| self.decide_doubled(ray, approach, end, probe)));
    }

    fn decide_doubled<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        (t, side): (f64, Side),
        probe: &mut P,
    ) -> Option<Crossing> {
        let name = if side == self.outer { Name::SphereTDoubled } else { Name::SphereTDoubledFar };
        let t = probe.note(name, t);
        self.decide_end(ray, approach, (t, side), probe)
    }

    /// The distance of an end of the chord in double-double arithmetic.
    pub(super) fn doubled_end(&self, ray: &Ray, side: Side) -> Doubled {
        let chord = DoubledChord::of(self.center, self.radius, ray);
        if side == self.outer { chord.near } else { chord.far }
    }

    /// Puts the point back onto the sphere, from which rounding took it, and looks at it from the centre: a scene that is moved keeps its
    /// normals.
    #[inline(always)]
    pub(super) fn robust_surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
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
        let normal = if crossing.side == self.outer {
            probe.note(Name::HitNormalOnSphere, from_center / distance)
        } else {
            probe.note(Name::HitNormalOnSphereBack, -from_center / distance)
        };
        Surface::plain(point, normal, crossing.side)
    }
}
