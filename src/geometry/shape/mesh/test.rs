//! The test of a mesh's triangles with a ray.

use super::facets::Facets;
use super::left::{LeftTriangle, corners_in_common};
use crate::geometry::line::RaySource;
use crate::geometry::ray::{Crossing, Ray};
use crate::geometry::shape::flat::PlaneHit;
use crate::geometry::shape::intersect::Target;
use crate::geometry::shape::kernel::{Approach, at_an_end, decide};
use crate::geometry::shape::quick::{Quick, quick};
use crate::geometry::size::unit;
use crate::log::{Miss, Step};
use crate::probe::{Probe, Silent};
use glam::DVec3;

/// What is the same for all triangles that a ray is tested with.
pub(super) struct Test<'m> {
    facets: &'m Facets,
    target: Target,
    /// The triangle that the ray leaves, if it leaves one.
    left: Option<LeftTriangle>,
}

impl Facets {
    /// The test with a ray that leaves no triangle.
    #[inline(always)]
    pub fn untested(&self, target: Target) -> Test<'_> {
        Test { facets: self, target, left: None }
    }

    /// The test of the triangles with this ray.
    #[inline(always)]
    pub fn test(&self, target: Target, source: &impl RaySource) -> Test<'_> {
        let leaving = source.leaving().filter(|leaving| leaving.object == target.object);
        let left = leaving.and_then(|leaving| LeftTriangle::of(self, leaving, source.ray()));
        Test { facets: self, target, left }
    }
}

impl Test<'_> {
    /// Whether every triangle counts, from either side.
    #[inline(always)]
    pub fn is_plain(&self) -> bool {
        self.left.is_none() && !self.target.one_sided
    }

    /// The crossing with a triangle, unless the triangle that the ray leaves bars it.
    #[inline(always)]
    pub fn crossing<P: Probe>(&self, triangle: u32, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        if self.is_barred(triangle, ray) {
            return None;
        }
        match quick::<P>(self.facets.corners(triangle), ray) {
            Quick::Beside => return None,
            Quick::Met(PlaneHit { t, side }) => {
                return self.decided(Crossing { t, side, primitive: triangle }, ray, probe);
            }
            Quick::Inside => return self.crossing_inside(triangle, ray),
            Quick::InDoubt => {}
        }
        let facet = self.facets.get(triangle);
        facet.give(probe);
        let step = Step::Test { object: self.target.object, triangle: Some(triangle) };
        let near_end = |t: f64, _| self.at_a_near_end(ray, triangle, t);
        probe.within(
            step,
            #[inline(always)]
            |probe| facet.crossing(ray, self.approach(), triangle, near_end, probe),
        )
    }

    /// The crossing at a candidate inside the edges, unless the triangle that the ray leaves bars it or the ray doesn't reach it.
    #[inline(always)]
    pub fn crossing_at<P: Probe>(&self, candidate: Crossing, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        if self.is_barred(candidate.primitive, ray) { None } else { self.decided(candidate, ray, probe) }
    }

    #[inline(always)]
    fn is_barred(&self, triangle: u32, ray: &Ray) -> bool {
        self.left.as_ref().is_some_and(|left| left.bars(self.facets, triangle, ray))
    }

    #[inline(always)]
    fn approach(&self) -> Approach {
        Approach { leaving: None, one_sided: self.target.one_sided }
    }

    /// A candidate inside the edges, if it is a hit.
    #[inline(always)]
    fn decided<P: Probe>(&self, candidate: Crossing, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        let Crossing { t, primitive: triangle, .. } = candidate;
        let at_an_end = if ray.is_near_an_end(t) { self.at_a_near_end(ray, triangle, t) } else { None };
        decide(ray, self.approach(), candidate, at_an_end, probe)
    }

    /// The crossing with a triangle inside whose edges the ray's line passes, for a probe that sees nothing.
    #[cold]
    #[inline(never)]
    fn crossing_inside(&self, triangle: u32, ray: &Ray) -> Option<Crossing> {
        let near_end = |t: f64, _| self.at_a_near_end(ray, triangle, t);
        self.facets.get(triangle).crossing_inside(ray, self.approach(), triangle, near_end, &mut Silent)
    }

    /// Whether a crossing near an end of the ray is that end. Neighbours of the triangle that it leaves are told by their wedge, and by their
    /// distance, unless they lie in the same plane.
    #[cold]
    #[inline(never)]
    fn at_a_near_end(&self, ray: &Ray, triangle: u32, t: f64) -> Option<Miss> {
        let facet = self.facets.get(triangle);
        let (normal, size) = (unit(facet.normal), facet.bounds().size());
        let is_on = |point: DVec3| ray.holds(normal.dot(point - facet.a), size);
        let is_apart = |left: &LeftTriangle| {
            matches!(corners_in_common(left.corners, facet.corners()), 1 | 2) && !left.corners.into_iter().all(is_on)
        };
        at_an_end(ray, !self.left.as_ref().is_some_and(is_apart), t, normal.dot(ray.direction).abs(), size)
    }
}
