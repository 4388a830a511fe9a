//! Lights with a surface, and points on them.

use super::adaptive_light::Adaptive;
use super::light_surface::{By, LightSurface};
use super::profile::CosineProfile;
use super::solid_angle::{self, Seen};
use crate::geometry::Bounds;
use crate::log::Name;
use crate::probe::Probe;
use crate::random::warp;
use arrayvec::ArrayVec;
use glam::DVec3;

/// A light with a surface. It gives the mean over the surface, by area or by solid angle, and by its profile, of what a point light
/// there would give; both sides shine, and it isn't seen itself.
#[derive(Clone, Debug, PartialEq)]
pub struct AreaLight {
    /// What the surface is.
    pub surface: LightSurface,
    /// How its weight falls toward the rim; `None` where it doesn't.
    pub profile: Option<CosineProfile>,
    /// How many points of it each surface point asks, at most if it is adaptive.
    pub samples: u32,
    /// What its mean is taken by.
    pub by: By,
    /// How it is asked for no more points than it takes; `None` where all are asked.
    pub adaptive: Option<Adaptive>,
}

impl AreaLight {
    /// The inputs, for the log.
    pub fn give<P: Probe>(&self, probe: &mut P) {
        probe.given(Name::LightCenter, self.surface.center());
        match self.surface {
            LightSurface::Rectangle { edges: [u, v], .. } | LightSurface::Disk { edges: [u, v], .. } => {
                probe.given(Name::LightEdgeU, u);
                probe.given(Name::LightEdgeV, v);
            }
            LightSurface::Sphere { radius, .. } => probe.given(Name::LightRadius, radius),
        }
    }

    /// The point of the light that a surface point asks for a point of the unit square, if that is uniform by area and profile or by
    /// solid angle; and the weight of its shadow ray, where not all have the same.
    // A call would cost a picture of penumbras 7 % more instructions.
    #[inline(always)]
    pub fn point<P: Probe>(&self, square: [f64; 2], from: DVec3, probe: &mut P) -> (DVec3, Option<f64>) {
        let seen = if self.by == By::SolidAngle { self.seen_point(square, from, probe) } else { None };
        seen.unwrap_or_else(|| (self.point_by_area(square, probe), None))
    }

    /// The point of a rule (see [`Adaptive`]) for a light without profile.
    pub fn ruled_point<P: Probe>(&self, at: [f64; 2], from: DVec3, probe: &mut P) -> DVec3 {
        if let LightSurface::Disk { center, edges } = self.surface {
            return self.point_of_disk(center, edges, at, probe);
        }
        probe.given(Name::SampleX, at[0]);
        probe.given(Name::SampleY, at[1]);
        self.point(at, from, probe).0
    }

    /// The point by solid angle, with its weight by the profile; `None` where the solid angle is none.
    // Kept out of the way of lights by area.
    #[inline(never)]
    fn seen_point<P: Probe>(&self, square: [f64; 2], from: DVec3, probe: &mut P) -> Option<(DVec3, Option<f64>)> {
        match self.surface {
            LightSurface::Sphere { center, radius } => {
                let Seen { at: outward, solid_angle } = solid_angle::of_sphere(center, radius, from, square);
                probe.given(Name::LightOutward, outward);
                probe.given(Name::LightSolidAngle, solid_angle);
                Some((probe.note(Name::LightPositionOnSphere, center + outward * radius), None))
            }
            LightSurface::Rectangle { center, edges } => {
                let Seen { at: [x, y], solid_angle } = solid_angle::of_rectangle(center, edges, from, square)?;
                probe.given(Name::LightX, x);
                probe.given(Name::LightY, y);
                probe.given(Name::LightSolidAngle, solid_angle);
                let position = on_edges(center, edges, [x, y], probe);
                let weight = self.profile.as_ref().map(|profile| profile.weigh(x.abs().max(y.abs()).min(1.0), probe));
                Some((position, weight))
            }
            // The door refuses it: no closed form gives such points.
            LightSurface::Disk { .. } => None,
        }
    }

    /// The largest weight of a shadow ray: 1 where all have the same.
    pub fn largest_weight(&self) -> f64 {
        match (&self.profile, self.by) {
            (Some(profile), By::SolidAngle) => 1.0 / profile.mean(),
            _ => 1.0,
        }
    }

