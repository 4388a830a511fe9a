//! The local model: ambient, diffuse, specular and transmitted light at a surface point (Ramos, section 1.2.1).

use super::one_light::{Source, from_light};
use super::{Meeting, in_range, light_points, pattern, unseen};
use crate::log::plane::Emitter;
use crate::log::{Decision, Name, Step, Term};
use crate::probe::{Probe, Saving};
use crate::scene::{Checker, Color, LightKind, Material, Scene, Specular};

/// I_local = I_a·K_a + Σ att·I_i [K_d (N·L)⁺ + K_e ((N·H)⁺)^n_e], for a light on the viewer's side; for one on the other
/// side of a transmitting surface att·I_i·K_t ((−N·H′)⁺)^n_t instead. Nothing where its weight is zero.
pub(crate) fn local_intensity<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Color {
    if let Some(why) = unseen::local_model(scene, meeting) {
        probe.rays_saved(Saving::Skipped(why), unseen::shadow_rays(scene, meeting));
        probe.mark(Decision::Skipped { what: Term::Local, why });
        return Color::ZERO;
    }
    probe.within(Step::Shade { object: meeting.layer.object }, |probe| match &meeting.material.pattern {
        None => from_all_lights(scene, meeting, probe),
        Some(pattern) => patterned(scene, meeting, pattern, probe),
    })
}

/// The same inside its node, with the material as it is.
// Inlined twice, so that a material without pattern pays one branch.
#[inline(always)]
fn from_all_lights<P: Probe>(scene: &Scene, meeting: &Meeting, probe: &mut P) -> Color {
    let material = meeting.material;
    probe.given(Name::AmbientLight, scene.ambient);
    if material.pattern.is_none() {
        probe.given(Name::MaterialAmbient, material.ambient);
    }
    let ambient = scene.ambient * material.ambient;
    if probe.sees_parts() {
        probe.part(Emitter::Ambient, ambient);
    }
    if scene.tracing.shades_ambient_only(meeting.path.level) {
        return probe.note(Name::ShadeLocalAmbient, ambient);
    }
    give(material, probe);
    let view = probe.note(Name::ViewDirection, -meeting.ray.direction);
    let mut sum = ambient;
    for (number, light) in (0..).zip(&scene.lights) {
        if let LightKind::Area(area) = &light.kind {
            sum = light_points::add(scene, meeting, view, (number, light, area), sum, probe);
            continue;
        }
        light.give(probe);
        sum += probe.within(
            Step::Light { light: number, split: 0 },
            #[inline(always)]
            |probe| {
                let arrival = light.seen_from(meeting.surface.point, probe);
                let source = Source { light, number, split: 0, color: &light.color, among: None, is_free: false };
                from_light(scene, meeting, view, &source, arrival, probe)
            },
        );
    }
    probe.note(local_name(scene, material), in_range(sum))
}

/// The local intensity where a pattern multiplies ambient and diffuse.
// Kept out of the shading of materials that have no pattern.
#[inline(never)]
fn patterned<P: Probe>(scene: &Scene, meeting: &Meeting, checker: &Checker, probe: &mut P) -> Color {
    let material = pattern::material(scene, meeting, checker, probe);
    from_all_lights(scene, &Meeting { material: &material, ..*meeting }, probe)
}

/// Which formula the local intensity has under the scene's options and on this material.
fn local_name(scene: &Scene, material: &Material) -> Name {
    match (scene.tracing.specular, material.uses_light_behind()) {
        (specular, false) if specular.is_sharp(material) => Name::ShadeLocalSharp,
        (specular, true) if specular.is_sharp(material) => Name::ShadeLocalSharpTransmitting,
        (Specular::HalfVector, false) => Name::ShadeLocal,
        (Specular::HalfVector, true) => Name::ShadeLocalTransmitting,
        (Specular::HalfVectorCompensated, false) => Name::ShadeLocalCompensated,
        (Specular::HalfVectorCompensated, true) => Name::ShadeLocalCompensatedTransmitting,
        (Specular::ReflectionVector, false) => Name::ShadeLocalMirror,
        (Specular::ReflectionVector, true) => Name::ShadeLocalMirrorTransmitting,
    }
}

/// The coefficients that the formula of the local intensity puts in. Those that a pattern has multiplied are noted already.
fn give<P: Probe>(material: &Material, probe: &mut P) {
    if material.pattern.is_none() {
        probe.given(Name::MaterialDiffuse, material.diffuse);
    }
    probe.given(Name::MaterialSpecular, material.specular);
    probe.given(Name::MaterialShininess, material.shininess);
    if material.uses_light_behind() {
        probe.given(Name::MaterialTransmission, material.transmission);
        probe.given(Name::MaterialTransmissionExponent, material.transmission_exponent);
    }
}
