//! The scene behind the viewer, which is traced while one looks.

pub mod drawing;
mod picture;

use crate::cli::textbook::scene_of;
use glam::DVec3;
use picture::Rendering;
use raywalk::log::{Log, Subject};
use raywalk::probe::CutOff;
use raywalk::record::{self, Arithmetic, Part};
use raywalk::report::causes::Study;
use raywalk::report::paper::Paper;
use raywalk::scene::Scene;
use raywalk::study::rounding::{self, MAX_CAUSES, Rounding};
use raywalk::study::textbook::{self, Example};
use raywalk::tui::{Drawing, Image, Live, Refusal};
use std::sync::Arc;

/// A scene and the arithmetic that it is shown in.
pub struct Session {
    scene: Arc<Scene>,
    arithmetic: Arithmetic,
    waits: bool,
    /// The picture; begun when somebody wants to see it.
    rendering: Option<Rendering>,
}

impl Session {
    /// The session of a scene; one that waits shows nothing of a picture before all of it is there.
    pub fn new(scene: Scene, arithmetic: Arithmetic, waits: bool) -> Session {
        Session { scene: Arc::new(scene), arithmetic, waits, rendering: None }
    }

    fn log(&self, part: Part, arithmetic: Arithmetic) -> Result<Log, Refusal> {
        record::bounded(&self.scene, part, arithmetic).map_err(refusal)
    }
}

fn refusal(cut_off: CutOff) -> Refusal {
    match cut_off {
        CutOff::TooLong { most } => Refusal::TooLong(most),
        CutOff::Memory => Refusal::NoMemory,
        CutOff::Io(error) => Refusal::Other(error.to_string()),
    }
}

/// The part of a scene that is traced for a subject.
fn part_of(subject: Subject) -> Result<Part, Refusal> {
    match subject {
        Subject::Pixel(pixel) => Ok(Part::Pixel(pixel)),
        Subject::Ray([ox, oy, oz, dx, dy, dz]) => {
            Ok(Part::Ray { origin: DVec3::new(ox, oy, oz), direction: DVec3::new(dx, dy, dz) })
        }
        Subject::Region(_) => Err(Refusal::RegionsNotCompared),
    }
}

impl Live for Session {
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal> {
        if self.arithmetic == Arithmetic::Printed {
            return Err(Refusal::OnePixelPrinted);
        }
        self.log(Part::Pixel(pixel), self.arithmetic)
    }

    fn picture(&mut self, whole: bool) -> Option<Arc<Image>> {
        let (scene, arithmetic, whole) = (&self.scene, self.arithmetic, whole || self.waits);
        // The printed values are those of one pixel; the others are as by hand.
        let arithmetic = if arithmetic == Arithmetic::Printed { Arithmetic::Decimal(3) } else { arithmetic };
        let rendering = self.rendering.get_or_insert_with(|| Rendering::start(Arc::clone(scene), arithmetic, whole));
        if whole {
            rendering.finish();
        }
        rendering.latest()
    }

    fn drawing(&mut self) -> Option<Arc<Drawing>> {
        Some(Arc::new(drawing::of(&self.scene)))
    }

    fn compare(&mut self, subject: Subject) -> Result<Vec<Log>, Refusal> {
        let part = part_of(subject)?;
        // The perturbed runs say how many digits of f64 can be trusted.
        let arithmetics = [Arithmetic::Decimal(3), Arithmetic::F32, Arithmetic::F64, Arithmetic::Perturbed(0)];
        arithmetics.into_iter().map(|arithmetic| self.log(part, arithmetic)).collect()
    }

    fn study(&mut self, subject: Subject) -> Result<Study, Refusal> {
        let rounding = Rounding::of(self.arithmetic).unwrap_or(Rounding::Decimal(3));
        rounding::study(&self.scene, part_of(subject)?, rounding).map_err(|cut_off| match cut_off {
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
    pub digest: String,
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
