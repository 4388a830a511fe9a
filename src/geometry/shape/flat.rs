//! What the flat shapes share: the distance to their plane, and the normal toward the ray.

use crate::geometry::bounds::{Bounds, Slabs};
use crate::geometry::doubled::{Doubled, Doubled3, length};
use crate::geometry::exact::dot;
use crate::geometry::ray::{Ray, Side};
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::DVec3;

/// Where a ray hits the plane of a flat shape.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct PlaneHit {
    /// The distance along the ray.
    pub t: f64,
    /// The side from which the ray arrives.
    pub side: Side,
}

/// What the quantities of a plane are called on this shape.
pub(super) struct PlaneNames {
    /// V_d = N · d
    pub v_d: Name,
    /// V_o = N · (Q − O) with a point Q of the plane
    pub v_o: Name,
    /// t = V_o/V_d
    pub t: Name,
}

/// What the quantities of the box around a shape are called.
pub(super) struct BoxNames {
    /// Where the ray enters the box.
    pub near: Name,
    /// Where it leaves it.
    pub far: Name,
    /// The distance that is kept in it.
    pub t: Name,
}

/// Meets the plane through `corner` with this normal of any length (Ramos, section 1.3, step 2).
///
/// V_o is the normal times one difference, and not the sum N·O + D of the plane's own formula: far from the coordinates'
/// origin that sum would cancel. A ray whose quotient or point has no end counts as parallel, and so does every ray to a
/// plane whose products overflow: a log holds finite numbers only.
#[inline]
pub(super) fn meet_plane<P: Probe>(
    ray: &Ray,
    normal: DVec3,
    corner: DVec3,
    names: &PlaneNames,
    probe: &mut P,
) -> Option<PlaneHit> {
    let (v_d, v_o) = (probe.dot(normal, ray.direction), probe.dot(normal, corner - ray.origin));
    let found = (|| {
        if !(v_d.is_finite() && v_o.is_finite()) {
            return None;
        }
        let v_d = probe.note(names.v_d, v_d);
        if v_d == 0.0 {
            return None;
        }
        let v_o = probe.note(names.v_o, v_o);
        let t = v_o / v_d;
        let side = if v_d < 0.0 { Side::Front } else { Side::Back };
        let has_point = (ray.origin + ray.direction * t).is_finite();
        has_point.then(|| PlaneHit { t: probe.note(names.t, t), side })
    })();
    if found.is_none() {
        probe.mark(Decision::Miss { why: Miss::Parallel });
    }
    found
}

/// The same, with twice the digits where f64 has lost too many; `doubled` is what the distance is called then.
#[inline]
pub(super) fn meet_plane_certainly<P: Probe>(
    ray: &Ray,
    normal: DVec3,
    corner: DVec3,
    (names, doubled): (&PlaneNames, Name),
    probe: &mut P,
) -> Option<PlaneHit> {
    if !(probe.certifies() && is_in_doubt_along(ray, normal, corner)) {
        return meet_plane(ray, normal, corner, names, probe);
    }
    probe.fallback();
    let t = refined(ray, normal, corner).value();
    let v_d = dot(normal, ray.vector, 0.0).head;
    if v_d == 0.0 || !(ray.origin + ray.direction * t).is_finite() {
        probe.mark(Decision::Miss { why: Miss::Parallel });
        return None;
    }
    let side = if v_d < 0.0 { Side::Front } else { Side::Back };
    Some(PlaneHit { t: probe.note(doubled, t), side })
}

/// The distance `t` along the ray to the plane, before an arithmetic of its own made something else of it.
#[inline]
pub(super) fn unaltered<P: Probe>(t: f64, ray: &Ray, normal: DVec3, corner: DVec3, probe: &P) -> f64 {
    if probe.certifies() { t } else { probe.dot(normal, corner - ray.origin) / probe.dot(normal, ray.direction) }
}

/// The distance, kept within the box around the shape. Along the shape's plane V_o/V_d is a quotient of rounding errors,
/// which may lie anywhere; kept in the box it can't be at odds with the trees of boxes, whatever the order of the tests.
///
/// `quotient` is the distance as it was computed, `t` what an arithmetic of its own has made of it.
#[inline]
pub(super) fn kept_in_box<P: Probe>(
    bounds: Bounds,
    ray: &Ray,
    t: f64,
    quotient: f64,
    names: &BoxNames,
    probe: &mut P,
) -> Option<f64> {
    if is_surely_within(bounds, ray, quotient) {
        return Some(t);
    }
    kept_in_interval(bounds, ray, t, quotient, names, probe)
}

