//! The meshes of a scene: found, read, and held by the paths by which the scene names them.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::fs;
use std::os::unix::fs::MetadataExt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::limits::MAX_MESH_BYTES;
use super::{Read, parse};
use crate::files::{FileError, KeyPath, Problem, Source, Wanted, display_name};
use crate::geometry::mesh::{Mesh, Winding};
use crate::scene::file::locate::locate;
use crate::scene::file::mesh_path::{MeshPathError, resolve_mesh_path};
use crate::scene::file::schema::{SceneFile, Shape};
use crate::scene::file::validate::limits::MAX_PROBLEMS;

/// Where the paths of meshes lead from.
#[derive(Clone, Copy, Debug)]
pub enum Folder<'p> {
    /// The folder of this scene file; the current one for standard input, `-`.
    OfScene(&'p Path),
    /// What comes with the program: gives the bytes of a mesh.
    BuiltIn(fn(&str) -> Option<&'static [u8]>),
}

/// The meshes of a scene.
#[derive(Clone, Debug, Default)]
pub struct Meshes {
    by_path: BTreeMap<String, Held>,
}

#[derive(Clone, Debug)]
struct Held {
    mesh: Arc<Mesh>,
    digest: blake3::Hash,
}

impl Meshes {
    /// Adds the mesh that a scene calls `path`, and the digest of its file.
    pub fn insert(&mut self, path: &str, mesh: Mesh, digest: blake3::Hash) {
        self.by_path.insert(path.to_owned(), Held { mesh: Arc::new(mesh), digest });
    }

    /// The mesh that a scene calls `path`.
    pub fn get(&self, path: &str) -> Option<&Arc<Mesh>> {
        self.by_path.get(path).map(|held| &held.mesh)
    }

    /// The digests of the meshes' files, by their paths.
    pub fn digests(&self) -> impl Iterator<Item = (&str, &blake3::Hash)> {
        self.by_path.iter().map(|(path, held)| (path.as_str(), &held.digest))
    }
}

/// Reads the meshes of a scene whose file is `scene_text`, in which paths that lead nowhere are shown. Gives them and
/// warnings, at most [`MAX_PROBLEMS`], with the number of further ones.
///
/// # Errors
/// [`FileError::Invalid`] with every path that is not followed, or with the first problem of a mesh file;
/// [`FileError::Refused`] and [`FileError::Unreadable`] as for a scene file.
pub fn load(scene: &SceneFile, scene_text: &Source, folder: Folder) -> Result<(Meshes, Warnings), FileError> {
    let mut meshes = Meshes::default();
    let mut warnings = Warnings::default();
    let mut problems = Vec::new();
    let mut omitted = 0;
    let mut by_file: HashMap<FileId, Held> = HashMap::new();
    for (index, object) in scene.objects.iter().enumerate() {
        let Shape::Mesh(named) = &object.shape else { continue };
        let is_held = meshes.get(&named.path).is_some();
        if is_held {
            continue;
        }
        let (read, file) = match read_one(&named.path, folder, &by_file) {
            Ok(Found::Known(held)) => {
                meshes.by_path.insert(named.path.clone(), held);
                continue;
            }
            Ok(Found::Read(read, digest, file)) => ((read, digest), file),
            Err(NotRead::Path(_)) if problems.len() == MAX_PROBLEMS => {
                omitted += 1;
                continue;
            }
            Err(NotRead::Path(message)) => {
                problems.push(path_problem(scene_text, index, message));
                continue;
            }
            Err(NotRead::File(error)) if problems.is_empty() => return Err(error),
            Err(NotRead::File(_)) => break,
        };
        meshes.insert(&named.path, read.0.mesh, read.1);
        if let (Some(file), Some(held)) = (file, meshes.by_path.get(&named.path)) {
            by_file.insert(file, held.clone());
        }
        read.0.warnings.into_iter().for_each(|warning| warnings.add(|| warning));
    }
    if !problems.is_empty() {
        return Err(FileError::Invalid { problems, omitted });
    }
    for (index, message) in transmitting(scene, &meshes) {
        warnings.add(|| path_problem(scene_text, index, message.to_owned()));
    }
    Ok((meshes, warnings))
}

/// What is odd about the meshes of a scene.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Warnings {
    /// The first ones.
    pub told: Vec<Problem>,
    /// How many more there are.
    pub more: usize,
}

