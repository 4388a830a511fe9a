//! Points of an area light that are uniform by the solid angle under which a surface point sees it (Ramos, section 1.5: shadow rays are
//! distributed over the solid angle of a source).
//!
//! A sphere is seen as a cap of directions about its centre, all of them equally likely (Shirley, Wang and Zimmerman, "Monte Carlo
//! techniques for direct lighting calculations", 1996). Of a rectangle: Ureña, Fajardo and King, "An area-preserving parametrization for
//! spherical rectangles", 2013. Both keep strata together and of equal solid angle.

use super::light_surface::least_axis;
use crate::random::warp;
use glam::DVec3;
use std::f64::consts::TAU;

/// A point of a light, and the solid angle of all of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Seen<T> {
    /// The point.
    pub at: T,
    /// The solid angle in steradians.
    pub solid_angle: f64,
}

/// The outward unit normal at the point of a sphere that is seen at the place of a unit square: in the cap that faces the surface point
/// `from`, or anywhere if that lies inside.
pub(super) fn of_sphere(center: DVec3, radius: f64, from: DVec3, square: [f64; 2]) -> Seen<DVec3> {
    let toward = center - from;
    let distance = toward.length();
    if distance <= radius {
        let direction = DVec3::from(warp::sphere(square));
        let along = toward.dot(direction);
        let half_chord = (along * along - distance * distance + radius * radius).max(0.0).sqrt();
        let outward = direction * (along + half_chord) - toward;
        return Seen { at: outward / outward.length(), solid_angle: 2.0 * TAU };
    }
    let [x, y] = square;
    let widest_squared = (radius / distance) * (radius / distance);
    // 1 − cos θ_max, which keeps its digits where the light is far away.
    let cap = widest_squared / (1.0 + (1.0 - widest_squared).sqrt());
    let drop = y * cap;
    let sine_squared = drop * (2.0 - drop);
    let cosine = 1.0 - drop;
    // The angle at the centre, from the point's direction to that of the surface point.
    let part = (sine_squared / widest_squared).min(1.0);
    let at_center = (sine_squared / widest_squared.sqrt() + cosine * (1.0 - part).sqrt()).clamp(-1.0, 1.0);
    let across = (1.0 - at_center * at_center).max(0.0).sqrt();
    let axis = -toward / distance;
    let helper = axis.cross(least_axis(axis));
    let first = helper / helper.length();
    let second = axis.cross(first);
    let angle = TAU * x;
    let outward = axis * at_center + (first * libm::cos(angle) + second * libm::sin(angle)) * across;
    Seen { at: outward / outward.length(), solid_angle: TAU * cap }
}

/// The coordinates, from −1 to 1 along each of the two halves of perpendicular edges, of the point of a rectangle that is seen at the place
/// of a unit square; `None` where the solid angle is too small for f64: where the light is seen from its own plane, or from very far.
pub(super) fn of_rectangle(
    center: DVec3,
    [half_u, half_v]: [DVec3; 2],
    from: DVec3,
    [u, v]: [f64; 2],
) -> Option<Seen<[f64; 2]>> {
    let sides = [half_u.length(), half_v.length()];
    let [x, y] = [half_u / sides[0], half_v / sides[1]];
    let toward = center - from;
    // The plane of the light lies at −height along the axis that looks away from it.
    let height = x.cross(y).dot(toward).abs();
    let middle = [toward.dot(x), toward.dot(y)];
    let [x0, x1] = [middle[0] - sides[0], middle[0] + sides[0]];
    let [y0, y1] = [middle[1] - sides[1], middle[1] + sides[1]];
    if height == 0.0 {
        return None;
    }
    let corner = |x: f64, y: f64| DVec3::new(x, y, -height);
    let corners = [corner(x0, y0), corner(x1, y0), corner(x1, y1), corner(x0, y1)];
    // Each side of the spherical rectangle lies in a plane through the surface point.
    let mut planes = [DVec3::ZERO; 4];
    for (side, plane) in planes.iter_mut().enumerate() {
        let across = corners[side].cross(corners[(side + 1) % 4]);
        *plane = across / across.length();
    }
    let angle = |side: usize| libm::acos((-planes[side].dot(planes[(side + 1) % 4])).clamp(-1.0, 1.0));
    let angles = [0, 1, 2, 3].map(angle);
    let beyond = TAU - angles[2] - angles[3];
    let solid_angle = angles[0] + angles[1] - beyond;
    // Not a number, too.
    if solid_angle.is_nan() || solid_angle < LEAST_SOLID_ANGLE {
        return None;
    }
    let [b0, b1] = [planes[0].z, planes[2].z];
    let turned = u * solid_angle + beyond;
    let slope = (libm::cos(turned) * b0 - b1) / libm::sin(turned);
    let cosine = (slope.signum() / (slope * slope + b0 * b0).sqrt()).clamp(-1.0, 1.0);
    let at_x = (cosine * height / (1.0 - cosine * cosine).sqrt()).clamp(x0, x1);
    let distance_squared = at_x * at_x + height * height;
    let [h0, h1] = [y0, y1].map(|y| y / (distance_squared + y * y).sqrt());
    let h = h0 + v * (h1 - h0);
    let at_y = (h * (distance_squared / (1.0 - h * h)).sqrt()).clamp(y0, y1);
    let at = [(at_x - middle[0]) / sides[0], (at_y - middle[1]) / sides[1]];
    at.iter().all(|x| x.is_finite()).then_some(Seen { at, solid_angle })
}

