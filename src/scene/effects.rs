//! Which distributed effects a scene has: what a sample decides at random beside its place in the pixel.

use super::{Camera, Light, LightKind, Material};
use crate::random::Partner;

/// The effects of a scene (Ramos, section 1.5).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Effects {
    /// The eye has a lens.
    pub lens: bool,
    /// Something moves while the shutter is open.
    pub motion: bool,
    /// Lights are surfaces.
    pub area_lights: bool,
    /// Reflections or transmissions are blurred.
    pub blurred_bounces: bool,
}

impl Effects {
    /// Those of a scene with these parts.
    pub fn of(camera: &Camera, lights: &[Light], materials: &[Material]) -> Effects {
        let is_blurred = |material: &Material| {
            let is_gloss = material.gloss_exponent.is_some() && material.reflects();
            is_gloss || material.translucency_exponent.is_some() && material.transmits()
        };
        Effects {
            lens: camera.lens.is_some(),
            motion: camera.shutter.is_some_and(|[open, close]| open < close),
            area_lights: lights.iter().any(|light| matches!(light.kind, LightKind::Area(_))),
            blurred_bounces: materials.iter().any(is_blurred),
        }
    }

    /// Whether every ray from the eye draws.
    pub fn of_the_eye(self) -> bool {
        self.lens || self.motion
    }

    /// Whether a ray that hits an object may draw.
    pub fn of_surfaces(self) -> bool {
        self.area_lights || self.blurred_bounces
    }

    /// What is spread jointly with the places in a pixel: what decides of most of the picture.
    #[inline]
    pub fn partner(self) -> Partner {
        if self.lens {
            Partner::Lens
        } else if self.motion {
            Partner::Time
        } else {
            Partner::Surface
        }
    }

    /// Their names.
    pub fn names(self) -> Vec<&'static str> {
        let effects = [
            (self.lens, "a lens"),
            (self.motion, "motion"),
            (self.area_lights, "area lights"),
            (self.blurred_bounces, "blurred bounces"),
        ];
        effects.into_iter().filter(|(is_there, _)| *is_there).map(|(_, name)| name).collect()
    }
}
