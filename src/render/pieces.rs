//! A picture in pieces, of which each can be rendered, kept and put together by itself.

use super::task::Task;
use super::{Canvas, Counter, Job, RenderError, Settings};
use crate::log::Shard;
use crate::scene::Scene;
use crate::threads::Threads;
use rayon::prelude::*;
use std::io;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// The side of a piece in pixels. Part files depend on it.
pub const PIECE: u32 = 32;

/// The pieces that cover a rectangle, row by row: left, top, right, bottom, the last two exclusive.
pub fn pieces([left, top, right, bottom]: [u32; 4]) -> impl Iterator<Item = [u32; 4]> {
    let starts = |from: u32, to: u32| (from..to).step_by(PIECE as usize);
    let row = move |y: u32| {
        starts(left, right)
            .map(move |x| [x, y, right.min(x.saturating_add(PIECE)), bottom.min(y.saturating_add(PIECE))])
    };
    starts(top, bottom).flat_map(row)
}

/// Those of a shard with their numbers.
pub fn pieces_of(crop: [u32; 4], shard: Shard) -> impl Iterator<Item = (u32, [u32; 4])> {
    (0..).zip(pieces(crop)).filter(move |(number, _)| shard.has(*number))
}

/// Renders pieces; `done` is called with the number of each, from one thread at a time, in no order. A pixel has the same bits as in the
/// whole picture. Corners between pieces that the pixels of several share are traced once for each piece, and counted so.
///
/// # Errors
/// As [`render`](super::render); [`RenderError::Io`] is that of `done`, after which nothing more is rendered.
pub fn render_pieces(
    scene: &Scene,
    settings: &Settings,
    job: &Job,
    pieces: &[(u32, [u32; 4])],
    done: impl FnMut(u32, Canvas) -> io::Result<()> + Send,
    stop: &AtomicBool,
) -> Result<Counter, RenderError> {
    job.ask_for_memory(settings.crop)?;
    let threads = Threads::of(settings.threads, pieces.len());
    let (failed, done) = (AtomicBool::new(false), Mutex::new(done));
    let is_over = || stop.load(Ordering::Relaxed) || failed.load(Ordering::Relaxed);
    let render = |(number, area): &(u32, [u32; 4])| {
        if is_over() {
            return Err(RenderError::Interrupted);
        }
        let settings = Settings { crop: *area, ..*settings };
        let task = Task { scene, settings: &settings, progress: &|_| {}, stop };
        let (pixels, counter) = job.run(&task).ok_or(RenderError::Interrupted)?;
        // A `done` that panicked isn't called again.
        let mut done = done.lock().map_err(|_| RenderError::Interrupted)?;
        if failed.load(Ordering::Relaxed) {
            return Err(RenderError::Interrupted);
        }
        done(*number, pixels).inspect_err(|_| failed.store(true, Ordering::Relaxed))?;
        Ok(counter)
    };
    let rendered: Vec<Result<Counter, RenderError>> = threads.run(|| pieces.par_iter().map(render).collect());
    let mut sum = Counter::default();
    let mut first = None;
    for counter in rendered {
        match counter {
            Ok(counter) => sum.add(&counter),
            // That pieces were left out is no reason by itself.
            Err(error @ RenderError::Interrupted) => first = first.or(Some(error)),
            Err(error) => return Err(error),
        }
    }
    first.map_or(Ok(sum), Err)
}
