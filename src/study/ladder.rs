//! The arithmetic ladder: what a picture loses with every digit less, and what it costs.

use super::rendered;
use crate::record::Arithmetic;
use crate::render::RenderError;
use crate::scene::{Color, Scene};
use serde::Serialize;

/// What became of a picture in one arithmetic.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Rung {
    /// The arithmetic, as it is named on the command line.
    pub arithmetic: String,
    /// How long rendering took, in seconds: the shortest of [`REPEATS`] times.
    pub seconds: f64,
    /// How far it is from the exact one.
    #[serde(flatten)]
    pub deviation: Deviation,
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
    let rung = |arithmetic: Arithmetic, seconds, errors: &[Color]| Rung {
        arithmetic: arithmetic.to_string(),
        seconds,
        deviation: Deviation::of(errors),
    };
    for arithmetic in by_hand.chain([Arithmetic::F32]) {
        let (picture, seconds) = timed(scene, arithmetic, threads)?;
        rungs.push(rung(arithmetic, seconds, &errors(scene, &picture, &exact)));
    }
    let mut moved = Vec::new();
    for seed in 0..REPEATS as u64 {
        let (picture, _) = rendered::picture(scene, Arithmetic::Perturbed(seed), threads)?;
        moved.extend(errors(scene, &exact, &picture));
    }
    rungs.push(rung(Arithmetic::F64, of_exact, &moved));
    Ok(rungs)
}

/// The errors of the pixels, in units of white.
pub(super) fn errors(scene: &Scene, picture: &[Color], exact: &[Color]) -> Vec<Color> {
    picture.iter().zip(exact).map(|(color, exact)| (*color - *exact) / scene.output.white).collect()
}

/// The picture, and the shortest of some times.
fn timed(scene: &Scene, arithmetic: Arithmetic, threads: usize) -> Result<(Vec<Color>, f64), RenderError> {
    let (picture, lap) = rendered::picture(scene, arithmetic, threads)?;
    let again = (1..REPEATS).map(|_| Ok(rendered::picture(scene, arithmetic, threads)?.1.seconds));
    let again = again.collect::<Result<Vec<_>, RenderError>>()?;
    Ok((picture, again.into_iter().fold(lap.seconds, f64::min)))
}
