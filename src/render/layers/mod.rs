//! What a pixel costs and what it sees, as layers beside the picture. Nothing of this is done when no layer is asked for.

mod catcher;
mod layered;
mod map;
mod observer;
mod parts;
mod planes;
mod watched;

pub use layered::Layered;
pub use map::{false_colors, of_plane};
pub use planes::{MAX_PLANES, NoPlane, Planes, classes_of, lights_of};
pub(super) use watched::Watched;

use super::export::{Channel, ExrLayer};
use super::task::Task;
use super::{Counter, Settings};
use crate::log::Unit;
use crate::log::plane::Plane;
use crate::log::words::words;
use crate::probe::Erased;
use crate::record::Pixel;
use crate::scene::{Color, Scene};
use observer::Observer;
use std::str::FromStr;
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

words! {
    /// What a layer shows of each pixel.
    pub Layer {
        /// Rays of all kinds.
        Rays = "rays",
        /// Tests of shapes, and of the boxes around them.
        Tests = "tests",
        /// The distance from the eye to what the camera's rays hit, the mean of those that meet something.
        Depth = "depth",
        /// The normal there that light is computed with, on the side of the eye; the mean of the same rays.
        Normal = "normal",
        /// Which object most of the camera's rays hit: its number in the scene from 1; 0 for none.
        Object = "object",
        /// Rays from the eye.
        Samples = "samples",
        /// The standard error of the pixel's colour, estimated from its samples: the largest of the three channels, as a part of white.
        Error = "error",
        /// Seconds that the pixel took, by the clock.
        Time = "time",
    }
}

impl FromStr for Layer {
    type Err = String;

    fn from_str(text: &str) -> Result<Layer, String> {
        Layer::find(text).ok_or_else(|| {
            let known = Layer::ALL.map(Layer::word).join(", ");
            format!("unknown layer `{text}`, expected one or several of {known}, with commas between them")
        })
    }
}

/// What is known of a pixel beside its colour.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PixelFacts {
    /// The pixel.
    pub color: Color,
    /// Rays of all kinds.
    pub rays: u64,
    /// Tests of shapes.
    pub primitive_tests: u64,
    /// Tests of boxes.
    pub bounds_tests: u64,
    /// The mean distance; `None` where only the background is seen.
    pub depth: Option<f64>,
    /// The mean normal; zero where only the background is seen.
    pub normal: Color,
    /// The object that most rays hit.
    pub object: Option<u32>,
    /// Rays from the eye.
    pub samples: u64,
    /// The standard error of the colour as a part of white; `None` of a single sample.
    pub error: Option<f64>,
    /// Seconds.
    pub seconds: f64,
}

/// The pixels with what they cost and see, and with the numbers of planes; `None` when the work is to stop.
pub(super) fn layers(task: &Task, planes: &Planes) -> Option<(Layered, Counter)> {
    let layered = Mutex::new(Layered::new(task.settings.crop, planes.numbers()));
    let lock = || layered.lock().unwrap_or_else(PoisonError::into_inner);
    let see = |pixel, _: &mut Counter| {
        let (seen, numbers) = see(task.scene, task.settings, planes, pixel);
        if !numbers.is_empty() {
            lock().put_numbers(pixel, &numbers);
        }
        seen
    };
    let (facts, counter) = task.by_pixels(see)?;
    let mut layered = layered.into_inner().unwrap_or_else(PoisonError::into_inner);
    layered.facts = facts;
    Some((layered, counter))
}

fn see(scene: &Scene, settings: &Settings, planes: &Planes, pixel: [u32; 2]) -> (PixelFacts, Vec<f64>) {
    let start = Instant::now();
    let (pixel, observer) = (Pixel { scene, pixel }, Observer::new(scene));
    let seen = |color, observer: Observer| observer.seen(color, scene.output.white, start.elapsed().as_secs_f64());
    if planes.names().is_empty() {
        let (color, observer) = settings.arithmetic.run(observer, pixel);
        return (seen(color, observer), Vec::new());
    }
    // As a log is recorded: what passes is what a log has, and the tracer isn't compiled once more.
    let mut watched = Watched::new(observer, planes);
    let (color, _) = settings.arithmetic.run(Erased::of(&mut watched), pixel);
    let (observer, numbers) = watched.finish();
    (seen(color, observer), numbers)
}

impl Layered {
    /// A layer as numbers, by channel. What isn't known isn't a number (NaN), and the depth of the background is infinite.
    pub fn layer(&self, layer: Layer) -> ExrLayer {
        let channel = |name: &'static str, of: &dyn Fn(&PixelFacts) -> f64| Channel {
            name,
            values: self.pixels().iter().map(|pixel| of(pixel) as f32).collect(),
        };
        let channels = match layer {
            Layer::Rays => vec![channel("count", &|seen| seen.rays as f64)],
            Layer::Tests => vec![
                channel("primitives", &|seen| seen.primitive_tests as f64),
                channel("bounds", &|seen| seen.bounds_tests as f64),
            ],
            Layer::Depth => vec![channel("Z", &|seen| seen.depth.unwrap_or(f64::INFINITY))],
            Layer::Normal => vec![
                channel("X", &|seen| seen.normal.x),
                channel("Y", &|seen| seen.normal.y),
                channel("Z", &|seen| seen.normal.z),
            ],
            Layer::Object => vec![channel("number", &|seen| seen.object.map_or(0.0, |object| f64::from(object) + 1.0))],
            Layer::Samples => vec![channel("count", &|seen| seen.samples as f64)],
            Layer::Error => vec![channel("value", &|seen| seen.error.unwrap_or(f64::NAN))],
            Layer::Time => vec![channel("seconds", &|seen| seen.seconds)],
        };
        ExrLayer { name: layer.word().to_owned(), channels }
    }

    /// A plane as numbers, by channel; `at` is the first of its numbers.
    pub fn plane(&self, plane: &Plane, at: usize) -> ExrLayer {
        let names: &[&'static str] = match plane {
            Plane::Value(value) if !value.is_triple() => &["value"],
            Plane::Value(value) if value.name.unit() != Unit::Intensity => &["X", "Y", "Z"],
            _ => &["R", "G", "B"],
        };
        let channel = |(name, at): (&&'static str, usize)| Channel {
            name,
            values: self.numbers_of(at).map(|number| number as f32).collect(),
        };
        ExrLayer { name: plane.file_name(), channels: names.iter().zip(at..).map(channel).collect() }
    }
}
