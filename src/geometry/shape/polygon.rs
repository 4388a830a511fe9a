//! The flat polygon with three or more corners, convex or concave.
//!
//! Its plane has the normal that Newell's method gives, the mean over all corners (Tampieri, Graphics Gems III, V.5). The
//! number of edges that a half plane from the ray's line crosses says whether the ray passes inside (Shimrat, 1962; Haines,
//! Graphics Gems IV, I.4): the signs that decide it are right (see [`edge`](super::edge)), so that of two polygons that share
//! an edge exactly one holds a ray through it.

use super::edge::HalfPlane;
use super::fan::{Fan, triangles};
use super::flat::{BoxNames, PlaneNames, kept_in_box, meet_plane_certainly, refined, toward, unaltered};
use super::{Approach, Kernel, decide};
use crate::geometry::area_normal::area_normal;
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::ray::{Crossing, Ray, Surface};
use crate::geometry::size::unit;
use crate::log::{Decision, Miss, Name};
use crate::probe::Probe;
use glam::{DVec2, DVec3};

/// A flat polygon. Its front is the side from which its corners run counter-clockwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    /// The first is the plane's point.
    pub(super) corners: Box<[DVec3]>,
    /// Of twice the polygon's area.
    normal: DVec3,
    unit_normal: DVec3,
    bounds: Bounds,
    is_convex: bool,
    /// Triangles with the normals at their corners, if shading is smooth.
    fan: Option<Box<Fan>>,
}

/// The plane of two axes, so turned that a polygon runs counter-clockwise in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Projection {
    across: usize,
    up: usize,
}

const PLANE: PlaneNames = PlaneNames { v_d: Name::PolygonVd, v_o: Name::PolygonVo, t: Name::PolygonT };
const IN_BOX: BoxNames = BoxNames { near: Name::PolygonTNear, far: Name::PolygonTFar, t: Name::PolygonTInBox };

/// The triangles into which a flat outline with these corners falls, two fewer than corners, by the numbers of their
/// corners.
pub fn triangulate(corners: &[DVec3]) -> Vec<[usize; 3]> {
    triangles(&outline(corners, newell_normal(corners)))
}

/// Corners in the projection along the largest component of a normal.
fn outline(corners: &[DVec3], normal: DVec3) -> Vec<DVec2> {
    let projection = Projection::along(normal);
    corners.iter().map(|corner| projection.of(*corner)).collect()
}

fn is_convex(corners: &[DVec2]) -> bool {
    let corner = |k: usize| corners[k % corners.len()];
    let turn = |k: usize| (corner(k + 1) - corner(k)).perp_dot(corner(k + 2) - corner(k + 1));
    let is_left = |k: usize| turn(k) >= 0.0;
    // One that winds around twice turns left too: a fan from a corner then turns back.
    let is_fan = |k: usize| (corner(k) - corner(0)).perp_dot(corner(k + 1) - corner(0)) >= 0.0;
    (0..corners.len()).all(|k| is_left(k) && is_fan(k))
}

impl Polygon {
    /// Its corners.
    pub fn corners(&self) -> &[DVec3] {
        &self.corners
    }

    /// Whether its normals are interpolated.
    pub fn is_smooth(&self) -> bool {
        self.fan.is_some()
    }

    /// Whether the corners lie in one plane, up to roundings.
    pub fn is_plane(&self) -> bool {
        let height = |corner: &DVec3| self.unit_normal.dot(*corner - self.corners[0]).abs();
        let size = self.corners.iter().map(|corner| corner.abs().max_element()).fold(0.0, f64::max);
        self.corners.iter().all(|corner| height(corner) <= 1e-12 * size)
    }

    /// Whether it turns the same way at all corners, once around.
    pub fn is_convex(&self) -> bool {
        self.is_convex
    }

    /// The polygon with these corners, three or more; with a normal for each its shading is smooth.
    pub fn new(vertices: &[[f64; 3]], normals: Option<&[[f64; 3]]>) -> Polygon {
        Polygon::of(vertices.to_vec(), normals)
    }

    /// The same of a list that nobody needs any more: it becomes that of the polygon.
    pub fn of(vertices: Vec<[f64; 3]>, normals: Option<&[[f64; 3]]>) -> Polygon {
        let corners: Box<[DVec3]> = vertices.into_iter().map(DVec3::from).collect();
        let normal = newell_normal(&corners);
        let unit_normal = unit(normal);
        let point = corners.first().copied().unwrap_or_default();
        // Where corners don't lie in one plane the surface is that of their mean, which may leave the box around them.
        let onto_plane = |corner: &DVec3| *corner - unit_normal * unit_normal.dot(*corner - point);
        let on_plane = corners.iter().map(onto_plane).filter(|corner| corner.is_finite());
        Polygon {
            normal,
            unit_normal,
            bounds: Bounds::around(corners.iter().copied().chain(on_plane)),
            is_convex: is_convex(&outline(&corners, normal)),
            fan: normals.map(|normals| Box::new(Fan::new(&corners, normals, &outline(&corners, normal)))),
            corners,
        }
    }

    /// A point of the plane.
    fn corner(&self) -> DVec3 {
        self.corners.first().copied().unwrap_or_default()
    }

    /// Whether the ray's line passes inside.
    #[inline]
    fn is_inside<P: Probe>(&self, ray: &Ray, probe: &mut P) -> bool {
        let crossings = HalfPlane::of(ray, probe.certifies()).crossings(&self.corners);
        if crossings.in_doubt {
            probe.fallback();
        }
        // A count is exact in any arithmetic, and no formula gives it.
        probe.given(Name::PolygonCrossings, f64::from(crossings.count));
        crossings.count % 2 == 1
    }
}

