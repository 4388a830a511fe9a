//! A pixel or ray of a scene as a log, in any arithmetic.

mod arithmetic;
pub mod digits;
pub mod region;

pub use arithmetic::{Arithmetic, ArithmeticError, Computation};

use crate::geometry::Ray;
use crate::log::header::{FORMAT, SceneId, TracingId};
use crate::log::{Events, Header, Log, Parameter, SkipReason, Subject};
use crate::probe::{CutOff, Outlet, Probe, Recorder, until_cut_off};
use crate::sampling;
use crate::scene::file::schema::word;
use crate::scene::{Color, Formulas, ReflectedScale, Sampling, Scene, Skip, ray_along};
use crate::trace::camera_ray;
use glam::DVec3;
use std::collections::BTreeMap;

/// The most events of a log in memory (2²⁰): more than anybody steps through, in about 120 MiB. A log that is
/// written as it grows may be longer.
pub const MAX_EVENTS: usize = 1 << 20;

/// A part of a scene that has a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Part {
    /// A pixel, by column and row from the top left.
    Pixel([u32; 2]),
    /// A ray.
    Ray {
        /// Where it begins.
        origin: DVec3,
        /// Where it goes, of any length.
        direction: DVec3,
    },
}

/// The log of a pixel, however long it is, of a single run: see [`bounded`] for digits.
pub fn pixel(scene: &Scene, pixel: [u32; 2], arithmetic: Arithmetic) -> Log {
    whole(scene, Part::Pixel(pixel), arithmetic)
}

/// The log of a ray from `origin` along `direction`, of any length.
pub fn ray(scene: &Scene, origin: DVec3, direction: DVec3, arithmetic: Arithmetic) -> Log {
    whole(scene, Part::Ray { origin, direction }, arithmetic)
}

/// The log of a part, if it has at most [`MAX_EVENTS`] events. In perturbed arithmetic every value has its number of
/// [`digits`]: its further runs are compared with the log.
pub fn bounded(scene: &Scene, part: Part, arithmetic: Arithmetic) -> Result<Log, CutOff> {
    let record = |arithmetic| until_cut_off(|| record(scene, part, arithmetic, Recorder::of_at_most(MAX_EVENTS)));
    let mut events = record(arithmetic)?;
    if let Arithmetic::Perturbed(seed) = arithmetic {
        digits::put_into(&mut events, seed, record)?;
    }
    Ok(Log { header: header(scene, part.subject(), arithmetic), events })
}

/// Hands the events of a part on as they come, so that memory doesn't grow with the log. They have no numbers of digits:
/// runs can be compared only when they are whole, see [`bounded`].
pub fn stream(scene: &Scene, part: Part, arithmetic: Arithmetic, outlet: &mut Outlet) -> Result<(), CutOff> {
    until_cut_off(|| record(scene, part, arithmetic, Recorder::to_outlet(outlet))).map(|_| ())
}

/// The colour of a pixel, without a log.
pub fn pixel_color(scene: &Scene, pixel: [u32; 2], arithmetic: Arithmetic) -> Color {
    arithmetic.color(Pixel { scene, pixel })
}

fn whole(scene: &Scene, part: Part, arithmetic: Arithmetic) -> Log {
    let events = record(scene, part, arithmetic, Recorder::default());
    Log { header: header(scene, part.subject(), arithmetic), events }
}

fn record(scene: &Scene, part: Part, arithmetic: Arithmetic, recorder: Recorder) -> Events {
    let (color, recorder) = arithmetic.run(recorder, PartOf { scene, part });
    recorder.finish(color.to_array())
}

impl Part {
    /// The part as the header of its log names it.
    pub fn subject(self) -> Subject {
        match self {
            Part::Pixel(pixel) => Subject::Pixel(pixel),
            Part::Ray { origin: o, direction: d } => Subject::Ray([o.x, o.y, o.z, d.x, d.y, d.z]),
        }
    }
}