impl Warnings {
    fn add(&mut self, warning: impl FnOnce() -> Problem) {
        if self.told.len() < MAX_PROBLEMS {
            self.told.push(warning());
        } else {
            self.more += 1;
        }
    }
}

/// The objects whose meshes transmit but enclose no medium, each mesh once, and what that means.
fn transmitting<'s>(scene: &'s SceneFile, meshes: &'s Meshes) -> impl Iterator<Item = (usize, &'static str)> + 's {
    let mut told = BTreeSet::new();
    scene.objects.iter().enumerate().filter_map(move |(index, object)| {
        let Shape::Mesh(named) = &object.shape else { return None };
        let material = scene.materials.get(object.material.as_ref()?)?;
        let transmits = material.weights.transmitted.rgb() != [0.0; 3];
        if !transmits || !told.insert(&named.path) {
            return None;
        }
        let message = match meshes.get(&named.path)?.winding() {
            Winding::Outward | Winding::Inward => return None,
            Winding::Mixed => {
                "transmits, but its triangles are wound both ways: a ray enters the medium where it sees a front and leaves it where \
                 it sees a back, whichever side is inside"
            }
            Winding::Open => {
                "transmits, but its mesh has open edges and encloses no medium: a ray enters the medium where it sees a front and \
                 leaves it where it sees a back, and through a hole it goes on in the medium that it is in"
            }
        };
        Some((index, message))
    })
}

/// Why a mesh isn't there.
enum NotRead {
    /// The scene names something that it must not, or that is not there.
    Path(String),
    /// The file is no good.
    File(FileError),
}

/// A file of the machine under any of its names: its device and its number there.
type FileId = (u64, u64);

/// A mesh as it was found.
enum Found {
    /// In a file that was read already, under another name.
    Known(Held),
    /// In this file, if it is one.
    Read(Read, blake3::Hash, Option<FileId>),
}

fn read_one(path: &str, folder: Folder, known: &HashMap<FileId, Held>) -> Result<Found, NotRead> {
    let mut id = None;
    let (bytes, name) = match folder {
        Folder::BuiltIn(bytes_of) => match bytes_of(path) {
            Some(bytes) => (bytes.to_vec(), path.to_owned()),
            None => return Err(NotRead::Path(format!("no such built-in mesh, `{path}`"))),
        },
        Folder::OfScene(scene) => {
            let file = find(scene, path)?;
            id = fs::metadata(&file).ok().map(|metadata| (metadata.dev(), metadata.ino()));
            if let Some(held) = id.and_then(|id| known.get(&id)) {
                return Ok(Found::Known(held.clone()));
            }
            let wanted = Wanted { what: "a mesh", max_bytes: MAX_MESH_BYTES };
            (wanted.read(&file).map_err(NotRead::File)?, display_name(&file))
        }
    };
    let read = parse(&bytes, &name).map_err(|error| match error {
        FileError::Refused { reason, .. } => NotRead::Path(reason),
        other => NotRead::File(other),
    })?;
    Ok(Found::Read(read, blake3::hash(&bytes), id))
}

fn find(scene: &Path, path: &str) -> Result<PathBuf, NotRead> {
    resolve_mesh_path(scene, path).map_err(|error| match error {
        MeshPathError::Refused(message) => NotRead::Path(message),
        MeshPathError::Unreadable { path, source } => {
            NotRead::File(FileError::Unreadable { file: display_name(&path), source })
        }
    })
}

/// A problem with the path of a mesh, at its place in the scene's text.
fn path_problem(scene_text: &Source, object: usize, message: String) -> Problem {
    let steps = ["objects".into(), object.into(), "shape".into(), "mesh".into(), "path".into()];
    let path: KeyPath = steps.into_iter().collect();
    let text = std::str::from_utf8(scene_text.text).unwrap_or_default();
    let text = text.trim_start_matches('\u{feff}');
    Source { name: scene_text.name, text: text.as_bytes() }.problem(locate(text, &path).value, path, message)
}
