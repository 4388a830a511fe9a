//! How rays are traced.

use super::{Color, Material};
use crate::geometry::shape::SphereMethod;
use crate::log::SkipReason;
pub use crate::scene::file::schema::{Algorithm, Formulas, ReflectedScale, Specular};

/// The options of the recursion.
#[derive(Clone, Debug, PartialEq)]
pub struct Tracing {
    /// Which pseudocode.
    pub algorithm: Algorithm,
    /// Its depth limit.
    pub max_depth: u32,
    /// Which specular term.
    pub specular: Specular,
    /// Which formulas, where several give the same number in exact arithmetic.
    pub formulas: Formulas,
    /// By which formulas spheres are intersected.
    pub sphere_method: SphereMethod,
    /// What scales the light that a reflected ray brings.
    pub reflected_scale: ReflectedScale,
    /// The weight below which bounces are left out; 0 leaves out none.
    pub cutoff: f64,
    /// Whether faces are seen from behind.
    pub two_sided: bool,
    /// What a semitransparent object does to the light behind it.
    pub shadows: Shadows,
    /// What is left out because it can't change the colour.
    pub skip: Skip,
}

/// What a semitransparent object between a light and a surface does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadows {
    /// Each of its surfaces keeps a part of the light, as its material says.
    PerSurface,
    /// It throws the shadow of an opaque one.
    Opaque,
}

impl Specular {
    /// The exponent of the term on a surface of this shininess, n_e. Of the compensated one it is 4·n_e: the angle between N and H is half of
    /// that between R and V, and cos^4n of the half falls off as cos^n of the whole.
    #[inline]
    pub fn exponent(self, shininess: f64) -> f64 {
        match self {
            Specular::HalfVector | Specular::ReflectionVector => shininess,
            Specular::HalfVectorCompensated => 4.0 * shininess,
        }
    }

    /// Whether the lobes of a material are so narrow that a cosine near 1 no longer tells their angle: the power is taken from the sine.
    pub fn is_sharp(self, material: &Material) -> bool {
        /// Up to here the power shows the cosine's rounding errors no more than 10⁻¹³ large.
        const SHARP: f64 = 1024.0;
        self.exponent(material.shininess) >= SHARP || material.transmission_exponent >= SHARP
    }
}

impl Tracing {
    /// What scales the light that a ray reflected by this material brings, where the material's weight is W_r.
    #[inline]
    pub fn scale_of_reflected(&self, weight: Color, material: &Material) -> Color {
        match self.reflected_scale {
            ReflectedScale::Weight => weight,
            ReflectedScale::Specular => weight * material.specular,
        }
    }

    /// Whether a ray at this level, the camera's ray having 0, may spawn others.
    pub fn goes_deeper(&self, level: u32) -> bool {
        match self.algorithm {
            Algorithm::Recursive => level < self.max_depth,
            // The second pseudocode counts from 1.
            Algorithm::Whitted | Algorithm::Foley => level + 1 < self.max_depth,
        }
    }

    /// Whether a hit at this level gets its ambient term only.
    pub fn shades_ambient_only(&self, level: u32) -> bool {
        self.algorithm == Algorithm::Whitted && !self.goes_deeper(level)
    }
}

/// The rules by which work is left out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Skip {
    rules: u16,
}

impl Skip {
    /// Every rule.
    pub const ALL: Skip = Skip { rules: u16::MAX };
    /// No rule.
    pub const NONE: Skip = Skip { rules: 0 };

    /// These rules too.
    pub fn with(self, rule: SkipReason) -> Skip {
        Skip { rules: self.rules | Skip::bit(rule) }
    }

    /// These rules without this one.
    pub fn without(self, rule: SkipReason) -> Skip {
        Skip { rules: self.rules & !Skip::bit(rule) }
    }

    /// Whether a rule is in force.
    #[inline]
    pub fn has(self, rule: SkipReason) -> bool {
        self.rules & Skip::bit(rule) != 0
    }

    fn bit(rule: SkipReason) -> u16 {
        1 << rule as u16
    }
}
