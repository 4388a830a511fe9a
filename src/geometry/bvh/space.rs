//! The tree's own space, in which single precision is enough: centred on what the tree holds, and scaled by a power of two so that all
//! of it lies between −1 and 1. `docs/acceleration.md` derives the margins.

use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::{exponent, scaled};
use crate::geometry::line::Line;
use glam::{DVec3, Vec3, Vec4};

/// The rounding error of one operation in single precision, as a part of the result.
pub(super) const U: f32 = 1.0 / (1 << 24) as f32;

/// No box is entered later than this: what lies between −1 and 1 is less than 5 from where a ray begins.
const LATEST: f32 = 16.0;

/// Where the space lies in the scene's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Space {
    pub center: DVec3,
    pub scale: f64,
}

/// A ray in the tree's space.
#[derive(Clone, Copy, Debug)]
pub(super) struct LocalRay {
    pub origin: [f32; 3],
    pub direction: [f32; 3],
    /// 1 over each component of the direction.
    pub inverse: [f32; 3],
    /// o/d and what a box is entered earlier than computed, by axis.
    pub near: [f32; 3],
    /// o/d less what a box is left later than computed, by axis.
    pub far: [f32; 3],
    /// Which side of a box is the near one, by axis: 0 the lesser coordinate.
    pub near_side: [usize; 3],
    /// How far the ray may lie from where it is in f64.
    pub slack: f32,
    /// What lies before this can't be hit.
    pub t_min: f32,
    /// The least distance along the ray that counts, in its own units.
    pub begin: f64,
    pub distance: Distance,
}

/// How distances along the ray become those of the tree.
#[derive(Clone, Copy, Debug)]
pub(super) struct Distance {
    /// A unit of length in the tree's space.
    pub unit: f64,
    /// A unit of distances along the ray.
    pub scale: f64,
    pub shift: f64,
    pub slack: f64,
}

impl Space {
    /// The space around these bounds.
    pub fn around(bounds: Bounds) -> Space {
        let half = ((bounds.max - bounds.min) * 0.5).max_element();
        let power = (exponent(half) + 1).clamp(-1000, 1000);
        Space { center: bounds.center(), scale: scaled(1.0, -power) }
    }

    /// A point of the scene.
    #[inline(always)]
    pub fn point(&self, point: DVec3) -> DVec3 {
        (point - self.center) * self.scale
    }

    /// A length of the scene.
    #[inline]
    pub fn length(&self, length: f64) -> f64 {
        length * self.scale
    }

    /// The line as a ray of the tree's space; `None` where it is so far away, or so ill-defined, that it may hit anything.
    #[inline(always)]
    pub fn ray(&self, line: &Line) -> Option<LocalRay> {
        let direction = line.direction;
        let mut origin = self.point(line.origin);
        let mut shift = 0.0;
        let size = sum_of_magnitudes(origin);
        if origin.dot(origin) > NEAR {
            // From far away the ray begins where it comes near.
            shift = -origin.dot(direction) - 2.0;
            origin += direction * shift;
        }
        let offset = sum_of_magnitudes(line.origin) * self.scale;
        let slack = ROUNDINGS * (size + shift.abs() + offset + 8.0);
        if slack.is_nan() || slack >= WIDEST.into() {
            return None;
        }
        let distance = Distance { unit: self.scale, scale: line.unit * self.scale, shift, slack };
        let slack = slack as f32 * (1.0 + 4.0 * U);
        Some(LocalRay::new(origin.as_vec3(), direction.as_vec3(), slack, line.t_min, distance))
    }
}

impl LocalRay {
    #[inline(always)]
    fn new(origin: Vec3, direction: Vec3, slack: f32, t_min: f64, distance: Distance) -> LocalRay {
        let [x, y, z] = direction.to_array();
        // Over the distances that count, so little moves the ray less than the margin.
        let along = |x: f32| if x.abs() < LEAST { LEAST.copysign(x) } else { x };
        let along = Vec4::new(along(x), along(y), along(z), 1.0);
        let inverse = Vec4::ONE / along;
        let center = origin.extend(0.0) * inverse;
        let around = inverse.abs() * (OF_BOX + slack);
        let three = |vector: Vec4| vector.truncate().to_array();
        LocalRay {
            origin: origin.to_array(),
            direction: [x, y, z],
            inverse: three(inverse),
            near: three(center + around),
            far: three(center - around),
            near_side: [x, y, z].map(|x| usize::from(x.is_sign_negative())),
            slack,
            t_min: distance.earliest(t_min),
            begin: t_min,
            distance,
        }
    }
}

/// A ray that begins within the root of this isn't moved.
pub(super) const NEAR: f64 = 8.0;

/// Roundings in f64, as parts of all coordinates that they are made of together.
pub(super) const ROUNDINGS: f64 = 24.0 * f64::EPSILON;

/// With a greater slack boxes exclude nothing.
pub(super) const WIDEST: f32 = 0.125;

/// The error of a distance to a plane, as a part of 1/|d|.
pub(super) const OF_BOX: f32 = 24.0 * U;

/// The least component of a direction.
pub(super) const LEAST: f32 = 1e-18;

/// |x| + |y| + |z|
#[inline(always)]
fn sum_of_magnitudes(vector: DVec3) -> f64 {
    let [x, y, z] = vector.to_array();
    x.abs() + y.abs() + z.abs()
}

/// Two near ties are distinguished with more digits, so what lies a little beyond the nearest hit still counts.
const NEAR_TIE: f64 = 16.0 * f64::EPSILON;

impl Distance {
    /// Of no ray.
    pub const NONE: Distance = Distance { unit: 0.0, scale: 0.0, shift: 0.0, slack: 0.0 };

