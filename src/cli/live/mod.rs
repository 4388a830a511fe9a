//! The scene behind the viewer, which is traced while one looks.

pub mod drawing;
mod picture;

use glam::DVec3;
use picture::Rendering;
use raywalk::log::{Log, Subject};
use raywalk::probe::CutOff;
use raywalk::record::{self, Arithmetic, Part};
use raywalk::scene::Scene;
use raywalk::tui::{Drawing, Image, Live, Refusal, Wanted};
use std::sync::Arc;

/// A scene and the arithmetic that it is shown in.
pub struct Session {
    scene: Arc<Scene>,
    arithmetic: Arithmetic,
    is_still: bool,
    /// The picture; begun when somebody wants to see it.
    rendering: Option<Rendering>,
}

impl Session {
    /// The session of a scene. That of a still viewer renders nothing but what is seen in the end.
    pub fn new(scene: Scene, arithmetic: Arithmetic, is_still: bool) -> Session {
        Session { scene: Arc::new(scene), arithmetic, is_still, rendering: None }
    }

    fn log(&self, part: Part, arithmetic: Arithmetic) -> Result<Log, Refusal> {
        record::bounded(&self.scene, part, arithmetic).map_err(|cut_off| match cut_off {
            CutOff::TooLong { most } => Refusal::TooLong(most),
            CutOff::Memory => Refusal::NoMemory,
            CutOff::Io(error) => Refusal::Other(error.to_string()),
        })
    }
}

impl Live for Session {
    fn trace(&mut self, pixel: [u32; 2]) -> Result<Log, Refusal> {
        if self.arithmetic == Arithmetic::Printed {
            return Err(Refusal::OnePixelPrinted);
        }
        self.log(Part::Pixel(pixel), self.arithmetic)
    }

    fn picture(&mut self, wanted: Wanted) -> Option<Arc<Image>> {
        let (scene, arithmetic) = (&self.scene, self.arithmetic);
        // The printed values are those of one pixel; the others are as by hand.
        let arithmetic = if arithmetic == Arithmetic::Printed { Arithmetic::Decimal(3) } else { arithmetic };
        match wanted {
            Wanted::Latest if self.is_still => return Some(picture::empty(scene)),
            Wanted::Pixels(pixels) if self.is_still => return Some(picture::of(scene, arithmetic, pixels)),
            _ => {}
        }
        let is_whole = wanted != Wanted::Latest;
        let rendering = self.rendering.get_or_insert_with(|| Rendering::start(Arc::clone(scene), arithmetic, is_whole));
        if is_whole {
            rendering.finish();
        }
        rendering.latest()
    }

    fn drawing(&mut self) -> Option<Arc<Drawing>> {
        Some(Arc::new(drawing::of(&self.scene)))
    }

    fn compare(&mut self, subject: Subject) -> Result<Vec<Log>, Refusal> {
        let part = match subject {
            Subject::Pixel(pixel) => Part::Pixel(pixel),
            Subject::Ray([ox, oy, oz, dx, dy, dz]) => {
                Part::Ray { origin: DVec3::new(ox, oy, oz), direction: DVec3::new(dx, dy, dz) }
            }
            Subject::Region(_) => return Err(Refusal::RegionsNotCompared),
        };
        // The perturbed runs say how many digits of f64 can be trusted.
        let arithmetics = [Arithmetic::Decimal(3), Arithmetic::F32, Arithmetic::F64, Arithmetic::Perturbed(0)];
        arithmetics.into_iter().map(|arithmetic| self.log(part, arithmetic)).collect()
    }
}
