//! What each method of sampling makes of a scene in which time: its error against a picture with many more samples.

use super::Spread;
use super::exact::{self, NotExact};
use crate::record::Arithmetic;
use crate::render::RenderError;
use crate::scene::{Color, Sampling, Scene};
use crate::study::rendered::{counts, picture};
use crate::threads::Threads;
use serde::Serialize;
use std::fmt;

/// The seeds of the two pictures that make the reference; those that are measured begin at 0.
const REFERENCE_SEEDS: [u64; 2] = [1 << 40, (1 << 40) + 1];

/// What pictures are compared with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reference {
    /// The mean of two pictures with this sampling.
    Sampled(Sampling),
    /// The picture computed without sampling.
    Exact,
}

/// Why methods can't be compared.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// The scene can't be rendered.
    #[error(transparent)]
    Render(#[from] RenderError),
    /// It has no exact picture.
    #[error(transparent)]
    NotExact(#[from] NotExact),
}

/// How methods are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparing {
    /// What they are compared with.
    pub reference: Reference,
    /// How often each method renders, each time with another seed.
    pub runs: usize,
    /// On how many threads; 0 is one per core.
    pub threads: usize,
}

/// The methods on a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// The sampling of the two pictures whose mean is the reference, or `exact`.
    pub reference: String,
    /// The reference's own error: half of what its two pictures differ by. Errors about as small say nothing. `None` where it isn't known,
    /// as the two pictures have their samples in the same places, and for exact areas, which are only rounded; of exact penumbras, the estimate of
    /// their quadrature.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub reference_error: Option<f64>,
    /// The methods, in the order in which they were asked for.
    pub outcomes: Vec<Outcome>,
}

/// What became of a method.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Outcome {
    /// The method, as `--sampling` has it.
    pub sampling: String,
    /// Its word.
    pub method: &'static str,
    /// Rays from the eye for each pixel.
    pub samples_per_pixel: f64,
    /// Rays of all kinds for each pixel.
    pub rays_per_pixel: f64,
    /// Seconds by the clock.
    pub seconds: Spread,
    /// Processor seconds of all threads.
    pub cpu_seconds: Spread,
    /// The root of the mean square error over all pixels and channels, in units of the scene's white.
    pub rmse: Spread,
    /// Whether no other method has less error in no more time, or takes less time for no more error.
    pub is_on_front: bool,
}

/// Makes the reference, of two pictures, then renders the scene with each method; `done` is called behind each of them.
///
/// # Errors
/// Where the scene can't be rendered, or has no exact picture.
pub fn compare(
    scene: &Scene,
    methods: &[Sampling],
    comparing: Comparing,
    mut done: impl FnMut(),
) -> Result<Comparison, CompareError> {
    let mut scene = scene.clone();
    let own_seed = scene.seed;
    let (reference, reference_error) = match comparing.reference {
        Reference::Exact => {
            let (exact, error) = Threads::of(comparing.threads, usize::MAX).run(|| exact::picture(&scene))?;
            REFERENCE_SEEDS.iter().for_each(|_| done());
            (exact, error.map(|error| error / scene.output.white))
        }
        Reference::Sampled(sampling) => {
            scene.sampling = sampling;
            let mut pictures = Vec::new();
            for seed in REFERENCE_SEEDS {
                scene.seed = own_seed.wrapping_add(seed);
                pictures.push(picture(&scene, Arithmetic::F64, comparing.threads)?.0);
                done();
            }
            let mean = |(one, other): (&Color, &Color)| (*one + *other) / 2.0;
            let error = rmse(&pictures[0], &pictures[1], scene.output.white) / 2.0;
            // Where both pictures have their samples in the same places, they err alike.
            let error = (!sampling.has_fixed_places()).then_some(error);
            (pictures[0].iter().zip(&pictures[1]).map(mean).collect(), error)
        }
    };
    let mut outcomes = Vec::new();
    for sampling in methods {
        scene.sampling = *sampling;
        outcomes.push(outcome(&mut scene, own_seed, &reference, comparing)?);
        done();
    }
    mark_front(&mut outcomes);
    Ok(Comparison { reference: comparing.reference.to_string(), reference_error, outcomes })
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Reference::Sampled(sampling) => sampling.fmt(f),
            Reference::Exact => f.write_str("exact"),
        }
    }
}

