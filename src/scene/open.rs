//! From a file to a scene that can be traced, in one step.

use super::file::mesh::{self, Folder};
use super::file::{self, SceneFile};
use super::{Scene, Unsupported, build, builtin};
use crate::files::{FileError, Source};
use std::path::Path;
use std::str::FromStr;

/// Why there is no scene.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// Its file, or that of a mesh, can't be read or isn't right. [`FileError::report`] shows where.
    #[error(transparent)]
    File(#[from] FileError),
    /// It asks for something that isn't there.
    #[error(transparent)]
    Unsupported(#[from] Unsupported),
    /// There is no built-in scene of this name.
    #[error("there is no built-in scene `{0}`")]
    Name(String),
}

impl Scene {
    /// The scene in a file, JSON or NFF, with its meshes beside it. Warnings are ignored; [`file::read`] has them.
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

/// What messages call a scene that comes from no file.
const NO_FILE: &str = "scene";

/// The scene that this text describes, JSON or NFF. The paths of its meshes lead from the current folder.
///
/// # Errors
/// [`OpenError::File`] and [`OpenError::Unsupported`].
impl FromStr for Scene {
    type Err = OpenError;

    fn from_str(text: &str) -> Result<Scene, OpenError> {
        ready(text.as_bytes(), NO_FILE, Folder::OfScene(Path::new("-")))
    }
}

/// A scene made in code, with the checks that a file gets. The paths of its meshes lead from the current folder.
///
/// # Errors
/// [`OpenError::File`] and [`OpenError::Unsupported`].
impl TryFrom<&SceneFile> for Scene {
    type Error = OpenError;

    fn try_from(scene: &SceneFile) -> Result<Scene, OpenError> {
        file::check_scene(scene, NO_FILE)?;
        with_meshes(scene, b"", NO_FILE, Folder::OfScene(Path::new("-")))
    }
}

fn ready(text: &[u8], name: &str, folder: Folder) -> Result<Scene, OpenError> {
    with_meshes(&file::check(text, name)?.scene, text, name, folder)
}

fn with_meshes(scene: &SceneFile, text: &[u8], name: &str, folder: Folder) -> Result<Scene, OpenError> {
    let (meshes, _) = mesh::load(scene, &Source { name, text }, folder)?;
    Ok(build(scene, &meshes)?)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
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
    fn a_scene_made_in_code_is_that_of_its_text_and_is_checked() {
        let text = builtin::text("mesh").unwrap();
        // Its mesh comes with the library, not from the current folder.
        assert!(matches!(text.parse::<Scene>(), Err(OpenError::File(_))));
        let text = builtin::text("textbook").unwrap();
        let mut in_code = file::parse(text.as_bytes(), "textbook.json").unwrap();
        let (made, parsed) = (Scene::try_from(&in_code).unwrap(), text.parse::<Scene>().unwrap());
        assert_eq!(made.objects.len(), parsed.objects.len());
        assert_eq!(made.digest, Scene::built_in("textbook").unwrap().digest);
        in_code.lights[0].color = [f64::NAN; 3];
        let refused = Scene::try_from(&in_code).map(|_| ()).unwrap_err().to_string();
        assert!(refused.contains("lights[0].color"), "{refused}");
    }

    #[test]
    fn what_is_not_there_is_reported() {
        let missing = Scene::open("/there/is/no.json").map(|_| ()).map_err(|error| error.to_string());
        assert!(missing.as_ref().is_err_and(|error| error.contains("no such file")), "{missing:?}");
        assert!(matches!(Scene::built_in("nothing"), Err(OpenError::Name(name)) if name == "nothing"));
    }
}
