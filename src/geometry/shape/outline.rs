//! Lines that show where a shape is, for drawings. They decide nothing and needn't be exact.

use super::Shape;
use super::axis::Axis;
use super::intersect::Intersect;
use crate::geometry::bounds::Bounds;
use glam::DVec3;
use std::f64::consts::TAU;

/// A line through these points.
pub type Polyline = Vec<DVec3>;

/// The corners of a circle.
const CORNERS: u32 = 32;

/// The most triangles of a mesh that are drawn.
const MOST_TRIANGLES: usize = 256;

/// The lines along the plane in each direction.
const LINES: u32 = 7;

impl Shape {
    /// Lines along the surface; of a plane, those inside the box `within`. A moving shape is where it is at time 0.
    pub fn outline(&self, within: &Bounds) -> Vec<Polyline> {
        match self {
            Shape::Plane(plane) => grid(plane.normal, plane.offset, within),
            Shape::Sphere(sphere) => {
                great_circles(sphere.center, [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| axis * sphere.radius))
            }
            Shape::Ellipsoid(ellipsoid) => great_circles(ellipsoid.center, ellipsoid.half_axes()),
            Shape::Triangle(triangle) => vec![closed(vec![triangle.facet.a, triangle.facet.b, triangle.facet.c])],
            Shape::Polygon(polygon) => vec![closed(polygon.corners.to_vec())],
            Shape::Cuboid(_) => self.bounds().map(|bounds| edges(&bounds)).unwrap_or_default(),
            Shape::Cylinder(cylinder) => tube(&cylinder.axis, [cylinder.radius; 2]),
            Shape::Cone(cone) => tube(&cone.axis, [cone.base_radius, cone.apex_radius]),
            Shape::Disk(disk) => {
                let [u, v] = across(disk.unit_normal);
                vec![circle(disk.center, u * disk.radius, v * disk.radius)]
            }
            Shape::Mesh(mesh) => {
                let mesh = mesh.mesh();
                let step = mesh.faces.len().div_ceil(MOST_TRIANGLES).max(1);
                let triangles = (0..mesh.faces.len()).step_by(step);
                triangles.map(|triangle| closed(mesh.corners(triangle as u32).to_vec())).collect()
            }
            Shape::Moving(moving) => moving.shape().outline(within),
        }
    }
}

/// Two unit vectors across another one and each other.
fn across(unit: DVec3) -> [DVec3; 2] {
    let first = unit.any_orthonormal_vector();
    [first, unit.cross(first)]
}

fn closed(mut corners: Polyline) -> Polyline {
    corners.extend(corners.first().copied());
    corners
}

/// The ellipse around a centre with these half axes.
pub fn circle(center: DVec3, u: DVec3, v: DVec3) -> Polyline {
    let corner = |k: u32| {
        let (sine, cosine) = libm::sincos(TAU * f64::from(k) / f64::from(CORNERS));
        center + u * cosine + v * sine
    };
    (0..=CORNERS).map(corner).collect()
}

fn great_circles(center: DVec3, [u, v, w]: [DVec3; 3]) -> Vec<Polyline> {
    vec![circle(center, u, v), circle(center, v, w), circle(center, w, u)]
}

/// The circles at both ends of an axis, and four lines between them.
fn tube(axis: &Axis, [base_radius, apex_radius]: [f64; 2]) -> Vec<Polyline> {
    let [u, v] = across(axis.direction);
    let mut lines =
        vec![circle(axis.base, u * base_radius, v * base_radius), circle(axis.apex, u * apex_radius, v * apex_radius)];
    let sides = [u, v, -u, -v];
    lines.extend(sides.map(|side| vec![axis.base + side * base_radius, axis.apex + side * apex_radius]));
    lines
}

fn edges(bounds: &Bounds) -> Vec<Polyline> {
    let corners: Vec<DVec3> = bounds.corners().collect();
    let pairs =
        (0..8_usize).flat_map(|from| [1, 2, 4].map(move |bit| (from, from | bit))).filter(|(from, to)| from != to);
    pairs.map(|(from, to)| vec![corners[from], corners[to]]).collect()
}

