//! The triangle, alone or as a facet of a mesh.
//!
//! Three edge functions with their right signs (see [`edge`](super::edge)) say whether the ray passes inside. A value of zero
//! counts as inside.
//!
//! The distance isn't made from the edge functions, although their weighted mean of the corners would give one: at the distance
//! D of a triangle of size s they err by D²/s² roundings. V_o/V_d with the triangle's own normal errs by a few, if
//! the normal has all its digits, which [`area_normal`] sees to.

use super::edge::{LEAST_SIZE, OF_EDGE};
use super::flat::{BoxNames, PlaneHit, PlaneNames, is_in_doubt_along, kept_in_box, meet_plane, toward, unaltered};
use super::{Approach, Kernel, decide};
use crate::geometry::area_normal::area_normal;
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::{Doubled, Doubled3, exponent, length};
use crate::geometry::exact::triple_product;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::geometry::size::unit;
use crate::log::{Decision, Miss, Name};
use crate::probe::{Probe, Silent};
use glam::DVec3;

/// A triangle. Its front is the side from which its corners run counter-clockwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {
    pub(super) facet: Facet,
    /// Normals at the corners, of any length; elsewhere, since most triangles have none.
    normals: Option<Box<[DVec3; 3]>>,
}

/// The kernel of a triangle: its three corners, and what is made of them once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::geometry) struct Facet {
    /// The first corner.
    pub a: DVec3,
    /// The second one.
    pub b: DVec3,
    /// The third one.
    pub c: DVec3,
    /// N_t = (B − A) × (C − A), with all its digits; zero for a triangle without area, which no ray hits.
    pub normal: DVec3,
}

const PLANE: PlaneNames = PlaneNames { v_d: Name::TriangleVd, v_o: Name::TriangleVo, t: Name::TriangleT };
const IN_BOX: BoxNames = BoxNames { near: Name::TriangleTNear, far: Name::TriangleTFar, t: Name::TriangleTInBox };

impl Triangle {
    /// Its corners.
    pub fn corners(&self) -> [DVec3; 3] {
        [self.facet.a, self.facet.b, self.facet.c]
    }

    /// The triangle with these corners; with normals there its shading is smooth.
    pub fn new(vertices: [[f64; 3]; 3], normals: Option<[[f64; 3]; 3]>) -> Triangle {
        let [a, b, c] = vertices.map(DVec3::from);
        Triangle { facet: Facet::new(a, b, c), normals: normals.map(|normals| Box::new(normals.map(DVec3::from))) }
    }

    /// Whether its normals are interpolated.
    pub fn is_smooth(&self) -> bool {
        self.normals.is_some()
    }

    /// The barycentric coordinates of a point of the triangle's plane, which aren't finite where there is no area.
    pub fn weights(&self, point: DVec3) -> [f64; 3] {
        self.facet.weights(self.facet.normal, point, &Silent)
    }
}

impl Kernel for Triangle {
    fn give<P: Probe>(&self, probe: &mut P) {
        self.facet.give(probe);
    }

    #[inline]
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing> {
        let near_end = |t: f64, side: Side| self.at_a_near_end(ray, approach, t, side, 0);
        self.facet.crossing(ray, approach, 0, near_end, probe)
    }

    #[inline]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        self.facet.surface(self.normals.as_deref(), ray, crossing, probe)
    }

    fn bounds(&self) -> Option<Bounds> {
        Some(self.facet.bounds())
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        self.facet.refined(ray, crossing)
    }
}

impl Facet {
    /// The kernel of the triangle with these corners.
    pub fn new(a: DVec3, b: DVec3, c: DVec3) -> Facet {
        Facet { a, b, c, normal: area_normal(a, b, c) }
    }

    /// Its corners.
    pub fn corners(&self) -> [DVec3; 3] {
        [self.a, self.b, self.c]
    }

