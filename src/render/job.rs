//! What can be rendered of each pixel.

use super::layers::{Layered, PixelFacts, layers};
use super::task::Task;
use super::{BYTES_PER_PIXEL, Counter, Film, RenderError, colors, digits::digits};
use raywalk_guard::has_room_for;

/// What is rendered of each pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Job {
    /// Its colour.
    Colors,
    /// How many digits of it can be trusted, from runs perturbed by this seed and its successors. Where pixels share samples, each pixel
    /// traces its own, as its log does. Rays of all runs are counted; the arithmetic of the settings is ignored.
    Digits {
        /// The seed of the first run.
        seed: u64,
    },
    /// Its colour with what it costs and sees: the same colours, bit for bit. Where pixels share samples, each traces its own, as its log
    /// does, and costs what it would cost by itself.
    Layers,
}

/// What was rendered: a picture, or a piece of one.
#[derive(Clone, Debug, PartialEq)]
pub enum Canvas {
    /// Colours.
    Colors(Film),
    /// Digits, as grey.
    Digits(Film),
    /// Colours with what pixels cost and see.
    Layers(Layered),
}

impl Job {
    /// Renders a picture or a piece of one; `None` when the work is to stop.
    pub(super) fn run(self, task: &Task) -> Option<(Canvas, Counter)> {
        Some(match self {
            Job::Colors => colors(task).map(|(film, counter)| (Canvas::Colors(film), counter))?,
            Job::Digits { seed } => digits(task, seed).map(|(film, counter)| (Canvas::Digits(film), counter))?,
            Job::Layers => layers(task).map(|(film, counter)| (Canvas::Layers(film), counter))?,
        })
    }

    /// Makes sure, as far as possible, that there is memory for a picture: in the middle of the work a failure could only abort.
    pub(super) fn ask_for_memory(self, [left, top, right, bottom]: [u32; 4]) -> Result<(), RenderError> {
        let (width, height) = (right - left, bottom - top);
        let of_pixel = BYTES_PER_PIXEL + if self == Job::Layers { size_of::<PixelFacts>() } else { 0 };
        let bytes = (width as usize).checked_mul(height as usize).and_then(|pixels| pixels.checked_mul(of_pixel));
        let is_there = bytes.is_some_and(has_room_for);
        if is_there { Ok(()) } else { Err(RenderError::Memory(width, height)) }
    }
}

impl Canvas {
    /// An empty one for a rectangle of pixels.
    ///
    /// # Errors
    /// [`RenderError::Memory`].
    pub fn new(crop: [u32; 4], job: Job) -> Result<Canvas, RenderError> {
        job.ask_for_memory(crop)?;
        Ok(match job {
            Job::Colors => Canvas::Colors(Film::new(crop)),
            Job::Digits { .. } => Canvas::Digits(Film::new(crop)),
            Job::Layers => Canvas::Layers(Film::new(crop)),
        })
    }

    /// Puts a piece of the picture in its place; what isn't of this kind is ignored.
    pub fn put(&mut self, piece: &Canvas) {
        match (self, piece) {
            (Canvas::Colors(film), Canvas::Colors(piece)) | (Canvas::Digits(film), Canvas::Digits(piece)) => {
                film.put(piece.area(), piece.pixels());
            }
            (Canvas::Layers(film), Canvas::Layers(piece)) => film.put(piece.area(), piece.pixels()),
            _ => {}
        }
    }

    /// How many pixels it has.
    pub fn count(&self) -> u64 {
        match self {
            Canvas::Colors(film) | Canvas::Digits(film) => film.pixels().len() as u64,
            Canvas::Layers(film) => film.pixels().len() as u64,
        }
    }
}
