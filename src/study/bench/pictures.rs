//! Whole pictures, timed or counted.

use super::clock::{Lap, timed};
use crate::render::{Counter, RenderError, Settings, render};
use crate::scene::{Color, Scene};
use std::sync::atomic::AtomicBool;

pub(super) fn picture(scene: &Scene, threads: usize) -> Result<(Vec<Color>, Lap), RenderError> {
    let settings = Settings { threads, ..Settings::whole(scene) };
    let (rendered, lap) = timed(|| render(scene, &settings, |_| (), &AtomicBool::new(false)));
    Ok((rendered?.film.into_pixels(), lap))
}

/// Counting takes time, so that it is a run of its own.
pub(super) fn counts(scene: &Scene, threads: usize) -> Result<Counter, RenderError> {
    let settings = Settings { threads, counts_rays: true, ..Settings::whole(scene) };
    Ok(render(scene, &settings, |_| (), &AtomicBool::new(false))?.counts.unwrap_or_default())
}