    /// The corners, for the log.
    #[inline]
    pub fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::TriangleA, self.a);
        probe.given(Name::TriangleB, self.b);
        probe.given(Name::TriangleC, self.c);
    }

    /// Where the ray crosses the triangle, which has this number in its mesh; marks the decision, which is left to `near_end` where that
    /// may be an end of the ray.
    // Several times the work of a call, and of the results that it would return through memory.
    #[inline(always)]
    pub fn crossing<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        number: u32,
        near_end: impl FnOnce(f64, Side) -> Option<Miss>,
        probe: &mut P,
    ) -> Option<Crossing> {
        if !self.edges(ray, probe).is_some_and(is_inside) {
            probe.mark(Decision::Miss { why: Miss::Beside });
            return None;
        }
        self.crossing_inside(ray, approach, number, near_end, probe)
    }

    /// The rest of [`Facet::crossing`] for a line that passes inside the edges.
    #[inline(always)]
    pub fn crossing_inside<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        number: u32,
        near_end: impl FnOnce(f64, Side) -> Option<Miss>,
        probe: &mut P,
    ) -> Option<Crossing> {
        let normal = self.normal;
        probe.given(Name::TriangleNormal, normal);
        let plane = if probe.certifies() && is_in_doubt_along(ray, normal, self.a) {
            self.meet_doubled(ray, probe)?
        } else {
            meet_plane(ray, normal, self.a, &PLANE, probe)?
        };
        let quotient = unaltered(plane.t, ray, normal, self.a, probe);
        let t = kept_in_box(self.bounds(), ray, plane.t, quotient, &IN_BOX, probe)?;
        let crossing = Crossing { t, side: plane.side, primitive: number };
        let at_an_end = if ray.is_near_an_end(t) { near_end(t, plane.side) } else { None };
        decide(ray, approach, crossing, at_an_end, probe)
    }

    /// Where the ray hits the triangle's plane, with twice the digits.
    #[cold]
    #[inline(never)]
    fn meet_doubled<P: Probe>(self, ray: &Ray, probe: &mut P) -> Option<PlaneHit> {
        probe.fallback();
        let (v_d, distance) = self.doubled_distance(ray);
        let t = distance.value();
        if v_d.head == 0.0 || !(ray.origin + ray.direction * t).is_finite() {
            probe.mark(Decision::Miss { why: Miss::Parallel });
            return None;
        }
        let side = if v_d.head < 0.0 { Side::Front } else { Side::Back };
        Some(PlaneHit { t: probe.note(Name::TriangleTDoubled, t), side })
    }

    /// V_d for the ray's vector, in units that are nobody's, and the distance to the triangle's plane.
    fn doubled_distance(self, ray: &Ray) -> (Doubled, Doubled) {
        let [along_b, along_c] = [self.b, self.c].map(|corner| Doubled3::difference(corner, self.a));
        let to_a = Doubled3::difference(self.a, ray.origin);
        // Powers of two keep the products of three lengths in range.
        let size = exponent(along_b.size().max(along_c.size()));
        let normal = along_b.scaled(-size).cross(along_c.scaled(-size));
        let vector = Doubled3::from(ray.vector);
        let v_d = normal.dot(vector);
        (v_d, normal.dot(to_a) * length(ray.vector) / v_d)
    }

    /// The distance with twice the digits, unless that isn't where the triangle was met: along its own plane.
    pub fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        let (_, distance) = self.doubled_distance(ray);
        let is_there = (distance.head - crossing.t).abs() <= CLOSE * crossing.t.abs();
        if is_there { distance } else { Doubled::from(crossing.t) }
    }

    /// The surface at a crossing. Where there are normals at the corners, light is computed with their mean.
    pub fn surface<P: Probe>(
        &self,
        normals: Option<&[DVec3; 3]>,
        ray: &Ray,
        crossing: Crossing,
        probe: &mut P,
    ) -> Surface {
        let point = probe.note(Name::HitPoint, ray.origin + ray.direction * crossing.t);
        let side = crossing.side;
        let unit_normal = unit(self.normal);
        probe.given(Name::TriangleUnitNormal, unit_normal);
        let Some(normals) = normals else {
            let normal = toward(side, unit_normal, Name::HitNormalTriangle, Name::HitNormalTriangleBack, probe);
            return Surface::plain(point, normal, side);
        };
        let (front, back) = (Name::HitGeometricNormalTriangle, Name::HitGeometricNormalTriangleBack);
        let geometric_normal = toward(side, unit_normal, front, back, probe);
        let normal = self.shading_normal(normals, point, geometric_normal, probe);
        Surface::interpolated(point, normal, geometric_normal, side)
    }

    /// The mean of the corners' normals at a point of the triangle, of unit length and on the side of `geometric_normal`,
    /// which is that normal itself where the mean has no direction.
    pub fn shading_normal<P: Probe>(
        &self,
        normals: &[DVec3; 3],
        point: DVec3,
        geometric_normal: DVec3,
        probe: &mut P,
    ) -> DVec3 {
        let normal = self.normal;
        let [w_a, w_b, _] = self.weights(normal, point, probe);
        let [n_a, n_b, n_c] = *normals;
        self.give(probe);
        for (name, value) in [
            (Name::TriangleNormal, normal),
            (Name::TriangleUnitNormal, unit(normal)),
            (Name::TriangleNormalA, n_a),
            (Name::TriangleNormalB, n_b),
            (Name::TriangleNormalC, n_c),
        ] {
            probe.given(name, value);
        }
        if !(w_a.is_finite() && w_b.is_finite()) {
            return probe.note(Name::HitNormalFlat, geometric_normal);
        }
        let w_a = probe.note(Name::TriangleWeightA, w_a);
        let w_b = probe.note(Name::TriangleWeightB, w_b);
        let w_c = probe.note(Name::TriangleWeightC, 1.0 - w_a - w_b);
        let mean = n_a * w_a + n_b * w_b + n_c * w_c;
        if !mean.is_finite() {
            return probe.note(Name::HitNormalFlat, geometric_normal);
        }
        let mean = probe.note(Name::TriangleMeanNormal, mean);
        let length = mean.dot(mean).sqrt();
        if length == 0.0 || !length.is_finite() {
            probe.note(Name::HitNormalFlat, geometric_normal)
        } else if mean.dot(geometric_normal) < 0.0 {
            probe.note(Name::HitNormalMeanTurned, -mean / length)
        } else {
            probe.note(Name::HitNormalMean, mean / length)
        }
    }

    /// The barycentric coordinates of a point of the triangle's plane: each is the area of the triangle over against a corner,
    /// as a part of the whole. They aren't finite where there is no area.
    ///
    /// They are taken from the point, which is nearer to the corners than the ray's origin is.
    pub fn weights<P: Probe>(&self, normal: DVec3, point: DVec3, probe: &P) -> [f64; 3] {
        let unit_normal = unit(normal);
        let whole = probe.dot(unit_normal, normal);
        let [to_a, to_b, to_c] = [self.a - point, self.b - point, self.c - point];
        let w_a = probe.dot(unit_normal, to_b.cross(to_c)) / whole;
        let w_b = probe.dot(unit_normal, to_c.cross(to_a)) / whole;
        [w_a, w_b, 1.0 - w_a - w_b]
    }

    /// The least box around the triangle.
    #[inline(always)]
    pub fn bounds(&self) -> Bounds {
        Bounds { min: self.a.min(self.b).min(self.c), max: self.a.max(self.b).max(self.c) }
    }

    /// The edge functions, named after the corner over against the edge; `None` where their products overflow. Their sum is
    /// −N_t · d. Where rounding may have changed a sign they are those of the ray's vector, with their right signs.
    #[inline(always)]
    fn edges<P: Probe>(&self, ray: &Ray, probe: &mut P) -> Option<[f64; 3]> {
        let [to_a, to_b, to_c] = [self.a, self.b, self.c].map(|corner| corner - ray.origin);
        let edge_a = probe.dot(ray.direction, to_c.cross(to_b));
        let edge_b = probe.dot(ray.direction, to_a.cross(to_c));
        let edge_c = probe.dot(ray.direction, to_b.cross(to_a));
        if !(edge_a.is_finite() && edge_b.is_finite() && edge_c.is_finite()) {
            return None;
        }
        let edges = [
            probe.note(Name::TriangleEdgeA, edge_a),
            probe.note(Name::TriangleEdgeB, edge_b),
            probe.note(Name::TriangleEdgeC, edge_c),
        ];
        let size = to_a.abs().max(to_b.abs()).max(to_c.abs()).max_element();
        let bound = OF_EDGE * size * size;
        let is_in_doubt = is_in_doubt(edges, bound) || size < LEAST_SIZE;
        Some(if is_in_doubt && probe.certifies() { self.exact_edges(ray, probe) } else { edges })
    }

    /// The edge functions of the ray's vector without error.
    #[cold]
    #[inline(never)]
    fn exact_edges<P: Probe>(self, ray: &Ray, probe: &mut P) -> [f64; 3] {
        probe.fallback();
        let corners = [self.a, self.b, self.c].map(|corner| Doubled3::difference(corner, ray.origin));
        let size = exponent(corners.iter().map(|corner| corner.size()).fold(0.0, f64::max));
        let [to_a, to_b, to_c] = corners.map(|corner| corner.scaled(-size));
        let edges = DVec3::new(
            triple_product(ray.vector, to_c, to_b),
            triple_product(ray.vector, to_a, to_c),
            triple_product(ray.vector, to_b, to_a),
        );
        // Their signs are exact in any arithmetic; they have no unit, and no formula of the log gives them.
        probe.given(Name::TriangleEdgesExact, edges);
        edges.to_array()
    }
}

