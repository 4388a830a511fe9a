//! The arithmetic ladder: what a picture loses with every digit less, and what it costs.

use crate::record::Arithmetic;
use crate::render::{RenderError, Settings, render};
use crate::scene::{Color, Scene};
use serde::Serialize;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

/// What became of a picture in one arithmetic.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rung {
    /// The arithmetic, as it is named on the command line.
    pub arithmetic: String,
    /// How long rendering took, in seconds: the shortest of [`REPEATS`] times.
    pub seconds: f64,
    /// The root of the mean squared error over all pixels and channels, in units of the scene's white.
    pub rmse: f64,
    /// The greatest error of a channel, in units of the scene's white.
    pub worst: f64,
    /// The part of the pixels that are off by more than one of 255 levels in some channel.
    pub visible: f64,
}

/// How far a picture is from another one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Deviation {
    /// The root of the mean squared error over all pixels and channels, in units of the scene's white.
    pub rmse: f64,
    /// The greatest error of a channel, in units of the scene's white.
    pub worst: f64,
    /// The part of the pixels that are off by more than one of 255 levels in some channel.
    pub visible: f64,
}

impl Deviation {
    /// That of these errors.
    pub fn of(errors: &[Color]) -> Deviation {
        let squares: f64 = errors.iter().map(|error| error.dot(*error)).sum();
        let worst = |error: &Color| error.abs().max_element();
        Deviation {
            rmse: (squares / (3 * errors.len()) as f64).sqrt(),
            worst: errors.iter().map(worst).fold(0.0, f64::max),
            visible: errors.iter().filter(|error| worst(error) > 1.0 / 255.0).count() as f64 / errors.len() as f64,
        }
    }
}

/// How often a picture is rendered to be timed.
pub const REPEATS: usize = 3;

/// The fewest and the most decimals by hand.
pub const DECIMALS: std::ops::RangeInclusive<u32> = 2..=15;

/// The rungs from few digits to many. All errors are against f64, and that of f64 itself against pictures of which every named
/// quantity was moved by a rounding error: what f64 can be trusted to.
///
/// # Errors
/// Where a picture can't be rendered.
pub fn ladder(scene: &Scene, threads: usize) -> Result<Vec<Rung>, RenderError> {
    let (exact, of_exact) = timed(scene, Arithmetic::F64, threads)?;
    let by_hand = DECIMALS.map(Arithmetic::Decimal);
    let mut rungs = Vec::new();
    for arithmetic in by_hand.chain([Arithmetic::F32]) {
        let (picture, seconds) = timed(scene, arithmetic, threads)?;
        rungs.push(Rung::of(arithmetic, seconds, &errors(scene, &picture, &exact)));
    }
    let mut moved = Vec::new();
    for seed in 0..REPEATS as u64 {
        let (picture, _) = once(scene, Arithmetic::Perturbed(seed), threads)?;
        moved.extend(errors(scene, &exact, &picture));
    }
    rungs.push(Rung::of(Arithmetic::F64, of_exact, &moved));
    Ok(rungs)
}

impl Rung {
    fn of(arithmetic: Arithmetic, seconds: f64, errors: &[Color]) -> Rung {
        let Deviation { rmse, worst, visible } = Deviation::of(errors);
        Rung { arithmetic: arithmetic.to_string(), seconds, rmse, worst, visible }
    }
}

/// The errors of the pixels, in units of white.
pub(super) fn errors(scene: &Scene, picture: &[Color], exact: &[Color]) -> Vec<Color> {
    picture.iter().zip(exact).map(|(color, exact)| (*color - *exact) / scene.output.white).collect()
}

/// The picture, and the shortest of some times.
fn timed(scene: &Scene, arithmetic: Arithmetic, threads: usize) -> Result<(Vec<Color>, f64), RenderError> {
    let (picture, mut shortest) = once(scene, arithmetic, threads)?;
    for _ in 1..REPEATS {
        shortest = shortest.min(once(scene, arithmetic, threads)?.1);
    }
    Ok((picture, shortest))
}

fn once(scene: &Scene, arithmetic: Arithmetic, threads: usize) -> Result<(Vec<Color>, f64), RenderError> {
    let settings = Settings { arithmetic, threads, ..Settings::whole(scene) };
    let begun = Instant::now();
    let rendered = render(scene, &settings, |_| (), &AtomicBool::new(false))?;
    Ok((rendered.film.into_pixels(), begun.elapsed().as_secs_f64()))
}
