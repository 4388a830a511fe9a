//! The normal of a triangle with all its digits, however thin the triangle is.
//!
//! The products of a cross product cancel where two edges are nearly parallel: at an aspect of 10¹⁵ the plain formula has no
//! right digit left, and the distance to the plane has none either. Here differences and products keep their rounding
//! errors (see [`super::doubled`]).

use super::doubled::Doubled;
use glam::DVec3;

/// (b − a) × (c − a): perpendicular to the triangle, its length twice the area; zero for a triangle without area.
pub(super) fn area_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    let [u_x, u_y, u_z] = differences(b, a);
    let [v_x, v_y, v_z] = differences(c, a);
    DVec3::new(
        difference_of_products(u_y, v_z, u_z, v_y),
        difference_of_products(u_z, v_x, u_x, v_z),
        difference_of_products(u_x, v_y, u_y, v_x),
    )
}

fn differences(a: DVec3, b: DVec3) -> [Doubled; 3] {
    [Doubled::sum(a.x, -b.x), Doubled::sum(a.y, -b.y), Doubled::sum(a.z, -b.z)]
}

/// a·b − c·d with about twice the digits of f64 before its last rounding. What lies below the rounding errors counts as
/// zero, and so does what overflows.
fn difference_of_products(a: Doubled, b: Doubled, c: Doubled, d: Doubled) -> f64 {
    /// The errors left below are at most about 2⁻¹⁰³ of the products.
    const NOISE: f64 = 16.0 * f64::EPSILON * f64::EPSILON;
    let (first, second) = (Doubled::product(a.head, b.head), Doubled::product(c.head, d.head));
    let heads = Doubled::sum(first.head, -second.head);
    let mixed = (a.head * b.tail + a.tail * b.head) - (c.head * d.tail + c.tail * d.head);
    let result = heads.head + (heads.tail + ((first.tail - second.tail) + mixed));
    // False for an infinite noise and for NaN.
    let is_known = result.abs() > (first.head.abs() + second.head.abs()) * NOISE;
    if is_known { result } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::size::unit;

    #[test]
    fn plain_triangles_are_exact() {
        assert_eq!(area_normal(DVec3::ZERO, DVec3::X, DVec3::Y), DVec3::Z);
        let normal = area_normal(DVec3::new(1.0, 2.0, 3.0), DVec3::new(4.0, 2.0, 3.0), DVec3::new(1.0, 4.0, 8.0));
        assert_eq!(normal, DVec3::new(0.0, -15.0, 6.0));
    }

    #[test]
    fn a_needle_keeps_its_digits() {
        // Whole numbers, so that i128 has the exact answer.
        let [b, c] = [[35_184_372_101_177_i64, 35_184_372_187_597], [35_184_372_143_153, 35_184_372_229_573]];
        let exact = i128::from(b[0]) * i128::from(c[1]) - i128::from(b[1]) * i128::from(c[0]);
        let [b, c] = [b, c].map(|[x, y]| DVec3::new(x as f64, y as f64, 0.0));
        assert_eq!(area_normal(DVec3::ZERO, b, c), DVec3::Z * exact as f64);
        assert_ne!(b.cross(c), DVec3::Z * exact as f64, "the plain formula would do as well");
    }

    #[test]
    fn no_area_is_exactly_zero() {
        let step = DVec3::new(0.1, 0.7, -0.3);
        for scale in [1e-80, 1e-9, 1.0, 1e9, 1e80] {
            let a = DVec3::new(0.3, 0.2, 0.9) * scale;
            for (b, c) in [(a, a), (a, a + step), (a + step, a), (step * 2.0 + a, a)] {
                assert_eq!(area_normal(a, b, c), DVec3::ZERO);
            }
            assert_eq!(area_normal(DVec3::ZERO, step * scale, step * scale * 4.0), DVec3::ZERO);
        }
        assert_eq!(area_normal(DVec3::X * 1e300, DVec3::Y * 1e300, DVec3::Z * 1e300), DVec3::ZERO);
    }

    #[test]
    fn powers_of_two_change_no_digit() {
        let (a, b, c) = (DVec3::new(0.1, 0.2, 0.3), DVec3::new(0.7, -0.1, 0.4), DVec3::new(-0.5, 0.9, 0.2));
        let power = f64::from_bits((1023 - 300) << 52);
        let small = area_normal(a * power, b * power, c * power);
        assert_eq!(small, area_normal(a, b, c) * power * power);
        assert_eq!(unit(small), unit(area_normal(a, b, c)));
    }
}
