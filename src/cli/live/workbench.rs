//! The scene of a session as it is now, and how it is traced: what is changed in the viewer, taken back, saved and read anew.

use super::paths::{self, PathError};
use super::results::{self, refused};
use crate::cli::failure::Failure;
use crate::cli::frames;
use crate::cli::inputs::Inputs;
use crate::cli::options::TracingOptions;
use crate::cli::sampling_spec;
use crate::cli::scene_argument::{self, Input, Loaded, mesh_paths};
use clap::ValueEnum;
use clap::builder::PossibleValue;
use raywalk::files::{FileError, KeyPath, unknown};
use raywalk::record::{Arithmetic, ArithmeticError};
use raywalk::scene::file::validate::Finding;
use raywalk::scene::file::{self, validate::limits::MAX_DEPTH};
use raywalk::scene::{Algorithm, Scene};
use raywalk::tui::{Change, Refusal};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant, SystemTime};

/// The scene, how it is traced, and how both were before each change.
pub struct Workbench {
    input: Input,
    /// The frame that is shown, if one was asked for.
    frame: Option<u32>,
    now: State,
    past: Vec<State>,
    watch: Watch,
}

#[derive(Clone)]
struct State {
    loaded: Loaded,
    tracing: TracingOptions,
}

/// The most changes that can be taken back.
const MAX_UNDO: usize = 100;

impl Workbench {
    /// A scene that was read.
    pub fn new(input: Input, loaded: Loaded, tracing: TracingOptions, frame: Option<u32>) -> Workbench {
        let watch = Watch::of(&input, &loaded);
        Workbench { input, frame, now: State { loaded, tracing }, past: Vec::new(), watch }
    }

    /// The scene as it is now, ready to be traced.
    pub fn scene(&self) -> Result<Scene, Failure> {
        self.built(&self.now)
    }

    /// The arithmetic in which it is traced.
    pub fn arithmetic(&self) -> Arithmetic {
        self.now.tracing.arithmetic()
    }

    fn built(&self, state: &State) -> Result<Scene, Failure> {
        state.tracing.apply(frames::at_one(state.loaded.clone(), self.frame)?)
    }

    /// The scene and the arithmetic before the last change.
    pub fn before(&self) -> Result<(Scene, Arithmetic), Refusal> {
        let state = self.past.last().ok_or(Refusal::NothingChanged)?;
        Ok((self.built(state).map_err(refused)?, state.tracing.arithmetic()))
    }

    /// Changes the scene or how it is traced. Where that can't be, nothing has changed.
    pub fn change(&mut self, change: &Change) -> Result<Scene, Refusal> {
        let next = match change {
            Change::Undo => self.past.last().cloned().ok_or(Refusal::NothingChanged)?,
            Change::Set { path, value } => State { loaded: self.with(path, value)?, ..self.now.clone() },
            Change::Arithmetic(word) => {
                self.traced(TracingOptions { arithmetic: arithmetic(word)?, ..self.now.tracing.clone() })
            }
            Change::Algorithm(word) => {
                let algorithm = Some(Algorithm::from_str(word, false).map_err(|_| unknown_algorithm(word))?);
                self.traced(TracingOptions { algorithm, ..self.now.tracing.clone() })
            }
            Change::Sampling(spec) => {
                let sampling = Some(sampling_spec::sampling(spec).map_err(Refusal::Other)?);
                self.traced(TracingOptions { sampling, ..self.now.tracing.clone() })
            }
            Change::Depth(number) => {
                let max_depth = number.parse().ok().filter(|depth| *depth <= MAX_DEPTH);
                if max_depth.is_none() {
                    return Err(Refusal::Other(format!(
                        "expected a whole number from 0 to {MAX_DEPTH}, found `{number}`"
                    )));
                }
                self.traced(TracingOptions { max_depth, ..self.now.tracing.clone() })
            }
        };
        let scene = self.built(&next).map_err(refused)?;
        // What changes nothing takes no step of `:undo`, and what was before stays to be compared with.
        let is_same = next.loaded.scene == self.now.loaded.scene && next.tracing == self.now.tracing;
        let left = std::mem::replace(&mut self.now, next);
        if *change == Change::Undo {
            self.past.pop();
        } else if !is_same {
            self.remember(left);
        }
        Ok(scene)
    }

    fn remember(&mut self, state: State) {
        if self.past.len() == MAX_UNDO {
            self.past.remove(0);
        }
        self.past.push(state);
    }

    fn traced(&self, tracing: TracingOptions) -> State {
        State { loaded: self.now.loaded.clone(), tracing }
    }

    /// The scene with another value at a path.
    fn with(&self, path: &str, value: &str) -> Result<Loaded, Refusal> {
        let old = &self.now.loaded;
        let mut scene = serde_json::to_value(&old.scene).map_err(|error| Refusal::Other(error.to_string()))?;
        paths::set(&mut scene, path, value).map_err(|error| match error {
            PathError::Unknown { step, known } => Refusal::NoParameter(step, known),
            PathError::NoPath => Refusal::NoPath,
        })?;
        let text = scene.to_string();
        let new = file::check(text.as_bytes(), &self.input.name).map_err(|error| problem(&error, false))?;
        let mut loaded = Loaded { scene: new.scene, ..old.clone() };
        if mesh_paths(&loaded.scene) != mesh_paths(&old.scene) {
            (loaded.meshes, _) =
                scene_argument::meshes(&self.input, &loaded.scene).map_err(|error| problem(&error, false))?;
        }
        Ok(loaded)
    }

