//! The normal of a triangle with all its digits, however thin the triangle is.
//!
//! The products of a cross product cancel where two edges are nearly parallel: at an aspect of 10¹⁵ the plain formula has no
//! right digit left, and the distance to the plane has none either. Here differences and products keep their rounding
//! errors (see [`super::doubled`]).

use super::doubled::Doubled;
use glam::DVec3;

/// (b − a) × (c − a): perpendicular to the triangle, its length twice the area; zero for a triangle without area.
///
/// Where the processor has a fused operation, the rounding error of a product takes one instruction. Both ways give the same bits, because the
/// error is a number of f64, which both find.
#[inline]
pub(super) fn area_normal(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
    #[cfg(target_arch = "x86_64")]
    if let Some(normal) = super::processor::avx2().and_then(|v3| fused::area_normal(v3, a, b, c)) {
        return normal;
    }
    plain(a, b, c)
}

fn plain(a: DVec3, b: DVec3, c: DVec3) -> DVec3 {
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
    let (first, second) = (Doubled::product(a.head, b.head), Doubled::product(c.head, d.head));
    let heads = Doubled::sum(first.head, -second.head);
    let mixed = (a.head * b.tail + a.tail * b.head) - (c.head * d.tail + c.tail * d.head);
    let result = heads.head + (heads.tail + ((first.tail - second.tail) + mixed));
    // False for an infinite noise and for NaN.
    let is_known = result.abs() > (first.head.abs() + second.head.abs()) * NOISE;
    if is_known { result } else { 0.0 }
}

/// The errors left below are at most about 2⁻¹⁰³ of the products.
const NOISE: f64 = 16.0 * f64::EPSILON * f64::EPSILON;

#[cfg(target_arch = "x86_64")]
mod fused {
    //! The same operations in the same order as in [`plain`](super::plain), but for the errors of products, with the components side by side.

    use super::NOISE;
    use glam::DVec3;
    use pulp::x86::V3;
    use std::arch::x86_64::{__m256d, _CMP_EQ_OQ, _CMP_GE_OQ, _CMP_GT_OQ, _CMP_LE_OQ};

    /// The sizes of edges whose products keep their errors.
    const SIZES: [f64; 2] = [1e-100, 1e100];

    /// Numbers of twice the digits side by side.
    #[derive(Clone, Copy)]
    struct Doubled4 {
        head: __m256d,
        tail: __m256d,
    }

    /// What [`area_normal`](super::area_normal) gives; `None` for edges of extreme lengths.
    #[inline]
    pub fn area_normal(v3: V3, a: DVec3, b: DVec3, c: DVec3) -> Option<DVec3> {
        v3.vectorize(
            #[inline(always)]
            || with(v3, a, b, c),
        )
    }

    #[inline(always)]
    fn with(v3: V3, a: DVec3, b: DVec3, c: DVec3) -> Option<DVec3> {
        let avx = v3.avx;
        let four = |vector: DVec3| avx._mm256_setr_pd(vector.x, vector.y, vector.z, 0.0);
        let size = |x| avx._mm256_andnot_pd(avx._mm256_set1_pd(-0.0), x);
        let minus_a = avx._mm256_xor_pd(four(a), avx._mm256_set1_pd(-0.0));
        let (u, v) = (sum(v3, four(b), minus_a), sum(v3, four(c), minus_a));
        let is_plain = |x| {
            let (size, [least, most]) = (size(x), SIZES.map(|size| avx._mm256_set1_pd(size)));
            let is_middling = avx._mm256_and_pd(
                avx._mm256_cmp_pd::<_CMP_GE_OQ>(size, least),
                avx._mm256_cmp_pd::<_CMP_LE_OQ>(size, most),
            );
            avx._mm256_or_pd(is_middling, avx._mm256_cmp_pd::<_CMP_EQ_OQ>(x, avx._mm256_setzero_pd()))
        };
        if avx._mm256_movemask_pd(avx._mm256_and_pd(is_plain(u.head), is_plain(v.head))) != 0b1111 {
            return None;
        }
        // y, z, x and z, x, y
        let next = |x: Doubled4| {
            let turned = |x| v3.avx2._mm256_permute4x64_pd::<0b11_00_10_01>(x);
            Doubled4 { head: turned(x.head), tail: turned(x.tail) }
        };
        let last = |x: Doubled4| {
            let turned = |x| v3.avx2._mm256_permute4x64_pd::<0b11_01_00_10>(x);
            Doubled4 { head: turned(x.head), tail: turned(x.tail) }
        };
        let (a, b, c, d) = (next(u), last(v), last(u), next(v));
        let add = |a, b| avx._mm256_add_pd(a, b);
        let sub = |a, b| avx._mm256_sub_pd(a, b);
        let mul = |a, b| avx._mm256_mul_pd(a, b);
        let (first, second) = (product(v3, a.head, b.head), product(v3, c.head, d.head));
        let heads = sum(v3, first.head, avx._mm256_xor_pd(second.head, avx._mm256_set1_pd(-0.0)));
        let mixed = sub(add(mul(a.head, b.tail), mul(a.tail, b.head)), add(mul(c.head, d.tail), mul(c.tail, d.head)));
        let result = add(heads.head, add(heads.tail, add(sub(first.tail, second.tail), mixed)));
        let noise = mul(add(size(first.head), size(second.head)), avx._mm256_set1_pd(NOISE));
        let is_known = avx._mm256_cmp_pd::<_CMP_GT_OQ>(size(result), noise);
        let [x, y, z, _]: [f64; 4] = pulp::cast(avx._mm256_and_pd(result, is_known));
        Some(DVec3::new(x, y, z))
    }

    /// a + b without any error, as [`Doubled::sum`](super::Doubled::sum).
    #[inline(always)]
    fn sum(v3: V3, a: __m256d, b: __m256d) -> Doubled4 {
        let (add, sub) = (|a, b| v3.avx._mm256_add_pd(a, b), |a, b| v3.avx._mm256_sub_pd(a, b));
        let head = add(a, b);
        let b_in_head = sub(head, a);
        let tail = add(sub(a, sub(head, b_in_head)), sub(b, b_in_head));
        Doubled4 { head, tail }
    }

    /// a·b without any error.
    #[inline(always)]
    fn product(v3: V3, a: __m256d, b: __m256d) -> Doubled4 {
        let head = v3.avx._mm256_mul_pd(a, b);
        Doubled4 { head, tail: v3.fma._mm256_fmsub_pd(a, b, head) }
    }
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

    #[test]
    fn every_processor_gives_the_same_bits() {
        let mut state = 1_u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let digits = (state >> 12) as f64 / (1_u64 << 52) as f64 - 0.5;
            match state >> 7 & 31 {
                0 => 0.0,
                1 => -0.0,
                2 => digits * 1e-90,
                3 => digits * 1e-160,
                4 => digits * 1e160,
                5..16 => (digits as f32).into(),
                16..20 => (digits * 4.0).round(),
                _ => digits,
            }
        };
        let mut zeros = 0;
        for round in 0..200_000 {
            let [a, b, mut c] = [0; 3].map(|_| DVec3::new(number(), number(), number()));
            if round % 4 == 0 {
                // Nearly on one line.
                c = a + (b - a) * 3.0;
            }
            let bits = |normal: DVec3| normal.to_array().map(f64::to_bits);
            assert_eq!(bits(area_normal(a, b, c)), bits(plain(a, b, c)), "{a:?} {b:?} {c:?}");
            zeros += u32::from(plain(a, b, c) == DVec3::ZERO);
        }
        assert!(zeros > 10, "{zeros}");
    }
}
