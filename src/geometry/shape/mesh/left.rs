//! The triangle that a ray leaves, and what follows for its neighbours.
//!
//! The origin of a ray that leaves a triangle is rounded. Near an edge it may thus lie on the wrong side of the triangle
//! beyond that edge, and the ray would hit that one just where it sets off. No epsilon is needed to tell that this can't be.
//! Two triangles at an edge cut space into two wedges. A ray that sets off from one of them runs in one of the wedges, until
//! it meets the other triangle from there. If that wedge is the wider one, the ray begins on the far side of the other
//! triangle's plane already, and so never meets it.

use super::facets::Facets;
use crate::geometry::bvh::Shaft;
use crate::geometry::ray::{Leaving, Ray, Side};
use crate::geometry::shape::triangle::Facet;
use crate::geometry::size::unit;
use crate::probe::ROUNDINGS;
use glam::DVec3;

/// The triangle of a mesh that a ray leaves.
pub(super) struct LeftTriangle {
    number: u32,
    pub corners: [DVec3; 3],
    /// The side on which the ray sets off; `None` if it runs along the triangle or doesn't begin there.
    sets_off: Option<Side>,
}

/// How far from a triangle, as a part of its size, an origin may lie that belongs to it. A caller with a ray that is
/// said to leave a triangle and begins elsewhere gets the answer for where it begins.
const NEARBY: f64 = 1.0 / (1 << 20) as f64;

impl LeftTriangle {
    /// The triangle that the ray leaves, if there is one.
    pub fn of(facets: &Facets, leaving: Leaving, ray: &Ray) -> Option<LeftTriangle> {
        let number = leaving.primitive;
        if number as usize >= facets.mesh.faces.len() {
            return None;
        }
        let normal = *facets.normals.of(number);
        let corners = facets.mesh.corners(number);
        let [a, b, c] = corners;
        let size = (b - a).abs().max((c - a).abs()).max_element();
        let is_nearby = normal.dot(ray.origin - a).abs() <= normal.length() * size * NEARBY;
        let along_normal = normal.dot(ray.direction);
        let sets_off = if !is_nearby {
            None
        } else if ray.slack > 0.0 {
            // A ray along the surface knows by itself on which side of it it runs.
            Some(leaving.side)
        } else if along_normal > 0.0 {
            Some(Side::Front)
        } else if along_normal < 0.0 {
            Some(Side::Back)
        } else {
            None
        };
        Some(LeftTriangle { number, corners, sets_off })
    }

    /// The same for all rays along the segments of a shaft, which set off on the side that `leaving` tells.
    pub fn in_shaft(facets: &Facets, leaving: Leaving, shaft: &Shaft) -> Option<LeftTriangle> {
        let along = shaft.light.center() - shaft.point;
        let left = LeftTriangle::of(facets, leaving, &Ray::new(shaft.point, along))?;
        // A ray with a slack sets off on the side that `leaving` tells, one without on that on which it runs.
        let goes_to = match shaft.rise_along(*facets.normals.of(leaving.primitive)) {
            [least, _] if least > 0.0 => Some(Side::Front),
            [_, most] if most < 0.0 => Some(Side::Back),
            _ => None,
        };
        let sets_off = left.sets_off.filter(|side| *side == leaving.side && goes_to == Some(*side));
        Some(LeftTriangle { sets_off, ..left })
    }

    /// Whether no ray along a segment of the shaft can hit a triangle: this one, or one at an edge of it.
    pub fn bars_all(&self, facets: &Facets, triangle: u32, shaft: &Shaft) -> bool {
        if triangle == self.number {
            return true;
        }
        let Some(sets_off) = self.sets_off else { return false };
        let Some((wedge, is_narrow)) = self.wedge(facets, triangle, sets_off) else { return false };
        !is_narrow || shaft.rise_along(wedge)[0] > 0.0
    }