    /// The paths that begin so, with their values.
    pub fn parameters(&self, beginning: &str) -> Vec<(String, String)> {
        serde_json::to_value(&self.now.loaded.scene).map_or_else(|_| Vec::new(), |scene| paths::list(&scene, beginning))
    }

    /// Saves the scene as it is traced now. It goes to no file that it was read from.
    pub fn save(&self, path: &str) -> Result<(), Refusal> {
        let scene = self.now.tracing.settled(self.now.loaded.clone()).map_err(refused)?.scene;
        results::write(path, self.inputs(), scene.to_json().as_bytes())
    }

    /// The files that the scene was read from.
    pub fn inputs(&self) -> &Inputs {
        &self.now.loaded.inputs
    }

    /// Whether the scene has files that may change.
    pub fn is_watching(&self) -> bool {
        !self.watch.files.is_empty()
    }

    /// The scene read anew, if its files have changed since they were last looked at. One that can't be read leaves all as it was.
    pub fn reload(&mut self) -> Option<Result<Scene, Refusal>> {
        self.watch.has_changed().then(|| {
            let path = self.input.path().ok_or(Refusal::NoScene)?.to_owned();
            let input = scene_argument::read(&path).map_err(refused)?;
            let new =
                scene_argument::quietly(&input, &self.now.tracing.import()).map_err(|error| problem(&error, true))?;
            let state = State { loaded: new, tracing: self.now.tracing.clone() };
            let scene = self.built(&state).map_err(refused)?;
            self.watch = Watch::of(&input, &state.loaded);
            self.input = input;
            let left = std::mem::replace(&mut self.now, state);
            self.remember(left);
            Ok(scene)
        })
    }

    /// The file of the scene, and the line of an object in it, from 1.
    pub fn place(&self, object: Option<u32>) -> Option<(PathBuf, usize)> {
        let path = self.input.path()?.to_owned();
        let steps = object.map(|object| KeyPath::default().join("objects").join(object as usize));
        let finding = steps.map(|path| Finding { path, message: String::new(), is_about_key: false });
        let placed = file::placed(finding.as_slice(), &self.input.bytes, &self.input.name);
        Some((path, placed.first().map_or(1, |problem| problem.line.max(1))))
    }
}

/// The arithmetic with this name.
pub fn arithmetic(word: &str) -> Result<Arithmetic, Refusal> {
    word.parse().map_err(|error: ArithmeticError| Refusal::Other(error.to_string()))
}

fn unknown_algorithm(word: &str) -> Refusal {
    let values: Vec<_> = Algorithm::value_variants().iter().filter_map(ValueEnum::to_possible_value).collect();
    let known: Vec<_> = values.iter().map(PossibleValue::get_name).collect();
    Refusal::Other(unknown("algorithm", word, &known))
}

/// The first problem of a file, in one line.
fn problem(error: &FileError, has_lines: bool) -> Refusal {
    Refusal::Other(match error {
        FileError::Invalid { problems, .. } if !problems.is_empty() => {
            let first = &problems[0];
            let place =
                if has_lines && first.line > 0 { format!("{}:{}: ", first.line, first.column) } else { String::new() };
            let path = if first.path.is_root() { String::new() } else { format!("{}: ", first.path) };
            format!("{place}{path}{}", first.message)
        }
        error => error.to_string(),
    })
}

/// The files of a scene, and what they were like when they were read.
struct Watch {
    files: Vec<(PathBuf, Option<Stamp>)>,
    looked: Instant,
}

/// When a file was last written, and its length.
type Stamp = (SystemTime, u64);

impl Watch {
    /// Looking costs a system call a file.
    const PAUSE: Duration = Duration::from_millis(400);

    fn of(input: &Input, loaded: &Loaded) -> Watch {
        let own = input.path().filter(|path| *path != Path::new("-"));
        let folder = own.and_then(Path::parent).unwrap_or(Path::new(""));
        let meshes = own.into_iter().flat_map(|_| mesh_paths(&loaded.scene)).map(|mesh| folder.join(mesh));
        let files = own.map(Path::to_owned).into_iter().chain(meshes);
        Watch { files: files.map(|file| (file.clone(), stamp(&file))).collect(), looked: Instant::now() }
    }

    /// Whether a file has changed since this was last asked. A file that is gone for a moment, as while an editor saves it, hasn't.
    fn has_changed(&mut self) -> bool {
        if self.looked.elapsed() < Watch::PAUSE {
            return false;
        }
        self.looked = Instant::now();
        let mut has_changed = false;
        for (file, known) in &mut self.files {
            let found = stamp(file);
            if found.is_some() && found != *known {
                (*known, has_changed) = (found, true);
            }
        }
        has_changed
    }
}

fn stamp(file: &Path) -> Option<Stamp> {
    let metadata = std::fs::metadata(file).ok()?;
    Some((metadata.modified().ok()?, metadata.len()))
}
