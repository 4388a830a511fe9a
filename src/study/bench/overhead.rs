//! What it costs to see the values of a computation: the same pixels before several probes.

use super::Spread;
use super::clock::timed;
use crate::log::Event;
use crate::probe::{CutOff, Recorder, Silent, until_cut_off};
use crate::record::{Arithmetic, MAX_EVENTS, Pixel};
use crate::render::Counter;
use crate::scene::Scene;
use serde::Serialize;
use std::hint::black_box;

/// A way to compute a pixel: a word for it, and the computation, which tells how many events it has where they are kept.
type Way = (&'static str, fn(Pixel) -> Result<usize, CutOff>);

/// Only the colour: what the other ways are compared with.
const SILENT: Way = ("silent", |pixel| Ok(forgotten(Arithmetic::F64, pixel)));

/// All ways: rays and tests counted, every event kept, the other arithmetics, and by hand with every event kept.
const WAYS: [Way; 7] = [
    SILENT,
    ("counter", |pixel| Ok(counted(pixel))),
    ("recorder", |pixel| kept(Arithmetic::F64, pixel)),
    ("f32", |pixel| Ok(forgotten(Arithmetic::F32, pixel))),
    ("decimal:3", |pixel| Ok(forgotten(Arithmetic::Decimal(3), pixel))),
    ("decimal:3+recorder", |pixel| kept(Arithmetic::Decimal(3), pixel)),
    ("perturbed", |pixel| Ok(forgotten(Arithmetic::Perturbed(0), pixel))),
];

/// What a way costs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cost {
    /// The way, in a word.
    pub way: &'static str,
    /// Nanoseconds a pixel.
    pub ns_per_pixel: Spread,
    /// Nanoseconds a ray, in the median.
    pub ns_per_ray: f64,
    /// How many times as long as without anything it took, of the runs of both one right after the other.
    pub ratio: Spread,
}

/// What each way costs on a scene, on one thread.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Overhead {
    /// How many pixels were computed in each run.
    pub pixels: u64,
    /// Rays of all kinds a pixel.
    pub rays_per_pixel: f64,
    /// Events that a pixel's log has.
    pub events_per_pixel: f64,
    /// Bytes that they take in memory, without what depends on them.
    pub event_bytes_per_pixel: f64,
    /// The ways.
    pub costs: Vec<Cost>,
}

fn forgotten(arithmetic: Arithmetic, pixel: Pixel) -> usize {
    black_box(arithmetic.run(Silent, pixel).0);
    0
}

fn counted(pixel: Pixel) -> usize {
    black_box(Arithmetic::F64.run(Counter::default(), pixel));
    0
}

fn kept(arithmetic: Arithmetic, pixel: Pixel) -> Result<usize, CutOff> {
    let events = until_cut_off(|| {
        let (color, recorder) = arithmetic.run(Recorder::of_at_most(MAX_EVENTS), pixel);
        recorder.finish(color.to_array())
    })?;
    Ok(black_box(events).len())
}

/// Computes all pixels of the scene in every way, each way in `pairs` pairs with the silent one, in turns first and second, so that a
/// machine that slows down slows both.
///
/// # Errors
/// Where a pixel's log is too long to be kept.
pub fn overhead(scene: &Scene, pairs: usize) -> Result<Overhead, CutOff> {
    let [width, height] = scene.camera.resolution;
    let pixels = u64::from(width) * u64::from(height);
    let rays = rays(scene);
    let mut events = 0;
    let mut costs = Vec::new();
    for way in WAYS {
        events = events.max(picture(scene, way)?);
        let (mut times, mut ratios) = (Vec::new(), Vec::new());
        for pair in 0..pairs {
            let [first, second] = if pair % 2 == 0 { [SILENT, way] } else { [way, SILENT] };
            let (one, other) = (seconds(scene, first)?, seconds(scene, second)?);
            let (silent, seen) = if pair % 2 == 0 { (one, other) } else { (other, one) };
            times.push(seen);
            ratios.push(seen / silent);
        }
        let ns_per_pixel = Spread::of(times).times(1e9 / pixels as f64);
        let ns_per_ray = ns_per_pixel.median * pixels as f64 / rays as f64;
        costs.push(Cost { way: way.0, ns_per_pixel, ns_per_ray, ratio: Spread::of(ratios) });
    }
    let events_per_pixel = events as f64 / pixels as f64;
    Ok(Overhead {
        pixels,
        rays_per_pixel: rays as f64 / pixels as f64,
        events_per_pixel,
        event_bytes_per_pixel: events_per_pixel * size_of::<Event>() as f64,
        costs,
    })
}

/// Seconds of processor time, which on one thread is the time that others don't lengthen.
fn seconds(scene: &Scene, way: Way) -> Result<f64, CutOff> {
    let (done, lap) = timed(|| picture(scene, way));
    done.map(|_| lap.cpu_seconds)
}

/// All pixels; how many events they have where they are kept.
fn picture(scene: &Scene, (_, compute): Way) -> Result<usize, CutOff> {
    let mut events = 0;
    for pixel in pixels(scene) {
        events += compute(Pixel { scene, pixel })?;
    }
    Ok(events)
}

fn pixels(scene: &Scene) -> impl Iterator<Item = [u32; 2]> + use<> {
    let [width, height] = scene.camera.resolution;
    (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]))
}

/// Rays of all kinds in the picture.
fn rays(scene: &Scene) -> u64 {
    let count = |counter, pixel| Arithmetic::F64.run(counter, Pixel { scene, pixel }).1;
    pixels(scene).fold(Counter::default(), count).rays()
}
