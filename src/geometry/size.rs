//! Lengths and directions of vectors of any size, whose squares may overflow or vanish.

use glam::DVec3;

/// The vector of length 1 in the direction of another one; zero for one without direction.
pub fn unit(vector: DVec3) -> DVec3 {
    let Some((scaled, _)) = scaled(vector) else { return DVec3::ZERO };
    scaled / scaled.dot(scaled).sqrt()
}

/// The length of a vector of finite numbers.
#[inline]
pub fn length(vector: DVec3) -> f64 {
    /// Squares between these neither overflow nor vanish.
    const MIDDLING: std::ops::Range<f64> = 1e-280..1e280;
    let squared = vector.dot(vector);
    if MIDDLING.contains(&squared) {
        return squared.sqrt();
    }
    scaled(vector).map_or(0.0, |(scaled, size)| scaled.dot(scaled).sqrt() * size)
}

/// The vector divided by a power of two, which is exact, so that no square overflows or vanishes; and that power.
fn scaled(vector: DVec3) -> Option<(DVec3, f64)> {
    const EXPONENT: u64 = 0x7ff0_0000_0000_0000;
    let largest = vector.abs().max_element().to_bits();
    // A subnormal number has no exponent: its highest bit is the power.
    let is_subnormal = largest != 0 && largest & EXPONENT == 0;
    let size = f64::from_bits(if is_subnormal { 1 << largest.ilog2() } else { largest & EXPONENT });
    (size != 0.0 && vector.is_finite()).then(|| (vector / size, size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_need_no_middling_size() {
        for size in [1e-300, 1e-91, 1.0, 1e91, 1e300] {
            let found = unit(DVec3::new(3.0, 0.0, -4.0) * size);
            assert!((found - DVec3::new(0.6, 0.0, -0.8)).length() <= f64::EPSILON, "{found} at {size:e}");
        }
        // Of subnormal numbers what is left of their digits decides.
        assert_eq!(unit(DVec3::new(0.0, -5e-324, 0.0)), -DVec3::Y);
        let found = unit(DVec3::new(3e-315, 0.0, -4e-315));
        assert!((found - DVec3::new(0.6, 0.0, -0.8)).length() < 1e-8, "{found}");
        assert_eq!(length(DVec3::new(0.0, 1e-318, 0.0)), 1e-318);
        assert_eq!(unit(DVec3::ZERO), DVec3::ZERO);
        assert_eq!(unit(DVec3::new(f64::NAN, 1.0, 0.0)), DVec3::ZERO);
    }
}
