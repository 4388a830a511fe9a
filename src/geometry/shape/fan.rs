//! The triangles of a polygon, for the interpolation of the normals at its corners.
//!
//! They are the fan from the first corner, as NFF's programs have it, as far as that lies inside the polygon; where it doesn't,
//! the next ear is cut off instead (Meisters, 1975). A polygon of three corners is its own triangle.

use super::triangle::Facet;
use crate::probe::Silent;
use glam::{DVec2, DVec3};

/// Triangles, each with the normals at its corners.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fan {
    triangles: Vec<(Facet, [DVec3; 3])>,
}

impl Fan {
    /// Cuts a polygon with these corners and normals into triangles. In the outline it runs counter-clockwise.
    pub fn new(corners: &[DVec3], normals: &[[f64; 3]], outline: &[DVec2]) -> Fan {
        let normals: Vec<DVec3> = normals.iter().copied().map(DVec3::from).collect();
        let normal = |corner: usize| normals.get(corner).copied().unwrap_or_default();
        let triangle =
            |[a, b, c]: [usize; 3]| (Facet::new(corners[a], corners[b], corners[c]), [normal(a), normal(b), normal(c)]);
        Fan { triangles: triangles(outline).into_iter().map(triangle).collect() }
    }

    /// The triangle that holds a point of the polygon; `None` if none has an area. Where rounding puts the point outside all
    /// of them it is the one that it is least outside of.
    pub fn triangle_at(&self, point: DVec3) -> Option<(&Facet, &[DVec3; 3])> {
        let depth = |facet: &Facet| {
            let [w_a, w_b, w_c] = facet.weights(facet.normal, point, &Silent);
            w_a.min(w_b).min(w_c)
        };
        let rated = self.triangles.iter().map(|(facet, normals)| (depth(facet), facet, normals));
        let deepest = rated.filter(|(depth, ..)| depth.is_finite()).max_by(|(a, ..), (b, ..)| a.total_cmp(b));
        deepest.map(|(_, facet, normals)| (facet, normals))
    }
}

/// The triangles of a counter-clockwise outline, by the numbers of their corners.
pub(super) fn triangles(outline: &[DVec2]) -> Vec<[usize; 3]> {
    let mut rest: Vec<usize> = (0..outline.len()).collect();
    let mut cut = Vec::with_capacity(outline.len());
    while rest.len() > 3 {
        let count = rest.len();
        let around = |at: usize| [rest[(at + count - 1) % count], rest[at], rest[(at + 1) % count]];
        // The second corner first: that makes the fan. An outline that crosses itself may have no ear at all.
        let at = (1..=count).map(|at| at % count).find(|at| is_ear(around(*at), &rest, outline)).unwrap_or(1);
        cut.push(around(at));
        rest.remove(at);
    }
    if let [a, b, c] = rest[..] {
        cut.push([a, b, c]);
    }
    cut
}

/// Whether a corner with its neighbours is a triangle inside the outline: one that turns left and holds no other corner.
fn is_ear(corners: [usize; 3], rest: &[usize], outline: &[DVec2]) -> bool {
    let [a, b, c] = corners.map(|corner| outline[corner]);
    let is_left = |from: DVec2, to: DVec2, point: DVec2| (to - from).perp_dot(point - from);
    let holds =
        |point: DVec2| is_left(a, b, point) >= 0.0 && is_left(b, c, point) >= 0.0 && is_left(c, a, point) >= 0.0;
    let is_other = |point: DVec2| point != a && point != b && point != c;
    is_left(a, b, c) > 0.0 && !rest.iter().map(|corner| outline[*corner]).any(|point| is_other(point) && holds(point))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outline(points: &[[f64; 2]]) -> Vec<DVec2> {
        points.iter().copied().map(DVec2::from).collect()
    }

    fn area(outline: &[DVec2], [a, b, c]: [usize; 3]) -> f64 {
        (outline[b] - outline[a]).perp_dot(outline[c] - outline[a]) / 2.0
    }

    #[test]
    fn a_convex_outline_is_a_fan_from_its_first_corner() {
        let pentagon = outline(&[[0.0, 0.0], [2.0, 0.0], [3.0, 2.0], [1.0, 3.0], [-1.0, 2.0]]);
        assert_eq!(triangles(&pentagon), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    }

    #[test]
    fn an_arrow_whose_notch_is_over_against_is_a_fan() {
        let arrow = outline(&[[0.0, 0.0], [4.0, 0.0], [1.0, 1.0], [0.0, 4.0]]);
        assert_eq!(triangles(&arrow), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn triangles_of_a_concave_outline_turn_left_and_fill_it() {
        let comb = outline(&[
            [0.0, 0.0],
            [6.0, 0.0],
            [6.0, 3.0],
            [5.0, 3.0],
            [5.0, 1.0],
            [3.5, 1.0],
            [3.0, 3.0],
            [2.0, 1.0],
            [1.0, 1.0],
            [0.0, 3.0],
        ]);
        let cut = triangles(&comb);
        assert_eq!(cut.len(), 8);
        assert!(cut.iter().all(|triangle| area(&comb, *triangle) > 0.0), "{cut:?}");
        let whole: f64 = comb.iter().zip(comb.iter().cycle().skip(1)).map(|(a, b)| a.perp_dot(*b)).sum::<f64>() / 2.0;
        let sum: f64 = cut.iter().map(|triangle| area(&comb, *triangle)).sum();
        assert!((sum - whole).abs() < 1e-12, "{sum} of {whole}");
    }

    #[test]
    fn what_has_no_ears_is_cut_all_the_same() {
        let crossing = outline(&[[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]]);
        assert_eq!(triangles(&crossing).len(), 2);
        assert!(triangles(&outline(&[[0.0, 0.0]; 2])).is_empty());
    }
}
