//! All pixels of a picture, on all cores. A pixel has the same bits whatever the tiles, the threads or the crop.

mod cells;
pub mod difference;
pub mod digits;
pub mod export;
pub(crate) mod film;
mod grid;
mod job;
pub mod layers;
pub(crate) mod losses;
pub mod part;
pub mod pieces;
mod pilots;
pub mod preview;
pub mod reach;
mod scale;
pub mod statistics;
mod task;

pub use film::Film;
pub use job::{Canvas, Job};
pub use statistics::{Counter, Statistics};

use crate::record::{Arithmetic, Pixel};
use crate::sampling::together;
use crate::scene::{Color, Sampling, Scene};
use crate::threads::Threads;
use std::io;
use std::sync::atomic::AtomicBool;
use task::{Task, tiles};

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

impl Settings {
    /// The whole picture of a scene in f64, on all cores; nothing is counted.
    pub fn whole(scene: &Scene) -> Settings {
        let [width, height] = scene.camera.resolution;
        let (arithmetic, order) = (Arithmetic::F64, TileOrder::Rows);
        Settings { crop: [0, 0, width, height], arithmetic, threads: 0, counts_rays: false, order }
    }
}

/// What was rendered.
#[derive(Clone, Debug)]
pub struct Rendered<T = Film> {
    /// The picture.
    pub film: T,
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

/// What a pixel needs at most until it is in a file: twice its colour (in its tile and in the film), its levels, their bytes.
pub const BYTES_PER_PIXEL: usize = 2 * size_of::<Color>() + 16;

/// Makes sure, as far as possible, that there is memory for a picture: in the middle of the work a failure could only abort.
///
/// # Errors
/// [`RenderError::Memory`] when there is none.
pub fn ask_for_memory(crop: [u32; 4]) -> Result<(), RenderError> {
    Job::Colors.ask_for_memory(crop)
}

/// Renders a picture. `progress` is called with the number of pixels of each finished tile; `stop` ends the work early.
///
/// # Errors
/// [`RenderError`].
pub fn render(
    scene: &Scene,
    settings: &Settings,
    progress: impl Fn(u64) + Sync,
    stop: &AtomicBool,
) -> Result<Rendered, RenderError> {
    on_threads(&Job::Colors, &Task { scene, settings, progress: &progress, stop }, colors)
}

/// Renders something of each pixel, as [`render`] does its colour.
///
/// # Errors
/// As [`render`].
pub fn render_job(
    job: Job,
    scene: &Scene,
    settings: &Settings,
    progress: impl Fn(u64) + Sync,
    stop: &AtomicBool,
) -> Result<Rendered<Canvas>, RenderError> {
    on_threads(&job, &Task { scene, settings, progress: &progress, stop }, |task| job.run(task))
}

/// Does the work on the threads that the settings ask for.
fn on_threads<T: Send>(
    job: &Job,
    task: &Task,
    work: impl FnOnce(&Task) -> Option<(T, Counter)> + Send,
) -> Result<Rendered<T>, RenderError> {
    let Settings { crop, threads, counts_rays, .. } = *task.settings;
    job.ask_for_memory(crop)?;
    // More threads than tiles would only compete.
    let threads = Threads::of(threads, tiles(crop).len());
    let (film, counter) = threads.run(|| work(task)).ok_or(RenderError::Interrupted)?;
    Ok(Rendered { film, counts: counts_rays.then_some(counter) })
}

/// The colours, by the way that suits the scene's sampling; `None` when the work is to stop.
fn colors(task: &Task) -> Option<(Film, Counter)> {
    let Task { scene, settings, .. } = *task;
    let looks_on = settings.counts_rays || settings.arithmetic != Arithmetic::F64;
    if let Some(count) = together::few_samples(scene).filter(|_| !looks_on) {
        return by_rows(task, count);
    }
    match scene.sampling {
        Sampling::Shared { n } => grid::by_corners(task, n),
        Sampling::Adaptive { threshold, depth } => cells::by_cells(task, (threshold, depth)),
        Sampling::Guided(wanted) => pilots::by_pilots(task, wanted),
        _ => task.by_pixels(|pixel, counter| task.color_of(Pixel { scene, pixel }, counter)),
    }
}

/// The colours row by row of the tiles, the few samples of neighbours together.
fn by_rows(task: &Task, count: u32) -> Option<(Film, Counter)> {
    task.by_tiles(|[left, top, right, bottom], _| {
        let mut colors = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
        for row in top..bottom {
            task.go_on()?;
            together::row(task.scene, row, left..right, count, &mut colors);
        }
        Some(task.done(colors))
    })
}
