//! The scenes that come with the program: the files of `scenes/`, embedded.

const SCENES: &[(&str, &str)] = include!(concat!(env!("OUT_DIR"), "/built_in_scenes.rs"));

const MESHES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/built_in_meshes.rs"));

/// The names of the built-in scenes, sorted.
pub fn names() -> impl Iterator<Item = &'static str> {
    SCENES.iter().map(|(name, _)| *name)
}

/// The text of a built-in scene's file.
pub fn text(name: &str) -> Option<&'static str> {
    SCENES.iter().find(|(known, _)| *known == name).map(|(_, text)| *text)
}

/// The bytes of a mesh that a built-in scene names.
pub fn mesh(path: &str) -> Option<&'static [u8]> {
    MESHES.iter().find(|(known, _)| *known == path).map(|(_, bytes)| *bytes)
}
