//! Whole pictures, and what it takes to render them.

use super::bench::clock::{Lap, timed};
use crate::record::Arithmetic;
use crate::render::{Counter, RenderError, Rendered, Settings, render};
use crate::scene::{Color, Scene};
use std::sync::atomic::AtomicBool;

/// The picture of a scene, row by row, and what rendering it took.
pub(super) fn picture(scene: &Scene, arithmetic: Arithmetic, threads: usize) -> Result<(Vec<Color>, Lap), RenderError> {
    let (rendered, lap) = timed(|| whole(scene, arithmetic, threads, false));
    Ok((rendered?.film.into_pixels(), lap))
}

/// The rays of a picture in f64. Counting takes time, so that it is a run of its own.
pub(super) fn counts(scene: &Scene, threads: usize) -> Result<Counter, RenderError> {
    whole(scene, Arithmetic::F64, threads, true).map(|rendered| rendered.counts.unwrap_or_default())
}

fn whole(scene: &Scene, arithmetic: Arithmetic, threads: usize, counts_rays: bool) -> Result<Rendered, RenderError> {
    let settings = Settings { arithmetic, threads, counts_rays, ..Settings::whole(scene) };
    render(scene, &settings, |_| (), &AtomicBool::new(false))
}
