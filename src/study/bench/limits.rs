//! What a picture loses with every level less of its ray tree, and by cutoffs, and what that saves.

use super::clock::Lap;
use super::pictures::{counts, picture};
use crate::render::RenderError;
use crate::scene::{Ceilings, Color, Scene};
use crate::study::ladder::{Deviation, errors};
use serde::Serialize;

/// A limit, in the scene's terms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// `tracing.max_depth`.
    MaxDepth(u32),
    /// `tracing.cutoff`.
    Cutoff(f64),
}

/// What became of a picture under a limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Limited {
    /// The limit.
    #[serde(flatten)]
    pub limit: Limit,
    /// Rays of all kinds for each pixel.
    pub rays_per_pixel: f64,
    /// How long rendering took, in seconds.
    pub seconds: f64,
    /// How far it is from the picture with the reference's limit.
    #[serde(flatten)]
    pub deviation: Deviation,
    /// The most that cutoffs can have taken from a channel of a pixel, in units of the scene's white, where there is a bound.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub bound: Option<f64>,
}

/// A scene under a number of limits.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ladder {
    /// The limit of the picture that the others are compared with.
    pub reference: Limit,
    /// The rungs, from the tightest limit on.
    pub rungs: Vec<Limited>,
}

/// How many levels the reference has more than the scene asks for. Rays branch, so many more levels could take forever.
const LEVELS_MORE: u32 = 2;

/// The cutoffs that are compared.
pub const CUTOFFS: [f64; 6] = [0.3, 0.1, 0.03, 0.01, 0.003, 0.001];

/// Every depth limit up to the scene's own, against two levels more.
///
/// # Errors
/// Where a picture can't be rendered.
pub fn depths(scene: &Scene, threads: usize) -> Result<Ladder, RenderError> {
    let own = scene.tracing.max_depth;
    ladder(scene, Limit::MaxDepth(own.saturating_add(LEVELS_MORE)), (0..=own).map(Limit::MaxDepth), threads)
}

/// [`CUTOFFS`], against none.
///
/// # Errors
/// Where a picture can't be rendered.
pub fn cutoffs(scene: &Scene, threads: usize) -> Result<Ladder, RenderError> {
    ladder(scene, Limit::Cutoff(0.0), CUTOFFS.into_iter().chain([0.0]).map(Limit::Cutoff), threads)
}

fn ladder(
    scene: &Scene,
    reference: Limit,
    limits: impl Iterator<Item = Limit>,
    threads: usize,
) -> Result<Ladder, RenderError> {
    let (exact, _) = picture(&under(scene, reference), threads)?;
    let rung = |limit| {
        let scene = under(scene, limit);
        let (pixels, Lap { seconds, .. }) = picture(&scene, threads)?;
        let counter = counts(&scene, threads)?;
        let statistics = counter.statistics_of(scene.sampling.largest_share(), 0, Default::default(), 0);
        let bound = match (limit, statistics.lost) {
            (Limit::MaxDepth(_), _) => None,
            (Limit::Cutoff(_), None) => Some(0.0),
            (Limit::Cutoff(_), Some(lost)) => {
                lost.largest.map(|largest| Color::from(largest).max_element() / scene.output.white)
            }
        };
        let rays_per_pixel = counter.rays() as f64 / pixels.len() as f64;
        let deviation = Deviation::of(&errors(&scene, &pixels, &exact));
        Ok(Limited { limit, rays_per_pixel, seconds, deviation, bound })
    };
    Ok(Ladder { reference, rungs: limits.map(rung).collect::<Result<_, RenderError>>()? })
}

/// The scene with another limit.
fn under(scene: &Scene, limit: Limit) -> Scene {
    let mut scene = scene.clone();
    match limit {
        Limit::MaxDepth(depth) => scene.tracing.max_depth = depth,
        Limit::Cutoff(cutoff) => scene.tracing.cutoff = cutoff,
    }
    scene.ceilings = if scene.tracing.cutoff > 0.0 { Ceilings::of(&scene) } else { Ceilings::default() };
    scene
}
