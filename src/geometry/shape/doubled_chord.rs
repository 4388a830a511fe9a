//! The chord of a ray in a sphere with twice the digits, and when it is needed.

use crate::geometry::doubled::{Doubled, Doubled3, exponent, length, scaled};
use crate::geometry::exact::squared_less;
use crate::geometry::ray::Ray;
use glam::DVec3;

/// A bound of the relative error of L2oc: three roundings of squares and sums, and two of each difference.
const OF_SQUARE: f64 = 4.0 * f64::EPSILON;

/// A bound of the error of T2_A in parts of L2oc + r². The way p from the centre to the line errs by at most 8 roundings of |OC|
/// across the line: one of OC, four of T_A·d, which the direction's own three join, and one of the difference. p² then
/// errs by 2·p·8u·|OC| and five roundings, r² by one; p and r are at most the root of the larger of L2oc and r².
const OF_CHORD: f64 = 16.0 * f64::EPSILON;

/// That in parts of the other. Both are powers of two, so that their products with a number are, too.
const OF_CHORD_PER_SQUARE: f64 = OF_CHORD / OF_SQUARE;

/// Where squares neither overflow nor lose digits.
const MIDDLING: std::ops::Range<f64> = 1e-260..1e260;

/// The least part of L2oc that may be left of L2oc − r².
pub(super) const LEAST_DIFFERENCE: f64 = 0.75;

/// The least part of L2oc left of L2oc − r² with which a distance can be corrected.
pub(super) const LEAST_TO_CORRECT: f64 = 1.0 / (1 << 20) as f64;

/// Where f64 can't tell how a line lies to a sphere: a bound of the relative error of L2oc. In a word, since a million spheres have a million
/// of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Doubt(f64);

impl Doubt {
    /// Nothing but doubt. Times zero it is zero, which is no less than a difference of zeros; so it isn't infinite, nor is the bound of T2_A.
    const ALL: Doubt = Doubt(f64::MAX / OF_CHORD_PER_SQUARE);

    /// The doubts about a sphere with this square of its radius: where that is so small that digits of squares are lost, all is in
    /// doubt.
    pub fn of_radius(radius_squared: f64) -> Doubt {
        if MIDDLING.contains(&radius_squared) { Doubt(OF_SQUARE) } else { Doubt::ALL }
    }

    /// Whether f64 can't tell on which side of the sphere with this square of its radius the origin lies by the difference L2oc − r². Squares
    /// without end are in doubt.
    #[inline(always)]
    pub fn has_side(self, l2_oc: f64, radius_squared: f64) -> bool {
        (l2_oc - radius_squared).abs() <= self.0 * (l2_oc + radius_squared)
    }

    /// Whether f64 can't tell if the line meets the sphere.
    #[inline(always)]
    pub fn has_touch(self, t2_a: f64, l2_oc: f64, radius_squared: f64) -> bool {
        t2_a.abs() <= self.0 * (l2_oc + radius_squared) * OF_CHORD_PER_SQUARE
    }
}

/// A distance to the sphere, of which the first digits are right, with all of its digits.
pub(super) fn corrected(center: DVec3, radius: f64, ray: &Ray, t: f64) -> f64 {
    corrected_in(|seen| seen, ray.vector, center, Doubled::product(radius, radius), ray, t)
}

/// The same where `map`, which makes `along` of the ray's vector, makes a sphere of the surface.
///
/// With s = t/|v| and f(s) = |OC − s·v|² − r², of which nothing is lost to rounding, the correction is the small root of v·v·Δ² + f′·Δ + f =
/// 0, where a few digits of f′ and Δ are enough.
pub(super) fn corrected_in(
    map: impl Fn(Doubled3) -> Doubled3,
    along: DVec3,
    center: DVec3,
    radius_squared: Doubled,
    ray: &Ray,
    t: f64,
) -> f64 {
    let length = length(ray.vector);
    let s = t / length.head;
    let [x, y, z] = [0, 1, 2].map(|i| from_center(center[i], ray.origin[i], s, ray.vector[i]));
    let seen = map(Doubled3 { x, y, z });
    let parts = [seen.x, seen.y, seen.z];
    // Of magnitude r² all, but for what is left in the end.
    let mut f = Doubled { head: -radius_squared.head, tail: -radius_squared.tail };
    for part in parts {
        let square = Doubled::product(part.head, part.head);
        let sum = Doubled::sum(f.head, square.head);
        f = Doubled { head: sum.head, tail: f.tail + sum.tail + (square.tail + 2.0 * part.head * part.tail) };
    }
    let f = f.value();
    let a = along.dot(along);
    let slope = -2.0 * DVec3::from_array(parts.map(|part| part.head)).dot(along);
    let root = (slope * slope - 4.0 * a * f).max(0.0).sqrt();
    let correction = -2.0 * f / (slope + root.copysign(slope));
    let way = Doubled::product(s, length.head);
    let corrected = way.head + (way.tail + (length.head * correction + length.tail * s));
    // Not where squares overflow, or the root is a double one.
    if corrected.is_finite() { corrected } else { t }
}

