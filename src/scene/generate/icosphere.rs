//! A ball of triangles: an icosahedron whose faces are cut into four, level by level.

use std::collections::HashMap;

use glam::DVec3;

use crate::geometry::mesh::{CornerNormals, Mesh};

/// The ball of radius 1 about the origin, closed, its normals pointing away from the origin. It has 20·4^`level`
/// triangles.
pub fn icosphere(level: u32) -> Mesh {
    let (mut corners, mut faces) = icosahedron();
    for _ in 0..level {
        // The middle of each edge, which two faces share, by its ends.
        let mut middles = HashMap::with_capacity(faces.len() * 3 / 2);
        let mut cut = Vec::with_capacity(faces.len() * 4);
        for [a, b, c] in faces {
            let [ab, bc, ca] = [[a, b], [b, c], [c, a]]
                .map(|[from, to]| middle(from.min(to), from.max(to), &mut corners, &mut middles));
            cut.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        faces = cut;
    }
    let normals = CornerNormals { vectors: corners.clone(), faces: faces.clone() };
    Mesh { positions: corners, normals: Some(normals), faces }
}

fn middle(from: u32, to: u32, corners: &mut Vec<DVec3>, middles: &mut HashMap<(u32, u32), u32>) -> u32 {
    *middles.entry((from, to)).or_insert_with(|| {
        corners.push(unit(corners[from as usize] + corners[to as usize]));
        corners.len() as u32 - 1
    })
}

/// Twelve corners of three golden rectangles, and the twenty faces between them.
fn icosahedron() -> (Vec<DVec3>, Vec<[u32; 3]>) {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let signs = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)];
    let mut corners = Vec::new();
    corners.extend(signs.map(|(s, t)| unit(DVec3::new(0.0, s, t * golden))));
    corners.extend(signs.map(|(s, t)| unit(DVec3::new(s, t * golden, 0.0))));
    corners.extend(signs.map(|(s, t)| unit(DVec3::new(t * golden, 0.0, s))));
    let faces = faces_of_nearest(&corners);
    (corners, faces)
}

/// The triangles between corners that are next to each other, counter-clockwise seen from outside.
fn faces_of_nearest(corners: &[DVec3]) -> Vec<[u32; 3]> {
    // The edge is as long as the shorter side of the golden rectangles; the next distance is 1.6 times as great.
    let edge = corners[0].distance(corners[1]) * 1.3;
    let count = corners.len();
    let are_near = |a: usize, b: usize| corners[a].distance(corners[b]) < edge;
    let mut faces = Vec::new();
    for a in 0..count {
        for b in a + 1..count {
            for c in b + 1..count {
                if are_near(a, b) && are_near(b, c) && are_near(c, a) {
                    let is_outward = corners[a].dot(corners[b].cross(corners[c])) > 0.0;
                    let [b, c] = if is_outward { [b, c] } else { [c, b] };
                    faces.push([a, b, c].map(|corner| corner as u32));
                }
            }
        }
    }
    faces
}

fn unit(vector: DVec3) -> DVec3 {
    vector / vector.length()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn it_is_closed_and_faces_outward() {
        for level in 0..4 {
            let mesh = icosphere(level);
            assert_eq!(mesh.faces.len(), 20 << (2 * level));
            assert_eq!(mesh.positions.len(), 2 + mesh.faces.len() / 2);
            crate::scene::generate::testing::is_closed(&mesh);
            for triangle in 0..mesh.faces.len() as u32 {
                let [a, b, c] = mesh.corners(triangle);
                assert!((b - a).cross(c - a).dot(a + b + c) > 0.0);
            }
        }
    }
}
