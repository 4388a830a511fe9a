//! Meshes as data: corners and the triangles between them.

use super::bounds::Bounds;
use glam::DVec3;
use std::collections::HashMap;

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

/// How the triangles of a mesh are wound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Winding {
    /// The mesh is closed, and its fronts face outward.
    Outward,
    /// The mesh is closed, and its fronts face inward: it is inside out.
    Inward,
    /// The mesh is closed, but fronts face both ways.
    Mixed,
    /// The mesh has edges without a triangle on the other side.
    Open,
}

impl Mesh {
    /// Whether the triangles enclose a solid, and on which side of them it lies.
    ///
    /// Corners are compared by their places, since files repeat them where normals or textures differ. A mesh is closed where
    /// each edge is run an even number of times, and wound consistently where it is run as often either way. The sign of its volume says which
    /// way its fronts face.
    pub fn winding(&self) -> Winding {
        let mut places: HashMap<[u64; 3], u32> = HashMap::new();
        // Adding zero makes −0 the same place as 0.
        let place = |position: &DVec3| (*position + DVec3::ZERO).to_array().map(f64::to_bits);
        let welded: Vec<u32> = self
            .positions
            .iter()
            .map(|position| {
                let next = places.len() as u32;
                *places.entry(place(position)).or_insert(next)
            })
            .collect();
        // How often each edge is run from its lower to its higher end, and the other way.
        let mut edges: HashMap<(u32, u32), [u32; 2]> = HashMap::new();
        let mut six_volumes = 0.0;
        let Some(origin) = self.positions.first() else { return Winding::Open };
        for triangle in 0..self.faces.len() as u32 {
            let corners = self.faces[triangle as usize].map(|corner| welded[corner as usize]);
            let sides = [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (corners[from], corners[to]));
            for (from, to) in sides.into_iter().filter(|(from, to)| from != to) {
                edges.entry((from.min(to), from.max(to))).or_default()[usize::from(from > to)] += 1;
            }
            let [a, b, c] = self.corners(triangle).map(|corner| corner - *origin);
            six_volumes += a.dot(b.cross(c));
        }
        let is_closed = !edges.is_empty() && edges.values().all(|[up, down]| (up + down) % 2 == 0);
        let is_consistent = edges.values().all(|[up, down]| up == down);
        match (is_closed, is_consistent) {
            (false, _) => Winding::Open,
            (true, false) => Winding::Mixed,
            (true, true) if six_volumes < 0.0 => Winding::Inward,
            (true, true) => Winding::Outward,
        }
    }

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