impl Comparison {
    /// The fastest method with no more than this error, in the medians.
    pub fn best(&self, error: f64) -> Option<&Outcome> {
        let good = self.outcomes.iter().filter(|outcome| outcome.rmse.median <= error);
        good.min_by(|one, other| one.seconds.median.total_cmp(&other.seconds.median))
    }
}

fn outcome(
    scene: &mut Scene,
    own_seed: u64,
    reference: &[Color],
    comparing: Comparing,
) -> Result<Outcome, RenderError> {
    let (mut seconds, mut cpu_seconds, mut errors) = (Vec::new(), Vec::new(), Vec::new());
    // A run of its own, which warms up too.
    scene.seed = own_seed;
    let counted = counts(scene, comparing.threads)?;
    for run in 0..comparing.runs {
        scene.seed = own_seed.wrapping_add(run as u64);
        let (pixels, lap) = picture(scene, Arithmetic::F64, comparing.threads)?;
        seconds.push(lap.seconds);
        cpu_seconds.push(lap.cpu_seconds);
        errors.push(rmse(&pixels, reference, scene.output.white));
    }
    let pixels = reference.len() as f64;
    Ok(Outcome {
        sampling: scene.sampling.to_string(),
        method: scene.sampling.key(),
        samples_per_pixel: counted.samples() as f64 / pixels,
        rays_per_pixel: counted.rays() as f64 / pixels,
        seconds: Spread::of(seconds),
        cpu_seconds: Spread::of(cpu_seconds),
        rmse: Spread::of(errors),
        is_on_front: false,
    })
}

fn mark_front(outcomes: &mut [Outcome]) {
    let places: Vec<_> = outcomes.iter().map(|outcome| (outcome.seconds.median, outcome.rmse.median)).collect();
    for (outcome, place) in outcomes.iter_mut().zip(&places) {
        outcome.is_on_front = !places.iter().any(|other| other != place && other.0 <= place.0 && other.1 <= place.1);
    }
}

/// The root of the mean square of what two pictures differ by, in units of white.
fn rmse(picture: &[Color], other: &[Color], white: f64) -> f64 {
    let squares: f64 = picture.iter().zip(other).map(|(one, other)| (*one - *other).length_squared()).sum();
    (squares / (3 * picture.len()) as f64).sqrt() / white
}

#[cfg(test)]
mod tests {
    use super::*;

    fn outcome(seconds: f64, rmse: f64) -> Outcome {
        let spread = |value| Spread::of(vec![value]);
        Outcome {
            sampling: format!("random:{seconds}"),
            method: "random",
            samples_per_pixel: 1.0,
            rays_per_pixel: 1.0,
            seconds: spread(seconds),
            cpu_seconds: spread(seconds),
            rmse: spread(rmse),
            is_on_front: false,
        }
    }

    #[test]
    fn the_front_has_what_nothing_is_better_than() {
        let mut outcomes =
            [outcome(1.0, 0.5), outcome(2.0, 0.5), outcome(2.0, 0.1), outcome(3.0, 0.2), outcome(4.0, 0.05)];
        mark_front(&mut outcomes);
        let front: Vec<_> = outcomes.iter().map(|outcome| outcome.is_on_front).collect();
        assert_eq!(front, [true, false, true, false, true]);
        let comparison = Comparison { reference: String::new(), reference_error: None, outcomes: outcomes.to_vec() };
        assert_eq!(comparison.best(0.2).map(|best| best.seconds.median), Some(2.0));
        assert_eq!(comparison.best(0.01), None);
    }
}
