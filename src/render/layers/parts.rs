//! What adds up the light of paths: of each wanted kind of path what it brings to the pixel.
//!
//! What a ray brings to its end is known when it is computed, the weights on its way to the eye only when the rays around it end. So each open ray has
//! the sums of what it brings itself and of what its bounces bring, and hands them on, weighted, when it ends.

use super::planes::{Place, Resolved};
use crate::log::plane::Emitter;
use crate::log::{Decision, Name, RayKind, Step, Term, Value};
use crate::probe::Quantity;
use crate::scene::Color;
use std::collections::HashMap;

/// Adds up the light of a pixel.
pub(super) struct Parts<'p> {
    wanted: &'p Resolved,
    open: Vec<Open>,
    rays: Vec<OpenRay>,
    /// The sums of the open rays, three times as many for each as are wanted: of its own light, of the reflected and of the transmitted one. The
    /// first belong to no ray: they are those of the sample.
    sums: Vec<Color>,
    /// Of the pixel.
    pixel: Vec<Color>,
    /// The weight of all samples so far.
    weight: f64,
    next: Sample,
    sample: Sample,
    /// The sums of corners by their places, where cells will say how much each counts.
    corners: HashMap<[u64; 2], Vec<Color>>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Open {
    /// A ray that brings light.
    Ray,
    Sample,
    Combine,
    Other,
}

struct OpenRay {
    kind: RayKind,
    bounces: u32,
    /// Which bounce the latest zone is of.
    zone: Term,
    /// Those that the weighted sum puts in: of the local, the reflected and the transmitted light.
    weights: [Color; 3],
}

/// What is said of a sample before it begins.
#[derive(Clone, Copy, Default)]
struct Sample {
    place: [Option<f64>; 2],
    weight: Option<f64>,
}

impl<'p> Parts<'p> {
    /// Before a pixel.
    pub fn new(wanted: &'p Resolved) -> Parts<'p> {
        let count = wanted.sums.len();
        Parts {
            wanted,
            open: Vec::new(),
            rays: Vec::new(),
            sums: vec![Color::ZERO; 3 * count],
            pixel: vec![Color::ZERO; count],
            weight: 0.0,
            next: Sample::default(),
            sample: Sample::default(),
            corners: HashMap::new(),
        }
    }

    /// Whether anything is added up.
    pub fn is_wanted(&self) -> bool {
        !self.wanted.sums.is_empty()
    }

    /// Light that the open ray brings to its own end.
    pub fn part(&mut self, emitter: Emitter, color: Color) {
        let Some(bounces) = self.rays.last().map(|ray| ray.bounces) else { return };
        let own = self.sums.len() - 3 * self.wanted.sums.len();
        for (sum, place) in self.sums[own..].iter_mut().zip(&self.wanted.sums) {
            if place.of.have(emitter, bounces) {
                *sum += color;
            }
        }
    }

    /// An input of the next event.
    pub fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        let number = |value: Value| value.number();
        match name {
            Name::SampleX => self.next.place[0] = number(value.value()),
            Name::SampleY => self.next.place[1] = number(value.value()),
            Name::SampleWeight => self.next.weight = number(value.value()),
            Name::LobeKept => self.divide(number(value.value())),
            _ if self.open.last() == Some(&Open::Combine) => self.weigh(name, value.value()),
            _ => {}
        }
    }

