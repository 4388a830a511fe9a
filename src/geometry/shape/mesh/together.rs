//! Intersecting a packet of rays with a mesh.

use super::TriangleMesh;
use super::test::Test;
use crate::geometry::bvh::{PerRay, RayMask, Search, each};
use crate::geometry::line::RaySource;
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Ray, Side};
use crate::geometry::shape::intersect::{Intersect, Target};
use crate::geometry::shape::quick::{RayLanes, quick_of_four};
use crate::probe::Probe;

impl TriangleMesh {
    /// Shows `nearest` of each of the rays in `which` the points where it crosses the target that may be its nearest crossing;
    /// `limits` says up to where triangles matter to each.
    #[inline(never)]
    pub fn nearest_together<P: Probe>(
        &self,
        target: Target,
        rays: &[Ray],
        which: RayMask,
        nearest: &mut PerRay<Nearest>,
        limits: &mut PerRay<f64>,
        probe: &mut P,
    ) {
        if self.copies.are_there() {
            for at in each(which) {
                self.nearest(target, &rays[at], &mut nearest[at], probe);
                limits[at] = nearest[at].limit();
            }
            return;
        }
        let tests = self.tests(target, rays, which);
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
                        nearest[at].offer(target.object, crossing, &rays[at], probe);
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
                    let found = quick_of_four::<P>(self.facets.corners(triangle), &lanes, first);
                    rest &= !((found.beside | found.met) << first);
                    for lane in each(found.met & these) {
                        let at = first + lane;
                        let side = if found.front >> lane & 1 == 1 { Side::Front } else { Side::Back };
                        let candidate = Crossing { t: found.t[lane & 3], side, primitive: triangle };
                        offer(at, tests[at].crossing_at(candidate, &rays[at], probe), probe);
                    }
                }
                for at in each(rest) {
                    offer(at, tests[at].crossing(triangle, &rays[at], probe), probe);
                }
            },
        );
    }

    /// Sets the limits of those rays in `which` below 0 that cross the object at all.
    #[inline(never)]
    pub fn cross_together<P: Probe, S: RaySource>(
        &self,
        target: Target,
        sources: &[S],
        which: RayMask,
        limits: &mut PerRay<f64>,
        probe: &mut P,
    ) {
        if self.copies.are_there() {
            let crossed = each(which).filter(|at| self.is_crossed(target, &sources[*at], probe));
            return crossed.for_each(|at| limits[at] = -1.0);
        }
        let tests = self.tests(target, sources, which);
        // A sure hit says nothing of the triangle that a ray leaves and its neighbours, nor of sides.
        let is_plain = tests.iter().all(Test::is_plain);
        let search = if is_plain { Search::of_any(probe) } else { Search::in_any_order(probe) };
        self.tree.visit_together::<P, S>(
            sources,
            which,
            search,
            limits,
            #[inline(always)]
            |which, triangle, is_sure, limits| {
                for at in each(which) {
                    if is_sure || tests[at].crossing(triangle, sources[at].ray(), probe).is_some() {
                        limits[at] = -1.0;
                    }
                }
            },
        );
    }

    /// The tests with each of the rays in `which`.
    #[inline(always)]
    fn tests<S: RaySource>(&self, target: Target, sources: &[S], which: RayMask) -> PerRay<Test<'_>> {
        std::array::from_fn(|at| match which >> at & 1 {
            0 => self.facets.untested(target),
            _ => self.facets.test(target, &sources[at]),
        })
    }
}
