//! The little arithmetic that checks need. It decides nothing about a picture.

use crate::scene::file::schema::Vec3;

/// How far from zero the sine between two vectors must be for them to span a plane: a few roundings.
const NO_SINE: f64 = 4.0 * f64::EPSILON;

pub fn minus(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

pub fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub fn length(a: Vec3) -> f64 {
    dot(a, a).sqrt()
}

/// The largest component in size.
pub fn size(a: Vec3) -> f64 {
    a.iter().fold(0.0, |size, component| component.abs().max(size))
}

/// The vector divided by a number.
pub fn over(a: Vec3, divisor: f64) -> Vec3 {
    a.map(|component| component / divisor)
}

/// Whether two vectors, neither of them zero, have (nearly) one direction or opposite ones.
pub fn are_parallel(a: Vec3, b: Vec3) -> bool {
    let (a, b) = (over(a, size(a)), over(b, size(b)));
    let sine = length(cross(a, b)) / (length(a) * length(b));
    sine.is_nan() || sine <= NO_SINE
}

/// Twice the area vector of a polygon whose first corner is the origin.
pub fn twice_area(corners: impl Iterator<Item = Vec3> + Clone) -> Vec3 {
    let mut sum = [0.0; 3];
    for (corner, next) in corners.clone().zip(corners.skip(1)) {
        let part = cross(corner, next);
        sum = std::array::from_fn(|axis| sum[axis] + part[axis]);
    }
    sum
}

/// Whether a polygon of three or more corners spans an area, rather than a line or a point.
pub fn has_area(vertices: &[Vec3]) -> bool {
    if let [a, b, c] = *vertices {
        let (first, second) = (minus(b, a), minus(c, a));
        return size(first) > 0.0 && size(second) > 0.0 && !are_parallel(first, second);
    }
    let extent = vertices.iter().map(|vertex| size(minus(*vertex, vertices[0]))).fold(0.0, f64::max);
    let corners = vertices.iter().map(|vertex| over(minus(*vertex, vertices[0]), extent));
    // As accurate as the rounding of this many sums.
    length(twice_area(corners)) > 4.0 * f64::EPSILON * vertices.len() as f64
}

/// Whether the rows are those of a proper rotation: orthonormal, determinant +1, within the tolerance.
pub fn is_proper_rotation(rows: &[Vec3; 3], tolerance: f64) -> bool {
    let is_near = |value: f64, wanted: f64| (value - wanted).abs() <= tolerance;
    let is_orthonormal = (0..3).all(|i| (0..3).all(|j| is_near(dot(rows[i], rows[j]), if i == j { 1.0 } else { 0.0 })));
    let determinant = dot(rows[0], cross(rows[1], rows[2]));
    is_orthonormal && determinant > 0.0
}
