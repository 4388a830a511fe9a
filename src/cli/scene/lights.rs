//! What `scene check` says about lights.

use crate::cli::output;
use crate::cli::scene_argument::{self, Input};
use raywalk::files::KeyPath;
use raywalk::render::reach::{Reach, reach};
use raywalk::scene::file::validate::limits::MAX_PROBLEMS;
use raywalk::scene::file::{self, Finding};
use raywalk::scene::{Color, Light, LightKind, Material, Scene};

/// Warns of lights that light nothing in view, and of those that light it from outside the field of view.
pub fn tell(input: &Input, scene: Scene) {
    if scene.objects.is_empty() {
        // There is a warning of that already, and nothing to be lit.
        return;
    }
    let is_outside: Vec<bool> = scene.lights.iter().map(|light| stands_outside(&scene, light)).collect();
    let is_dark: Vec<bool> = scene.lights.iter().map(|light| light.color == Color::ZERO).collect();
    let uses_light = |material: &Material| {
        [material.diffuse, material.specular, material.transmission]
            .iter()
            .any(|coefficient| *coefficient != Color::ZERO)
    };
    let is_light_used = scene.objects.iter().any(|object| uses_light(&scene.materials[object.material]));
    let Reach { lights: is_lit, unusable, hidden, is_unweighted, pixels, is_cut_off } = reach(scene);
    let finding = |light: usize| {
        let outside = if is_outside[light] { "; it is outside the field of view" } else { "" };
        let message = match (is_lit[light], unusable[light], hidden[light]) {
            (true, ..) if is_outside[light] => "is outside the field of view, which it lights all the same".to_owned(),
            (true, ..) => return None,
            _ if is_dark[light] => "lights nothing in view: its colour is 0 in every channel".to_owned(),
            _ if !is_light_used => {
                "lights nothing in view: K_d, K_e and K_t of every surface are 0 in every channel".to_owned()
            }
            // It might reach what wasn't looked at.
            _ if is_cut_off => return None,
            _ if is_unweighted => format!(
                "lights nothing in view: no surface seen through {pixels} pixels has a local term that weighs more than 0"
            ),
            (false, false, _) => {
                format!("lights nothing in view: reaches no surface seen through {pixels} pixels{outside}")
            }
            (false, true, false) => format!(
                "lights nothing in view: its colour and the coefficients of the surfaces seen through {pixels} pixels \
                 leave nothing of any channel"
            ),
            (false, true, true) => format!(
                "lights nothing in view: of the surfaces seen through {pixels} pixels it reaches none, or its colour and their \
                 coefficients leave nothing of any channel{outside}"
            ),
        };
        Some(Finding { path: KeyPath::default().join("lights").join(light), message, is_about_key: false })
    };
    // The place of each is looked for, so that only those that are reported have one.
    let mut findings = (0..is_outside.len()).filter_map(finding);
    let told: Vec<Finding> = findings.by_ref().take(MAX_PROBLEMS).collect();
    scene_argument::warn(&file::placed(&told, &input.bytes, &input.name), findings.count());
    if is_cut_off {
        let unknown = (0..is_lit.len()).filter(|light| !is_lit[*light] && !is_dark[*light]).count();
        output::tell(&format!(
            "warning: what {unknown} of the {} lights reach isn't known: too many surfaces lie on the ways to them to find out here",
            is_lit.len()
        ));
    }
}

/// Whether a light has a place and the camera can't see it.
fn stands_outside(scene: &Scene, light: &Light) -> bool {
    match &light.kind {
        LightKind::Point { position } => !scene.camera.sees(*position),
        LightKind::Area(area) => !scene.camera.sees(area.surface.center()),
        LightKind::Directional { .. } => false,
    }
}