    /// A decision.
    pub fn mark(&mut self, decision: Decision) {
        let Decision::Accepted { cell: Some([left, top, side]), .. } = decision else { return };
        for [x, y] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]] {
            let weight = side * side / 4.0;
            self.weight += weight;
            let corner = self.corners.get(&key([left + x * side, top + y * side]));
            for (sum, corner) in self.pixel.iter_mut().zip(corner.into_iter().flatten()) {
                *sum += *corner * weight;
            }
        }
    }

    /// A node begins.
    pub fn enter(&mut self, step: Step) {
        let open = match step {
            Step::Ray { kind: RayKind::Shadow { .. }, .. } => Open::Other,
            Step::Ray { kind, depth, .. } => {
                self.sums.extend((0..3 * self.wanted.sums.len()).map(|_| Color::ZERO));
                self.rays.push(OpenRay { kind, bounces: depth, zone: Term::Reflected, weights: [Color::ONE; 3] });
                Open::Ray
            }
            Step::Sample { .. } => {
                self.sample = std::mem::take(&mut self.next);
                Open::Sample
            }
            Step::Zone { what, .. } => {
                if let Some(ray) = self.rays.last_mut() {
                    ray.zone = what;
                }
                Open::Other
            }
            Step::Combine => Open::Combine,
            _ => Open::Other,
        };
        self.open.push(open);
    }

    /// The latest node ends.
    pub fn leave(&mut self) {
        match self.open.pop() {
            Some(Open::Ray) => self.leave_ray(),
            Some(Open::Sample) => self.leave_sample(),
            _ => {}
        }
    }

    /// Puts the numbers of the pixel in their places.
    pub fn finish(mut self, numbers: &mut [f64]) {
        // A pixel of one ray has no samples.
        if self.weight == 0.0 {
            self.leave_sample();
        }
        for (Place { at, .. }, sum) in self.wanted.sums.iter().zip(&self.pixel) {
            numbers[*at..*at + 3].copy_from_slice(&(*sum / self.weight).to_array());
        }
    }

    /// Where the sums of the latest ray begin for its own light (0), the reflected (1) and the transmitted one (2).
    fn start(&self, of: usize) -> usize {
        let count = self.wanted.sums.len();
        self.sums.len() - (3 - of) * count
    }

    /// The mean of a blurred bounce.
    fn divide(&mut self, kept: Option<f64>) {
        let (Some(kept), Some(ray)) = (kept, self.rays.last()) else { return };
        let start = self.start(place_of(ray.zone));
        self.sums[start..start + self.wanted.sums.len()].iter_mut().for_each(|sum| *sum /= kept);
    }

    /// A weight of the sum at the end of a ray.
    fn weigh(&mut self, name: Name, value: Value) {
        let (Some(ray), Value::Triple(weight)) = (self.rays.last_mut(), value) else { return };
        let weight = Color::from_array(weight);
        match name {
            Name::WeightLocal => ray.weights[0] = weight,
            Name::WeightReflected => ray.weights[1] = weight,
            // What scales the reflected light beside its weight, where the scene says so.
            Name::MaterialSpecular => ray.weights[1] *= weight,
            Name::WeightTransmitted => ray.weights[2] = weight,
            _ => {}
        }
    }

    /// Hands on what a ray brings.
    fn leave_ray(&mut self) {
        let Some(ray) = self.rays.pop() else { return };
        let count = self.wanted.sums.len();
        let [own, reflected, transmitted] = [0, 1, 2].map(|of| self.start(of));
        let [local, of_reflected, of_transmitted] = ray.weights;
        let before = match ray.kind {
            // The sample's.
            RayKind::Camera => 0,
            RayKind::Transmitted => own - count,
            _ => own - 2 * count,
        };
        for at in 0..count {
            let sums = &self.sums;
            let brought =
                sums[own + at] * local + sums[reflected + at] * of_reflected + sums[transmitted + at] * of_transmitted;
            self.sums[before + at] += brought;
        }
        self.sums.truncate(own);
    }

    /// A sample is complete.
    fn leave_sample(&mut self) {
        let count = self.wanted.sums.len();
        let brought = self.sums[..count].to_vec();
        self.sums[..count].fill(Color::ZERO);
        let sample = std::mem::take(&mut self.sample);
        match (sample.place, sample.weight) {
            ([Some(x), Some(y)], None) if self.wanted.has_cells => _ = self.corners.insert(key([x, y]), brought),
            (_, weight) => {
                let weight = weight.unwrap_or(1.0);
                self.weight += weight;
                self.pixel.iter_mut().zip(brought).for_each(|(sum, brought)| *sum += brought * weight);
            }
        }
    }
}

fn place_of(bounce: Term) -> usize {
    if bounce == Term::Transmitted { 2 } else { 1 }
}

/// A place in the pixel. Both who names it compute it without rounding.
fn key(place: [f64; 2]) -> [u64; 2] {
    place.map(f64::to_bits)
}
