//! All pixels of a picture, on all cores. A pixel has the same bits whatever the tiles, the threads or the crop.

pub mod export;
pub mod film;
pub mod statistics;

pub use film::Film;
pub use statistics::{Counter, Statistics};

use crate::probe::Silent;
use crate::record::{Arithmetic, Pixel};
use crate::scene::{Color, Scene};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// What to render and how.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The part of the picture: left, top, right and bottom in pixels, the last two exclusive.
    pub crop: [u32; 4],
    /// In which arithmetic.
    pub arithmetic: Arithmetic,
    /// On how many threads; 0 is one a core.
    pub threads: usize,
    /// Whether rays are counted.
    pub counts_rays: bool,
}

/// A rendered picture.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The picture.
    pub film: Film,
    /// The counts, if they were asked for.
    pub counts: Option<Counter>,
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// It was asked to stop.
    #[error("interrupted")]
    Interrupted,
    /// There are no threads to be had.
    #[error("cannot start threads: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
}

/// The side of a tile. Tiles are what threads take turns on, and what progress counts.
const TILE: u32 = 16;

/// Renders a picture. `progress` is told how many pixels each finished tile had; `stop` ends the work early.
pub fn render(
    scene: &Scene,
    settings: &Settings,
    progress: impl Fn(u64) + Sync,
    stop: &AtomicBool,
) -> Result<Rendered, RenderError> {
    let tiles = tiles(settings.crop);
    let threads = rayon::ThreadPoolBuilder::new().num_threads(settings.threads).build()?;
    let rendered = threads.install(|| {
        let of_tile = |tile: &[u32; 4]| tile_of(scene, settings, *tile, &progress, stop);
        // Collected by the tiles' order, so that nothing depends on which thread was first.
        tiles.par_iter().map(of_tile).collect::<Option<Vec<_>>>()
    });
    let rendered = rendered.ok_or(RenderError::Interrupted)?;
    let mut film = Film::new(settings.crop);
    let mut counts = settings.counts_rays.then(Counter::default);
    for (tile, (colors, counter)) in tiles.iter().zip(rendered) {
        film.put(*tile, &colors);
        if let Some(counts) = &mut counts {
            counts.add(&counter);
        }
    }
    Ok(Rendered { film, counts })
}

/// The tiles that cover a rectangle, row by row.
fn tiles([left, top, right, bottom]: [u32; 4]) -> Vec<[u32; 4]> {
    let starts = |from: u32, to: u32| (from..to).step_by(TILE as usize);
    let row = |y: u32| starts(left, right).map(move |x| [x, y, right.min(x + TILE), bottom.min(y + TILE)]);
    starts(top, bottom).flat_map(row).collect()
}

/// The pixels of a tile row by row; `None` when the work is to stop.
fn tile_of(
    scene: &Scene,
    settings: &Settings,
    [left, top, right, bottom]: [u32; 4],
    progress: &impl Fn(u64),
    stop: &AtomicBool,
) -> Option<(Vec<Color>, Counter)> {
    let mut counter = Counter::default();
    let mut colors = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
    for row in top..bottom {
        for column in left..right {
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            let pixel = Pixel { scene, pixel: [column, row] };
            let color = if settings.counts_rays {
                let (color, counted) = settings.arithmetic.run(counter, pixel);
                counter = counted;
                color
            } else {
                settings.arithmetic.run(Silent, pixel).0
            };
            colors.push(color);
        }
    }
    progress(colors.len() as u64);
    Some((colors, counter))
}
