//! Area lights: points of their surface, each with a shadow ray of its own (Ramos, section 1.5; Cook, Porter and Carpenter,
//! "Distributed ray tracing", 1984).

use super::Meeting;
use super::shade::{Source, from_light};
use crate::log::{Name, Step};
use crate::probe::Probe;
use crate::random::Dimension;
use crate::scene::square::place_in_square;
use crate::scene::{AreaLight, Arrival, Color, Light, Scene};
use glam::DVec3;

/// The sum with what an area light adds: its points are so many lights, one in each stratum of its surface, that share its intensity.
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
    let dimension = Dimension::Light { route: meeting.path.route(), light: number };
    let splits = meeting.path.draws.splits(dimension, area.samples);
    let color = light.share();
    // What can't shadow any point of the light isn't asked for each. Whoever counts is told which searches that saves.
    let among = if P::IS_HURRIED {
        scene.index.between(meeting.surface.point, area.ball(), meeting.layer.object)
    } else {
        None
    };
    for part in 0..area.samples {
        let split = if area.samples == 1 { 0 } else { part + 1 };
        light.give(probe);
        sum += probe.within(Step::Light { light: number, split }, |probe| {
            let square = place_in_square(splits.pick(part), probe);
            let (position, weight) = area.point(square, meeting.surface.point, probe);
            let color = weight.map_or(color, |weight| probe.note(Name::LightColorWeighted, color * weight));
            let source = Source { light, number, split, color: &color, among: among.as_deref() };
            let arrival = Arrival::of(position, meeting.surface.point, probe);
            from_light(scene, meeting, view, &source, arrival, probe)
        });
    }
    sum
}
