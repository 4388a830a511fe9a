//! What can be rendered of each pixel.

use super::layers::{Layered, PixelFacts, Planes, layers};
use super::task::Task;
use super::{BYTES_PER_PIXEL, Counter, Film, RenderError, colors, digits::digits};
use raywalk_guard::has_room_for;

/// What is rendered of each pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
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
    /// does, and costs what it would cost by itself. Planes are layers that are asked for by name; with them it takes longer.
    Layers(Planes),
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
    pub(super) fn run(&self, task: &Task) -> Option<(Canvas, Counter)> {
        Some(match self {
            Job::Colors => colors(task).map(|(film, counter)| (Canvas::Colors(film), counter))?,
            Job::Digits { seed } => digits(task, *seed).map(|(film, counter)| (Canvas::Digits(film), counter))?,
            Job::Layers(planes) => layers(task, planes).map(|(film, counter)| (Canvas::Layers(film), counter))?,
        })
    }

    /// Makes sure, as far as possible, that there is memory for a picture: in the middle of the work a failure could only abort.
    pub(super) fn ask_for_memory(&self, crop: [u32; 4]) -> Result<(), RenderError> {
        let beside = match self {
            Job::Layers(planes) => bytes_of_layers(planes.numbers()),
            Job::Colors | Job::Digits { .. } => 0,
        };
        is_room(crop, beside)
    }
}

/// The bytes of a pixel's layers.
fn bytes_of_layers(numbers: usize) -> usize {
    size_of::<PixelFacts>() + numbers * size_of::<f64>()
}

/// Whether there is memory for a picture with this much beside each pixel.
fn is_room([left, top, right, bottom]: [u32; 4], beside: usize) -> Result<(), RenderError> {
    let (width, height) = (right - left, bottom - top);
    let pixels = (width as usize).checked_mul(height as usize);
    let bytes = pixels.and_then(|pixels| pixels.checked_mul(BYTES_PER_PIXEL + beside));
    if bytes.is_some_and(has_room_for) { Ok(()) } else { Err(RenderError::Memory(width, height)) }
}

impl Canvas {
    /// An empty one for the colours of a rectangle of pixels.
    ///
    /// # Errors
    /// [`RenderError::Memory`].
    pub fn colors(crop: [u32; 4]) -> Result<Canvas, RenderError> {
        is_room(crop, 0).map(|()| Canvas::Colors(Film::new(crop)))
    }

    /// The same for their digits.
    ///
    /// # Errors
    /// [`RenderError::Memory`].
    pub fn digits(crop: [u32; 4]) -> Result<Canvas, RenderError> {
        is_room(crop, 0).map(|()| Canvas::Digits(Film::new(crop)))
    }

    /// The same for their layers, with this many numbers of planes a pixel.
    ///
    /// # Errors
    /// [`RenderError::Memory`].
    pub fn layers(crop: [u32; 4], numbers: usize) -> Result<Canvas, RenderError> {
        is_room(crop, bytes_of_layers(numbers)).map(|()| Canvas::Layers(Layered::new(crop, numbers)))
    }

    /// Puts a piece of the picture in its place; what isn't of this kind is ignored.
    pub fn put(&mut self, piece: &Canvas) {
        match (self, piece) {
            (Canvas::Colors(film), Canvas::Colors(piece)) | (Canvas::Digits(film), Canvas::Digits(piece)) => {
                film.put(piece.area(), piece.pixels());
            }
            (Canvas::Layers(film), Canvas::Layers(piece)) => film.put(piece),
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
