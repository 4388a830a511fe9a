//! Intersecting a packet of rays with a mesh.

use super::TriangleMesh;
use super::left::LeftTriangle;
use crate::geometry::bvh::{PerRay, RayMask, Search, each};
use crate::geometry::line::RaySource;
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Ray, Side};
use crate::geometry::shape::quick::{RayLanes, quick_of_four};
use crate::probe::Probe;

impl TriangleMesh {
    /// Shows `nearest` of each of the rays in `which` the points where it crosses object `object` of this shape that may be its nearest
    /// crossing; `limits` says up to where triangles matter to each.
    #[inline(never)]
    pub fn nearest_together<P: Probe>(
        &self,
        (object, one_sided): (u32, bool),
        rays: &[Ray],
        which: RayMask,
        nearest: &mut PerRay<Nearest>,
        limits: &mut PerRay<f64>,
        probe: &mut P,
    ) {
        if self.copies.are_there() {
            for at in each(which) {
                self.nearest(object, one_sided, &rays[at], &mut nearest[at], probe);
                limits[at] = nearest[at].limit();
            }
            return;
        }
        let left = self.left_by_each(object, rays, which);
        let lanes = RayLanes::of(rays, which);
        self.tree.visit_together::<P, Ray>(
            rays,
            which,
            Search::nearest_first(probe),
            limits,
            #[inline(always)]
            |which, triangle, _, limits| {
                let mut offer = |at: usize, crossing: Option<Crossing>, probe: &P| {
                    if let Some(crossing) = crossing {
                        nearest[at].offer(object, crossing, &rays[at], probe);
                        limits[at] = nearest[at].limit();
                    }
                };
                let mut rest = which;
                // For a ray alone there is a quicker way.
                for first in [0, 4] {
                    let these = which >> first & 0xf;
                    if these & these.wrapping_sub(1) == 0 {
                        continue;
                    }
                    let found = quick_of_four::<P>(self.corners(triangle), &lanes, first);
                    rest &= !((found.beside | found.met) << first);
                    for lane in each(found.met & these) {
                        let at = first + lane;
                        let side = if found.front >> lane & 1 == 1 { Side::Front } else { Side::Back };
                        let candidate = Crossing { t: found.t[lane & 3], side, primitive: triangle };
                        offer(at, self.met(one_sided, candidate, &rays[at], left[at].as_ref(), probe), probe);
                    }
                }
                for at in each(rest) {
                    offer(at, self.meet(object, one_sided, triangle, &rays[at], left[at].as_ref(), probe), probe);
                }
            },
        );
    }

    /// Sets the limits of those rays in `which` below 0 that cross the object at all.
    #[inline(never)]
    pub fn cross_together<P: Probe, S: RaySource>(
        &self,
        (object, one_sided): (u32, bool),
        sources: &[S],
        which: RayMask,
        limits: &mut PerRay<f64>,
        probe: &mut P,
    ) {
        if self.copies.are_there() {
            let crossed = each(which).filter(|at| self.is_crossed(object, one_sided, &sources[*at], probe));
            return crossed.for_each(|at| limits[at] = -1.0);
        }
        let left = self.left_by_each(object, sources, which);
        // A sure hit says nothing of the triangle that a ray leaves and its neighbours, nor of sides.
        let search = match left.iter().all(Option::is_none) && !one_sided {
            true => Search::of_any(probe),
            false => Search::in_any_order(probe),
        };
        self.tree.visit_together::<P, S>(
            sources,
            which,
            search,
            limits,
            #[inline(always)]
            |which, triangle, is_sure, limits| {
                for at in each(which) {
                    let meet = |probe: &mut P| {
                        self.meet(object, one_sided, triangle, sources[at].ray(), left[at].as_ref(), probe).is_some()
                    };
                    if is_sure || meet(probe) {
                        limits[at] = -1.0;
                    }
                }
            },
        );
    }

    /// The triangles that the rays leave.
    #[inline(always)]
    fn left_by_each<S: RaySource>(&self, object: u32, sources: &[S], which: RayMask) -> PerRay<Option<LeftTriangle>> {
        let mut left: PerRay<Option<LeftTriangle>> = Default::default();
        for ray in each(which) {
            left[ray] = self.left(object, &sources[ray]);
        }
        left
    }

    /// The crossing at a candidate inside the edges, unless the triangle that the ray leaves bars it or the ray doesn't reach it.
    #[inline(always)]
    fn met<P: Probe>(
        &self,
        one_sided: bool,
        candidate: Crossing,
        ray: &Ray,
        left: Option<&LeftTriangle>,
        probe: &mut P,
    ) -> Option<Crossing> {
        let triangle = candidate.primitive;
        if left.is_some_and(|left| left.bars(&self.mesh, &self.normals, triangle, ray)) {
            return None;
        }
        self.decided(one_sided, candidate, ray, left, probe)
    }
}