    /// A distance in the tree's space before which nothing lies that the ray hits beyond `t`.
    #[inline(always)]
    pub fn earliest(&self, t: f64) -> f32 {
        -self.rounded_up(-t, -1.0)
    }

    /// A distance in the tree's space beyond which nothing lies that the ray hits up to `t`.
    #[inline(always)]
    pub fn latest(&self, t: f64) -> f32 {
        self.rounded_up(t, 1.0)
    }

    /// Between which distances a crossing certainly counts of a ray from `t_min` up to `t_max` whose origin rounding may have moved by `slack`;
    /// `None` where that is more than filters allow for.
    #[inline(always)]
    pub fn surely_within(&self, t_min: f64, t_max: f64, slack: f64) -> Option<[f32; 2]> {
        let before = if t_max == f64::INFINITY { LATEST } else { self.earliest(t_max) };
        (slack * self.unit <= self.slack).then(|| [self.latest(t_min), before])
    }

    #[inline(always)]
    fn rounded_up(&self, t: f64, sign: f64) -> f32 {
        let t = t * self.scale;
        let t = (t + t.abs() * NEAR_TIE - sign * self.shift + self.slack) as f32;
        // A rounding here, and what the direction and the unit of distances may be off by.
        let t = t + t.abs() * (4.0 * U);
        // Also where −∞ has become no number.
        if t < LATEST { t } else { LATEST }
    }
}

/// A number of f64 rounded down to single precision.
#[inline]
pub(super) fn down(x: f64) -> f32 {
    let x = x as f32;
    x - (x.abs() * (2.0 * U) + f32::MIN_POSITIVE)
}

/// A number of f64 rounded up to single precision.
#[inline]
pub(super) fn up(x: f64) -> f32 {
    -down(-x)
}

#[cfg(test)]
mod tests {
    use super::super::packet_lines::{Lines, Local, PACKET};
    use super::*;

    fn space() -> Space {
        Space::around(Bounds { min: DVec3::new(9.0, -1.0, -3.0), max: DVec3::new(11.0, 1.0, 3.0) })
    }

    fn of(origin: DVec3, direction: DVec3) -> Option<LocalRay> {
        Line::along(origin, direction, [0.0, f64::INFINITY]).and_then(|line| space().ray(&line))
    }

    #[test]
    fn what_it_is_around_lies_between_minus_one_and_one() {
        assert_eq!(space().point(DVec3::new(11.0, 0.0, -3.0)), DVec3::new(0.25, 0.0, -0.75));
        assert_eq!(space().length(2.0), 0.5);
    }

    #[test]
    fn a_far_ray_begins_near() {
        let local = of(DVec3::new(10.0, 0.0, 1e6), DVec3::NEG_Z).expect("near enough");
        assert_eq!(local.origin, [0.0, 0.0, 2.0]);
        // The nearest side is at 3, and t counts from the ray's own origin.
        let side = local.distance.latest(1e6 - 3.0);
        assert!((1.25..1.2501).contains(&side), "{side}");
    }

    #[test]
    fn rays_of_a_packet_are_those_of_each_alone() {
        let number = |k: u64| 8.0 * crate::random::unit(crate::random::hash(7, k)) - 4.0;
        for k in 0..500 {
            let place =
                |axis: u64| DVec3::new(number(9 * k + axis), number(9 * k + axis + 1), number(9 * k + axis + 2));
            let (mut lines, mut local) = (Lines::NONE, Local::NONE);
            let far = if k % 4 == 0 { 1e5 } else { 1.0 };
            let ray = |at: usize| {
                let direction =
                    place(3 + at as u64).normalize() * if k % 3 == 0 { DVec3::new(1.0, 0.0, -0.0) } else { DVec3::ONE };
                Line::along(place(0) * far, direction, [0.25 * at as f64, f64::INFINITY])
                    .map(|line| (line, 5.0 + at as f64))
            };
            let drawn: Vec<_> = (0..PACKET).map(|at| ray(at).expect("a plain direction")).collect();
            for (at, (line, reach)) in drawn.iter().enumerate() {
                lines.set(at, line, *reach);
            }
            space().rays(&lines, &mut local);
            for (at, (line, reach)) in drawn.iter().enumerate() {
                let Some(alone) = space().ray(line) else {
                    assert!(local.slack[at] >= WIDEST, "{k} {at}");
                    continue;
                };
                let of = |eights: &[[f32; 8]; 3]| [eights[0][at], eights[1][at], eights[2][at]];
                let together =
                    [of(&local.origin), of(&local.direction), of(&local.inverse), of(&local.near), of(&local.far)];
                assert_eq!(together, [alone.origin, alone.direction, alone.inverse, alone.near, alone.far], "{k} {at}");
                let ends = [local.slack[at], local.t_min[at], local.t_max[at]];
                assert_eq!(ends, [alone.slack, alone.t_min, alone.distance.latest(*reach)], "{k} {at}");
            }
        }
    }

    #[test]
    fn what_has_no_place_has_no_ray() {
        assert!(of(DVec3::ZERO, DVec3::ZERO).is_none());
        assert!(of(DVec3::ZERO, DVec3::X).is_some());
        assert!(of(DVec3::X * 1e30, DVec3::X).is_none());
    }

    #[test]
    fn rounding_goes_outward() {
        for x in [0.0, 1.0, -1.0, 0.1, -0.7, 1e-50, 1.0 + 1e-12] {
            assert!(f64::from(down(x)) < x && x < f64::from(up(x)), "{x}");
            assert!(up(x) - down(x) < 1e-6);
        }
    }
}
