//! Meshes as data: corners and the triangles between them.

use super::bounds::Bounds;
use glam::DVec3;

pub use super::shape::polygon::triangulate;

/// Triangles that share corners. Triangle `k` is the face with that number, which is its number in the mesh file; faces
/// without area keep theirs and are never met.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// The corners.
    pub positions: Vec<DVec3>,
    /// Normals for smooth shading, if every corner of every triangle has one.
    pub normals: Option<CornerNormals>,
    /// The triangles, each by the numbers of its corners, counter-clockwise seen from the front.
    pub faces: Vec<[u32; 3]>,
}

/// The normals at the corners of a mesh's triangles. Two triangles may see different normals at a corner that they share.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CornerNormals {
    /// The normals, of any length.
    pub vectors: Vec<DVec3>,
    /// For each triangle the numbers of its three normals.
    pub faces: Vec<[u32; 3]>,
}

impl Mesh {
    /// The corners of a triangle.
    #[inline(always)]
    pub fn corners(&self, triangle: u32) -> [DVec3; 3] {
        let [a, b, c] = self.faces[triangle as usize];
        [self.positions[a as usize], self.positions[b as usize], self.positions[c as usize]]
    }

    /// The normals at the corners of a triangle.
    pub fn corner_normals(&self, triangle: u32) -> Option<[DVec3; 3]> {
        let normals = self.normals.as_ref()?;
        Some(normals.faces[triangle as usize].map(|normal| normals.vectors[normal as usize]))
    }

    /// The box around a triangle.
    pub fn bounds_of(&self, triangle: u32) -> Bounds {
        Bounds::around(self.corners(triangle))
    }

    /// Whether a triangle has no area: two of its corners are one, or all three lie on a line.
    pub fn is_degenerate(&self, triangle: u32) -> bool {
        let [a, b, c] = self.corners(triangle);
        let (ab, ac) = (b - a, c - a);
        // Brought to size 1, so that neither huge nor tiny triangles lose their area by over- or underflow.
        let size = ab.abs().max(ac.abs()).max_element();
        let twice_area = (ab / size).cross(ac / size);
        let has_area = size > 0.0 && size.is_finite() && twice_area.abs().max_element() > 0.0;
        !has_area
    }

    /// How many triangles have no area.
    pub fn degenerate_count(&self) -> usize {
        (0..self.faces.len() as u32).filter(|triangle| self.is_degenerate(*triangle)).count()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn degenerates(corners: [[f64; 3]; 3], expected: bool) {
        let positions = corners.map(DVec3::from).to_vec();
        let mesh = Mesh { positions, normals: None, faces: vec![[0, 1, 2]] };
        assert_eq!(mesh.is_degenerate(0), expected);
    }

    #[test]
    fn points_and_lines_have_no_area() {
        degenerates([[1.0, 2.0, 3.0]; 3], true);
        degenerates([[0.0; 3], [1.0, 1.0, 1.0], [2.0, 2.0, 2.0]], true);
        degenerates([[0.0; 3], [1.0, 1.0, 1.0], [0.0; 3]], true);
    }

    #[test]
    fn small_and_thin_triangles_have_an_area() {
        degenerates([[0.0; 3], [1e-200, 0.0, 0.0], [0.0, 1e-200, 0.0]], false);
        degenerates([[0.0; 3], [1e200, 0.0, 0.0], [0.0, 1e200, 0.0]], false);
        degenerates([[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-15, 0.0]], false);
    }
}
