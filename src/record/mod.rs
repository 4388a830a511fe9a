//! A pixel or ray of a scene as a log, in any arithmetic.

mod arithmetic;

pub use arithmetic::{Arithmetic, ArithmeticError, Computation};

use crate::log::header::{FORMAT, SceneId, TracingId};
use crate::log::{Event, Header, Log, Subject};
use crate::probe::{Probe, Recorder};
use crate::sampling;
use crate::scene::{Algorithm, Color, Sampling, Scene, Specular, camera};
use crate::trace::camera_ray;
use glam::DVec3;
use std::collections::BTreeMap;

/// The log of a pixel, by column and row from the top left.
pub fn pixel(scene: &Scene, pixel: [u32; 2], arithmetic: Arithmetic) -> Log {
    Log { header: header(scene, Subject::Pixel(pixel), arithmetic), events: pixel_events(scene, pixel, arithmetic) }
}

/// The events of a pixel.
pub fn pixel_events(scene: &Scene, pixel: [u32; 2], arithmetic: Arithmetic) -> Vec<Event> {
    record(arithmetic, Pixel { scene, pixel })
}

/// The colour of a pixel, without a log.
pub fn pixel_color(scene: &Scene, pixel: [u32; 2], arithmetic: Arithmetic) -> Color {
    let (color, _) = arithmetic.run(crate::probe::Silent, Pixel { scene, pixel });
    color
}

/// The log of a ray from `origin` along `direction`, of any length.
pub fn ray(scene: &Scene, origin: DVec3, direction: DVec3, arithmetic: Arithmetic) -> Log {
    let [ox, oy, oz] = origin.to_array();
    let [dx, dy, dz] = direction.to_array();
    let header = header(scene, Subject::Ray([ox, oy, oz, dx, dy, dz]), arithmetic);
    Log { header, events: record(arithmetic, SingleRay { scene, origin, direction }) }
}

/// What a log of this part of the scene says about itself.
pub fn header(scene: &Scene, subject: Subject, arithmetic: Arithmetic) -> Header {
    let tracing = &scene.tracing;
    Header {
        log: FORMAT.to_owned(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        scene: SceneId { name: scene.name.clone(), digest: scene.digest.clone() },
        subject,
        arithmetic: arithmetic.to_string(),
        tracing: TracingId {
            algorithm: match tracing.algorithm {
                Algorithm::Recursive => "recursive",
                Algorithm::Whitted => "whitted",
                Algorithm::Foley => "foley",
            }
            .to_owned(),
            max_depth: tracing.max_depth,
            specular: match tracing.specular {
                Specular::HalfVector => "half_vector",
                Specular::ReflectionVector => "reflection_vector",
            }
            .to_owned(),
            sphere_method: tracing.sphere_method.word().to_owned(),
            cutoff: tracing.cutoff,
            two_sided: tracing.two_sided,
        },
        sampling: sampling_id(scene.sampling),
        objects: scene.objects.iter().map(|object| object.name.clone()).collect(),
        lights: scene.lights.iter().map(|light| light.name.clone()).collect(),
    }
}

fn sampling_id(sampling: Sampling) -> BTreeMap<String, BTreeMap<String, f64>> {
    let parameters = sampling.parameters().into_iter().map(|(name, value)| (name.to_owned(), value));
    BTreeMap::from([(sampling.word().to_owned(), parameters.collect())])
}

fn record(arithmetic: Arithmetic, computation: impl Computation) -> Vec<Event> {
    let (color, recorder) = arithmetic.run(Recorder::default(), computation);
    recorder.finish(color.to_array())
}

/// The computation of a pixel.
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
        sampling::shared::corner(self.scene, self.n, self.corner, probe)
    }
}

struct SingleRay<'s> {
    scene: &'s Scene,
    origin: DVec3,
    direction: DVec3,
}

impl Computation for SingleRay<'_> {
    fn run<P: Probe>(self, probe: &mut P) -> Color {
        camera_ray(self.scene, |probe| camera::ray_along(self.origin, self.direction, probe), probe)
    }
}