    /// Whether the ray can't hit a triangle: this one, or one at an edge of it.
    pub fn bars(&self, facets: &Facets, triangle: u32, ray: &Ray) -> bool {
        if triangle == self.number {
            return true;
        }
        let Some(sets_off) = self.sets_off else { return false };
        let Some((wedge, is_narrow)) = self.wedge(facets, triangle, sets_off) else { return false };
        let arrives_from_it = wedge.dot(ray.direction) < 0.0;
        !(is_narrow && arrives_from_it)
    }

    /// Along which way of another triangle's normal the wedge lies in which a ray runs that sets off on this side, and whether it is the narrow
    /// one. `None` if they have no edge in common.
    #[inline(always)]
    fn wedge(&self, facets: &Facets, triangle: u32, sets_off: Side) -> Option<(DVec3, bool)> {
        let corners = facets.mesh.corners(triangle);
        let edge = shared_edge(self.corners, corners)?;
        let normal = *facets.normals.of(triangle);
        let wedge = if edge.fronts_agree == (sets_off == Side::Front) { normal } else { -normal };
        Some((wedge, wedge.dot(edge.over_against - corners[0]) > 0.0))
    }
}

/// How many corners two triangles have in common. Corners are compared by their places: files repeat them where normals or
/// textures differ.
pub(super) fn corners_in_common(one: [DVec3; 3], other: [DVec3; 3]) -> usize {
    one.into_iter().filter(|corner| other.contains(corner)).count()
}

/// Whether two triangles with an edge in common lie in one plane and on the same side of the edge.
pub(super) fn overlap(one: &Facet, other: &Facet) -> bool {
    let (corners, others) = (one.corners(), other.corners());
    let apex = |of: [DVec3; 3], without: [DVec3; 3]| of.into_iter().find(|corner| !without.contains(corner));
    let mut edge = corners.into_iter().filter(|corner| others.contains(corner));
    let (Some(apex), Some(other_apex)) = (apex(corners, others), apex(others, corners)) else { return false };
    let (Some(from), Some(to)) = (edge.next(), edge.next()) else { return false };
    let size = one.bounds().size().max(other.bounds().size());
    let is_in_plane = unit(one.normal).dot(other_apex - from).abs() <= 2.0 * ROUNDINGS * size;
    let side = |apex: DVec3| one.normal.dot((to - from).cross(apex - from));
    is_in_plane && side(apex) * side(other_apex) > 0.0
}

/// An edge that two triangles have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SharedEdge {
    /// Whether their fronts lie on the same side. They then run along the edge in opposite directions.
    fronts_agree: bool,
    /// The corner of the first triangle that isn't on the edge.
    over_against: DVec3,
}

