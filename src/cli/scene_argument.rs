//! The scene that a command names: a path, `-` for standard input, or a built-in scene. A path that exists wins.

use super::failure::Failure;
use super::inputs::Inputs;
use super::output;
use raywalk::files::{
    FileError, Kind, Opened, Problem, Severity, Source, escape_hidden, is_there, more_warnings, suggest,
};
use raywalk::scene::builtin;
use raywalk::scene::file;
use raywalk::scene::file::mesh::{self, Folder, Meshes};
use raywalk::scene::file::nff::Import;
use raywalk::scene::file::schema::SceneFile;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// The text of a scene, and the name by which messages call it.
pub struct Input {
    /// The bytes.
    pub bytes: Vec<u8>,
    /// The name.
    pub name: String,
    /// Where it was read from; `None` if it is built in.
    path: Option<PathBuf>,
}

/// A checked scene with its meshes.
#[derive(Clone)]
pub struct Loaded {
    /// The scene.
    pub scene: SceneFile,
    /// The meshes that it names.
    pub meshes: Meshes,
    /// Which frame of an animation it is, from 1.
    pub frame: u32,
    /// The files that were read.
    pub inputs: Inputs,
}

impl Input {
    /// Where it was read from; `None` if it is built in.
    pub fn path(&self) -> Option<&Path> {
        self.path.as_deref()
    }

    /// The files of the scene in this text: its own and the meshes beside it, whether they are there or not.
    pub fn files(&self, scene: &SceneFile) -> Inputs {
        let Some(path) = &self.path else { return Inputs::none() };
        let folder = path.parent().unwrap_or(Path::new(""));
        let meshes = mesh_paths(scene).into_iter().map(|mesh| folder.join(mesh));
        Inputs::of([path.clone()].into_iter().chain(meshes))
    }
}

/// The paths of a scene's meshes, each once: thousands of objects may share a mesh.
pub fn mesh_paths(scene: &SceneFile) -> BTreeSet<&str> {
    scene.objects.iter().filter_map(|object| object.shape.mesh_path()).collect()
}

/// Reads and checks the scene and its meshes; prints their warnings.
pub fn load(argument: &Path, import: &Import) -> Result<Loaded, Failure> {
    scene(&read(argument)?, import)
}

/// A built-in scene, whatever files there are.
pub fn built_in(name: &str) -> Result<Input, Failure> {
    let text = builtin::text(name).ok_or_else(|| nothing_of(name))?;
    Ok(Input { bytes: text.as_bytes().to_vec(), name: format!("{name}.json"), path: None })
}

/// What an argument names, judged by its beginning.
pub enum Named {
    /// A scene, or what was meant to be one.
    Scene(Input),
    /// A log, which is read by the way.
    Log(raywalk::files::Opened),
}

/// Opens what the argument names: a scene or a log.
pub fn open(argument: &Path) -> Result<Named, Failure> {
    let Some(opened) = opened(argument)? else {
        return built_in(&argument.to_string_lossy()).map(Named::Scene);
    };
    Ok(match Kind::of(opened.beginning()).is_log() {
        true => Named::Log(opened),
        false => Named::Scene(whole(opened, argument)?),
    })
}

/// Reads what the argument names.
pub fn read(argument: &Path) -> Result<Input, Failure> {
    match opened(argument)? {
        Some(opened) => whole(opened, argument),
        None => built_in(&argument.to_string_lossy()),
    }
}

/// The file that the argument names; `None` if it names no file.
fn opened(argument: &Path) -> Result<Option<Opened>, Failure> {
    let refused = |error: FileError| Failure::scene(&error);
    // What may be a file is no built-in scene.
    let is_path = argument == Path::new("-")
        || is_there(argument).map_err(|source| {
            let file = argument.to_string_lossy().into_owned();
            refused(FileError::Unreadable { file, source })
        })?;
    is_path.then(|| file::open(argument)).transpose().map_err(refused)
}

fn whole(opened: Opened, argument: &Path) -> Result<Input, Failure> {
    let name = opened.name().to_owned();
    if let Some(what) = no_scene(opened.beginning()) {
        return Err(Failure::caller(format!("{}: expected a scene, found {what}", escape_hidden(&name))));
    }
    let bytes = opened.bytes().map_err(|error| Failure::scene(&error))?;
    Ok(Input { bytes, name, path: Some(argument.to_owned()) })
}

/// What else of ours begins like this, and what to do with it.
fn no_scene(beginning: &[u8]) -> Option<&'static str> {
    match Kind::of(beginning) {
        Kind::Part => Some("a part of a picture; `raywalk merge` joins parts"),
        Kind::Log(_) => Some("a log; `raywalk walk` and `raywalk trace` show it"),
        Kind::Picture(_) => Some("a picture; `raywalk diff` compares two"),
        Kind::Utf16 | Kind::Other => None,
    }
}

/// Checks a scene that was read, and reads its meshes; prints their warnings.
pub fn scene(input: &Input, import: &Import) -> Result<Loaded, Failure> {
    let scene = without_meshes(input, import)?;
    let (meshes, warnings) = meshes(input, &scene).map_err(|error| Failure::scene(&error))?;
    warn(&warnings.told, warnings.more);
    let inputs = input.files(&scene);
    Ok(Loaded { scene, meshes, frame: 1, inputs })
}

/// The same without a word about what is odd, where there is no place for it.
pub fn quietly(input: &Input, import: &Import) -> Result<Loaded, FileError> {
    let scene = file::check_as(&input.bytes, &input.name, import)?.scene;
    let (meshes, _) = meshes(input, &scene)?;
    let inputs = input.files(&scene);
    Ok(Loaded { scene, meshes, frame: 1, inputs })
}

/// The meshes that a scene names, which lie beside its text.
pub fn meshes(input: &Input, scene: &SceneFile) -> Result<(Meshes, mesh::Warnings), FileError> {
    let source = Source { name: &input.name, text: &input.bytes };
    let folder = input.path.as_ref().map_or(Folder::BuiltIn(builtin::mesh), |path| Folder::OfScene(path));
    mesh::load(scene, &source, folder)
}

/// Checks a scene that was read, but doesn't look for its meshes; prints its warnings.
pub fn without_meshes(input: &Input, import: &Import) -> Result<SceneFile, Failure> {
    let loaded = file::check_as(&input.bytes, &input.name, import).map_err(|error| Failure::scene(&error))?;
    warn(&loaded.warnings, loaded.more_warnings);
    Ok(loaded.scene)
}

/// Prints what is odd about a scene, and how much more of it there is.
pub fn warn(warnings: &[Problem], more: usize) {
    for warning in warnings {
        output::tell(&warning.report(Severity::Warning, true));
    }
    if let Some(more) = more_warnings(more, true) {
        output::tell(&more);
    }
}

fn nothing_of(name: &str) -> Failure {
    let hint = match suggest(name, builtin::names()) {
        Some(near) => format!("; did you mean the built-in scene `{near}`?"),
        // The name of a file.
        None if name.contains(['.', '/', '\\']) => String::new(),
        None => format!("; the built-in scenes are {}", builtin::names().collect::<Vec<_>>().join(", ")),
    };
    Failure::caller(format!("{}: no such file or built-in scene{hint}", escape_hidden(name)))
}
