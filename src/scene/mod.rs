//! A scene, validated and ready to be traced.
//!
//! After [`mod@file`] has read and checked a scene, names are indices, vectors have a length, and numbers
//! are finite.

pub(crate) mod adaptive_light;
mod aim;
pub(crate) mod area_light;
mod bare;
mod build;
pub mod builtin;
pub(crate) mod camera;
pub(crate) mod ceiling;
mod effects;
pub mod file;
pub mod generate;
mod immersion;
mod index;
pub(crate) mod lens;
pub(crate) mod light;
pub(crate) mod light_surface;
pub(crate) mod material;
mod open;
pub(crate) mod profile;
mod solid_angle;
pub(crate) mod square;
pub(crate) mod tracing;
pub(crate) mod unsupported;

pub use adaptive_light::{Adaptive, Rule, Sight};
pub use aim::ray_along;
pub use area_light::AreaLight;
pub use build::{Around, build, build_with};
pub use camera::Camera;
pub use ceiling::Ceilings;
pub use effects::Effects;
pub use file::schema::{Guided, Output, Sampling, Statistical, Transfer};
pub use immersion::AroundEye;
pub use index::{Between, Index};
pub use lens::Lens;
pub use light::{Arrival, Light, LightKind};
pub use light_surface::{By, LightSurface};
pub use material::{Checker, Material, Weights};
pub use open::OpenError;
pub use tracing::{Algorithm, Formulas, ReflectedScale, Shadows, Skip, Specular, Tracing};

pub use unsupported::Unsupported;

use crate::geometry::{Shape, Side, Target};
use crate::log::FrameId;
use compact_str::CompactString;
use glam::DVec3;

/// A colour: red, green and blue, linear and unbounded.
pub type Color = DVec3;

/// A scene that can be traced.
#[derive(Clone, Debug)]
pub struct Scene {
    /// Its name.
    pub name: String,
    /// The digest of the resolved scene file, `blake3:…`.
    pub digest: String,
    /// The eye.
    pub camera: Camera,
    /// The ambient light, I_a.
    pub ambient: Color,
    /// The colour of a ray that leaves the scene.
    pub background: Color,
    /// The lights.
    pub lights: Vec<Light>,
    /// The materials.
    pub materials: Vec<Material>,
    /// The random decisions of samples besides their place in the pixel.
    pub effects: Effects,
    /// The objects, in the order that decides ties.
    pub objects: Vec<Object>,
    /// Which objects a ray can hit.
    pub index: Index,
    /// The media that hold the eye.
    pub around_eye: AroundEye,
    /// How rays are traced.
    pub tracing: Tracing,
    /// Upper bounds of the colours of rays; empty where they aren't needed.
    pub ceilings: Ceilings,
    /// Which rays make a pixel.
    pub sampling: Sampling,
    /// Which random numbers samples draw.
    pub seed: u64,
    /// Which frame of an animation it is; `None` where there is one only.
    pub frame: Option<FrameId>,
    /// How the picture is shown.
    pub output: Output,
}

/// An object of the scene.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its name, unique in the scene.
    pub name: CompactString,
    /// Its shape.
    pub shape: Shape,
    /// Its material, by number.
    pub material: usize,
    /// Whether it is absent for rays that arrive at its back.
    pub one_sided: bool,
    /// How far the roundings of its shape's numbers may move its surface ([`Shape::slack`]).
    pub slack: f64,
    /// The side of its surface on which its medium lies; `None` where it transmits nothing, or encloses nothing.
    pub inside: Option<Side>,
}

// Scenes have millions of them: docs/robustness.md has the memory per byte of a file.
const _: () = assert!(size_of::<Object>() <= 120 && size_of::<Material>() <= 240);

impl Object {
    /// The object as a target of rays; `number` is its own in the scene.
    #[inline(always)]
    pub fn target(&self, number: u32) -> Target {
        Target { object: number, one_sided: self.one_sided }
    }
}

impl Scene {
    /// The material of an object.
    #[inline]
    pub fn material_of(&self, object: u32) -> &Material {
        &self.materials[self.objects[object as usize].material]
    }
}
