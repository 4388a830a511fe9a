//! All pixels of a picture, on all cores. A pixel has the same bits whatever the tiles, the threads or the crop.

mod cells;
pub mod difference;
pub mod digits;
pub mod export;
pub mod film;
mod grid;
pub mod layers;
pub mod losses;
pub mod part;
pub mod pieces;
mod pilots;
pub mod preview;
pub mod reach;
mod scale;
pub mod statistics;

pub use film::Film;
pub use statistics::{Counter, Statistics};

use crate::random::permutation::permuted;
use crate::record::{Arithmetic, Computation, Pixel};
use crate::sampling::together;
use crate::scene::{Color, Sampling, Scene};
use crate::threads::Threads;
use rayon::prelude::*;
use raywalk_guard::has_room_for;
use std::io;
use std::ops::Range;
use std::sync::atomic::{AtomicBool, Ordering};

/// In which order threads take up the tiles. Nothing depends on it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum TileOrder {
    /// Row by row from the top left.
    #[default]
    Rows,
    /// In one of the other orders, by its number.
    Shuffled(u64),
}

/// What to render and how.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The part of the picture: left, top, right and bottom in pixels, the last two exclusive.
    pub crop: [u32; 4],
    /// In which arithmetic.
    pub arithmetic: Arithmetic,
    /// On how many threads; 0 is one per core. Where the system lets fewer start, on those.
    pub threads: usize,
    /// Whether rays are counted.
    pub counts_rays: bool,
    /// In which order the tiles are taken up.
    pub order: TileOrder,
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
    /// The rendered pieces can't be saved.
    #[error(transparent)]
    Io(#[from] io::Error),
    /// Out of memory.
    #[error("not enough memory for a picture of {0} x {1} pixels")]
    Memory(u32, u32),
}

/// Called with the number of pixels of each finished tile. Behind a pointer, so that the tracer isn't compiled again for each one.
pub(crate) type Progress<'p> = &'p (dyn Fn(u64) + Sync);

/// The side of a tile. Tiles are what threads take turns on, and what progress counts.
const TILE: u32 = 16;

/// What a pixel needs until it is in a file: twice its colour (in its tile and in the film), its levels, their bytes.
pub const BYTES_PER_PIXEL: usize = 2 * size_of::<Color>() + 16;

/// Makes sure, as far as possible, that there is memory for a picture: in the middle of the work a failure could only abort.
///
/// # Errors
/// [`RenderError::Memory`] when there is none.
pub fn ask_for_memory([left, top, right, bottom]: [u32; 4]) -> Result<(), RenderError> {
    let (width, height) = (right - left, bottom - top);
    let bytes = (width as usize).checked_mul(height as usize).and_then(|pixels| pixels.checked_mul(BYTES_PER_PIXEL));
    let is_there = bytes.is_some_and(has_room_for);
    if is_there { Ok(()) } else { Err(RenderError::Memory(width, height)) }
}

/// Renders a picture. `progress` is called with the number of pixels of each finished tile; `stop` ends the work early.
pub fn render(
    scene: &Scene,
    settings: &Settings,
    progress: impl Fn(u64) + Sync,
    stop: &AtomicBool,
) -> Result<Rendered, RenderError> {
    on_threads(settings, || colors_in(scene, settings, &progress, stop))
}

/// The picture, on the threads of the pool that this is called in; `None` when the work is to stop.
fn colors_in(scene: &Scene, settings: &Settings, progress: Progress, stop: &AtomicBool) -> Option<(Film, Counter)> {
    let of_pixel = |pixel: [u32; 2], counter: &mut Counter| color_of(settings, Pixel { scene, pixel }, counter);
    let looks_on = settings.counts_rays || settings.arithmetic != Arithmetic::F64;
    if let Some(count) = together::few_samples(scene).filter(|_| !looks_on) {
        return by_rows(scene, settings, count, progress, stop);
    }
    match scene.sampling {
        Sampling::Shared { n } => grid::by_corners(scene, settings, n, progress, stop),
        Sampling::Adaptive { threshold, depth } => cells::by_cells(scene, settings, (threshold, depth), progress, stop),
        Sampling::Guided(wanted) => pilots::by_pilots(scene, settings, wanted, progress, stop),
        _ => by_pixels(settings, of_pixel, progress, stop),
    }
}

