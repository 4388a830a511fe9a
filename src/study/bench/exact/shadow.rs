//! How much light of a disk reaches a point past opaque objects, by integrals along the outline of what the point sees of the disk.

use super::quadrature::{Estimate, Rule, integral, pieces, zeros};
use glam::DVec3;
use std::f64::consts::PI;

/// Directions from the point count as on an edge within this angle.
const ON_EDGE: f64 = 1e-13;

/// A piece of an outline is analytic; what is left is rounding.
const ALONG: Rule = Rule { tolerance: 1e-14, halvings: 12 };

/// A closed cone of directions from the point, in the frame of the disk: x and y in its plane, z toward it.
#[derive(Clone, Debug, PartialEq)]
pub enum Cone {
    /// A convex one with flat sides, which run so that (from × to)·d isn't negative inside.
    Flat(Vec<Side>),
    /// That over an ellipse.
    Round(Circle),
}

/// A side of a flat cone: two of its directions and the unit normal inward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Side {
    from: DVec3,
    to: DVec3,
    normal: DVec3,
}

/// The directions m + a·cos φ + b·sin φ, m·(a × b) being positive, and the rows of the inverse of the matrix with the columns a, b, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circle {
    middle: DVec3,
    across: [DVec3; 2],
    inverse: [DVec3; 3],
}

impl Circle {
    /// `None` where the point lies in the circle's plane.
    pub fn new(middle: DVec3, [a, b]: [DVec3; 2]) -> Option<Circle> {
        let volume = middle.dot(a.cross(b));
        if volume.abs() <= 1e-14 * middle.length() * a.length() * b.length() {
            return None;
        }
        let b = if volume < 0.0 { -b } else { b };
        let volume = volume.abs();
        let inverse = [b.cross(middle) / volume, middle.cross(a) / volume, a.cross(b) / volume];
        Some(Circle { middle, across: [a, b], inverse })
    }

    fn at(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(angle);
        self.middle + self.across[0] * cosine + self.across[1] * sine
    }

    fn slope(&self, angle: f64) -> DVec3 {
        let (sine, cosine) = libm::sincos(angle);
        self.across[1] * cosine - self.across[0] * sine
    }

    /// The direction in units of a, b and m.
    fn within(&self, direction: DVec3) -> DVec3 {
        DVec3::from(self.inverse.map(|row| row.dot(direction)))
    }

    fn contains(&self, direction: DVec3) -> bool {
        let inside = self.within(direction);
        inside.z > 0.0 && form(inside, inside) < 0.0
    }
}

/// x·x′ + y·y′ − z·z′, which is negative inside the unit circle's cone.
fn form(one: DVec3, other: DVec3) -> f64 {
    one.x * other.x + one.y * other.y - one.z * other.z
}

impl Cone {
    /// Over a convex polygon by its sides, in any order and sense, and a direction inside. `None` where the point lies in its plane.
    pub fn flat(sides: impl IntoIterator<Item = [DVec3; 2]>, inside: DVec3) -> Option<Cone> {
        let mut cone = Vec::new();
        for [from, to] in sides {
            let normal = from.cross(to);
            let length = normal.length();
            if length <= 1e-15 * from.length() * to.length() {
                continue;
            }
            let normal = normal / length;
            let height = normal.dot(inside);
            if height.abs() <= 1e-14 * inside.length() {
                return None;
            }
            cone.push(match height > 0.0 {
                true => Side { from, to, normal },
                false => Side { from: to, to: from, normal: -normal },
            });
        }
        Some(Cone::Flat(cone))
    }

    /// Whether it certainly hides nothing of the disk with this centre.
    pub fn misses(&self, center: DVec3, radius: f64) -> bool {
        match self {
            // A side has the whole disk outside.
            Cone::Flat(sides) => sides.iter().any(|Side { normal, .. }| {
                normal.dot(center) + radius * libm::hypot(normal.x, normal.y) < -ON_EDGE * center.length()
            }),
            // Both lie in round cones that are apart; a radius over the distance is no less than the sine of half an opening.
            Cone::Round(Circle { middle, across, .. }) => {
                let half = |sine: f64| if sine < 1.0 { libm::asin(sine) } else { PI };
                let halves = half(radius / center.length()) + half(across[0].length() / middle.length());
                let between = libm::atan2(middle.cross(center).length(), middle.dot(center));
                between > halves + 1e-9
            }
        }
    }

