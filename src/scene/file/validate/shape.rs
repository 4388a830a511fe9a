//! The checks of the `shape` and `motion` of one of the `objects`.

use crate::scene::file::mesh_path::check_as_written;
use crate::scene::file::schema::{AxisBox, Cone, Ellipsoid, Motion, Polygon, Shape, Triangle, Vec3};

use super::checker::{Checker, number};
use super::limits::{MAX_COORDINATE, MAX_RATIO};
use super::vector::{distance, has_area, in_own_unit, is_proper_rotation, size, twice_area};

/// How exactly the rows of a rotation must be orthonormal.
const ROTATION_TOLERANCE: f64 = 1e-6;

/// How far, relative to its size, a polygon's corners may lie outside its plane without a warning.
const FLATNESS: f64 = 1e-6;

/// Checks a shape.
pub fn shape(mut check: Checker<'_>, shape: &Shape) {
    let mut check = check.at(shape.key());
    match shape {
        Shape::Plane(plane) => {
            let [a, b, c, d] = plane.coefficients;
            check.direction("coefficients", [a, b, c]);
            check.at("coefficients").finite(3, d);
        }
        Shape::Sphere(sphere) => {
            check.point("center", sphere.center);
            check.positive("radius", sphere.radius);
        }
        Shape::Ellipsoid(each) => ellipsoid(check, each),
        Shape::Triangle(each) => triangle(check, each),
        Shape::Polygon(each) => polygon(check, each),
        Shape::Box(each) => axis_box(check, each),
        Shape::Cylinder(cylinder) => {
            axis(&mut check, cylinder.base, cylinder.apex);
            check.positive("radius", cylinder.radius);
        }
        Shape::Cone(each) => cone(check, each),
        Shape::Disk(disk) => {
            check.point("center", disk.center);
            check.direction("normal", disk.normal);
            check.positive("radius", disk.radius);
        }
        Shape::Mesh(mesh) => {
            if let Err(problem) = check_as_written(&mesh.path) {
                check.at("path").error(problem);
            }
        }
    }
}

/// Checks a motion; at all of these times the object must be within reach of the numbers.
pub fn motion(mut check: Checker<'_>, motion: &Motion, times: &[f64]) {
    check.point("translation", motion.translation);
    let farthest = times.iter().map(|time| size(motion.translation) * time.abs()).fold(0.0, f64::max);
    if size(motion.translation) <= MAX_COORDINATE && farthest > MAX_COORDINATE {
        let message = format!("must lead at most 1e100 away while the shutter is open, found {}", number(farthest));
        check.at("translation").error(message);
    }
    if let Some(rotation) = &motion.rotation {
        let mut check = check.at("rotation");
        check.direction("axis", rotation.axis);
        check.point("point", rotation.point);
        check.finite("degrees", rotation.degrees);
    }
}

fn ellipsoid(mut check: Checker<'_>, ellipsoid: &Ellipsoid) {
    check.point("center", ellipsoid.center);
    check.positive_each("radii", ellipsoid.radii);
    let Some(rows) = &ellipsoid.rotation else {
        return;
    };
    if !is_proper_rotation(rows, ROTATION_TOLERANCE) {
        check.at("rotation").error(
            "must be a proper rotation (rows of length 1, perpendicular, right-handed), found another matrix"
                .to_string(),
        );
    }
}

fn triangle(mut check: Checker<'_>, triangle: &Triangle) {
    let are_finite = points(check.at("vertices"), &triangle.vertices);
    if are_finite && !has_area(&triangle.vertices) {
        let message = "must not lie on one line, found a triangle without area";
        check.at("vertices").error(message.to_string());
    }
    if let Some(normals) = &triangle.normals {
        directions(check.at("normals"), &normals[..]);
    }
}

fn polygon(mut check: Checker<'_>, polygon: &Polygon) {
    let vertices = &polygon.vertices;
    let are_finite = points(check.at("vertices"), vertices);
    if vertices.len() < 3 {
        let message = format!("must be 3 or more, found {}", vertices.len());
        check.at("vertices").error(message);
    } else if are_finite {
        flatness(check.at("vertices"), vertices);
    }
    let Some(normals) = &polygon.normals else {
        return;
    };
    directions(check.at("normals"), normals);
    if normals.len() != vertices.len() {
        let message = format!("must be one for each of the {} vertices, found {}", vertices.len(), normals.len());
        check.at("normals").error(message);
    }
}

/// A polygon needs an area, and should be flat.
fn flatness(mut check: Checker<'_>, vertices: &[Vec3]) {
    if !has_area(vertices) {
        return check.error("must span an area, found a polygon without".to_string());
    }
    let (extent, corners) = in_own_unit(vertices);
    let normal = twice_area(corners.clone());
    let area = normal.length();
    let height = corners.map(|corner| (corner.dot(normal) / area).abs()).fold(0.0, f64::max);
    if height > FLATNESS {
        check.warning(format!("should lie in one plane, found one {} away from it", number(height * extent)));
    }
}

fn axis_box(mut check: Checker<'_>, axis_box: &AxisBox) {
    check.point("min", axis_box.min);
    check.point("max", axis_box.max);
    for axis in 0..3 {
        let (low, high) = (axis_box.min[axis], axis_box.max[axis]);
        if low >= high {
            let message = format!("must be greater than min[{axis}], {}, found {}", number(low), number(high));
            check.at("max").at(axis).error(message);
        }
    }
}

fn cone(mut check: Checker<'_>, cone: &Cone) {
    let has_axis = axis(&mut check, cone.base, cone.apex);
    let radii = [("base_radius", cone.base_radius), ("apex_radius", cone.apex_radius)];
    radii.into_iter().for_each(|(key, radius)| check.not_negative(key, radius));
    if cone.base_radius == 0.0 && cone.apex_radius == 0.0 {
        check.error("`base_radius` and `apex_radius` must not both be 0".to_string());
    }
    let has_radii = radii.iter().all(|(_, radius)| (0.0..=MAX_COORDINATE).contains(radius));
    let slope = (cone.apex_radius - cone.base_radius).abs() / distance(cone.apex, cone.base);
    if has_axis && has_radii && slope > MAX_RATIO {
        let found = number(slope);
        check.error(format!("its radius must change by at most {MAX_RATIO:e} a unit of its axis, found {found}"));
    }
}

/// Whether there is a direction from base to apex.
fn axis(check: &mut Checker<'_>, base: Vec3, apex: Vec3) -> bool {
    check.point("base", base);
    check.point_away("apex", apex, base, "the base")
}

/// Whether all points are finite.
fn points(mut check: Checker<'_>, points: &[Vec3]) -> bool {
    for (index, point) in points.iter().enumerate() {
        check.point(index, *point);
    }
    points.iter().flatten().all(|coordinate| coordinate.is_finite())
}

fn directions(mut check: Checker<'_>, directions: &[Vec3]) {
    for (index, direction) in directions.iter().enumerate() {
        check.direction(index, *direction);
    }
}
