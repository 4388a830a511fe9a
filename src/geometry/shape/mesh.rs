//! A mesh of triangles with a tree over them.
//!
//! Each triangle is intersected by the kernel of a triangle, in a test of its own. The tree narrows down and decides nothing: of
//! several coincident triangles the first in the mesh file wins, whatever the order of the tests.

mod copies;
mod left;
mod together;

use super::flat::PlaneHit;
use super::quick::{Corners, Quick, quick};
use super::triangle::Facet;
use super::{Approach, at_an_end, decide, touched};
use crate::geometry::bounds::Bounds;
use crate::geometry::bvh::{Bvh, Form, Search, Shaft};
use crate::geometry::doubled::Doubled;
use crate::geometry::line::RaySource;
use crate::geometry::mesh::{Mesh, Winding};
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Leaving, Ray, Side, Surface};
use crate::geometry::size::unit;
use crate::log::{Miss, Step};
use crate::probe::{Probe, ROUNDINGS, Silent};
use crate::threads::share;
use copies::{Copies, Normals};
use glam::DVec3;
use left::{LeftTriangle, corners_in_common, overlap};
use rayon::prelude::*;
use std::iter::successors;
use std::sync::{Arc, OnceLock};

/// A mesh, ready to be met by rays. A crossing's primitive is the triangle's number in the mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct TriangleMesh {
    mesh: Arc<Mesh>,
    tree: Bvh,
    /// Those of the triangles that the tree has stand for these, too.
    copies: Copies,
    normals: Normals,
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
        TriangleMesh { mesh, tree, copies, normals, inside: OnceLock::new() }
    }

    /// The triangles.
    pub fn mesh(&self) -> &Mesh {
        &self.mesh
    }

    /// The side of the triangles on which the solid lies that they enclose: the back, or the front where the mesh is wound inside out.
    /// `None` where they enclose none.
    pub fn inside(&self) -> Option<Side> {
        let side = || match self.mesh.winding() {
            Winding::Outward => Some(Side::Back),
            Winding::Inward => Some(Side::Front),
            Winding::Mixed | Winding::Open => None,
        };
        *self.inside.get_or_init(side)
    }

    /// Shows `nearest` the points where the ray crosses object `object` of this shape that may be its nearest crossing.
    // Kept apart from the search among objects, as the kernels of other shapes are.
    #[inline(never)]
    pub fn nearest<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, nearest: &mut Nearest, probe: &mut P) {
        self.visit(object, one_sided, ray, Search::nearest_first(probe), probe, |crossing, probe| {
            nearest.offer(object, crossing, ray, probe);
            nearest.limit()
        });
    }

    /// Shows the log the crossing of a ray that begins on a triangle and goes through it.
    pub fn touch<P: Probe>(&self, object: u32, triangle: u32, probe: &mut P) {
        self.facet(triangle).give(probe);
        probe.within(Step::Test { object, triangle: Some(triangle) }, touched);
    }

    /// Whether a ray along a segment of the shaft can cross a triangle. `leaving` tells the triangle that all of them leave, if they leave one, and
    /// the side on which they set off.
    pub fn can_be_crossed_in(&self, shaft: &Shaft, leaving: Option<Leaving>) -> bool {
        let left = leaving.and_then(|leaving| LeftTriangle::in_shaft(&self.mesh, &self.normals, leaving, shaft));
        let bars = |triangle: &u32| {
            left.as_ref().is_some_and(|left| left.bars_all(&self.mesh, &self.normals, *triangle, shaft))
        };
        let bars_copies = |triangle| {
            successors(Some(triangle), |triangle| self.copies.after::<true>(*triangle)).all(|each| bars(&each))
        };
        !self.tree.between(shaft, bars_copies)
    }

    /// Whether two triangles have one or two corners in common and don't overlap.
    pub fn are_neighbours(&self, one: u32, other: u32) -> bool {
        let (one, other) = (self.facet(one), self.facet(other));
        match corners_in_common(one.corners(), other.corners()) {
            1 => true,
            2 => !overlap(&one, &other),
            _ => false,
        }
    }

    /// The corners of a triangle.
    pub fn corners_of(&self, triangle: u32) -> [DVec3; 3] {
        self.mesh.corners(triangle)
    }

    /// The greatest coordinate of a triangle.
    pub fn size(&self, triangle: u32) -> f64 {
        self.facet(triangle).bounds().size()
    }

    /// Whether the ray crosses the object at all. Ends with the first triangle that is found.
    pub fn is_crossed<P: Probe>(&self, object: u32, one_sided: bool, source: &impl RaySource, probe: &mut P) -> bool {
        if self.copies.are_there() {
            return self.is_crossed_among_copies(object, one_sided, source, probe);
        }
        self.is_crossed_by::<P, false>(object, one_sided, source, probe)
    }

    #[cold]
    #[inline(never)]
    fn is_crossed_among_copies<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        source: &impl RaySource,
        probe: &mut P,
    ) -> bool {
        self.is_crossed_by::<P, true>(object, one_sided, source, probe)
    }

    /// The same. `COPIES` says whether the tree's triangles stand for others: asked at each, that would take time where they don't.
    #[inline(always)]
    fn is_crossed_by<P: Probe, const COPIES: bool>(
        &self,
        object: u32,
        one_sided: bool,
        source: &impl RaySource,
        probe: &mut P,
    ) -> bool {
        let left = self.left(object, source);
        // A sure hit says nothing of the triangle that the ray leaves and its neighbours, nor of sides.
        let search = match left {
            None if !one_sided => Search::of_any(probe),
            _ => Search::in_any_order(probe),
        };
        let mut is_crossed = false;
        let tested = self.tree.visit::<P>(
            source,
            search,
            #[inline(always)]
            |mut triangle, is_sure| loop {
                is_crossed =
                    is_sure || self.meet(object, one_sided, triangle, source.ray(), left.as_ref(), probe).is_some();
                match self.copies.after::<COPIES>(triangle) {
                    _ if is_crossed => break -1.0,
                    Some(copy) => triangle = copy,
                    None => break source.reach(),
                }
            },
        );
        probe.bounds_tested(tested);
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
        self.visit(object, one_sided, ray, Search::in_any_order(probe), probe, |crossing, _| {
            found.push(crossing);
            ray.t_max
        });
        found[before..].sort_by(|a, b| a.t.total_cmp(&b.t).then(a.primitive.cmp(&b.primitive)));
        self.keep_edges_once(ray, found, before);
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
                (self.size(crossing.primitive), unit(*self.normals.of(crossing.primitive)).dot(ray.direction));
            let bound = ROUNDINGS * (2.0 * (ray.origin.abs().element_sum() + crossing.t.abs()) + 2.0 * size);
            let is_same = |before: &&Crossing| (crossing.t - before.t) * slope.abs() <= bound;
            let most = if compared < MOST { usize::MAX } else { 64 };
            let is_again = found[from..kept].iter().rev().take(most).take_while(is_same).any(|before| {
                compared += 1;
                before.side == crossing.side && self.are_neighbours(before.primitive, crossing.primitive)
            });
            if !is_again {
                found[kept] = crossing;
                kept += 1;
            }
        }
        found.truncate(kept);
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

    /// Tests the triangles that the ray can hit, but for the one that it leaves, and shows `meet` every crossing. `meet`
    /// says how far further ones matter; a negative distance ends the search.
    #[inline(always)]
    fn visit<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        search: Search,
        probe: &mut P,
        meet: impl FnMut(Crossing, &P) -> f64,
    ) {
        if self.copies.are_there() {
            return self.visit_among_copies(object, one_sided, ray, search, probe, meet);
        }
        self.visit_by::<P, false>(object, one_sided, ray, search, probe, meet);
    }

    #[cold]
    #[inline(never)]
    fn visit_among_copies<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        search: Search,
        probe: &mut P,
        meet: impl FnMut(Crossing, &P) -> f64,
    ) {
        self.visit_by::<P, true>(object, one_sided, ray, search, probe, meet);
    }

    #[inline(always)]
    fn visit_by<P: Probe, const COPIES: bool>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        search: Search,
        probe: &mut P,
        mut meet: impl FnMut(Crossing, &P) -> f64,
    ) {
        let left = self.left(object, ray);
        let mut t_max = ray.t_max;
        let tested = self.tree.visit::<P>(
            ray,
            search,
            #[inline(always)]
            |mut triangle, _| loop {
                if let Some(crossing) = self.meet(object, one_sided, triangle, ray, left.as_ref(), probe) {
                    t_max = meet(crossing, probe);
                }
                match self.copies.after::<COPIES>(triangle) {
                    Some(copy) if t_max >= 0.0 => triangle = copy,
                    _ => break t_max,
                }
            },
        );
        probe.bounds_tested(tested);
    }

    /// The triangle that the ray leaves, if it leaves one.
    #[inline(always)]
    fn left(&self, object: u32, source: &impl RaySource) -> Option<LeftTriangle> {
        let leaving = source.leaving().filter(|leaving| leaving.object == object)?;
        LeftTriangle::of(&self.mesh, &self.normals, leaving, source.ray())
    }

    /// The crossing with a triangle, unless the triangle that the ray leaves bars it.
    #[inline(always)]
    fn meet<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        triangle: u32,
        ray: &Ray,
        left: Option<&LeftTriangle>,
        probe: &mut P,
    ) -> Option<Crossing> {
        if left.is_some_and(|left| left.bars(&self.mesh, &self.normals, triangle, ray)) {
            return None;
        }
        let approach = Approach { leaving: None, one_sided };
        let near_end = |t: f64, _| self.at_a_near_end(ray, triangle, t, left);
        match quick::<P>(self.corners(triangle), ray) {
            Quick::Beside => return None,
            Quick::Met(PlaneHit { t, side }) => {
                return self.decided(one_sided, Crossing { t, side, primitive: triangle }, ray, left, probe);
            }
            Quick::Inside => return self.meet_inside(one_sided, triangle, ray, left),
            Quick::InDoubt => {}
        }
        let facet = self.facet(triangle);
        facet.give(probe);
        let step = Step::Test { object, triangle: Some(triangle) };
        probe.within(
            step,
            #[inline(always)]
            |probe| facet.crossing(ray, approach, triangle, near_end, probe),
        )
    }

    /// A candidate inside the edges, if it is a hit.
    #[inline(always)]
    fn decided<P: Probe>(
        &self,
        one_sided: bool,
        candidate: Crossing,
        ray: &Ray,
        left: Option<&LeftTriangle>,
        probe: &mut P,
    ) -> Option<Crossing> {
        let Crossing { t, primitive: triangle, .. } = candidate;
        let at_an_end = if ray.is_near_an_end(t) { self.at_a_near_end(ray, triangle, t, left) } else { None };
        decide(ray, Approach { leaving: None, one_sided }, candidate, at_an_end, probe)
    }

    /// The crossing with a triangle inside whose edges the ray's line passes, for a probe that sees nothing.
    #[cold]
    #[inline(never)]
    fn meet_inside(&self, one_sided: bool, triangle: u32, ray: &Ray, left: Option<&LeftTriangle>) -> Option<Crossing> {
        let approach = Approach { leaving: None, one_sided };
        let near_end = |t: f64, _| self.at_a_near_end(ray, triangle, t, left);
        self.facet(triangle).crossing_inside(ray, approach, triangle, near_end, &mut Silent)
    }

    /// Whether a crossing near an end of the ray is that end. Neighbours of the triangle that it leaves are told by their wedge, and by their
    /// distance, unless they lie in the same plane.
    #[cold]
    #[inline(never)]
    fn at_a_near_end(&self, ray: &Ray, triangle: u32, t: f64, left: Option<&LeftTriangle>) -> Option<Miss> {
        let facet = self.facet(triangle);
        let (normal, size) = (unit(facet.normal), facet.bounds().size());
        let is_on = |point: DVec3| ray.holds(normal.dot(point - facet.a), size);
        let is_apart = |left: &LeftTriangle| {
            matches!(corners_in_common(left.corners, facet.corners()), 1 | 2) && !left.corners.into_iter().all(is_on)
        };
        at_an_end(ray, !left.is_some_and(is_apart), t, normal.dot(ray.direction).abs(), size)
    }

    #[inline(always)]
    fn corners(&self, triangle: u32) -> Corners<'_> {
        let [a, b, c] = self.mesh.faces[triangle as usize];
        let at = |corner: u32| &self.mesh.positions[corner as usize];
        Corners { corners: [at(a), at(b), at(c)], normal: self.normals.of(triangle) }
    }

    #[inline(always)]
    fn facet(&self, triangle: u32) -> Facet {
        let [a, b, c] = self.mesh.corners(triangle);
        Facet { a, b, c, normal: *self.normals.of(triangle) }
    }
}

#[cfg(test)]
mod tests;