/// The header of a log of this part of the scene.
pub fn header(scene: &Scene, subject: Subject, arithmetic: Arithmetic) -> Header {
    let tracing = &scene.tracing;
    Header {
        log: FORMAT.to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: SceneId { name: scene.name.clone(), digest: scene.digest.clone() },
        subject,
        arithmetic: arithmetic.to_string(),
        tracing: TracingId {
            algorithm: word(tracing.algorithm),
            max_depth: tracing.max_depth,
            specular: word(tracing.specular),
            formulas: (tracing.formulas != Formulas::Robust).then(|| word(tracing.formulas)),
            sphere_method: word(tracing.sphere_method),
            reflected_scale: (tracing.reflected_scale != ReflectedScale::Weight).then(|| word(tracing.reflected_scale)),
            round_products: arithmetic.rounds_products(),
            cutoff: tracing.cutoff,
            two_sided: tracing.two_sided,
            skip: skip_id(tracing.skip),
            tests: scene.index.shows_all().then(|| "all".to_owned()),
        },
        sampling: sampling_id(scene.sampling),
        seed: scene.seed,
        frame: scene.frame,
        shard: None,
        objects: scene.objects.iter().map(|object| object.name.to_string()).collect(),
        lights: scene.lights.iter().map(|light| light.name.to_string()).collect(),
        only_elsewhere: Vec::new(),
    }
}

/// The rules that are in force; `None` if it is all of them.
fn skip_id(skip: Skip) -> Option<String> {
    let words = || SkipReason::ALL.iter().filter(|rule| skip.has(**rule)).map(|rule| rule.word());
    let has_all = words().count() == SkipReason::ALL.len();
    (!has_all)
        .then(|| words().collect::<Vec<_>>().join(","))
        .map(|words| if words.is_empty() { "none".to_owned() } else { words })
}

fn sampling_id(sampling: Sampling) -> BTreeMap<String, BTreeMap<String, Parameter>> {
    let (key, parameters) = sampling.parts();
    let parameters = parameters.into_iter().map(|(name, value)| (name.to_owned(), Parameter(value)));
    BTreeMap::from([(key.to_owned(), parameters.collect())])
}

/// The computation of a pixel.
#[derive(Clone, Copy)]
pub struct Pixel<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// Column and row from the top left.
    pub pixel: [u32; 2],
}

impl Computation for Pixel<'_> {
    fn run<P: Probe>(self, probe: &mut P) -> Color {
        sampling::pixel(self.scene, self.pixel, probe)
    }

    fn pixel(&self) -> [u32; 2] {
        self.pixel
    }
}

/// The computation of a corner that pixels share.
pub struct Corner<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// Corners a pixel's side.
    pub n: u32,
    /// Column and row in the picture's grid of corners.
    pub corner: [u32; 2],
}

impl Computation for Corner<'_> {
    fn run<P: Probe>(self, probe: &mut P) -> Color {
        sampling::shared::Corners::All { n: self.n }.seen(self.scene, self.corner, probe).color
    }
}

/// The computation of a part that has a log.
#[derive(Clone, Copy)]
pub struct PartOf<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// What is traced of it.
    pub part: Part,
}

impl Computation for PartOf<'_> {
    fn run<P: Probe>(self, probe: &mut P) -> Color {
        match self.part {
            Part::Pixel(pixel) => sampling::pixel(self.scene, pixel, probe),
            Part::Ray { origin, direction } => {
                let time = self.scene.camera.opening();
                let aim = |probe: &mut P| Some(Ray { time, ..ray_along(origin, direction, probe)? });
                camera_ray(self.scene, aim, probe)
            }
        }
    }

    fn pixel(&self) -> [u32; 2] {
        match self.part {
            Part::Pixel(pixel) => pixel,
            Part::Ray { .. } => [0, 0],
        }
    }
}
