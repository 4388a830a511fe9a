//! A mesh of triangles with a tree over them.
//!
//! Each triangle is met by the kernel of a triangle, in a test of its own. The tree narrows down and decides nothing: of
//! several triangles at the same distance the first in the mesh file wins, whatever the order of the tests.

mod left;

use super::Approach;
use super::triangle::Facet;
use crate::geometry::bounds::Bounds;
use crate::geometry::bvh::{Bvh, Form, Search};
use crate::geometry::doubled::Doubled;
use crate::geometry::mesh::Mesh;
use crate::geometry::ray::{Crossing, Ray, Surface};
use crate::log::Step;
use crate::probe::Probe;
use glam::DVec3;
use left::LeftTriangle;
use rayon::prelude::*;
use std::sync::Arc;

/// A mesh, ready to be met by rays. A crossing's primitive is the triangle's number in the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleMesh {
    mesh: Arc<Mesh>,
    tree: Bvh,
    /// The normals of the triangles, as [`Facet`] has them.
    normals: Vec<DVec3>,
}

const NEAREST_FIRST: bool = true;
const IN_ANY_ORDER: bool = false;

impl TriangleMesh {
    /// Builds the tree. Triangles without area are left out of it.
    pub fn new(mesh: Arc<Mesh>) -> TriangleMesh {
        let has_area = |triangle: &u32| !mesh.is_degenerate(*triangle);
        let solid: Vec<u32> = (0..mesh.faces.len() as u32).into_par_iter().filter(has_area).collect();
        let tree = Bvh::new(Vec::new(), &solid, |triangle| Form::Triangle(mesh.corners(triangle)));
        let normal = |triangle| {
            let [a, b, c] = mesh.corners(triangle);
            Facet::new(a, b, c).normal
        };
        let normals = (0..mesh.faces.len() as u32).into_par_iter().map(normal).collect();
        TriangleMesh { mesh, tree, normals }
    }

    /// The triangles.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The first point where the ray crosses object `object` of this shape; of several triangles there, on the first.
    pub fn first_crossing<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        let mut nearest: Option<Crossing> = None;
        self.visit(object, one_sided, ray, NEAREST_FIRST, probe, |crossing| {
            if nearest.is_none_or(|best| (crossing.t, crossing.primitive) < (best.t, best.primitive)) {
                nearest = Some(crossing);
            }
            nearest.map_or(ray.t_max, |best| best.t)
        });
        nearest
    }

    /// Whether the ray crosses the object at all. Ends with the first triangle that is found.
    pub fn is_crossed<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, probe: &mut P) -> bool {
        let mut is_crossed = false;
        self.visit(object, one_sided, ray, IN_ANY_ORDER, probe, |_| {
            is_crossed = true;
            -1.0
        });
        is_crossed
    }

    /// All points where the ray crosses the object, in the order of the ray.
    pub fn all_crossings<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        found: &mut Vec<Crossing>,
        probe: &mut P,
    ) {
        let before = found.len();
        self.visit(object, one_sided, ray, IN_ANY_ORDER, probe, |crossing| {
            found.push(crossing);
            ray.t_max
        });
        found[before..].sort_by(|a, b| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive)));
    }

    /// The surface at a crossing, its normals turned toward the arriving ray.
    pub fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let normals = self.mesh.corner_normals(crossing.primitive);
        self.facet(crossing.primitive).surface(normals.as_ref(), ray, crossing, probe)
    }

    /// The distance of a crossing with twice the digits.
    pub(super) fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        self.facet(crossing.primitive).refined(ray, crossing)
    }

    /// A box around the mesh; `None` if no triangle has an area.
    pub fn bounds(&self) -> Option<Bounds> {
        self.tree.bounds()
    }

    /// Tests the triangles that the ray can meet, but for the one that it leaves, and shows `meet` every crossing. `meet`
    /// says how far further ones matter; a negative distance ends the search.
    fn visit<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        nearest_first: bool,
        probe: &mut P,
        mut meet: impl FnMut(Crossing) -> f64,
    ) {
        let left = ray.leaving.filter(|leaving| leaving.object == object);
        let left = left.and_then(|leaving| LeftTriangle::of(&self.mesh, &self.normals, leaving.primitive, ray));
        let approach = Approach { leaving: None, one_sided };
        let mut t_max = ray.t_max;
        let search = Search { nearest_first, one_by_one: probe.certifies() };
        let tested = self.tree.visit::<P>(
            ray,
            search,
            #[inline(always)]
            |triangle| {
                let is_out_of_reach =
                    left.as_ref().is_some_and(|left| left.bars(&self.mesh, &self.normals, triangle, ray));
                if !is_out_of_reach && let Some(crossing) = self.test(object, triangle, ray, approach, probe) {
                    t_max = meet(crossing);
                }
                t_max
            },
        );
        probe.bounds_tested(tested);
    }

    #[inline(always)]
    fn test<P: Probe>(
        &self,
        object: u32,
        triangle: u32,
        ray: &Ray,
        approach: Approach,
        probe: &mut P,
    ) -> Option<Crossing> {
        let facet = self.facet(triangle);
        facet.give(probe);
        let step = Step::Test { object, triangle: Some(triangle) };
        probe.within(
            step,
            #[inline(always)]
            |probe| facet.crossing(ray, approach, triangle, probe),
        )
    }

    #[inline(always)]
    fn facet(&self, triangle: u32) -> Facet {
        let [a, b, c] = self.mesh.corners(triangle);
        Facet { a, b, c, normal: self.normals[triangle as usize] }
    }
}

#[cfg(test)]
mod tests;
