//! The triangles of a mesh, as their kernel has them.

use crate::geometry::mesh::Mesh;
use crate::geometry::shape::quick::Corners;
use crate::geometry::shape::triangle::Facet;
use glam::DVec3;
use rayon::prelude::*;
use std::sync::Arc;

/// The triangles of a mesh with their normals.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Facets {
    pub mesh: Arc<Mesh>,
    pub normals: Normals,
}

/// The normals of the triangles, as [`Facet`] has them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Normals {
    /// Empty where there are copies.
    at_their_numbers: Vec<DVec3>,
    /// Those of the triangles that are copies of none, where there are copies,
    of_firsts: Vec<DVec3>,
    /// and for each triangle where its normal is among them.
    places: Vec<u32>,
}

impl Facets {
    /// A triangle by its number.
    #[inline(always)]
    pub fn get(&self, triangle: u32) -> Facet {
        let [a, b, c] = self.mesh.corners(triangle);
        Facet { a, b, c, normal: *self.normals.of(triangle) }
    }

    /// The same where its numbers lie in memory.
    #[inline(always)]
    pub fn corners(&self, triangle: u32) -> Corners<'_> {
        let [a, b, c] = self.mesh.faces[triangle as usize];
        let at = |corner: u32| &self.mesh.positions[corner as usize];
        Corners { corners: [at(a), at(b), at(c)], normal: self.normals.of(triangle) }
    }
}

impl Normals {
    /// Those of these triangles, and where that of each triangle of the mesh is among them.
    pub fn new(mesh: &Mesh, triangles: impl IndexedParallelIterator<Item = u32>, places: Vec<u32>) -> Normals {
        let normal = |triangle| {
            let [a, b, c] = mesh.corners(triangle);
            Facet::new(a, b, c).normal
        };
        let normals = triangles.map(normal).collect();
        match places.is_empty() {
            true => Normals { at_their_numbers: normals, ..Normals::default() },
            false => Normals { of_firsts: normals, places, ..Normals::default() },
        }
    }

    /// That of a triangle, where it lies in memory.
    #[inline(always)]
    pub fn of(&self, triangle: u32) -> &DVec3 {
        match self.at_their_numbers.get(triangle as usize) {
            Some(normal) => normal,
            None => self.of_copy(triangle),
        }
    }

    #[cold]
    #[inline(never)]
    fn of_copy(&self, triangle: u32) -> &DVec3 {
        &self.of_firsts[self.places[triangle as usize] as usize]
    }
}
