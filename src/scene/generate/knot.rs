//! A knot of triangles: a round tube about a curve that winds around a torus.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::geometry::mesh::{CornerNormals, Mesh};

/// How often the curve goes around the torus's axis, and around its tube.
const WINDINGS: (f64, f64) = (2.0, 3.0);
/// The radii of the torus: to the middle of its tube, and of the tube.
const TORUS: (f64, f64) = (1.0, 0.45);
/// The radius of the tube about the curve.
const RADIUS: f64 = 0.2;

/// The knot about the origin, closed, at most 1.65 away from it and 0.65 high and deep along z, with the normals of the
/// round tube. It has 256·4^`level` triangles.
pub fn knot(level: u32) -> Mesh {
    let (along, around) = (32_u32 << level, 4_u32 << level);
    let mut positions = Vec::new();
    let mut vectors = Vec::new();
    for step in 0..along {
        let place = Place::on_curve(TAU * f64::from(step) / f64::from(along));
        for spoke in 0..around {
            let (sine, cosine) = libm::sincos(TAU * f64::from(spoke) / f64::from(around));
            let normal = place.outward * cosine + place.sideways * sine;
            positions.push(place.point + normal * RADIUS);
            vectors.push(normal);
        }
    }
    let corner = |step: u32, spoke: u32| (step % along) * around + spoke % around;
    let mut faces = Vec::new();
    for step in 0..along {
        for spoke in 0..around {
            let [a, b] = [corner(step, spoke), corner(step + 1, spoke)];
            let [c, d] = [corner(step + 1, spoke + 1), corner(step, spoke + 1)];
            faces.extend([[a, c, b], [a, d, c]]);
        }
    }
    Mesh { positions, normals: Some(CornerNormals { vectors, faces: faces.clone() }), faces }
}

/// A place on the curve, with two unit vectors across it.
struct Place {
    point: DVec3,
    /// The normal of the torus there, which is across the curve because the curve lies on the torus.
    outward: DVec3,
    sideways: DVec3,
}

impl Place {
    fn on_curve(angle: f64) -> Place {
        let ((around_axis, around_tube), (large, small)) = (WINDINGS, TORUS);
        let (axis_sine, axis_cosine) = libm::sincos(around_axis * angle);
        let (tube_sine, tube_cosine) = libm::sincos(around_tube * angle);
        let away = DVec3::new(axis_cosine, axis_sine, 0.0);
        let onward = DVec3::new(-axis_sine, axis_cosine, 0.0);
        let outward = away * tube_cosine + DVec3::Z * tube_sine;
        let up_tube = DVec3::Z * tube_cosine - away * tube_sine;
        let distance = large + small * tube_cosine;
        let tangent = onward * (distance * around_axis) + up_tube * (small * around_tube);
        let sideways = tangent.cross(outward) / tangent.length();
        Place { point: away * large + outward * small, outward, sideways }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn it_is_closed_and_faces_outward() {
        for level in 1..3 {
            let mesh = knot(level);
            assert_eq!(mesh.faces.len(), 256 << (2 * level));
            crate::scene::generate::testing::is_closed(&mesh);
            for triangle in 0..mesh.faces.len() as u32 {
                let [a, b, c] = mesh.corners(triangle);
                let normals: DVec3 = mesh.corner_normals(triangle).unwrap().into_iter().sum();
                assert!((b - a).cross(c - a).dot(normals) > 0.0, "{triangle}");
            }
        }
    }

    #[test]
    fn it_stays_in_its_box() {
        for position in knot(2).positions {
            assert!(position.truncate().length() < 1.65 + 1e-9 && position.z.abs() < 0.65 + 1e-9, "{position}");
        }
    }
}
