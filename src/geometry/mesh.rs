//! Meshes as data: corners and the triangles between them.

use crate::threads::share;
use glam::DVec3;
use rayon::prelude::*;
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

/// Whether each edge of some triangles is run an even number of times, and whether it is run as often either way.
fn balance(faces: &[[u32; 3]]) -> (bool, bool) {
    let mut edges = Vec::with_capacity(3 * faces.len());
    for [a, b, c] in faces {
        let sides = [(a, b), (b, c), (c, a)].into_iter().filter(|(from, to)| from != to);
        edges.extend(sides.map(|(from, to)| (from.min(to), from.max(to), from < to)));
    }
    share(edges.len(), || edges.par_sort_unstable());
    let runs = || edges.chunk_by(|one, other| (one.0, one.1) == (other.0, other.1));
    let is_closed = !edges.is_empty() && runs().all(|run| run.len() % 2 == 0);
    let is_consistent = is_closed && runs().all(|run| 2 * run.iter().filter(|edge| edge.2).count() == run.len());
    (is_closed, is_consistent)
}

impl Mesh {
    /// Whether the triangles enclose a solid, and on which side of them it lies.
    ///
    /// Corners are compared by their places, since files repeat them where normals or textures differ. A mesh is closed where
    /// each edge is run an even number of times, and wound consistently where it is run as often either way. The sign of its volume says which
    /// way its fronts face.
    pub fn winding(&self) -> Winding {
        let (mut is_closed, mut is_consistent) = balance(&self.faces);
        if !is_consistent {
            (is_closed, is_consistent) = balance(&self.welded_faces());
        }
        let origin = self.positions.first().copied().unwrap_or_default();
        let six_volumes: f64 = (0..self.faces.len() as u32)
            .map(|triangle| {
                let [a, b, c] = self.corners(triangle).map(|corner| corner - origin);
                a.dot(b.cross(c))
            })
            .sum();
        match (is_closed, is_consistent) {
            (false, _) => Winding::Open,
            (true, false) => Winding::Mixed,
            (true, true) if six_volumes < 0.0 => Winding::Inward,
            (true, true) => Winding::Outward,
        }
    }

    /// The triangles by the places of their corners, each named by the first corner there.
    fn welded_faces(&self) -> Vec<[u32; 3]> {
        // Adding zero makes −0 the same place as 0.
        let place = |corner: u32| (self.positions[corner as usize] + DVec3::ZERO).to_array().map(f64::to_bits);
        let mut first: HashMap<[u64; 3], u32> = HashMap::new();
        let mut weld = |corner: u32| *first.entry(place(corner)).or_insert(corner);
        self.faces.iter().map(|corners| corners.map(&mut weld)).collect()
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

    /// Whether a triangle has no area: two of its corners are one, or all three lie on a line.
    pub fn is_degenerate(&self, triangle: u32) -> bool {
        let [a, b, c] = self.corners(triangle);
        let (ab, ac) = (b - a, c - a);
        // Brought to size 1, so that neither huge nor tiny triangles lose their area by over- or underflow.
        let size = ab.abs().max(ac.abs()).max_element();
        // Without a division where the area is beyond doubt.
        if (1e-100..1e100).contains(&size) && ab.cross(ac).abs().max_element() > size * size * 1e-10 {
            return false;
        }
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

    /// A tetrahedron with these triangles turned over, and without its last few.
    #[track_caller]
    fn is_wound(turned: &[usize], missing: usize, expected: Winding) {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let mut faces = vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
        turned.iter().for_each(|face| faces[*face].reverse());
        faces.truncate(4 - missing);
        // Each triangle with corners of its own, as files with normals have them, far from the origin.
        let positions =
            faces.iter().flatten().map(|corner: &u32| corners[*corner as usize] - DVec3::splat(1e3)).collect();
        let faces = (0..faces.len() as u32).map(|face| [3 * face, 3 * face + 1, 3 * face + 2]).collect();
        assert_eq!(Mesh { positions, normals: None, faces }.winding(), expected);
    }

    #[test]
    fn which_way_a_mesh_is_wound() {
        is_wound(&[], 0, Winding::Outward);
        is_wound(&[0, 1, 2, 3], 0, Winding::Inward);
        is_wound(&[1], 0, Winding::Mixed);
        is_wound(&[], 1, Winding::Open);
        is_wound(&[0, 1, 2, 3], 4, Winding::Open);
    }

    #[test]
    fn small_and_thin_triangles_have_an_area() {
        degenerates([[0.0; 3], [1e-200, 0.0, 0.0], [0.0, 1e-200, 0.0]], false);
        degenerates([[0.0; 3], [1e200, 0.0, 0.0], [0.0, 1e200, 0.0]], false);
        degenerates([[0.0; 3], [1.0, 0.0, 0.0], [0.5, 1e-15, 0.0]], false);
    }
}
