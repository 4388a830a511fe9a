//! What a surface does with light.

use super::Color;
use glam::DVec3;

/// The coefficients of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// K_a per channel.
    pub ambient: Color,
    /// K_d per channel.
    pub diffuse: Color,
    /// K_e per channel.
    pub specular: Color,
    /// K_t per channel: the transmitted term of the local model.
    pub transmission: Color,
    /// n_e.
    pub shininess: f64,
    /// n_t.
    pub transmission_exponent: f64,
    /// The refractive index of the medium behind the surface.
    pub ior: f64,
    /// The weights of the three contributions.
    pub weights: Weights,
    /// The exponent of the lobe of a blurred reflection; `None` for a mirror.
    pub gloss_exponent: Option<f64>,
    /// The exponent of the lobe of a blurred transmission; `None` for clear glass.
    pub translucency_exponent: Option<f64>,
    /// How many zones a lobe has: a square number.
    pub zones: u32,
    /// What multiplies `ambient` and `diffuse` from place to place.
    pub pattern: Option<Box<Checker>>,
}

/// A checkerboard: cubes of two colours that fill space, of which a flat surface shows squares.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Checker {
    /// The colour where the sum of floor(coordinate/size) is even.
    pub a: Color,
    /// The colour where it is odd.
    pub b: Color,
    /// The side of a cube.
    pub size: f64,
}

/// W_l, W_r and W_t (Ramos, section 1.2.3), per channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// W_l.
    pub local: Color,
    /// W_r.
    pub reflected: Color,
    /// W_t; also the part of the light that a shadow ray keeps.
    pub transmitted: Color,
}

impl Material {
    /// Whether a hit spawns a reflected ray.
    pub fn reflects(&self) -> bool {
        self.weights.reflected != DVec3::ZERO || self.transmits()
    }

    /// Whether a hit spawns a transmitted ray, and whether light passes.
    pub fn transmits(&self) -> bool {
        self.weights.transmitted != DVec3::ZERO
    }

    /// Whether light passes in any way, so that both sides of the surface are there.
    pub fn lets_light_through(&self) -> bool {
        self.transmits() || self.uses_light_behind()
    }

    /// Whether the local model can use a light on the viewer's side.
    pub fn uses_light_in_front(&self) -> bool {
        self.diffuse != DVec3::ZERO || self.specular != DVec3::ZERO
    }

    /// Whether the local model can use a light on the other side.
    pub fn uses_light_behind(&self) -> bool {
        self.transmission != DVec3::ZERO
    }
}
