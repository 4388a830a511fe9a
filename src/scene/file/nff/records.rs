//! What an NFF file says, entity by entity.

use std::ops::Range;

use super::mistake::Mistake;
use crate::files::{Problem, Source};
use crate::scene::file::schema::{Rgb, Shape, Vec3};

/// A whole file.
#[derive(Debug, Clone, Default)]
pub struct Records {
    /// The view.
    pub view: View,
    /// The background and the offset of its entity.
    pub background: Option<(Rgb, u32)>,
    /// The lights.
    pub lights: Vec<Light>,
    /// The fills.
    pub fills: Vec<Fill>,
    /// The primitives that a ray can hit.
    pub primitives: Vec<Primitive>,
    /// What has no effect.
    pub passed_over: Vec<Ignored>,
}

/// A value and the offset of its keyword.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Placed<T> {
    /// The value.
    pub value: T,
    /// The offset.
    pub at: u32,
}

/// A `v`.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct View {
    /// The eye.
    pub from: Placed<Vec3>,
    /// The point in the middle of the picture.
    pub at: Placed<Vec3>,
    /// What points up.
    pub up: Placed<Vec3>,
    /// The vertical angle in degrees.
    pub angle: Placed<f64>,
    /// Pixels across and down.
    pub resolution: Placed<[u32; 2]>,
}

/// An `l`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Light {
    /// Where the light is.
    pub position: Vec3,
    /// Its colour, if it has its own.
    pub color: Option<Rgb>,
    /// The offset of the entity.
    pub at: u32,
}

/// An `f`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fill {
    /// The colour.
    pub color: Rgb,
    /// Kd.
    pub diffuse: f64,
    /// Ks.
    pub specular: f64,
    /// The exponent of the highlight.
    pub shine: f64,
    /// T.
    pub transmittance: f64,
    /// The refractive index; 1 where an opaque fill has none.
    pub ior: f64,
    /// The offset of the entity.
    pub at: u32,
}

/// A primitive.
#[derive(Debug, Clone, PartialEq)]
pub struct Primitive {
    /// Its form.
    pub shape: Shape,
    /// Its fill, from 0.
    pub fill: u32,
    /// The offset of the entity.
    pub at: u32,
}

/// Records of one kind that have no effect.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Ignored {
    /// What they are, and that they are ignored.
    pub what: &'static str,
    /// The place of the first in bytes.
    pub first: Range<usize>,
    /// How many there are.
    pub count: usize,
}

impl Ignored {
    /// The warning about them.
    pub fn problem(&self, source: &Source) -> Problem {
        let message = match self.count {
            1 => self.what.to_string(),
            count => format!("{} ({count} times in this file)", self.what),
        };
        Mistake { span: self.first.clone(), message }.problem(source)
    }
}
