//! What scene files may ask for and this version can't do.

use super::file::schema as file;
use super::file::{Finding, KeyPath};

/// Something that a scene file asks for and this version can't do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}: {}", .0.path, .0.message)]
pub struct Unsupported(Finding);

impl From<Finding> for Unsupported {
    fn from(finding: Finding) -> Unsupported {
        Unsupported(finding)
    }
}

/// Everything in a scene that isn't supported.
pub fn features(scene: &file::SceneFile) -> Vec<Finding> {
    let mut found = Vec::new();
    if scene.camera.lens.is_some() {
        found.push(missing(KeyPath::default().join("camera").join("lens"), "a lens"));
    }
    let lights = scene.lights.iter().enumerate();
    found.extend(lights.filter(|(_, of)| is_area(of)).map(|(index, of)| light(index, of)));
    for (name, material) in scene.materials.iter() {
        let path = |key: &'static str| KeyPath::default().join("materials").join(name.to_owned()).join(key);
        if material.gloss_exponent.is_some() {
            found.push(missing(path("gloss_exponent"), "blurry reflection"));
        }
        if material.translucency_exponent.is_some() {
            found.push(missing(path("translucency_exponent"), "blurry transmission"));
        }
    }
    let moves = scene.objects.iter().enumerate().filter(|(_, object)| object.motion.is_some());
    let motion = |index: usize| missing(KeyPath::default().join("objects").join(index).join("motion"), "motion");
    found.extend(moves.map(|(index, _)| motion(index)));
    found
}

/// An error, if anything was found.
pub(super) fn refuse(found: Vec<Finding>) -> Result<(), Unsupported> {
    found.into_iter().next().map_or(Ok(()), |first| Err(first.into()))
}

fn is_area(light: &file::Light) -> bool {
    !matches!(light.kind, file::LightKind::Point(_) | file::LightKind::Directional(_))
}

/// A light of a kind that isn't supported.
pub(super) fn light(index: usize, light: &file::Light) -> Finding {
    let key = light.kind.key();
    missing(KeyPath::default().join("lights").join(index).join(key), &format!("a light `{key}`"))
}

/// A mesh that nobody has read.
pub(super) fn not_loaded(object: usize) -> Unsupported {
    let path = KeyPath::default().join("objects").join(object).join("shape").join("mesh").join("path");
    missing(path, "a mesh that was not loaded").into()
}

fn missing(path: KeyPath, what: &str) -> Finding {
    Finding { path, message: format!("not supported by this version: {what}"), is_about_key: true }
}
