//! What several test files need.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

use insta::Settings;
use raywalk::files::Source;
use raywalk::record::Arithmetic;
use raywalk::scene::file::schema::SceneFile;
use raywalk::scene::file::{self, mesh};
use raywalk::scene::{Around, Formulas, Scene, build_with, builtin};

/// A built-in scene, ready to be traced.
#[track_caller]
pub fn scene(name: &str) -> Scene {
    scene_of(builtin::text(name).expect("a built-in scene").as_bytes(), name)
}

/// A scene from the text of its file.
#[track_caller]
pub fn scene_of(text: &[u8], name: &str) -> Scene {
    changed_scene_of(text, name, |_| ())
}

/// A built-in scene with other settings, so that what is derived from them fits.
#[track_caller]
pub fn changed_scene(name: &str, change: impl FnOnce(&mut SceneFile)) -> Scene {
    changed_scene_of(builtin::text(name).expect("a built-in scene").as_bytes(), name, change)
}

/// A scene from the text of its file, with other settings.
#[track_caller]
pub fn changed_scene_of(text: &[u8], name: &str, change: impl FnOnce(&mut SceneFile)) -> Scene {
    built(text, name, Formulas::Robust, change)
}

/// A built-in scene as the program traces it in this arithmetic.
#[track_caller]
pub fn scene_in(name: &str, arithmetic: Arithmetic) -> Scene {
    let text = builtin::text(name).expect("a built-in scene").as_bytes();
    built(text, name, arithmetic.implied_formulas(), |_| ())
}

#[track_caller]
fn built(text: &[u8], name: &str, formulas: Formulas, change: impl FnOnce(&mut SceneFile)) -> Scene {
    let mut loaded =
        file::check(text, &format!("{name}.json")).unwrap_or_else(|error| panic!("{}", error.report(false)));
    change(&mut loaded.scene);
    let source = Source { name, text };
    let meshes = mesh::load(&loaded.scene, &source, mesh::Folder::BuiltIn(builtin::mesh));
    let (meshes, _) = meshes.unwrap_or_else(|error| panic!("{}", error.report(false)));
    build_with(loaded.scene, &meshes, Around { formulas, ..Around::default() })
        .unwrap_or_else(|unsupported| panic!("{unsupported}"))
}

/// The middle pixel of a scene.
pub fn middle(scene: &Scene) -> [u32; 2] {
    scene.camera.resolution.map(|side| side / 2)
}

/// A coarse grid of pixels, the middle one among them.
pub fn grid(scene: &Scene, across: u32) -> Vec<[u32; 2]> {
    let [width, height] = scene.camera.resolution;
    let places = |side: u32| (0..across).map(move |k| (2 * k + 1) * side / (2 * across));
    let mut pixels: Vec<_> = places(height).flat_map(|y| places(width).map(move |x| [x, y])).collect();
    pixels.push(middle(scene));
    pixels
}

/// Every arithmetic that works on every scene.
pub const ARITHMETICS: [Arithmetic; 4] =
    [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(3), Arithmetic::Decimal(8)];

/// Snapshots are in the top-level folder `snapshots/`, named as they are called.
pub fn snapshots() -> Settings {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
}
