//! A mesh of triangles with a tree over them.
//!
//! Each triangle is intersected by the kernel of a triangle, in a test of its own. The tree narrows down and decides nothing: of
//! several coincident triangles the first in the mesh file wins, whatever the order of the tests.

mod copies;
mod facets;
mod left;
mod test;
mod together;

use super::intersect::{Intersect, Target};
use super::kernel::touched;
use crate::geometry::bounds::Bounds;
use crate::geometry::bvh::{Bvh, Form, Search, Shaft};
use crate::geometry::doubled::Doubled;
use crate::geometry::line::RaySource;
use crate::geometry::mesh::{Mesh, Winding};
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Leaving, Ray, Side, Surface};
use crate::geometry::size::unit;
use crate::log::Step;
use crate::probe::{Probe, ROUNDINGS};
use crate::threads::share;
use copies::Copies;
use facets::{Facets, Normals};
use glam::DVec3;
use left::{LeftTriangle, corners_in_common, overlap};
use rayon::prelude::*;
use std::iter::successors;
use std::sync::{Arc, OnceLock};

/// A mesh, ready to be met by rays. A crossing's primitive is the triangle's number in the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleMesh {
    facets: Facets,
    tree: Bvh,
    /// Those of the triangles that the tree has stand for these, too.
    copies: Copies,
    /// What [`TriangleMesh::inside`] found; only media need it.
    inside: OnceLock<Option<Side>>,
}

impl TriangleMesh {
    /// Builds the tree. Triangles without area are left out of it.
    pub fn new(mesh: Arc<Mesh>) -> TriangleMesh {
        share(mesh.faces.len(), || TriangleMesh::of(mesh))
    }

    fn of(mesh: Arc<Mesh>) -> TriangleMesh {
        let has_area = |triangle: &u32| !mesh.is_degenerate(*triangle);
        let tree_over = |solid| Bvh::new(Vec::new(), solid, |triangle| Form::Triangle(mesh.corners(triangle)));
        let numbers = (0..mesh.faces.len() as u32).into_par_iter();
        let (tree, copies, normals) = match Copies::of(&mesh) {
            None => {
                let tree = tree_over(numbers.clone().filter(has_area).collect());
                (tree, Copies::default(), Normals::new(&mesh, numbers, Vec::new()))
            }
            Some((copies, places, firsts)) => {
                let tree = tree_over(firsts.iter().copied().filter(has_area).collect());
                (tree, copies, Normals::new(&mesh, firsts.into_par_iter(), places))
            }
        };
        TriangleMesh { facets: Facets { mesh, normals }, tree, copies, inside: OnceLock::new() }
    }

    /// The triangles.
    pub fn mesh(&self) -> &Mesh {
        &self.facets.mesh
    }

    /// The side of the triangles on which the solid lies that they enclose: the back, or the front where the mesh is wound inside out.
    /// `None` where they enclose none.
    pub fn inside(&self) -> Option<Side> {
        let side = || match self.facets.mesh.winding() {
            Winding::Outward => Some(Side::Back),
            Winding::Inward => Some(Side::Front),
            Winding::Mixed | Winding::Open => None,
        };
        *self.inside.get_or_init(side)
    }

    /// Whether a ray along a segment of the shaft can cross a triangle. `leaving` tells the triangle that all of them leave, if they leave one, and
    /// the side on which they set off.
    pub fn can_be_crossed_in(&self, shaft: &Shaft, leaving: Option<Leaving>) -> bool {
        let left = leaving.and_then(|leaving| LeftTriangle::in_shaft(&self.facets, leaving, shaft));
        let bars = |triangle: &u32| left.as_ref().is_some_and(|left| left.bars_all(&self.facets, *triangle, shaft));
        let bars_copies = |triangle| {
            successors(Some(triangle), |triangle| self.copies.after::<true>(*triangle)).all(|each| bars(&each))
        };
        !self.tree.between(shaft, bars_copies)
    }

    /// Whether two triangles have one or two corners in common and don't overlap.
    pub fn are_neighbors(&self, one: u32, other: u32) -> bool {
        let (one, other) = (self.facets.get(one), self.facets.get(other));
        match corners_in_common(one.corners(), other.corners()) {
            1 => true,
            2 => !overlap(&one, &other),
            _ => false,
        }
    }

    /// The corners of a triangle.
    pub fn corners_of(&self, triangle: u32) -> [DVec3; 3] {
        self.facets.mesh.corners(triangle)
    }

    /// Drops crossings, sorted by their distance from number `from` on, with triangles next to one that is crossed in the same place and
    /// from the same side: a ray through an edge or a corner crosses the mesh once.
    fn keep_edges_once(&self, ray: &Ray, found: &mut Vec<Crossing>, from: usize) {
        // Of more than 1,400 coincident triangles only the latest are compared, because there may be a hundred thousand.
        const MOST: usize = 1 << 20;
        let (mut kept, mut compared) = (from, 0);
        for at in from..found.len() {
            let crossing = found[at];
            let (size, slope) =
                (self.size(crossing.primitive), unit(*self.facets.normals.of(crossing.primitive)).dot(ray.direction));
            let bound = ROUNDINGS * (2.0 * (ray.origin.abs().element_sum() + crossing.t.abs()) + 2.0 * size);
            let is_same = |before: &&Crossing| (crossing.t - before.t) * slope.abs() <= bound;
            let most = if compared < MOST { usize::MAX } else { 64 };
            let is_again = found[from..kept].iter().rev().take(most).take_while(is_same).any(|before| {
                compared += 1;
                before.side == crossing.side && self.are_neighbors(before.primitive, crossing.primitive)
            });
            if !is_again {
                found[kept] = crossing;
                kept += 1;
            }
        }
        found.truncate(kept);
    }