impl Kernel for Polygon {
    fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::PolygonCorner, self.corner());
        probe.given(Name::PolygonNormal, self.normal);
        probe.given(Name::PolygonUnitNormal, self.unit_normal);
    }

    #[inline]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let corner = self.corner();
        let plane = meet_plane_certainly(ray, self.normal, corner, (&PLANE, Name::PolygonTDoubled), probe)?;
        let candidate = Crossing { t: plane.t, side: plane.side, primitive: 0 };
        if !(ray.reaches(plane.t) && approach.shows(plane.side)) {
            return decide(ray, approach, candidate, None, probe);
        }
        if !self.is_inside(ray, probe) {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        }
        let quotient = unaltered(plane.t, ray, self.normal, corner, probe);
        let t = kept_in_box(self.bounds, ray, plane.t, quotient, &IN_BOX, probe)?;
        let crossing = Crossing { t, ..candidate };
        self.decide(ray, approach, crossing, probe)
    }

    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
        let side = crossing.side;
        let Some((facet, normals)) = self.fan.as_ref().and_then(|fan| fan.triangle_at(point)) else {
            let normal = toward(side, self.unit_normal, Name::HitNormalPolygon, Name::HitNormalPolygonBack, probe);
            return Surface::plain(point, normal, side);
        };
        let (front, back) = (Name::HitGeometricNormalPolygon, Name::HitGeometricNormalPolygonBack);
        let geometric_normal = toward(side, self.unit_normal, front, back, probe);
        let normal = facet.shading_normal(normals, point, geometric_normal, probe);
        Surface::interpolated(point, normal, geometric_normal, side)
    }

    fn refined(&self, ray: &Ray, _crossing: Crossing) -> Doubled {
        refined(ray, self.normal, self.corner())
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(self.bounds)
    }
}

/// Twice the area as a vector: the sum over the triangles that a first corner makes with the edges, which is Newell's sum with
/// that corner as origin, so that it doesn't cancel far from the coordinates' origin.
fn newell_normal(corners: &[DVec3]) -> DVec3 {
    let Some((first, others)) = corners.split_first() else { return DVec3::ZERO };
    let normal: DVec3 = others.windows(2).map(|edge| area_normal(*first, edge[0], edge[1])).sum();
    if normal.is_finite() { normal } else { DVec3::ZERO }
}

impl Projection {
    /// The projection along the largest component of a normal.
    fn along(normal: DVec3) -> Projection {
        let size = normal.abs();
        let axis = if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        let (next, after_next) = ((axis + 1) % 3, (axis + 2) % 3);
        let points_along_axis = normal[axis] >= 0.0;
        let (across, up) = if points_along_axis { (next, after_next) } else { (after_next, next) };
        Projection { across, up }
    }

    fn of(self, point: DVec3) -> DVec2 {
        DVec2::new(point[self.across], point[self.up])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::ray::Side;
    use crate::probe::Silent;

    const ARROW: [[f64; 3]; 4] = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 4.0, 0.0]];

    fn holds(polygon: &Polygon, x: f64, y: f64) -> bool {
        let ray = Ray::new(DVec3::new(x, y, 1.0), DVec3::NEG_Z);
        let found = polygon.first_crossing(&ray, Approach { leaving: None, one_sided: false }, &mut Silent);
        assert!(found.is_none_or(|crossing| (crossing.t, crossing.side) == (1.0, Side::Front)));
        found.is_some()
    }

    #[test]
    fn a_notch_is_outside() {
        let arrow = Polygon::new(&ARROW, None);
        assert_eq!(arrow.normal, DVec3::Z * 8.0);
        assert!(holds(&arrow, 0.5, 0.5) && holds(&arrow, 3.0, 0.25) && holds(&arrow, 0.25, 3.0));
        assert!(!holds(&arrow, 1.5, 1.5) && !holds(&arrow, 2.0, 1.0) && !holds(&arrow, -0.1, 1.0));
    }

    #[test]
    fn a_line_through_corners_counts_each_once() {
        let diamond = Polygon::new(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]], None);
        assert!(holds(&diamond, 0.0, 0.0) && !holds(&diamond, -2.0, 0.0) && !holds(&diamond, 2.0, 0.0));
        assert!(!holds(&diamond, -0.5, 1.0) && !holds(&diamond, -0.5, -1.0));
    }

    #[test]
    fn of_two_neighbours_one_holds_each_point_of_the_edge() {
        let (low, high) = ([0.0, 0.0, 0.0], [1.0, 3.0, 0.0]);
        let right = Polygon::new(&[low, [4.0, 0.0, 0.0], high], None);
        let left = Polygon::new(&[high, [-2.0, 1.0, 0.0], low], None);
        for k in 0..=64 {
            let part = f64::from(k) / 64.0;
            let count = [&left, &right].iter().filter(|polygon| holds(polygon, part, 3.0 * part)).count();
            assert!(count == 1 || (count == 0 && (k == 0 || k == 64)), "{count} hold the point {k}");
        }
    }

    #[test]
    fn the_front_is_where_the_corners_run_counter_clockwise() {
        for axis in 0..3 {
            let turned = |corner: [f64; 3]| [corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3]];
            let polygon = Polygon::new(&ARROW.map(turned), None);
            assert_eq!(polygon.unit_normal, DVec3::from(turned([0.0, 0.0, 1.0])));
            let mut backwards = ARROW.map(turned);
            backwards.reverse();
            assert_eq!(Polygon::new(&backwards, None).unit_normal, -polygon.unit_normal);
        }
    }
}
