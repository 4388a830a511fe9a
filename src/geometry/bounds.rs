//! Axis-aligned boxes around shapes.

use super::ray::Ray;
use glam::DVec3;

/// An axis-aligned box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner of the least coordinates.
    pub min: DVec3,
    /// The corner of the greatest coordinates.
    pub max: DVec3,
}

impl Bounds {
    /// The box that holds nothing.
    pub const EMPTY: Bounds = Bounds { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    /// The least box around these points.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Bounds {
        points.into_iter().fold(Bounds::EMPTY, |bounds, point| bounds.with(point))
    }

    /// The box and a point.
    #[must_use]
    pub fn with(self, point: DVec3) -> Bounds {
        Bounds { min: self.min.min(point), max: self.max.max(point) }
    }

    /// The box and another one.
    #[must_use]
    pub fn union(self, other: Bounds) -> Bounds {
        Bounds { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// A slightly larger box, which still holds what rounding moved out: each side goes outward by a few units in the
    /// last place of its largest coordinate.
    #[must_use]
    pub fn widened(self) -> Bounds {
        let largest = self.min.abs().max(self.max.abs());
        let margin = largest * (8.0 * f64::EPSILON) + f64::MIN_POSITIVE;
        Bounds { min: self.min - margin, max: self.max + margin }
    }

    /// Its eight corners.
    pub fn corners(&self) -> impl Iterator<Item = DVec3> + '_ {
        let pick = |k: u32, axis: usize| if k >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] };
        (0..8).map(move |k| DVec3::new(pick(k, 0), pick(k, 1), pick(k, 2)))
    }

    /// The middle of the box.
    pub fn center(&self) -> DVec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// Its greatest coordinate.
    pub fn size(self) -> f64 {
        self.min.abs().max(self.max.abs()).max_element()
    }

    /// Whether a point lies in the box.
    pub fn contains(&self, point: DVec3) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }

    /// Whether a half line, its direction of any length, certainly passes beside the box, which something rounded may exceed by 10⁻¹² of all
    /// coordinates. Neither the direction's length is needed nor a division: this is a test of separating axes (Ericson, "Real-time collision
    /// detection", 2005, section 5.3.3).
    #[inline(always)]
    pub fn is_surely_missed(&self, origin: DVec3, direction: DVec3) -> bool {
        /// Far more than all roundings.
        const MARGIN: f64 = 1.0 / (1_u64 << 40) as f64;
        /// Products of lesser numbers lose their digits.
        const LEAST: f64 = 1e-140;
        let half = self.max * 0.5 - self.min * 0.5;
        let center = self.center();
        let from_center = origin - center;
        let half = half + MARGIN * (origin.abs() + center.abs() + half).element_sum();
        let along = direction.abs();
        let is_behind =
            |axis: usize| from_center[axis].abs() > half[axis] && from_center[axis] * direction[axis] >= 0.0;
        let across = from_center.cross(direction).abs();
        let reach = DVec3::new(
            half.y * along.z + half.z * along.y,
            half.z * along.x + half.x * along.z,
            half.x * along.y + half.y * along.x,
        );
        // Comparisons with what is no number are false.
        let is_missed = is_behind(0) | is_behind(1) | is_behind(2) | across.cmpgt(reach).any();
        is_missed && along.max_element() * half.min_element() > LEAST
    }

    /// Where the ray's line enters and leaves the box; it passes beside the box if that is the wrong way round. Errs on the
    /// side of meeting, and the interval of a box in this box lies in this interval.
    #[inline]
    pub fn interval(&self, ray: &Slabs) -> [f64; 2] {
        let to_min = (self.min - ray.origin) * ray.inverse;
        let to_max = (self.max - ray.origin) * ray.inverse;
        // Two rounding errors a quotient (Ize, Robust BVH ray traversal, 2013), and a few of what lies in the box.
        let sooner = |t: f64| t * (1.0 - (8.0 * f64::EPSILON).copysign(t));
        let near = sooner(to_min.min(to_max).max_element());
        let far = -sooner(-to_min.max(to_max).min_element());
        [near, far]
    }
}

/// A ray, prepared for many boxes.
#[derive(Clone, Copy, Debug)]
pub struct Slabs {
    origin: DVec3,
    /// 1 over each component of the direction; the greatest number instead of infinity, so that 0 · ∞ doesn't occur.
    inverse: DVec3,
}

impl Slabs {
    /// Prepares a ray.
    pub fn new(ray: &Ray) -> Slabs {
        let bounded = |x: f64| if x.is_finite() { x } else { f64::MAX.copysign(x) };
        let inverse = DVec3::ONE / ray.direction;
        let inverse = DVec3::new(bounded(inverse.x), bounded(inverse.y), bounded(inverse.z));
        Slabs { origin: ray.origin, inverse }
    }
}
