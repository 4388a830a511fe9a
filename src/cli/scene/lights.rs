//! What `scene check` says about lights.

use crate::cli::options::ColorChoice;
use crate::cli::scene_argument::{self, Input};
use raywalk::render::reach::{Reach, reach};
use raywalk::scene::file::{self, Finding, KeyPath};
use raywalk::scene::{Light, LightKind, Scene};

/// Warns of lights that light nothing in view, and of those that light it from outside the field of view.
pub fn tell(input: &Input, scene: Scene, colors: ColorChoice) {
    if scene.objects.is_empty() {
        // There is a warning of that already, and nothing to be lit.
        return;
    }
    let is_outside: Vec<bool> = scene.lights.iter().map(|light| stands_outside(&scene, light)).collect();
    let Reach { lights: is_lit, pixels } = reach(scene);
    let finding = |light: usize| {
        let message = match (is_lit[light], is_outside[light]) {
            (true, false) => return None,
            (true, true) => "stands outside the field of view, which it lights all the same".to_owned(),
            (false, false) => format!("lights nothing in view: reaches no surface seen through {pixels} pixels"),
            (false, true) => format!(
                "lights nothing in view: reaches no surface seen through {pixels} pixels; it stands outside the field of view"
            ),
        };
        Some(Finding { path: KeyPath::default().join("lights").join(light), message, is_about_key: false })
    };
    let findings: Vec<Finding> = (0..is_outside.len()).filter_map(finding).collect();
    scene_argument::warn(&file::placed(&findings, &input.bytes, &input.name), colors);
}

/// Whether a light has a place and the camera can't see it.
fn stands_outside(scene: &Scene, light: &Light) -> bool {
    match &light.kind {
        LightKind::Point { position } => !scene.camera.sees(*position),
        LightKind::Area(area) => !scene.camera.sees(area.surface.center()),
        LightKind::Directional { .. } => false,
    }
}