/// Whether the point at this distance lies so clearly within the widened box that the distance is between those where the ray enters and
/// leaves it.
///
/// The box is wider by 16 roundings of its largest coordinate. The point on the other hand errs by one of the product and one of the sum,
/// which are at most two of |O| + 2·|P|. A side of the box that the exact point doesn't pass isn't passed before t by what
/// [`Bounds::interval`] computes either, which errs to the outside.
#[inline(always)]
fn is_surely_within(bounds: Bounds, ray: &Ray, t: f64) -> bool {
    let Bounds { min, max } = bounds;
    let point = ray.origin + ray.direction * t;
    let largest = min.abs().max(max.abs()).max_element();
    let of_point = ray.origin.abs().max_element() + 2.0 * point.abs().max_element();
    let margin = margin_of(largest, of_point);
    point.cmpge(min - margin).all() && point.cmple(max + margin).all()
}

/// How far beyond the box a point may seem to lie and is surely within the widened one. What is left of the 16 roundings is for those of the
/// sides.
#[inline(always)]
pub(super) fn margin_of(largest: f64, of_point: f64) -> f64 {
    const ROUNDING: f64 = 0.5 * f64::EPSILON;
    (12.0 * largest - 2.0 * of_point) * ROUNDING
}

/// The rest of [`kept_in_box`].
#[inline(never)]
fn kept_in_interval<P: Probe>(
    bounds: Bounds,
    ray: &Ray,
    t: f64,
    quotient: f64,
    names: &BoxNames,
    probe: &mut P,
) -> Option<f64> {
    let [near, far] = bounds.widened().interval(&Slabs::new(ray));
    if near > far {
        probe.mark(Decision::Miss { why: Miss::Beside });
        return None;
    }
    if near <= quotient && quotient <= far {
        return Some(t);
    }
    probe.given(names.near, near);
    probe.given(names.far, far);
    Some(probe.note(names.t, t.max(near).min(far)))
}

/// Whether the distance to the plane through `corner` has lost digits.
#[inline]
pub(super) fn is_in_doubt_along(ray: &Ray, normal: DVec3, corner: DVec3) -> bool {
    let to_corner = corner - ray.origin;
    let sum = |vector: DVec3| Sum { value: normal.dot(vector), terms: normal.abs().dot(vector.abs()) };
    is_distance_in_doubt(sum(to_corner), sum(ray.direction), ray)
}

/// The distance V_o/V_d of [`meet_plane`] with twice the digits.
pub(super) fn refined(ray: &Ray, normal: DVec3, corner: DVec3) -> Doubled {
    let normal = Doubled3::from(normal);
    let to_corner = Doubled3::difference(corner, ray.origin);
    normal.dot(to_corner) * length(ray.vector) / normal.dot(Doubled3::from(ray.vector))
}

/// A sum of products.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sum {
    /// The sum in f64.
    pub value: f64,
    /// The sum of the products' magnitudes, which its rounding errors are parts of.
    pub terms: f64,
}

impl Sum {
    /// Whether it is at least this part of its terms.
    #[inline(always)]
    fn keeps(self, part: f64) -> bool {
        self.value.abs() >= part * self.terms
    }
}

/// The part of a sum's terms that its value is with all of its digits: each term errs by two roundings or three.
pub(super) const LEAST_KEPT: f64 = 0.75;

/// The part of a sum's terms that its value is with half of its digits.
pub(super) const HALF: f64 = 1.0 / (1 << 20) as f64;

/// Whether the distance V_o/V_d has lost digits because the terms of a sum cancel, and half of them aren't enough.
#[inline(always)]
pub(super) fn is_distance_in_doubt(v_o: Sum, v_d: Sum, ray: &Ray) -> bool {
    let has_all = v_o.keeps(LEAST_KEPT) && v_d.keeps(LEAST_KEPT);
    !(has_all || (v_o.keeps(HALF) && v_d.keeps(HALF) && ray.is_settled_by_half(v_o.value / v_d.value)))
}

/// The unit normal toward the arriving ray, noted under the name for its side.
#[inline]
pub(super) fn toward<P: Probe>(side: Side, unit_normal: DVec3, front: Name, back: Name, probe: &mut P) -> DVec3 {
    match side {
        Side::Front => probe.note(front, unit_normal),
        Side::Back => probe.note(back, -unit_normal),
    }
}
