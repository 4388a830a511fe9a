//! From a file to a scene that can be traced, in one step.

use super::file::mesh::{self, Folder};
use super::file::{self, SceneError, Source};
use super::{Scene, Unsupported, build, builtin};
use std::path::Path;

/// Why there is no scene.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// Its file, or that of a mesh, can't be read or isn't right. [`SceneError::report`] shows where.
    #[error(transparent)]
    File(#[from] SceneError),
    /// It asks for something that isn't there.
    #[error(transparent)]
    Unsupported(#[from] Unsupported),
    /// There is no built-in scene of this name.
    #[error("there is no built-in scene `{0}`")]
    Name(String),
}

impl Scene {
    /// The scene in a file, JSON or NFF, with its meshes beside it. Warnings are passed over; [`file::read`] has them.
    ///
    /// # Errors
    /// [`OpenError::File`] and [`OpenError::Unsupported`].
    pub fn open(path: impl AsRef<Path>) -> Result<Scene, OpenError> {
        let path = path.as_ref();
        ready(&file::read_bytes(path)?, &path.to_string_lossy(), Folder::OfScene(path))
    }

    /// A scene that comes with the library, such as `textbook`.
    ///
    /// # Errors
    /// [`OpenError::Name`].
    pub fn built_in(name: &str) -> Result<Scene, OpenError> {
        let text = builtin::text(name).ok_or_else(|| OpenError::Name(name.to_owned()))?;
        ready(text.as_bytes(), &format!("{name}.json"), Folder::BuiltIn(builtin::mesh))
    }
}

fn ready(text: &[u8], name: &str, folder: Folder) -> Result<Scene, OpenError> {
    let scene = file::check(text, name)?.scene;
    let (meshes, _) = mesh::load(&scene, &Source { name, text }, folder)?;
    Ok(build(&scene, &meshes)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_built_in_scene_opens_by_name_and_by_file() {
        for name in builtin::names() {
            let by_name = Scene::built_in(name).unwrap_or_else(|error| panic!("{name}: {error}"));
            let file = format!("{}/scenes/{name}.json", env!("CARGO_MANIFEST_DIR"));
            let by_file = Scene::open(&file).unwrap_or_else(|error| panic!("{file}: {error}"));
            let shapes = |scene: &Scene| scene.objects.iter().map(|object| object.shape.clone()).collect::<Vec<_>>();
            assert!(!by_name.objects.is_empty() && shapes(&by_name) == shapes(&by_file), "{name}");
        }
    }

    #[test]
    fn what_is_not_there_is_told() {
        let missing = Scene::open("/there/is/no.json").map(|_| ()).map_err(|error| error.to_string());
        assert!(missing.as_ref().is_err_and(|error| error.contains("no such file")), "{missing:?}");
        assert!(matches!(Scene::built_in("nothing"), Err(OpenError::Name(name)) if name == "nothing"));
    }
}
