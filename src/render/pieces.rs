//! A picture in pieces, of which each can be rendered, kept and put together by itself.

use super::layers::{Layered, Seen, layers_in};
use super::{Counter, Film, RenderError, Settings, ask_for_memory, colors_in, digits};
use crate::log::Shard;
use crate::scene::{Color, Scene};
use crate::threads::Threads;
use rayon::prelude::*;
use raywalk_guard::attempt;
use std::io;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

/// The side of a piece in pixels. Part files depend on it.
pub const PIECE: u32 = 32;

/// What is rendered of each pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// Its colour.
    Colors,
    /// How many digits of it can be trusted, from runs perturbed by this seed and its successors.
    Digits {
        /// The seed of the first run.
        seed: u64,
    },
    /// Its colour with what it costs and sees.
    Layers,
}

/// What was rendered of some pixels, row by row.
#[derive(Clone, Debug, PartialEq)]
pub enum Pixels {
    /// Colours, or digits as grey.
    Colors(Vec<Color>),
    /// Colours with what pixels cost and see.
    Layers(Vec<Seen>),
}

impl Pixels {
    /// How many there are.
    pub fn count(&self) -> u64 {
        match self {
            Pixels::Colors(colors) => colors.len() as u64,
            Pixels::Layers(seen) => seen.len() as u64,
        }
    }
}

/// A picture that is put together from its pieces.
#[derive(Clone, Debug)]
pub enum Canvas {
    /// Colours, or digits as grey.
    Colors(Film),
    /// Colours with what pixels cost and see.
    Layers(Layered),
}

impl Canvas {
    /// An empty one for a rectangle of pixels.
    ///
    /// # Errors
    /// [`RenderError::Memory`].
    pub fn new(crop @ [left, top, right, bottom]: [u32; 4], of: Of) -> Result<Canvas, RenderError> {
        let (width, height) = (right - left, bottom - top);
        if of != Of::Layers {
            ask_for_memory(crop)?;
            return Ok(Canvas::Colors(Film::new(crop)));
        }
        let mut pixels = Vec::new();
        let count = width as usize * height as usize;
        attempt(|| pixels.try_reserve_exact(count)).map_err(|_| RenderError::Memory(width, height))?;
        pixels.resize(count, Seen::default());
        Ok(Canvas::Layers(Layered { width, height, pixels }))
    }

    /// Puts the pixels of a piece of the picture in their place; what isn't of this kind is ignored.
    pub fn put(&mut self, crop: [u32; 4], area: [u32; 4], pixels: &Pixels) {
        match (self, pixels) {
            (Canvas::Colors(film), Pixels::Colors(colors)) => film.put(area, colors),
            (Canvas::Layers(layered), Pixels::Layers(seen)) => {
                let (across, width) = ((area[2] - area[0]) as usize, layered.width as usize);
                for (row, line) in (area[1] - crop[1]..).zip(seen.chunks(across.max(1))) {
                    let start = row as usize * width + (area[0] - crop[0]) as usize;
                    layered.pixels[start..start + line.len()].copy_from_slice(line);
                }
            }
            _ => {}
        }
    }
}

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
    of: Of,
    pieces: &[(u32, [u32; 4])],
    done: impl FnMut(u32, Pixels) -> io::Result<()> + Send,
    stop: &AtomicBool,
) -> Result<Counter, RenderError> {
    ask_for_memory(settings.crop)?;
    let threads = Threads::of(settings.threads, pieces.len());
    let (failed, done) = (AtomicBool::new(false), Mutex::new(done));
    let is_over = || stop.load(Ordering::Relaxed) || failed.load(Ordering::Relaxed);
    let render = |(number, area): &(u32, [u32; 4])| {
        if is_over() {
            return Err(RenderError::Interrupted);
        }
        let settings = Settings { crop: *area, ..*settings };
        let (pixels, counter) = pixels_in(scene, &settings, of, stop).ok_or(RenderError::Interrupted)?;
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

/// The pixels of the settings' crop, on the threads of the pool that this is called in; `None` when the work is to stop.
fn pixels_in(scene: &Scene, settings: &Settings, of: Of, stop: &AtomicBool) -> Option<(Pixels, Counter)> {
    let of_film = |(film, counter): (Film, Counter)| (Pixels::Colors(film.into_pixels()), counter);
    match of {
        Of::Colors => colors_in(scene, settings, &|_| {}, stop).map(of_film),
        Of::Digits { seed } => digits::digits_in(scene, settings, seed, &|_| {}, stop).map(of_film),
        Of::Layers => {
            let seen = layers_in(scene, settings, &|_| {}, stop)?;
            Some((Pixels::Layers(seen), Counter::default()))
        }
    }
}
