//! The scene behind the viewer, which is traced while one looks.

pub mod drawing;
mod notes;
mod paths;
mod picture;
mod results;
pub mod workbench;

use crate::cli::inputs::Inputs;
use crate::cli::textbook::scene_of;
use glam::DVec3;
use notes::Notebook;
use picture::Rendering;
use raywalk::log::plane::Plane;
use raywalk::log::{Log, Subject};
use raywalk::probe::CutOff;
use raywalk::record::{self, Arithmetic, Part};
use raywalk::render::layers::{NoPlane, Planes};
use raywalk::report::Style;
use raywalk::report::causes::Study;
use raywalk::report::language::Language;
use raywalk::report::paper::Paper;
use raywalk::scene::Scene;
use raywalk::study::rounding::{self, MAX_CAUSES, Rounding};
use raywalk::study::textbook::{self, Example};
use raywalk::tui::{Change, Drawing, Image, Live, Note, Notes, Refusal, Wanted};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use workbench::Workbench;

/// A scene and how it is traced.
pub struct Session {
    scene: Arc<Scene>,
    workbench: Workbench,
    is_still: bool,
    /// The picture; begun when somebody wants to see it.
    rendering: Option<Rendering>,
    /// What of it was asked for by name.
    plane: Option<Plane>,
}

impl Session {
    /// The session of a scene. That of a still viewer renders nothing but what is seen in the end.
    pub fn new(scene: Scene, workbench: Workbench, is_still: bool) -> Session {
        Session { scene: Arc::new(scene), workbench, is_still, rendering: None, plane: None }
    }

    fn log(&self, part: Part, arithmetic: Arithmetic) -> Result<Log, Refusal> {
        log_of(&self.scene, part, arithmetic)
    }

    /// What is rendered. What was asked for by name isn't if the scene has it no more.
    fn subject(&self) -> picture::Subject {
        // The printed values are those of one pixel; the others are as by hand.
        let arithmetic = match self.workbench.arithmetic() {
            Arithmetic::Printed => Arithmetic::Decimal(3),
            other => other,
        };
        let planes = self.plane.as_ref().and_then(|plane| Planes::of(&self.scene, std::slice::from_ref(plane)).ok());
        picture::Subject { scene: Arc::clone(&self.scene), arithmetic, planes }
    }

    /// Goes on with another scene, and traces the same of it.
    fn go_on_with(&mut self, scene: Scene, subject: Subject) -> Result<Log, Refusal> {
        self.scene = Arc::new(scene);
        self.rendering = None;
        self.log(part_in(&self.scene, subject)?, self.workbench.arithmetic())
    }
}

fn log_of(scene: &Scene, part: Part, arithmetic: Arithmetic) -> Result<Log, Refusal> {
    record::bounded(scene, part, arithmetic).map_err(refusal)
}

fn refusal(cut_off: CutOff) -> Refusal {
    match cut_off {
        CutOff::TooLong { most } => Refusal::TooLong(most),
        CutOff::Memory => Refusal::NoMemory,
        CutOff::Io(error) => Refusal::Other(error.to_string()),
    }
}

/// The part of a scene that is traced for a subject. The picture may be smaller than it was.
fn part_in(scene: &Scene, subject: Subject) -> Result<Part, Refusal> {
    let [width, height] = scene.camera.resolution;
    match subject {
        Subject::Pixel([x, y]) => Ok(Part::Pixel([x.min(width - 1), y.min(height - 1)])),
        Subject::Ray([ox, oy, oz, dx, dy, dz]) => {
            Ok(Part::Ray { origin: DVec3::new(ox, oy, oz), direction: DVec3::new(dx, dy, dz) })
        }
        Subject::Region(_) => Err(Refusal::RegionsNotCompared),
    }
}

impl Live for Session {
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal> {
        let arithmetic = self.workbench.arithmetic();
        if arithmetic == Arithmetic::Printed {
            return Err(Refusal::OnePixelPrinted);
        }
        self.log(Part::Pixel(pixel), arithmetic)
    }

    fn picture(&mut self, wanted: Wanted) -> Option<Arc<Image>> {
        match wanted {
            Wanted::Latest if self.is_still => return Some(picture::empty(&self.subject())),
            Wanted::Pixels(pixels) if self.is_still => return Some(picture::of(&self.subject(), pixels)),
            _ => {}
        }
        let is_whole = wanted != Wanted::Latest;
        let subject = self.subject();
        let rendering = self.rendering.get_or_insert_with(|| Rendering::start(subject, is_whole));
        if is_whole {
            rendering.finish();
        }
        rendering.latest()
    }

    fn show(&mut self, plane: &Plane) -> Result<(), Refusal> {
        Planes::of(&self.scene, std::slice::from_ref(plane)).map_err(|error| match error {
            NoPlane::Light { name, known } => Refusal::NoLight(name, known),
            NoPlane::Class { class, known } => Refusal::NoClass(class, known),
            NoPlane::TooMany => Refusal::Other(error.to_string()),
        })?;
        self.plane = Some(plane.clone());
        self.rendering = None;
        Ok(())
    }

    fn drawing(&mut self) -> Option<Arc<Drawing>> {
        Some(Arc::new(drawing::of(&self.scene)))
    }