/// C − O − s·v along an axis.
#[inline]
fn from_center(center: f64, origin: f64, s: f64, v: f64) -> Doubled {
    let oc = Doubled::sum(center, -origin);
    let along = Doubled::product(s, v);
    let heads = Doubled::sum(oc.head, -along.head);
    Doubled::sum(heads.head, heads.tail + (oc.tail - along.tail))
}

/// The chord, each number of it right to the last bit or two.
#[derive(Clone, Copy, Debug)]
pub(super) struct DoubledChord {
    /// Where the line is nearest to the centre.
    pub t_a: f64,
    /// The square of half the chord.
    pub t2_a: f64,
    /// Where the line enters.
    pub near: Doubled,
    /// Where it leaves.
    pub far: Doubled,
    /// Whether the ray begins outside.
    pub is_origin_outside: bool,
    /// Whether the line has no point in common with the sphere but the ray's own origin.
    pub is_beside: bool,
}

impl DoubledChord {
    /// Meets the sphere along the ray's vector, of any length: with a = v·v, b = OC·v, c = OC·OC − r² and
    /// Δ = r²·a − |OC × v|² the distances are c·√a/(b + √Δ) and (b + √Δ)/√a, or the other way round where b is negative.
    pub fn of(center: DVec3, radius: f64, ray: &Ray) -> DoubledChord {
        let oc = Doubled3::difference(center, ray.origin);
        let size = exponent(oc.size().max(radius));
        let (oc, radius) = (oc.scaled(-size), scaled(radius, -size));
        let vector = Doubled3::from(ray.vector);
        let c = squared_less(oc, radius);
        DoubledChord::in_sphere(oc, vector, c, Doubled::product(radius, radius), length(ray.vector)).scaled(size)
    }

    /// The chord along `vector` in the sphere whose centre is seen at `oc`, c = OC·OC − r²; distances are in units of the vector's
    /// `length`, which is another one where a linear map has made the sphere.
    pub fn in_sphere(
        oc: Doubled3,
        vector: Doubled3,
        c: Doubled,
        radius_squared: Doubled,
        length: Doubled,
    ) -> DoubledChord {
        let a = vector.dot(vector);
        let b = oc.dot(vector);
        let across = oc.cross(vector);
        let discriminant = radius_squared * a - across.dot(across);
        let root = discriminant.sqrt();
        let larger = if b.head > 0.0 { b + root } else { b - root };
        let is_point = larger.head == 0.0;
        let (there, other) =
            if is_point { (Doubled::ZERO, Doubled::ZERO) } else { (larger * length / a, c * length / larger) };
        let (near, far) = if b.head > 0.0 { (other, there) } else { (there, other) };
        DoubledChord {
            t_a: (b * length / a).value(),
            t2_a: (discriminant / a).value(),
            near,
            far,
            is_origin_outside: c.head > 0.0,
            is_beside: discriminant.head < 0.0 || is_point,
        }
    }

    /// The chord in a world larger by 2 to this power.
    pub fn scaled(self, size: i32) -> DoubledChord {
        DoubledChord {
            t_a: scaled(self.t_a, size),
            t2_a: scaled(self.t2_a, 2 * size),
            near: self.near.scaled(size),
            far: self.far.scaled(size),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_chords_are_exact() {
        let ray = Ray::along(DVec3::new(0.0, 3.0, -10.0), DVec3::Z * 7.0);
        let chord = DoubledChord::of(DVec3::ZERO, 5.0, &ray);
        assert_eq!((chord.near.value(), chord.far.value(), chord.t_a, chord.t2_a), (6.0, 14.0, 10.0, 16.0));
        assert!(chord.is_origin_outside && !chord.is_beside);
        let inside = DoubledChord::of(DVec3::new(0.0, 3.0, -10.0), 5.0, &ray);
        assert_eq!((inside.near.value(), inside.far.value()), (-5.0, 5.0));
        assert!(DoubledChord::of(DVec3::X * 6.0, 5.0, &ray).is_beside);
    }

    #[test]
    fn any_size_will_do() {
        for exponent in [-560, -300, 300, 500] {
            let scale = libm::scalbn(1.0, exponent);
            let ray = Ray::along(DVec3::new(0.0, 3.0, -10.0) * scale, DVec3::Z * 7.0);
            let chord = DoubledChord::of(DVec3::ZERO, 5.0 * scale, &ray);
            assert_eq!((chord.near.value(), chord.far.value()), (6.0 * scale, 14.0 * scale));
        }
    }
}