    /// Whether the direction of a piece of the outline of cone `own` is hidden by this one, which is number `number`. Of two sides in the same place
    /// and sense the first stays; those in opposite senses both stay, and their integrals cancel.
    fn hides(&self, direction: DVec3, number: usize, own: Option<(usize, DVec3)>) -> bool {
        match self {
            Cone::Round(circle) => circle.contains(direction),
            Cone::Flat(sides) => {
                let unit = direction / direction.length();
                let mut is_on_earlier = true;
                let is_inside = sides.iter().all(|side| {
                    let height = side.normal.dot(unit);
                    if height.abs() <= ON_EDGE {
                        is_on_earlier &= own.is_some_and(|(own, normal)| number < own && normal.dot(side.normal) > 0.0);
                        return true;
                    }
                    height > 0.0
                });
                is_inside && is_on_earlier
            }
        }
    }
}

/// A part of an outline.
#[derive(Clone, Copy)]
enum Curve<'a> {
    Straight(&'a Side),
    Round(&'a Circle),
}

impl Curve<'_> {
    fn range(&self) -> [f64; 2] {
        match self {
            Curve::Straight(_) => [0.0, 1.0],
            Curve::Round(_) => [0.0, 2.0 * PI],
        }
    }

    fn at(&self, place: f64) -> DVec3 {
        match self {
            Curve::Straight(Side { from, to, .. }) => *from * (1.0 - place) + *to * place,
            Curve::Round(circle) => circle.at(place),
        }
    }

    fn slope(&self, place: f64) -> DVec3 {
        match self {
            Curve::Straight(Side { from, to, .. }) => *to - *from,
            Curve::Round(circle) => circle.slope(place),
        }
    }

    /// The places where it meets a plane through the point.
    fn meets_plane(&self, normal: DVec3, found: &mut Vec<f64>) {
        match self {
            Curve::Straight(Side { from, to, .. }) => {
                let (from, to) = (normal.dot(*from), normal.dot(*to));
                found.push(from / (from - to));
            }
            Curve::Round(circle) => {
                let [a, b] = circle.across.map(|across| normal.dot(across));
                let ratio = -normal.dot(circle.middle) / libm::hypot(a, b);
                if ratio.abs() < 1.0 {
                    let (toward, away) = (libm::atan2(b, a), libm::acos(ratio));
                    found.extend([toward - away, toward + away].map(|angle| angle.rem_euclid(2.0 * PI)));
                }
            }
        }
    }

    /// The places where it meets the cone over a circle.
    fn meets_circle(&self, circle: &Circle, found: &mut Vec<f64>) {
        match self {
            Curve::Straight(Side { from, to, .. }) => {
                // Counted from the middle, so that the side reaches from −1 to 1.
                let (from, to) = (circle.within(*from), circle.within(*to));
                let (middle, half) = ((from + to) / 2.0, (to - from) / 2.0);
                let factors = [form(middle, middle), 2.0 * form(middle, half), form(half, half)];
                found.extend(zeros(&factors).into_iter().map(|place| (place + 1.0) / 2.0));
            }
            Curve::Round(own) => {
                let [a, b] = own.across.map(|across| circle.within(across));
                let middle = circle.within(own.middle);
                // With t = tan(φ/2): (1 + t²)·d = (m + a) + 2t·b + t²·(m − a), for either half of the circle.
                for (sign, start) in [(1.0, 0.0), (-1.0, PI)] {
                    let [p, q, r] = [middle + a * sign, b * (2.0 * sign), middle - a * sign];
                    let factors =
                        [form(p, p), 2.0 * form(p, q), form(q, q) + 2.0 * form(p, r), 2.0 * form(q, r), form(r, r)];
                    let angle = |t: f64| (2.0 * libm::atan(t) + start).rem_euclid(2.0 * PI);
                    found.extend(zeros(&factors).into_iter().map(angle));
                }
            }
        }
    }

    fn meets(&self, cone: &Cone, found: &mut Vec<f64>) {
        match cone {
            Cone::Flat(sides) => sides.iter().for_each(|side| self.meets_plane(side.normal, found)),
            Cone::Round(circle) => self.meets_circle(circle, found),
        }
    }
}