/// The picture row by row of its tiles, the few samples of neighbours together.
fn by_rows(
    scene: &Scene,
    settings: &Settings,
    count: u32,
    progress: Progress,
    stop: &AtomicBool,
) -> Option<(Film, Counter)> {
    let of_row = |row: u32, columns: Range<u32>, colors: &mut Vec<Color>, _: &mut Counter| {
        let goes_on = !stop.load(Ordering::Relaxed);
        if goes_on {
            together::row(scene, row, columns, count, colors);
        }
        goes_on.then_some(())
    };
    by_tiles(settings, of_row, progress)
}

/// Does the work on the threads that the settings ask for.
fn on_threads(
    settings: &Settings,
    work: impl FnOnce() -> Option<(Film, Counter)> + Send,
) -> Result<Rendered, RenderError> {
    ask_for_memory(settings.crop)?;
    // More threads than tiles would only compete.
    let threads = Threads::of(settings.threads, tiles(settings.crop).len());
    let (film, counter) = threads.run(work).ok_or(RenderError::Interrupted)?;
    Ok(Rendered { film, counts: settings.counts_rays.then_some(counter) })
}

/// The picture, pixel by pixel; `None` when the work is to stop.
fn by_pixels(
    settings: &Settings,
    of_pixel: impl Fn([u32; 2], &mut Counter) -> Color + Sync,
    progress: Progress,
    stop: &AtomicBool,
) -> Option<(Film, Counter)> {
    let of_row = |row: u32, columns: Range<u32>, colors: &mut Vec<Color>, counter: &mut Counter| {
        for column in columns {
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            colors.push(of_pixel([column, row], counter));
        }
        Some(())
    };
    by_tiles(settings, of_row, progress)
}

/// The picture, rows of its tiles at a time: `of_row` adds the colours of some columns of a row, or gives `None` when the work is to stop.
fn by_tiles(
    settings: &Settings,
    of_row: impl Fn(u32, Range<u32>, &mut Vec<Color>, &mut Counter) -> Option<()> + Sync,
    progress: Progress,
) -> Option<(Film, Counter)> {
    let tiles = tiles_of(settings.crop, settings.order);
    let of_tile = |tile: &[u32; 4]| tile_of(&of_row, *tile, progress);
    // Collected by the order of the list, so that nothing depends on which thread was first.
    let rendered = tiles.par_iter().map(of_tile).collect::<Option<Vec<_>>>()?;
    let mut film = Film::new(settings.crop);
    let mut counter = Counter::default();
    for (tile, (colors, counted)) in tiles.iter().zip(rendered) {
        film.put(*tile, &colors);
        counter.add(&counted);
    }
    Some((film, counter))
}

/// The tiles that cover a rectangle, row by row.
fn tiles([left, top, right, bottom]: [u32; 4]) -> Vec<[u32; 4]> {
    let starts = |from: u32, to: u32| (from..to).step_by(TILE as usize);
    let row = |y: u32| starts(left, right).map(move |x| [x, y, right.min(x + TILE), bottom.min(y + TILE)]);
    starts(top, bottom).flat_map(row).collect()
}

/// The same in the order in which they are taken up.
fn tiles_of(area: [u32; 4], order: TileOrder) -> Vec<[u32; 4]> {
    let tiles = tiles(area);
    let TileOrder::Shuffled(key) = order else { return tiles };
    let count = tiles.len() as u32;
    (0..count).map(|index| tiles[permuted(index, count, key) as usize]).collect()
}

/// The pixels of a tile row by row; `None` when the work is to stop.
fn tile_of(
    of_row: &impl Fn(u32, Range<u32>, &mut Vec<Color>, &mut Counter) -> Option<()>,
    [left, top, right, bottom]: [u32; 4],
    progress: Progress,
) -> Option<(Vec<Color>, Counter)> {
    let mut counter = Counter::default();
    let mut colors = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
    for row in top..bottom {
        of_row(row, left..right, &mut colors, &mut counter)?;
    }
    progress(colors.len() as u64);
    Some((colors, counter))
}

/// The colour of a computation, which is counted if rays are.
fn color_of(settings: &Settings, computation: impl Computation, counter: &mut Counter) -> Color {
    if !settings.counts_rays {
        return settings.arithmetic.color(computation);
    }
    let (color, counted) = settings.arithmetic.run(std::mem::take(counter), computation);
    *counter = counted;
    color
}
