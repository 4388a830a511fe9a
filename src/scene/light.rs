//! Lights, and how a surface point sees them.

use super::{AreaLight, Color};
use crate::log::Name;
use crate::probe::Probe;
use compact_str::CompactString;
use glam::DVec3;

/// A light.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Its name, unique in the scene.
    pub name: CompactString,
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
    /// On a surface.
    Area(Box<AreaLight>),
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

impl Arrival {
    /// A place as seen from a point; `None` if it is the same.
    #[inline]
    pub fn of<P: Probe>(position: DVec3, point: DVec3, probe: &mut P) -> Option<Arrival> {
        let vector = probe.note(Name::LightVector, position - point);
        let distance = probe.note(Name::LightDistance, probe.dot(vector, vector).sqrt());
        if distance == 0.0 {
            return None;
        }
        let direction = probe.note(Name::LightDirection, vector / distance);
        Some(Arrival { direction, distance })
    }
}

impl Light {
    /// The inputs of the light, for the log.
    pub fn give<P: Probe>(&self, probe: &mut P) {
        self.give_with(self.share(), probe);
    }

    /// The same where a point of it has this intensity.
    pub fn give_with<P: Probe>(&self, color: Color, probe: &mut P) {
        match &self.kind {
            LightKind::Point { position } => probe.given(Name::LightPosition, *position),
            LightKind::Area(area) => area.give(probe),
            LightKind::Directional { travel } => probe.given(Name::LightTravel, *travel),
        }
        probe.given(Name::LightColor, color);
        if let Some([constant, linear, quadratic]) = self.attenuation {
            probe.given(Name::LightConstant, constant);
            probe.given(Name::LightLinear, linear);
            probe.given(Name::LightQuadratic, quadratic);
        }
    }

    /// The intensity of one of its points: of an area light each point that is asked has an equal share.
    pub fn share(&self) -> Color {
        match &self.kind {
            LightKind::Area(area) => self.color / f64::from(area.samples),
            _ => self.color,
        }
    }

    /// The most that a point of it counts for, in parts of the mean.
    pub fn largest_weight(&self) -> f64 {
        if let LightKind::Area(area) = &self.kind { area.largest_weight() } else { 1.0 }
    }

    /// The light as seen from a point (Ramos, section 1.3, step 6), an area light's centre; `None` from the very place where it is.
    #[inline]
    pub fn seen_from<P: Probe>(&self, point: DVec3, probe: &mut P) -> Option<Arrival> {
        match &self.kind {
            LightKind::Point { position } => Arrival::of(*position, point, probe),
            LightKind::Area(area) => Arrival::of(area.surface.center(), point, probe),
            LightKind::Directional { travel } => {
                let direction = probe.note(Name::LightDirectionFixed, -*travel);
                Some(Arrival { direction, distance: f64::INFINITY })
            }
        }
    }

    /// What arrives of this colour over this distance through empty space: all, scaled by
    /// min(1, 1/(c + l·dist + q·dist²)).
    #[inline]
    pub fn faded<P: Probe>(&self, color: &Color, distance: f64, probe: &mut P) -> Color {
        let Some([constant, linear, quadratic]) = self.attenuation else { return *color };
        let fading = 1.0 / (constant + linear * distance + quadratic * (distance * distance));
        *color * probe.note(Name::LightAttenuation, fading.min(1.0))
    }

    /// Whether min(1, 1/(c + l·d + q·d²)) leaves 1 between two distances: it has no derivative there.
    pub fn bends_between(&self, [near, far]: [f64; 2]) -> bool {
        let Some([constant, linear, quadratic]) = self.attenuation else { return false };
        let reciprocal = |distance: f64| constant + linear * distance + quadratic * (distance * distance);
        reciprocal(near.max(0.0)) < 1.0 && reciprocal(far) > 1.0
    }
}