    /// Shows `meet` the triangles that the ray can hit, with whether it certainly crosses them. `meet` says how far further ones matter; a
    /// negative distance ends the search.
    #[inline(always)]
    fn visit<P: Probe>(
        &self,
        source: &impl RaySource,
        search: Search,
        probe: &mut P,
        meet: impl FnMut(u32, bool, &mut P) -> f64,
    ) {
        if self.copies.are_there() {
            return self.visit_among_copies(source, search, probe, meet);
        }
        self.visit_by::<P, false>(source, search, probe, meet);
    }

    #[cold]
    #[inline(never)]
    fn visit_among_copies<P: Probe>(
        &self,
        source: &impl RaySource,
        search: Search,
        probe: &mut P,
        meet: impl FnMut(u32, bool, &mut P) -> f64,
    ) {
        self.visit_by::<P, true>(source, search, probe, meet);
    }

    /// The same. `COPIES` says whether the tree's triangles stand for others: asked at each, that would take time where they don't.
    #[inline(always)]
    fn visit_by<P: Probe, const COPIES: bool>(
        &self,
        source: &impl RaySource,
        search: Search,
        probe: &mut P,
        mut meet: impl FnMut(u32, bool, &mut P) -> f64,
    ) {
        let tested = self.tree.visit::<P>(
            source,
            search,
            #[inline(always)]
            |mut triangle, is_sure| loop {
                let limit = meet(triangle, is_sure, probe);
                match self.copies.after::<COPIES>(triangle) {
                    Some(copy) if limit >= 0.0 => triangle = copy,
                    _ => break limit,
                }
            },
        );
        probe.bounds_tested(tested);
    }
}

impl Intersect for TriangleMesh {
    // Kept apart from the search among objects, as the kernels of other shapes are.
    #[inline(never)]
    fn nearest<P: Probe>(&self, target: Target, ray: &Ray, nearest: &mut Nearest, probe: &mut P) {
        let test = self.facets.test(target, ray);
        let mut t_max = ray.t_max;
        self.visit(
            ray,
            Search::nearest_first(probe),
            probe,
            #[inline(always)]
            |triangle, _, probe| {
                if let Some(crossing) = test.crossing(triangle, ray, probe) {
                    nearest.offer(target.object, crossing, ray, probe);
                    t_max = nearest.limit();
                }
                t_max
            },
        );
    }

    /// Ends with the first triangle that is found.
    fn is_crossed<P: Probe>(&self, target: Target, source: &impl RaySource, probe: &mut P) -> bool {
        let test = self.facets.test(target, source);
        // A sure hit says nothing of the triangle that the ray leaves and its neighbours, nor of sides.
        let search = if test.is_plain() { Search::of_any(probe) } else { Search::in_any_order(probe) };
        let mut is_crossed = false;
        self.visit(
            source,
            search,
            probe,
            #[inline(always)]
            |triangle, is_sure, probe| {
                is_crossed = is_sure || test.crossing(triangle, source.ray(), probe).is_some();
                if is_crossed { -1.0 } else { source.reach() }
            },
        );
        is_crossed
    }

    fn all_crossings<P: Probe>(&self, target: Target, ray: &Ray, found: &mut Vec<Crossing>, probe: &mut P) {
        let before = found.len();
        let test = self.facets.test(target, ray);
        self.visit(ray, Search::in_any_order(probe), probe, |triangle, _, probe| {
            found.extend(test.crossing(triangle, ray, probe));
            ray.t_max
        });
        found[before..].sort_by(|a, b| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive)));
        self.keep_edges_once(ray, found, before);
    }

    fn touch<P: Probe>(&self, target: Target, triangle: u32, _ray: &Ray, probe: &mut P) {
        self.facets.get(triangle).give(probe);
        probe.within(Step::Test { object: target.object, triangle: Some(triangle) }, touched);
    }

    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let normals = self.facets.mesh.corner_normals(crossing.primitive);
        self.facets.get(crossing.primitive).surface(normals.as_ref(), ray, crossing, probe)
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        self.facets.get(crossing.primitive).refined(ray, crossing)
    }

    /// A box around the mesh; `None` if no triangle has an area.
    fn bounds(&self) -> Option<Bounds> {
        self.tree.bounds()
    }

    /// The greatest coordinate of a triangle.
    fn size(&self, triangle: u32) -> f64 {
        self.facets.get(triangle).bounds().size()
    }

    fn can_self_intersect(&self, _sets_off: Side) -> bool {
        true
    }
}

#[cfg(test)]
mod tests;
