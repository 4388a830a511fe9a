//! Where a ray runs, for filters: they need no certified unit vector, which costs more than most of them.

use super::ray::{Leaving, Ray};
use glam::DVec3;

/// A part of a line, as filters take it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Where it begins.
    pub origin: DVec3,
    /// Where it goes, of unit length but for [`Line::ERROR`].
    pub direction: DVec3,
    /// The unit of distances along it, in units of length, but for [`Line::ERROR`].
    pub unit: f64,
    /// What lies before this distance doesn't matter.
    pub t_min: f64,
    /// What lies beyond this distance doesn't matter.
    pub t_max: f64,
}

impl Line {
    /// By how much the length of a direction may differ from 1: a rounding in single precision.
    pub const ERROR: f64 = 1.0 / (1 << 24) as f64;

    /// A line along a vector of any length, its ends in units of that vector. `None` for a vector so long or short that its square isn't a
    /// plain number.
    ///
    /// Vectors of single precision, rounded after they were normalised, are taken as they are.
    #[inline(always)]
    pub fn along(origin: DVec3, vector: DVec3, [t_min, t_max]: [f64; 2]) -> Option<Line> {
        let squared = vector.dot(vector);
        // The length differs from 1 by half of what its square does.
        if (squared - 1.0).abs() <= 2.0 * Line::ERROR {
            return Some(Line { origin, direction: vector, unit: 1.0, t_min, t_max });
        }
        let is_plain = squared > 1e-200 && squared < 1e200;
        is_plain.then(|| {
            let length = squared.sqrt();
            Line { origin, direction: vector / length, unit: length, t_min, t_max }
        })
    }
}

/// Where a search gets its ray from: filters take the line, kernels the ray, which may be made only when the first of them asks.
pub trait RaySource {
    /// The line, for filters; `None` where it is so ill-defined that they tell nothing. Its distances are in the units of those that kernels
    /// give, but for [`Line::ERROR`].
    fn line(&self) -> Option<Line>;

    /// How far the ray reaches.
    fn reach(&self) -> f64;

    /// How far rounding may have moved its origin ([`Ray::slack`]).
    fn slack(&self) -> f64;

    /// The surface that it leaves.
    fn leaving(&self) -> Option<Leaving>;

    /// The ray, for kernels.
    fn ray(&self) -> &Ray;
}

impl RaySource for Ray {
    #[inline(always)]
    fn line(&self) -> Option<Line> {
        Line::along(self.origin, self.direction, [self.t_min, self.t_max])
    }

    #[inline(always)]
    fn reach(&self) -> f64 {
        self.t_max
    }

    #[inline(always)]
    fn slack(&self) -> f64 {
        self.slack
    }

    #[inline(always)]
    fn leaving(&self) -> Option<Leaving> {
        self.leaving
    }

    #[inline(always)]
    fn ray(&self) -> &Ray {
        self
    }
}
