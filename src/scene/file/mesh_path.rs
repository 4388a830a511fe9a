//! Where the file of a mesh is, and whether a scene may name it.

use std::fs;
use std::io;
use std::path::{Component, Path, PathBuf};

use crate::files::escape::escape_hidden;
use crate::files::{irregular, is_callers_fault};

/// Why the path of a mesh is not followed.
#[derive(Debug, thiserror::Error)]
pub enum MeshPathError {
    /// The scene names something that it must not, or that is not there.
    #[error("{0}")]
    Refused(String),
    /// The machine did not say what is there.
    #[error("cannot look at `{}`: {source}", escape_hidden(&path.to_string_lossy()))]
    Unreadable {
        /// The resolved path.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

/// The file of a mesh, relative to the scene's folder (to the current one for standard input, `-`), without opening it.
///
/// # Errors
/// When the path is absolute, leads out of the scene's folder (by `..` or by a link), is the scene itself, or is not a
/// regular file. The message names the resolved path and nothing of the file's content.
pub fn resolve_mesh_path(scene_path: &Path, mesh_path: &str) -> Result<PathBuf, MeshPathError> {
    check_as_written(mesh_path).map_err(MeshPathError::Refused)?;
    let folder = scene_path.parent().unwrap_or(Path::new(""));
    let resolved = folder.join(mesh_path);
    let shown = escape_hidden(&resolved.to_string_lossy()).into_owned();
    let failure = |source: io::Error| match source.kind() {
        io::ErrorKind::NotFound => MeshPathError::Refused(format!("no such file, `{shown}`, expected a mesh")),
        _ if is_callers_fault(&source) => MeshPathError::Refused(format!("expected a mesh at `{shown}`: {source}")),
        _ => MeshPathError::Unreadable { path: resolved.clone(), source },
    };
    let metadata = fs::metadata(&resolved).map_err(failure)?;
    if let Some(kind) = irregular(&metadata) {
        let message = format!("expected a regular file at `{shown}`, found {kind}");
        return Err(MeshPathError::Refused(message));
    }
    let real = fs::canonicalize(&resolved).map_err(failure)?;
    let current = Path::new(".");
    let real_folder = fs::canonicalize(if folder == Path::new("") { current } else { folder }).map_err(failure)?;
    if !real.starts_with(&real_folder) {
        let message = format!("`{shown}` is a link out of the scene's folder, expected a file inside it");
        return Err(MeshPathError::Refused(message));
    }
    let scene = match fs::canonicalize(scene_path) {
        Ok(scene) => Some(scene),
        // Standard input has no place.
        Err(error) if is_callers_fault(&error) => None,
        Err(error) => return Err(MeshPathError::Unreadable { path: scene_path.to_owned(), source: error }),
    };
    if scene.is_some_and(|scene| scene == real) {
        let message = format!("`{shown}` is the scene file itself, expected an OBJ or PLY file");
        return Err(MeshPathError::Refused(message));
    }
    Ok(resolved)
}

/// What can be said about the path of a mesh without looking at the disk.
pub fn check_as_written(mesh_path: &str) -> Result<(), String> {
    let shown = escape_hidden(mesh_path);
    if mesh_path.is_empty() {
        return Err("must not be empty, expected the path of an OBJ or PLY file".to_string());
    }
    if mesh_path.contains('\0') {
        return Err(format!("must not hold a NUL character, found `{shown}`"));
    }
    let mut depth = 0_usize;
    for component in Path::new(mesh_path).components() {
        match component {
            Component::Normal(_) => depth += 1,
            Component::CurDir => {}
            Component::ParentDir if depth > 0 => depth -= 1,
            Component::ParentDir => {
                return Err(format!("must stay inside the scene's folder, found `{shown}`"));
            }
            Component::RootDir | Component::Prefix(_) => {
                return Err(format!("must be relative to the scene file, found the absolute path `{shown}`"));
            }
        }
    }
    Ok(())
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    /// A folder with a scene, a mesh, and what must not be followed.
    fn folder() -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        let inside = folder.path().join("scenes");
        fs::create_dir_all(inside.join("meshes")).unwrap();
        fs::write(inside.join("scene.json"), "{}").unwrap();
        fs::write(inside.join("meshes/cow.obj"), "").unwrap();
        fs::write(folder.path().join("secret.obj"), "secret").unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink("../secret.obj", inside.join("link.obj")).unwrap();
        folder
    }

    #[track_caller]
    fn refuses(mesh_path: &str, part: &str) {
        let folder = folder();
        let error = resolve_mesh_path(&folder.path().join("scenes/scene.json"), mesh_path).unwrap_err();
        assert!(matches!(error, MeshPathError::Refused(_)), "{error:?}");
        assert!(error.to_string().contains(part), "{error}");
    }

    #[test]
    fn a_mesh_in_the_folder_is_found() {
        let folder = folder();
        let scene = folder.path().join("scenes/scene.json");
        let found = resolve_mesh_path(&scene, "meshes/../meshes/cow.obj").unwrap();
        assert!(found.ends_with("meshes/cow.obj"));
    }

    #[test]
    fn b44_a_missing_mesh_names_the_resolved_path() {
        refuses("no.obj", "scenes/no.obj`, expected a mesh");
    }

    #[test]
    fn b45_a_way_out_of_the_folder() {
        refuses("meshes/../../secret.obj", "must stay inside the scene's folder");
    }

    #[test]
    fn b46_an_absolute_path() {
        refuses("/etc/passwd", "absolute path `/etc/passwd`");
    }

    #[test]
    #[cfg(unix)]
    fn b45_a_link_out_of_the_folder() {
        refuses("link.obj", "is a link out of the scene's folder");
    }

    #[test]
    fn b47_not_a_regular_file() {
        refuses("meshes", "found a directory");
    }

    #[test]
    #[cfg(unix)]
    fn b48_a_fifo_does_not_hang() {
        let folder = folder();
        let fifo = folder.path().join("scenes/fifo.obj");
        let made = std::process::Command::new("mkfifo").arg(&fifo).status().unwrap();
        assert!(made.success());
        let scene = folder.path().join("scenes/scene.json");
        let error = resolve_mesh_path(&scene, "fifo.obj").unwrap_err();
        assert!(error.to_string().contains("found a FIFO"), "{error}");
    }

    #[test]
    fn b49_the_scene_itself() {
        refuses("scene.json", "is the scene file itself");
    }

    #[test]
    fn an_empty_path() {
        refuses("", "must not be empty");
    }
}