/// The mean of N·L over a disk: of its points outside all `hidden` cones, L being the unit direction to each, by the whole disk's area.
///
/// In the disk's frame its centre lies in direction `center` from the point. With d = (x, y, z) from the point, the integral of N·d/|d| over x is
/// F = N_x·|d| + (N_y·y + N_z·z)·asinh(x/√(y² + z²)), and that over the visible part is ∮ F dy along its outline (Green).
pub fn mean_cosine(normal: DVec3, center: DVec3, radius: f64, hidden: &[Cone]) -> Estimate<f64> {
    let nothing = Estimate { value: 0.0, error: 0.0 };
    let Some(light) = Circle::new(center, [DVec3::X * radius, DVec3::Y * radius]) else {
        // From its own plane the disk has no width.
        return Estimate { error: 1.0, ..nothing };
    };
    let antiderivative = |d: DVec3| {
        let flat = (d.y * d.y + d.z * d.z).sqrt();
        normal.x * d.length() + (normal.y * d.y + normal.z * d.z) * libm::asinh(d.x / flat)
    };
    let area = PI * radius * radius;
    let mut sum = nothing;
    let mut add = |curve: Curve, own: Option<(usize, DVec3)>, number: Option<usize>, sign: f64| {
        let mut splits = Vec::new();
        let mut regions: Vec<_> = hidden.iter().enumerate().filter(|(k, _)| Some(*k) != number).collect();
        regions.iter().for_each(|(_, cone)| curve.meets(cone, &mut splits));
        if number.is_some() {
            curve.meets_circle(&light, &mut splits);
        }
        if matches!(curve, Curve::Round(_)) {
            splits.extend([0.5 * PI, PI, 1.5 * PI]);
        }
        splits.retain(|place| place.is_finite());
        for [from, to] in pieces(curve.range(), &mut splits) {
            let middle = curve.at((from + to) / 2.0);
            let is_seen = number.is_none() || light.contains(middle);
            if !is_seen || regions.iter_mut().any(|(k, cone)| cone.hides(middle, *k, own)) {
                continue;
            }
            let on_disk = |d: DVec3| d * (center.z / d.z);
            let part = match curve {
                // A straight piece of the disk's plane, along which it is walked evenly.
                Curve::Straight(_) => {
                    let (start, end) = (on_disk(curve.at(from)), on_disk(curve.at(to)));
                    let rise = end.y - start.y;
                    let mut along = |place: f64| {
                        let value = antiderivative(start * (1.0 - place) + end * place) * rise / area;
                        Estimate { value, error: 0.0 }
                    };
                    integral(&mut along, [0.0, 1.0], ALONG)
                }
                Curve::Round(_) => {
                    let mut along = |place: f64| {
                        let (d, slope) = (curve.at(place), curve.slope(place));
                        let rise = center.z * (slope.y * d.z - d.y * slope.z) / (d.z * d.z);
                        Estimate { value: antiderivative(on_disk(d)) * rise / area, error: 0.0 }
                    };
                    integral(&mut along, [from, to], ALONG)
                }
            };
            sum = Estimate { value: sum.value + sign * part.value, error: sum.error + part.error };
        }
    };
    add(Curve::Round(&light), None, None, 1.0);
    for (number, cone) in hidden.iter().enumerate() {
        match cone {
            Cone::Flat(sides) => {
                for side in sides {
                    add(Curve::Straight(side), Some((number, side.normal)), Some(number), -1.0);
                }
            }
            Cone::Round(circle) => add(Curve::Round(circle), None, Some(number), -1.0),
        }
    }
    sum
}
