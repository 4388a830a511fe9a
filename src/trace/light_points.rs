//! Area lights: points of their surface, each with a shadow ray of its own (Ramos, section 1.5; Cook, Porter and Carpenter,
//! "Distributed ray tracing", 1984).

use super::adaptive_light::{OneSide, on_one_side};
use super::one_light::{Source, from_light};
use super::{Meeting, adaptive_light};
use crate::log::{Name, Step};
use crate::probe::Probe;
use crate::random::{Dimension, Splits};
use crate::scene::square::place_in_square;
use crate::scene::{AreaLight, Arrival, Between, Color, Light, Scene};
use glam::DVec3;

/// The sum with what an area light adds: its points are as many lights, one in each stratum of its surface, that share its intensity.
// Kept out of the shading by point lights.
#[inline(never)]
pub(super) fn add<P: Probe>(
    scene: &Scene,
    meeting: &Meeting,
    view: DVec3,
    (number, light, area): (u32, &Light, &AreaLight),
    mut sum: Color,
    probe: &mut P,
) -> Color {
    if let Some(adaptive) = &area.adaptive {
        return adaptive_light::add(scene, meeting, view, (number, light, area, adaptive), sum, probe);
    }
    let dimension = Dimension::Light { route: meeting.path.route(), light: number };
    let splits = Splits::new(meeting.path.draws, dimension, area.samples);
    let color = light.share();
    // What can't shadow any point of the light isn't tested for each. A counting probe gets the searches that this saves.
    let mut among =
        if P::USES_SIMD { scene.index.between(meeting.surface.point, area.ball(), meeting.layer.object) } else { None };
    let mut is_asked =
        !P::USES_SIMD || scene.index.shows_all() || !pays(scene, meeting, area.samples, among.as_deref());
    for part in 0..area.samples {
        let split = if area.samples == 1 { 0 } else { part + 1 };
        light.give(probe);
        let seen = probe.within(Step::Light { light: number, split }, |probe| {
            let square = place_in_square(splits.pick(part), probe);
            let (position, weight) = area.point(square, meeting.surface.point, probe);
            let color = weight.map_or(color, |weight| probe.note(Name::LightColorWeighted, color * weight));
            let source = Source { light, number, split, color: &color, among: among.as_deref(), is_free: false };
            let arrival = Arrival::of(position, meeting.surface.point, probe);
            from_light(scene, meeting, view, &source, arrival, probe)
        });
        sum += seen;
        // Where the first point that is lit is, others often are, too; where none is, there is nothing to gain.
        if !is_asked && seen != Color::ZERO {
            is_asked = true;
            among = in_shaft(scene, meeting, area, among.as_deref()).or(among);
        }
    }
    sum
}

/// In a scene with a tree over its objects a shaft pays for a light of this many points, or more.
const WITH_TREE: u32 = 8;

/// The same for a scene of few objects.
const WITHOUT_TREE: u32 = 4;

/// Whether it pays to look closer at what can lie between the surface point and a light of this many points, of which `among` is known.
#[inline(always)]
fn pays(scene: &Scene, meeting: &Meeting, samples: u32, among: Option<&[u32]>) -> bool {
    match among {
        None => samples >= WITH_TREE,
        Some(among) => {
            let is_told = |object: &u32| {
                *object == meeting.layer.object || scene.objects[*object as usize].shape.is_told_by_a_shaft()
            };
            samples >= WITHOUT_TREE && among.iter().any(is_told)
        }
    }
}

/// The objects that can lie between the surface point and the light; `None` where these are many, or where the light isn't all on one side of
/// the surface.
#[inline(never)]
fn in_shaft(scene: &Scene, meeting: &Meeting, area: &AreaLight, among: Option<&[u32]>) -> Option<Between> {
    let OneSide { shaft, leaving, .. } = on_one_side(meeting, area)?;
    scene.index.in_shaft(&scene.objects, &shaft, leaving, among)
}
