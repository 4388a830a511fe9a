//! Lights, and how a surface point sees them.

use super::Color;
use crate::log::Name;
use crate::probe::Probe;
use glam::DVec3;

/// A light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name, unique in the scene.
    pub name: String,
    /// Its place or direction.
    pub kind: LightKind,
    /// Its intensity per channel, I_i.
    pub color: Color,
    /// How it fades with distance: constant, linear and quadratic coefficient; `None` where it doesn't.
    pub attenuation: Option<[f64; 3]>,
}

/// Where a light is.
#[derive(Clone, Debug, PartialEq)]
pub enum LightKind {
    /// At a point.
    Point {
        /// The point.
        position: DVec3,
    },
    /// Infinitely far away.
    Directional {
        /// The unit direction in which its light travels.
        travel: DVec3,
    },
}

/// A light as a surface point sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arrival {
    /// The unit direction from the surface to the light, L.
    pub direction: DVec3,
    /// How far the light is.
    pub distance: f64,
}

impl Light {
    /// The inputs of the light, for the log.
    pub fn give<P: Probe>(&self, probe: &mut P) {
        match self.kind {
            LightKind::Point { position } => probe.given(Name::LightPosition, position),
            LightKind::Directional { travel } => probe.given(Name::LightTravel, travel),
        }
        probe.given(Name::LightColor, self.color);
        if let Some([constant, linear, quadratic]) = self.attenuation {
            probe.given(Name::LightConstant, constant);
            probe.given(Name::LightLinear, linear);
            probe.given(Name::LightQuadratic, quadratic);
        }
    }

    /// The light as seen from a point (Ramos, section 1.3, step 6); `None` from the very place where it is.
    #[inline]
    pub fn seen_from<P: Probe>(&self, point: DVec3, probe: &mut P) -> Option<Arrival> {
        match self.kind {
            LightKind::Point { position } => {
                let vector = probe.note(Name::LightVector, position - point);
                let distance = probe.note(Name::LightDistance, vector.dot(vector).sqrt());
                if distance == 0.0 {
                    return None;
                }
                let direction = probe.note(Name::LightDirection, vector / distance);
                Some(Arrival { direction, distance })
            }
            LightKind::Directional { travel } => {
                let direction = probe.note(Name::LightDirectionFixed, -travel);
                Some(Arrival { direction, distance: f64::INFINITY })
            }
        }
    }

    /// The colour that arrives over this distance through empty space: the light's, scaled by
    /// min(1, 1/(c + l·dist + q·dist²)).
    #[inline]
    pub fn faded<P: Probe>(&self, distance: f64, probe: &mut P) -> Color {
        let Some([constant, linear, quadratic]) = self.attenuation else { return self.color };
        let fading = 1.0 / (constant + linear * distance + quadratic * (distance * distance));
        self.color * probe.note(Name::LightAttenuation, fading.min(1.0))
    }
}
