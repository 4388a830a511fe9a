//! Unit vectors with all their digits, which every ray needs before anything else is known of it.

use super::doubled::{Doubled, exponent, length, scaled};
#[cfg(target_arch = "x86_64")]
use fused::Fused;
use glam::DVec3;

/// The unit vector along a vector, the vector itself scaled to a middling size, and its length. Scaling by a power of two,
/// which is exact, keeps the squares of very long and very short vectors in range.
///
/// Where the processor has a fused operation, the rounding error of a product takes one instruction instead of sixteen. Both ways give
/// the same bits, because the error is a number of f64, which both find.
#[inline]
pub(crate) fn unit(vector: DVec3) -> (DVec3, DVec3, f64) {
    #[cfg(target_arch = "x86_64")]
    if let Some(fused) = Fused::detected() {
        return fused.run(
            #[inline(always)]
            || fused.unit(vector),
        );
    }
    plain(vector)
}

/// Calls `body` with what [`unit`] gives, and so that all that is inlined into it may use the processor's best instructions.
#[inline(always)]
pub(crate) fn with_unit<R>(vector: DVec3, body: impl FnOnce((DVec3, DVec3, f64)) -> R) -> R {
    #[cfg(target_arch = "x86_64")]
    if let Some(fused) = Fused::detected() {
        return fused.run(
            #[inline(always)]
            || body(fused.unit(vector)),
        );
    }
    body(plain(vector))
}

#[inline(never)]
fn plain(vector: DVec3) -> (DVec3, DVec3, f64) {
    let power = exponent(vector.abs().max_element());
    let middling = middling(vector);
    // With twice the digits, so that the unit vector has no rounding errors but its last: its length would be an error of every
    // distance along it.
    let length = length(middling);
    let unit = DVec3::from_array(middling.to_array().map(|x| Doubled::from(x).quotient(length)));
    (unit, middling, scaled(length.value(), power))
}

/// The vector times the power of two that makes its greatest component one from 1 to 2.
#[inline]
pub(crate) fn middling(vector: DVec3) -> DVec3 {
    let power = exponent(vector.abs().max_element());
    DVec3::from_array(vector.to_array().map(|x| scaled(x, -power)))
}

#[cfg(target_arch = "x86_64")]
mod fused {
    //! The same operations in the same order as in [`plain`](super::plain), but for the errors of products, with the components side by
    //! side. The crate `pulp` vouches that the instructions are there.

    use crate::geometry::doubled::{Doubled, exponent, scaled};
    use crate::geometry::processor;
    use glam::DVec3;
    use pulp::x86::V3;

    /// The sizes of vectors whose powers of two are plain numbers.
    const SIZES: std::ops::Range<f64> = 1e-300..1e300;

    /// A component less than this, as a part of the greatest, may have a square whose error is less than the least number.
    const LEAST: f64 = 1e-100;

    /// The proof that the processor has fused operations.
    #[derive(Clone, Copy)]
    pub struct Fused(V3);

    impl Fused {
        /// The proof, if there is one.
        #[inline(always)]
        pub fn detected() -> Option<Fused> {
            processor::avx2().map(Fused)
        }

        /// Calls `body`, in which all that is inlined may use the instructions.
        #[inline(always)]
        pub fn run<R>(self, body: impl FnOnce() -> R) -> R {
            self.0.vectorize(body)
        }

        /// What [`unit`](super::unit) gives.
        #[inline(always)]
        pub fn unit(self, vector: DVec3) -> (DVec3, DVec3, f64) {
            with(self.0, vector).unwrap_or_else(|| super::plain(vector))
        }
    }

    /// `None` for extreme vectors.
    #[inline(always)]
    fn with(v3: V3, vector: DVec3) -> Option<(DVec3, DVec3, f64)> {
        let size = vector.abs().max_element();
        if !SIZES.contains(&size) {
            return None;
        }
        let power = exponent(size);
        let middling = vector * scaled(1.0, -power);
        let is_plain = |x: f64| x == 0.0 || x.abs() >= LEAST;
        // False for what is no number.
        if !(is_plain(middling.x) & is_plain(middling.y) & is_plain(middling.z)) {
            return None;
        }
        let (avx, fma) = (v3.avx, v3.fma);
        let parts = avx._mm256_setr_pd(middling.x, middling.y, middling.z, 1.0);
        let squares = avx._mm256_mul_pd(parts, parts);
        let [x, y, z, _]: [f64; 4] = pulp::cast(squares);
        let [x_tail, y_tail, z_tail, _]: [f64; 4] = pulp::cast(fma._mm256_fmsub_pd(parts, parts, squares));
        let first = Doubled::sum(x, y);
        let all = Doubled::sum(first.head, z);
        let tail = first.tail + all.tail + (x_tail + y_tail + z_tail);
        let squared = all.head + tail;
        let squared_tail = tail - (squared - all.head);
        let length = squared.sqrt();
        let square = length * length;
        let of_root = avx._mm256_set1_pd(length);
        let [square_tail, ..]: [f64; 4] = pulp::cast(fma._mm256_fmsub_pd(of_root, of_root, avx._mm256_set1_pd(square)));
        let rest = (squared - square) + (squared_tail - square_tail);
        let length_tail = rest / (2.0 * length);
        let first = avx._mm256_div_pd(parts, of_root);
        let product = avx._mm256_mul_pd(first, of_root);
        let product_tail = fma._mm256_fmsub_pd(first, of_root, product);
        let rest = avx._mm256_sub_pd(avx._mm256_sub_pd(parts, product), product_tail);
        let rest = avx._mm256_sub_pd(rest, avx._mm256_mul_pd(first, avx._mm256_set1_pd(length_tail)));
        let [x, y, z, _]: [f64; 4] = pulp::cast(avx._mm256_add_pd(first, avx._mm256_div_pd(rest, of_root)));
        Some((DVec3::new(x, y, z), middling, scaled(length + length_tail, power)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unit_vectors_of_any_length() {
        for exponent in [-1000, -300, 0, 300, 1000] {
            let scale = libm::scalbn(1.0, exponent);
            let (direction, vector, length) = unit(DVec3::new(3.0, 0.0, 4.0) * scale);
            assert_eq!(direction, DVec3::new(0.6, 0.0, 0.8));
            assert_eq!(length, 5.0 * scale);
            assert!(vector.length() < 1e101);
        }
    }

    #[test]
    fn every_processor_gives_the_same_bits() {
        let bits = |(unit, middling, length): (DVec3, DVec3, f64)| {
            [unit.x, unit.y, unit.z, middling.x, middling.y, middling.z, length].map(f64::to_bits)
        };
        let mut state = 1_u64;
        let mut next = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let digits = (state >> 12) as f64 / (1_u64 << 52) as f64 - 0.5;
            match state >> 7 & 31 {
                0 => 0.0,
                1 => -0.0,
                2 => digits * 1e-90,
                3 => digits * 1e-160,
                4 => digits * 1e200,
                5 => (digits as f32).into(),
                _ => digits,
            }
        };
        for _ in 0..200_000 {
            let vector = DVec3::new(next(), next(), next());
            if vector != DVec3::ZERO {
                assert_eq!(bits(unit(vector)), bits(plain(vector)), "{vector:?}");
            }
        }
    }
}
