//! What sees a pixel's computation for its layers.

use super::PixelFacts;
use crate::log::{Decision, Name, RayKind, Step, Value};
use crate::probe::{Probe, Quantity, forward};
use crate::render::Counter;
use crate::sampling::mean::Sum;
use crate::scene::{Color, Scene};
use glam::DVec3;
use std::collections::BTreeMap;

/// Counts, and keeps what the camera's rays see.
pub(super) struct Observer<'s> {
    scene: &'s Scene,
    counter: Counter,
    /// Of each open node, whether what is noted there is said of a camera's ray.
    open: Vec<bool>,
    /// What the camera's ray that is under way has brought so far.
    sample: Sample,
    distances: f64,
    normals: DVec3,
    hits: BTreeMap<u32, u64>,
    colors: Sum,
    squares: DVec3,
    /// The first sample: differences from it keep their digits in squares.
    first: Option<Color>,
    samples: u64,
}

#[derive(Clone, Copy, Default)]
struct Sample {
    object: Option<u32>,
    point: Option<DVec3>,
    normal: Option<DVec3>,
    color: Option<Color>,
}

impl<'s> Observer<'s> {
    /// Before a pixel of this scene.
    pub fn new(scene: &'s Scene) -> Observer<'s> {
        Observer {
            scene,
            counter: Counter::default(),
            open: Vec::new(),
            sample: Sample::default(),
            distances: 0.0,
            normals: DVec3::ZERO,
            hits: BTreeMap::new(),
            colors: Sum::ZERO,
            squares: DVec3::ZERO,
            first: None,
            samples: 0,
        }
    }

    /// All that was seen of a pixel with this colour, which took so long.
    pub fn seen(&self, color: Color, white: f64, seconds: f64) -> PixelFacts {
        let met: u64 = self.hits.values().sum();
        let most = self.hits.iter().max_by_key(|(object, count)| (**count, std::cmp::Reverse(**object)));
        PixelFacts {
            color,
            rays: self.counter.rays(),
            primitive_tests: self.counter.primitive_tests(),
            bounds_tests: self.counter.bounds_tests(),
            depth: (met > 0).then(|| self.distances / met as f64),
            normal: if met > 0 { self.normals / met as f64 } else { Color::ZERO },
            object: most.filter(|(_, count)| **count >= self.samples - met).map(|(object, _)| *object),
            samples: self.samples,
            error: self.error().map(|error| error / white),
            seconds,
        }
    }

    /// s/√n of the channel where it is largest.
    fn error(&self) -> Option<f64> {
        let n = self.samples as f64;
        if self.samples < 2 {
            return None;
        }
        let mean = self.colors.over(n);
        let variance = (self.squares - mean * mean * n).max(DVec3::ZERO) / (n - 1.0);
        Some((variance.max_element() / n).sqrt())
    }

    fn is_of_camera(&self) -> bool {
        self.open.last().copied().unwrap_or(false)
    }

    /// Everything of a camera ray is traced.
    fn add(&mut self, sample: Sample) {
        self.samples += 1;
        if let (Some(object), Some(point)) = (sample.object, sample.point) {
            self.distances += (point - self.scene.camera.position()).length();
            self.normals += sample.normal.unwrap_or(DVec3::ZERO);
            *self.hits.entry(object).or_default() += 1;
        }
        let color = sample.color.unwrap_or(self.scene.background);
        let first = *self.first.get_or_insert(color);
        let difference = color - first;
        self.colors.add(difference);
        self.squares += difference * difference;
    }
}

impl Probe for Observer<'_> {
    const USES_SIMD: bool = true;

    forward!(self => Probe of self.counter; given bounds_tested fallback rays_saved);

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        if self.is_of_camera()
            && let Value::Triple(triple) = value.value()
        {
            if name.is(Name::HitPoint) {
                self.sample.point = Some(triple.into());
            } else if name.is(Name::HitNormalPlane) {
                self.sample.normal = Some(triple.into());
            } else if name.is(Name::CombineColor) {
                self.sample.color = Some(triple.into());
            }
        }
        value
    }

    fn mark(&mut self, decision: Decision) {
        self.counter.mark(decision);
        if let Decision::Nearest { object } = decision
            && self.is_of_camera()
        {
            self.sample.object = Some(object);
        }
    }

    fn enter(&mut self, step: Step) {
        self.counter.enter(step);
        let is_of_camera = match step {
            Step::Ray { kind: RayKind::Camera, .. } => {
                self.sample = Sample::default();
                true
            }
            // Tests may note points of what isn't the nearest; zones have rays of their own.
            Step::Ray { .. } | Step::Test { .. } | Step::Zone { .. } => false,
            Step::Sample { .. } | Step::Pixel(_) => false,
            Step::Motion { .. } | Step::Shade { .. } | Step::Light { .. } | Step::Combine => self.is_of_camera(),
        };
        self.open.push(is_of_camera);
    }

    fn leave(&mut self) {
        self.counter.leave();
        let was_of_camera = self.open.pop().unwrap_or(false);
        if was_of_camera && !self.is_of_camera() {
            let sample = self.sample;
            self.add(sample);
        }
    }
}