/// Below this solid angle its points are drawn by area. It is the difference of angles of up to 2π, which has some eight roundings, less than
/// 2⁻⁴⁷: from here on it is right to 2⁻¹⁷ of itself. What is seen so small is far away, where both ways are the same, or seen from
/// within 10⁻⁹ of its plane.
const LEAST_SOLID_ANGLE: f64 = 1.0 / (1 << 30) as f64;

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn grid(n: u32) -> impl Iterator<Item = [f64; 2]> {
        let at = move |k: u32| (f64::from(k) + 0.5) / f64::from(n);
        (0..n * n).map(move |k| [at(k % n), at(k / n)])
    }

    /// The solid angle of a rectangle above its middle: 4·asin(a·b/√((a² + h²)(b² + h²))) for half sides a and b.
    #[test]
    fn the_solid_angle_of_a_rectangle_above_its_middle() {
        for (a, b, h) in [(1.0, 2.0, 1.5), (0.3, 0.3, 0.01), (5.0, 1.0, 20.0)] {
            let found = of_rectangle(DVec3::Z * h, [DVec3::X * a, DVec3::Y * b], DVec3::ZERO, [0.5, 0.5]);
            let expected = 4.0 * libm::asin(a * b / ((a * a + h * h) * (b * b + h * h)).sqrt());
            let found = found.expect("it is seen").solid_angle;
            assert!((found - expected).abs() < 1e-13 * PI, "{found} is not {expected}");
        }
    }

    /// Means of the coordinates by solid angle: of the points drawn, and by a quadrature with the weight cos θ/d² = h/d³.
    #[test]
    fn points_of_a_rectangle_are_uniform_by_solid_angle() {
        for (center, from) in [
            ([0.0, 0.0, 1.0], [0.2, 0.1, 0.0]),
            ([3.0, 1.0, 0.5], [0.0, 0.0, 0.0]),
            ([0.0, 0.0, -2.0], [4.0, 4.0, 1.0]),
        ] {
            let (center, from) = (DVec3::from(center), DVec3::from(from));
            let edges = [DVec3::new(0.6, 0.8, 0.0) * 1.5, DVec3::new(-0.8, 0.6, 0.0) * 0.7];
            let (mut drawn, mut weighed, mut weights) = ([0.0; 4], [0.0; 4], 0.0);
            for square in grid(400) {
                let [x, y] = of_rectangle(center, edges, from, square).expect("it is seen").at;
                assert!(x.abs() <= 1.0 + 1e-12 && y.abs() <= 1.0 + 1e-12, "{x}, {y}");
                let [s, t] = square.map(|x| 2.0 * x - 1.0);
                let distance = (center + edges[0] * s + edges[1] * t - from).length();
                let weight = 1.0 / (distance * distance * distance);
                weights += weight;
                for (k, (at, by)) in [(x, s), (y, t), (x * x, s * s), (x * y, s * t)].into_iter().enumerate() {
                    drawn[k] += at / 160_000.0;
                    weighed[k] += by * weight;
                }
            }
            for (at, by) in drawn.iter().zip(weighed) {
                assert!((at - by / weights).abs() < 1e-4, "{center}: {at} is not {}", by / weights);
            }
        }
    }

    #[test]
    fn points_of_a_sphere_are_seen_uniformly() {
        let (center, radius, from) = (DVec3::new(1.0, 2.0, 2.0), 1.2, DVec3::ZERO);
        // The mean direction of a cap has the length (1 + cos θ_max)/2.
        let cosine = (1.0_f64 - radius * radius / 9.0).sqrt();
        let mut sum = DVec3::ZERO;
        for square in grid(200) {
            let seen = of_sphere(center, radius, from, square);
            assert!((seen.solid_angle - TAU * (1.0 - cosine)).abs() < 1e-14 * TAU);
            let point = center + seen.at * radius;
            // It lies on the near side: the light itself doesn't hide it.
            assert!(seen.at.dot(from - point) >= -1e-9 && (seen.at.length() - 1.0).abs() < 1e-14);
            sum += point / (point.length() * 40_000.0);
        }
        let expected = center / 3.0 * (1.0 + cosine) / 2.0;
        assert!((sum - expected).length() < 1e-5, "{sum} is not {expected}");
    }

    #[test]
    fn from_inside_a_sphere_all_directions_are_alike() {
        let (center, radius, from) = (DVec3::new(1.0, 2.0, 2.0), 4.0, DVec3::new(0.0, 1.0, 2.0));
        let direction = |square| {
            let toward = center + of_sphere(center, radius, from, square).at * radius - from;
            toward / toward.length()
        };
        let mean: DVec3 = grid(200).map(direction).sum();
        assert!(mean.length() / 40_000.0 < 1e-9, "{mean}");
        assert_eq!(of_sphere(center, radius, center, [0.3, 0.4]).solid_angle, 4.0 * PI);
    }

    #[test]
    fn a_light_seen_edge_on_has_no_solid_angle() {
        let edges = [DVec3::X, DVec3::Y];
        assert_eq!(of_rectangle(DVec3::ZERO, edges, DVec3::new(5.0, 0.0, 0.0), [0.5, 0.5]), None);
        assert_eq!(of_rectangle(DVec3::ZERO, edges, DVec3::new(5.0, 0.0, 1e-12), [0.5, 0.5]), None);
        assert_eq!(of_rectangle(DVec3::ZERO, edges, DVec3::new(0.0, 0.0, 1e9), [0.5, 0.5]), None);
        assert!(of_rectangle(DVec3::ZERO, edges, DVec3::new(5.0, 0.0, 1e-6), [0.5, 0.5]).is_some());
    }
}
