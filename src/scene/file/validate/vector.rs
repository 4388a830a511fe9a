//! The little geometry that checks need. It decides nothing about a picture.

use crate::scene::file::schema::Vec3;
use glam::DVec3;

/// How far from zero the sine between two vectors must be for them to span a plane: a few roundings.
const NO_SINE: f64 = 4.0 * f64::EPSILON;

/// The largest component in size.
pub fn size(a: impl Into<DVec3>) -> f64 {
    a.into().abs().max_element()
}

/// The [`size`] of the way between two points.
pub fn distance(a: Vec3, b: Vec3) -> f64 {
    size(DVec3::from(a) - DVec3::from(b))
}

/// Whether two vectors, neither of them zero, have (nearly) one direction or opposite ones.
pub fn are_parallel(a: impl Into<DVec3>, b: impl Into<DVec3>) -> bool {
    let [a, b] = [a.into(), b.into()].map(|vector: DVec3| vector / size(vector));
    let sine = a.cross(b).length() / (a.length() * b.length());
    sine.is_nan() || sine <= NO_SINE
}

/// Whether two vectors are at right angles, as far as the digits of a file tell: to a millionth.
pub fn are_perpendicular(u: Vec3, v: Vec3) -> bool {
    let [u, v] = [u, v].map(DVec3::from);
    u.dot(v).abs() <= 1e-6 * (u.length() * v.length())
}

/// How far the farthest corner of a polygon is from its first one, and the corners from there in that unit.
pub fn in_own_unit(vertices: &[Vec3]) -> (f64, impl Iterator<Item = DVec3> + Clone) {
    let extent = vertices.iter().map(|vertex| distance(*vertex, vertices[0])).fold(0.0, f64::max);
    let first = DVec3::from(vertices[0]);
    (extent, vertices.iter().map(move |vertex| (DVec3::from(*vertex) - first) / extent))
}

/// Twice the area vector of a polygon whose first corner is the origin.
pub fn twice_area(corners: impl Iterator<Item = DVec3> + Clone) -> DVec3 {
    corners.clone().zip(corners.skip(1)).map(|(corner, next)| corner.cross(next)).sum()
}

/// Whether a polygon of three or more corners spans an area, rather than a line or a point.
pub fn has_area(vertices: &[Vec3]) -> bool {
    if let [a, b, c] = *vertices {
        let [a, b, c] = [a, b, c].map(DVec3::from);
        return size(b - a) > 0.0 && size(c - a) > 0.0 && !are_parallel(b - a, c - a);
    }
    // As accurate as the rounding of this many sums.
    twice_area(in_own_unit(vertices).1).length() > 4.0 * f64::EPSILON * vertices.len() as f64
}

/// Whether the rows are those of a proper rotation: orthonormal, determinant +1, within the tolerance.
pub fn is_proper_rotation(rows: &[Vec3; 3], tolerance: f64) -> bool {
    let rows = rows.map(DVec3::from);
    let is_near = |value: f64, wanted: f64| (value - wanted).abs() <= tolerance;
    let is_orthonormal = (0..3).all(|i| (0..3).all(|j| is_near(rows[i].dot(rows[j]), if i == j { 1.0 } else { 0.0 })));
    let determinant = rows[0].dot(rows[1].cross(rows[2]));
    is_orthonormal && determinant > 0.0
}