/// The greatest difference of a distance and the same with twice the digits, as a part of it.
const CLOSE: f64 = 1.0 / (1 << 20) as f64;

/// Whether the signs of these edge functions decide nothing because some of them may be wrong.
#[inline]
fn is_in_doubt(edges: [f64; 3], bound: f64) -> bool {
    let [a, b, c] = edges;
    let least = a.min(b).min(c);
    let greatest = a.max(b).max(c);
    let is_certainly_beside = least < -bound && greatest > bound;
    let is_certainly_inside = least > bound || greatest < -bound;
    !(is_certainly_beside || is_certainly_inside)
}

/// Whether the ray's line passes inside all three edges: the one place where their signs decide.
#[inline]
fn is_inside(edges: [f64; 3]) -> bool {
    let all_front = edges.iter().all(|edge| *edge >= 0.0);
    let all_back = edges.iter().all(|edge| *edge <= 0.0);
    // Both: the line lies in the triangle's plane.
    all_front != all_back
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probe::Silent;

    const APPROACH: Approach = Approach { leaving: None, one_sided: false };

    fn facet() -> Facet {
        Facet::new(DVec3::ZERO, DVec3::X, DVec3::Y)
    }

    #[test]
    fn the_answer_is_exact_in_front_and_behind() {
        let down = Ray::new(DVec3::new(0.25, 0.25, 2.0), DVec3::NEG_Z);
        let found = facet().crossing(&down, APPROACH, 7, |_, _| None, &mut Silent);
        assert_eq!(found, Some(Crossing { t: 2.0, side: Side::Front, primitive: 7 }));
        let up = Ray::new(DVec3::new(0.25, 0.25, -2.0), DVec3::Z);
        let found = facet().crossing(&up, APPROACH, 7, |_, _| None, &mut Silent);
        assert_eq!(found, Some(Crossing { t: 2.0, side: Side::Back, primitive: 7 }));
        assert_eq!(facet().crossing(&up, Approach { one_sided: true, ..APPROACH }, 7, |_, _| None, &mut Silent), None);
    }

    #[test]
    fn a_line_in_the_plane_misses() {
        let along = Ray::new(DVec3::new(-1.0, 0.25, 0.0), DVec3::X);
        assert_eq!(facet().crossing(&along, APPROACH, 0, |_, _| None, &mut Silent), None);
    }

    #[test]
    fn exchanged_corners_negate_an_edge_exactly() {
        let origin = DVec3::new(0.3, -0.7, 11.1);
        let ray = Ray::new(origin, DVec3::new(0.1, 0.2, -0.9));
        let one = Facet::new(DVec3::new(0.1, 0.2, 0.3), DVec3::new(1.7, 0.3, -0.2), DVec3::new(0.2, 1.9, 0.7));
        let other = Facet::new(one.b, one.a, DVec3::new(3.3, 2.2, 1.1));
        let edge = |facet: Facet| facet.edges(&ray, &mut Silent).map(|[_, _, edge_c]| edge_c);
        assert_eq!(edge(one), edge(other).map(|edge| -edge));
    }

    #[test]
    fn weights_of_the_corners_are_one_and_zero() {
        let facet = Facet::new(DVec3::ZERO, DVec3::X * 4.0, DVec3::Y * 2.0);
        assert_eq!(facet.weights(facet.normal, facet.a, &Silent), [1.0, 0.0, 0.0]);
        assert_eq!(facet.weights(facet.normal, facet.b, &Silent), [0.0, 1.0, 0.0]);
        assert_eq!(facet.weights(facet.normal, facet.c, &Silent), [0.0, 0.0, 1.0]);
    }
}