/// The edge of two triangles that have exactly one in common. Corners are compared by their places: files repeat them where
/// normals or textures differ.
fn shared_edge(one: [DVec3; 3], other: [DVec3; 3]) -> Option<SharedEdge> {
    let edges = |[a, b, c]: [DVec3; 3]| [([a, b], c), ([b, c], a), ([c, a], b)];
    let mut found = None;
    for ([from, to], over_against) in edges(one) {
        for (edge, _) in edges(other) {
            let fronts_agree = edge == [to, from];
            let is_shared = fronts_agree || edge == [from, to];
            if is_shared && found.replace(SharedEdge { fronts_agree, over_against }).is_some() {
                return None;
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::super::facets::Normals;
    use super::*;
    use crate::geometry::bounds::Bounds;
    use crate::geometry::mesh::Mesh;
    use rayon::prelude::*;
    use std::sync::Arc;

    #[test]
    fn edges_in_common() {
        let [a, b, c, d] = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        let edge = |fronts_agree, over_against| Some(SharedEdge { fronts_agree, over_against });
        assert_eq!(shared_edge([a, b, c], [b, a, d]), edge(true, c));
        assert_eq!(shared_edge([a, b, c], [d, b, c]), edge(false, a));
        assert_eq!(shared_edge([a, b, c], [c, d, a]), edge(true, b));
        assert_eq!(shared_edge([a, b, c], [a, d, d * 2.0]), None);
        assert_eq!(shared_edge([a, b, c], [c, a, b]), None);
    }

    fn facets(mesh: Mesh) -> Facets {
        let normals = Normals::new(&mesh, (0..mesh.faces.len() as u32).into_par_iter(), Vec::new());
        Facets { mesh: Arc::new(mesh), normals }
    }

    fn leaving(primitive: u32) -> Leaving {
        Leaving { object: 0, primitive, side: Side::Front }
    }

    /// Two squares' halves that meet in the edge from the origin along y, the second turned up or down from the first.
    #[track_caller]
    fn bars(up: f64, direction: [f64; 3], expected: bool) {
        let positions = vec![DVec3::ZERO, DVec3::Y, DVec3::NEG_X, DVec3::new(1.0, 0.0, up)];
        let mesh = Mesh { positions, normals: None, faces: vec![[0, 1, 2], [1, 0, 3]] };
        let ray = Ray::new(DVec3::new(-0.1, 0.5, 0.0), DVec3::from(direction));
        let facets = facets(mesh);
        let left = LeftTriangle::of(&facets, leaving(0), &ray).map(|left| left.bars(&facets, 1, &ray));
        assert_eq!(left, Some(expected));
    }

    #[test]
    fn a_neighbour_is_hit_in_a_valley_only() {
        bars(1.0, [1.0, 0.0, 0.1], false);
        bars(1.0, [1.0, 0.0, -0.1], true);
        bars(1.0, [1.0, 0.0, 2.0], true);
        bars(-1.0, [1.0, 0.0, 0.1], true);
        bars(-1.0, [1.0, 0.0, -0.1], false);
        bars(0.0, [1.0, 0.0, 0.1], true);
    }

    /// The same for all rays to a light between these heights over the far end of the second half.
    #[track_caller]
    fn bars_all(up: f64, heights: [f64; 2], side: Side, expected: bool) {
        let positions = vec![DVec3::ZERO, DVec3::Y, DVec3::NEG_X, DVec3::new(1.0, 0.0, up)];
        let mesh = Mesh { positions, normals: None, faces: vec![[0, 1, 2], [1, 0, 3]] };
        let facets = facets(mesh);
        let [min, max] = heights.map(|height| DVec3::new(10.0, 0.5, height));
        let shaft =
            Shaft::new(DVec3::new(-0.1, 0.5, 0.0), Bounds { min, max }, ((min + max) * 0.5, heights[1] - heights[0]));
        let left = LeftTriangle::in_shaft(&facets, Leaving { side, ..leaving(0) }, &shaft);
        assert_eq!(left.map(|left| left.bars_all(&facets, 1, &shaft)), Some(expected));
    }

    #[test]
    fn a_neighbour_is_out_of_the_way_to_all_of_a_light_or_not() {
        // A valley: all of the light has to be above the other slope.
        bars_all(1.0, [12.0, 30.0], Side::Front, true);
        bars_all(1.0, [9.0, 30.0], Side::Front, false);
        // A ridge: what leaves one slope upward never meets the other.
        bars_all(-1.0, [0.1, 30.0], Side::Front, true);
        // The light is on both sides, or on another one than the rays are said to leave.
        bars_all(-1.0, [-0.1, 30.0], Side::Front, false);
        bars_all(-1.0, [0.1, 30.0], Side::Back, false);
    }

    #[test]
    fn a_ray_that_begins_elsewhere_leaves_nothing_but_the_triangle_itself() {
        let positions = vec![DVec3::ZERO, DVec3::Y, DVec3::NEG_X, DVec3::new(1.0, 0.0, -1.0)];
        let mesh = Mesh { positions, normals: None, faces: vec![[0, 1, 2], [1, 0, 3]] };
        let ray = Ray::new(DVec3::new(-0.1, 0.5, 1.0), DVec3::new(1.0, 0.0, 0.1));
        let facets = facets(mesh);
        let left = LeftTriangle::of(&facets, leaving(0), &ray);
        assert_eq!(
            left.as_ref().map(|left| [0, 1].map(|triangle| left.bars(&facets, triangle, &ray))),
            Some([true, false])
        );
        assert!(LeftTriangle::of(&facets, leaving(9), &ray).is_none());
    }
}
