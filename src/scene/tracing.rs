//! How rays are traced.

use crate::geometry::shape::SphereMethod;
use crate::log::SkipReason;

/// The options of the recursion.
#[derive(Clone, Debug, PartialEq)]
pub struct Tracing {
    /// Which pseudocode.
    pub algorithm: Algorithm,
    /// Its depth limit.
    pub max_depth: u32,
    /// Which specular term.
    pub specular: Specular,
    /// By which formulas spheres are met.
    pub sphere_method: SphereMethod,
    /// The weight below which bounces are left out; 0 leaves out none.
    pub cutoff: f64,
    /// Whether faces are seen from behind.
    pub two_sided: bool,
    /// What a semitransparent thing does to the light behind it.
    pub shadows: Shadows,
    /// What is left out because it can't change the colour.
    pub skip: Skip,
}

/// The algorithms of the source text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Algorithm {
    /// The first pseudocode: every hit is shaded whole, rays deeper than the limit are black.
    Recursive,
    /// The second as printed: at the limit a hit returns its ambient term.
    Whitted,
    /// The second as in its source: at the limit only the bounces stop.
    Foley,
}

/// The specular term of the local model.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Specular {
    /// (N·H)^n.
    HalfVector,
    /// (R·V)^n.
    ReflectionVector,
}

/// What a semitransparent thing between a light and a surface does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shadows {
    /// Each of its surfaces keeps a part of the light, as its material says.
    PerSurface,
    /// It throws the shadow of an opaque one.
    Opaque,
}

impl Tracing {
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