    /// The point of the light for a point of the unit square: uniform by area and profile, if that is uniform.
    #[inline(always)]
    fn point_by_area<P: Probe>(&self, square: [f64; 2], probe: &mut P) -> DVec3 {
        match self.surface {
            LightSurface::Rectangle { center, edges } => {
                let [a, b] = square.map(|x| 2.0 * x - 1.0);
                let spread = self.spread(a.abs().max(b.abs()), probe);
                let x = probe.note(Name::LightX, a * spread);
                let y = probe.note(Name::LightY, b * spread);
                on_edges(center, edges, [x, y], probe)
            }
            LightSurface::Disk { center, edges } => self.point_of_disk(center, edges, warp::disc(square), probe),
            LightSurface::Sphere { center, radius } => {
                let outward = probe.note(Name::LightOutward, DVec3::from(warp::sphere(square)));
                probe.note(Name::LightPositionOnSphere, center + outward * radius)
            }
        }
    }

    #[inline(always)]
    fn point_of_disk<P: Probe>(&self, center: DVec3, edges: [DVec3; 2], [a, b]: [f64; 2], probe: &mut P) -> DVec3 {
        probe.given(Name::DiscX, a);
        probe.given(Name::DiscY, b);
        let spread = self.spread((a * a + b * b).sqrt(), probe);
        let x = probe.note(Name::LightXOnDisk, a * spread);
        let y = probe.note(Name::LightYOnDisk, b * spread);
        on_edges(center, edges, [x, y], probe)
    }

    /// Points whose convex hull holds the light, with more to spare than the roundings of its points.
    pub fn corners(&self) -> ArrayVec<DVec3, 8> {
        const OFF: f64 = 1.0 + 1e-9;
        match self.surface {
            LightSurface::Rectangle { center, edges: [u, v] } | LightSurface::Disk { center, edges: [u, v] } => {
                let at = |[x, y]: [f64; 2]| center + u * (x * OFF) + v * (y * OFF);
                [[-1.0, -1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, 1.0]].map(at).into_iter().collect()
            }
            LightSurface::Sphere { center, radius } => {
                let sign = |k: u32, axis: u32| if k >> axis & 1 == 0 { -radius * OFF } else { radius * OFF };
                (0..8).map(|k| center + DVec3::new(sign(k, 0), sign(k, 1), sign(k, 2))).collect()
            }
        }
    }

    /// A box that holds the light, but for roundings of its coordinates.
    pub fn bounds(&self) -> Bounds {
        let (center, half) = match self.surface {
            LightSurface::Rectangle { center, edges: [u, v] } => (center, u.abs() + v.abs()),
            LightSurface::Disk { center, edges: [u, v] } => (center, (u * u + v * v).map(f64::sqrt)),
            LightSurface::Sphere { center, radius } => (center, DVec3::splat(radius)),
        };
        Bounds { min: center - half, max: center + half }
    }

    /// Centre and radius of a ball that holds the light.
    pub fn ball(&self) -> (DVec3, f64) {
        let radius = match self.surface {
            LightSurface::Rectangle { edges: [u, v], .. } | LightSurface::Disk { edges: [u, v], .. } => {
                (u + v).length().max((u - v).length())
            }
            LightSurface::Sphere { radius, .. } => radius,
        };
        (self.surface.center(), radius)
    }

    fn spread<P: Probe>(&self, rho: f64, probe: &mut P) -> f64 {
        let spread = self.profile.as_ref().map_or(1.0, |profile| profile.spread(rho.min(1.0)));
        probe.given(Name::LightSpread, spread);
        spread
    }
}

fn on_edges<P: Probe>(center: DVec3, [u, v]: [DVec3; 2], [x, y]: [f64; 2], probe: &mut P) -> DVec3 {
    probe.note(Name::LightPositionOnArea, center + u * x + v * y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::probe::Silent;
    use crate::random::{hash, unit};

    #[test]
    fn a_light_lies_in_its_box_and_its_ball() {
        for k in 0..3000_u64 {
            let number = |axis: u64| unit(hash(k, axis));
            let vector = |axis: u64| DVec3::new(number(axis), number(axis + 1), number(axis + 2)) * 2.0 - 1.0;
            let surface = match k % 3 {
                0 => LightSurface::rectangle(vector(0), vector(3), vector(6)),
                1 => LightSurface::disk(vector(0), vector(3), number(6)),
                _ => LightSurface::Sphere { center: vector(0), radius: number(6) },
            };
            let light = AreaLight { surface, profile: None, samples: 1, by: By::Area, adaptive: None };
            let (Bounds { min, max }, (center, radius)) = (light.bounds(), light.ball());
            for at in 0..20 {
                let square = [0, 1].map(|axis| unit(hash(hash(k, at), axis)));
                let (point, _) = light.point(square, DVec3::splat(9.0), &mut Silent);
                let rounding = 1e-15;
                assert!(Bounds { min: min - rounding, max: max + rounding }.contains(point), "{k}");
                assert!((point - center).length() <= radius + rounding, "{k}");
            }
        }
    }
}