    fn compare(&mut self, subject: Subject) -> Result<Vec<Log>, Refusal> {
        let part = part_in(&self.scene, subject)?;
        // The perturbed runs say how many digits of f64 can be trusted.
        let arithmetics = [Arithmetic::Decimal(3), Arithmetic::F32, Arithmetic::F64, Arithmetic::Perturbed(0)];
        arithmetics.into_iter().map(|arithmetic| self.log(part, arithmetic)).collect()
    }

    fn change(&mut self, change: &Change, subject: Subject) -> Result<Log, Refusal> {
        let scene = self.workbench.change(change)?;
        self.go_on_with(scene, subject)
    }

    fn before(&mut self, subject: Subject) -> Result<Log, Refusal> {
        let (scene, arithmetic) = self.workbench.before()?;
        log_of(&scene, part_in(&scene, subject)?, arithmetic)
    }

    fn is_watching(&self) -> bool {
        self.workbench.is_watching()
    }

    fn reload(&mut self, subject: Subject) -> Option<Result<Log, Refusal>> {
        let scene = self.workbench.reload()?;
        Some(scene.and_then(|scene| self.go_on_with(scene, subject)))
    }

    fn parameters(&mut self, beginning: &str) -> Vec<(String, String)> {
        self.workbench.parameters(beginning)
    }

    fn save(&mut self, path: &str) -> Result<(), Refusal> {
        self.workbench.save(path)
    }

    fn write(&mut self, path: &str, text: &str) -> Result<(), Refusal> {
        results::write(path, self.workbench.inputs(), text.as_bytes())
    }

    fn export(&mut self, log: &Log, path: &str, language: Language, numbers: Style) -> Result<(), Refusal> {
        results::export(Some(&self.scene), log, (path, self.workbench.inputs()), (language, numbers))
    }

    fn files(&mut self, beginning: &str) -> Vec<String> {
        results::files(beginning)
    }

    fn source(&mut self, object: Option<u32>) -> Option<(PathBuf, usize)> {
        self.workbench.place(object)
    }

    fn study(&mut self, subject: Subject, arithmetic: Option<&str>) -> Result<Study, Refusal> {
        let rounding = match arithmetic {
            Some(word) => Rounding::of(workbench::arithmetic(word)?).ok_or(Refusal::RoundsNothing)?,
            None => Rounding::of(self.workbench.arithmetic()).unwrap_or(Rounding::Decimal(3)),
        };
        rounding::study(&self.scene, part_in(&self.scene, subject)?, rounding).map_err(|cut_off| match cut_off {
            CutOff::TooLong { .. } => Refusal::TooManyQuantities(MAX_CAUSES),
            other => refusal(other),
        })
    }

    fn book(&mut self, subject: Subject) -> Result<Paper, Refusal> {
        book(&self.scene.digest, subject)
    }
}

/// What can be asked of a saved log, which has no scene.
pub struct SavedLog {
    /// The digest of the scene that it is of.
    digest: String,
    /// The files that were read.
    inputs: Inputs,
    notebook: Notebook,
}

impl SavedLog {
    /// That of a scene with this digest, which was read from these files, the log from the first path.
    pub fn new(digest: String, inputs: Inputs, path: &Path) -> SavedLog {
        SavedLog { digest, inputs, notebook: Notebook::beside(path) }
    }

    /// The files that were read, those of the notes among them: only notes may be written there.
    fn read(&self) -> Inputs {
        self.inputs.clone().and(Inputs::of(self.notebook.file()))
    }
}

impl Live for SavedLog {
    fn trace(&mut self, _: [u32; 2]) -> Result<Log, Refusal> {
        Err(Refusal::NoScene)
    }

    fn compare(&mut self, _: Subject) -> Result<Vec<Log>, Refusal> {
        Err(Refusal::NoScene)
    }

    fn book(&mut self, subject: Subject) -> Result<Paper, Refusal> {
        book(&self.digest, subject)
    }

    fn write(&mut self, path: &str, text: &str) -> Result<(), Refusal> {
        results::write(path, &self.read(), text.as_bytes())
    }

    fn export(&mut self, log: &Log, path: &str, language: Language, numbers: Style) -> Result<(), Refusal> {
        results::export(None, log, (path, &self.read()), (language, numbers))
    }

    fn files(&mut self, beginning: &str) -> Vec<String> {
        results::files(beginning)
    }

    fn notes(&mut self, log: &Log) -> Result<Option<Notes>, Refusal> {
        self.notebook.read(log)
    }

    fn keep(&mut self, log: &Log, notes: &[Note]) -> Result<String, Refusal> {
        self.notebook.write(log, notes, &self.inputs)
    }
}

/// The worked example on the scene with this digest, which is another with other options for tracing.
fn book(digest: &str, subject: Subject) -> Result<Paper, Refusal> {
    let scenes = Example::ALL.into_iter().filter_map(|example| Some((example, scene_of(example).ok()?)));
    let is_it = |scene: &Scene| {
        scene.digest == digest && subject == Subject::Pixel(scene.camera.resolution.map(|side| side / 2))
    };
    let (example, scene) = scenes.into_iter().find(|(_, scene)| is_it(scene)).ok_or(Refusal::NoExample)?;
    Ok(Paper { scene: example.scene(), rows: textbook::table(example, &scene).steps })
}