/// Lines along the plane N·P + D = 0, as far as they lie in the box.
fn grid(normal: DVec3, offset: f64, within: &Bounds) -> Vec<Polyline> {
    let (size, squared) = (normal.length(), normal.dot(normal));
    if squared == 0.0 || !within.center().is_finite() {
        return Vec::new();
    }
    let [u, v] = across(normal / size);
    let center = within.center();
    let foot = center - normal * ((normal.dot(center) + offset) / squared);
    let reach = (within.max - within.min).length() / 2.0;
    let place = |k: u32| reach * (2.0 * f64::from(k) / f64::from(LINES - 1) - 1.0);
    let line = |from: DVec3, way: DVec3| clipped(from, way, within);
    let along = |k: u32| [line(foot + v * place(k), u), line(foot + u * place(k), v)];
    (0..LINES).flat_map(along).flatten().collect()
}

/// The part of a line inside a box.
fn clipped(point: DVec3, way: DVec3, within: &Bounds) -> Option<Polyline> {
    let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
    for axis in 0..3 {
        if way[axis] == 0.0 {
            if point[axis] < within.min[axis] || point[axis] > within.max[axis] {
                return None;
            }
            continue;
        }
        let ends = [within.min, within.max].map(|corner| (corner[axis] - point[axis]) / way[axis]);
        (near, far) = (near.max(ends[0].min(ends[1])), far.min(ends[0].max(ends[1])));
    }
    (near < far).then(|| vec![point + way * near, point + way * far])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::shape::{
        Cone, Cuboid, Cylinder, Disk, Ellipsoid, Plane, Polygon, Sphere, SphereMethod, Triangle,
    };

    /// Every point of the lines is on the surface, as far as rounding goes: a ray to it from outside hits something there.
    #[track_caller]
    fn lies_on(shape: &Shape, is_on: impl Fn(DVec3) -> bool) {
        let box_around = Bounds { min: DVec3::splat(-5.0), max: DVec3::splat(5.0) };
        let lines = shape.outline(&box_around);
        assert!(!lines.is_empty());
        for point in lines.iter().flatten() {
            assert!(is_on(*point), "{point} of {shape:?}");
        }
    }

    #[test]
    fn lines_lie_on_their_shapes() {
        let near = |value: f64, expected: f64| (value - expected).abs() < 1e-12;
        let (center, up) = (DVec3::new(1.0, -2.0, 0.5), DVec3::Y);
        lies_on(&Shape::Sphere(Sphere::new(center, 2.0, false, SphereMethod::Robust)), |point| {
            near((point - center).length(), 2.0)
        });
        let radii = DVec3::new(1.0, 2.0, 3.0);
        lies_on(&Shape::Ellipsoid(Box::new(Ellipsoid::new(center, radii, None))), |point| {
            near(((point - center) / radii).length(), 1.0)
        });
        lies_on(&Shape::Plane(Plane::new([1.0, 2.0, 2.0, -3.0])), |point| {
            near(point.dot(DVec3::new(1.0, 2.0, 2.0)), 3.0) && point.abs().max_element() <= 5.0 + 1e-12
        });
        let round = |point: DVec3, radius: f64| near(((point - center) * (DVec3::ONE - up)).length(), radius);
        lies_on(&Shape::Cylinder(Box::new(Cylinder::new(center, center + up, 0.5, true, false))), |point| {
            round(point, 0.5)
        });
        lies_on(&Shape::Cone(Box::new(Cone::new((center, 0.5), (center + up, 0.0), true, false))), |point| {
            round(point, 0.5 * (1.0 - (point - center).y))
        });
        lies_on(&Shape::Disk(Box::new(Disk::new(center, up, 3.0))), |point| {
            round(point, 3.0) && near(point.y, center.y)
        });
        let corners = [[0.0; 3], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]];
        let is_corner = |point: DVec3| corners.contains(&point.to_array());
        lies_on(&Shape::Triangle(Box::new(Triangle::new(corners, None))), is_corner);
        lies_on(&Shape::Polygon(Box::new(Polygon::new(&corners, None))), is_corner);
        let cuboid = Shape::Cuboid(Cuboid::new(DVec3::ZERO, DVec3::ONE));
        lies_on(&cuboid, |point| point.abs().max_element() <= 1.0);
        assert_eq!(cuboid.outline(&Bounds::EMPTY).len(), 12);
    }
}
