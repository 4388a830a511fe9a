//! What `scene check` says about lights.

use crate::cli::options::ColorChoice;
use crate::cli::output;
use crate::cli::scene_argument::{self, Input};
use raywalk::render::reach::{Reach, reach};
use raywalk::scene::file::{self, Finding, KeyPath, visible};
use raywalk::scene::{Light, LightKind, Scene};

/// Warns of lights that light nothing in view. Those that light it from outside the field of view, as most do, get a line.
pub fn tell(input: &Input, scene: Scene, colors: ColorChoice) {
    if scene.objects.is_empty() {
        // There is a warning of that already, and nothing to be lit.
        return;
    }
    let names: Vec<String> = scene.lights.iter().map(|light| visible(&light.name).into_owned()).collect();
    let is_outside: Vec<bool> = scene.lights.iter().map(|light| stands_outside(&scene, light)).collect();
    let Reach { lights: is_lit, pixels } = reach(scene);
    let (lit, dark): (Vec<usize>, Vec<usize>) = (0..names.len()).partition(|light| is_lit[*light]);
    let unlit = |light: usize| {
        let place = if is_outside[light] { "; it stands outside the field of view" } else { "" };
        Finding {
            path: KeyPath::default().join("lights").join(light),
            message: format!("lights nothing in view: reaches no surface seen through {pixels} pixels{place}"),
            is_about_key: false,
        }
    };
    let findings: Vec<Finding> = dark.into_iter().map(unlit).collect();
    scene_argument::warn(&file::placed(&findings, &input.bytes, &input.name), colors);
    let outside: Vec<&str> = lit.into_iter().filter(|light| is_outside[*light]).map(|light| &*names[light]).collect();
    if !outside.is_empty() {
        let (file, names) = (visible(&input.name), outside.join(", "));
        output::tell(&format!(
            "note: {file}: lights outside the field of view, which they light all the same: {names}"
        ));
    }
}

/// Whether a light has a place and the camera can't see it.
fn stands_outside(scene: &Scene, light: &Light) -> bool {
    match light.kind {
        LightKind::Point { position } => !scene.camera.sees(position),
        LightKind::Directional { .. } => false,
    }
}
