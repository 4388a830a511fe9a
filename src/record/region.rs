//! The log of a rectangle of pixels: the pixels' logs one after the other, rows top down, left to right, each opened by an event
//! that names it.
//!
//! A pixel's log doesn't depend on other pixels, so that they may be made on several threads; they come in order all the same.

use super::{Arithmetic, MAX_EVENTS, Part, digits, header, record};
use crate::log::{Event, Events, Log, Shard, Subject};
use crate::probe::{CutOff, Recorder, until_cut_off};
use crate::scene::Scene;
use crate::threads::Threads;
use rayon::prelude::*;
use std::io;

/// A rectangle of pixels: left, top, right and bottom, the last two exclusive.
pub type Region = [u32; 4];

/// The pixels of a region in the order of its log.
pub fn pixels([left, top, right, bottom]: Region) -> impl Iterator<Item = [u32; 2]> {
    (top..bottom).flat_map(move |y| (left..right).map(move |x| [x, y]))
}

/// The pixels of a region that a shard has: a stretch of them, so that the logs of all shards in order are that of the region.
pub fn pixels_of(region: Region, shard: Shard) -> impl Iterator<Item = [u32; 2]> {
    let [left, top, right, bottom] = region;
    let (across, down) = (u64::from(right - left), u64::from(bottom - top));
    shard.stretch(across * down).map(move |place| [left + (place % across) as u32, top + (place / across) as u32])
}

/// The log of a region, if it has at most [`MAX_EVENTS`] events.
pub fn bounded(scene: &Scene, region: Region, arithmetic: Arithmetic) -> Result<Log, CutOff> {
    let too_long = || CutOff::TooLong { most: MAX_EVENTS };
    let mut events = Events::new();
    for pixel in pixels(region) {
        events.push(Event::opening(pixel));
        let room = MAX_EVENTS.checked_sub(events.len()).filter(|room| *room > 0).ok_or_else(too_long)?;
        events.add_all(&of_pixel(scene, pixel, arithmetic, room).map_err(|cut_off| match cut_off {
            // The limit of the whole log, not what was left for this pixel.
            CutOff::TooLong { .. } => too_long(),
            other => other,
        })?);
    }
    Ok(Log { header: header(scene, Subject::Region(region), arithmetic), events })
}

/// The events of a pixel, of which there are at most `room`; in perturbed arithmetic with their numbers of digits.
pub fn of_pixel(scene: &Scene, pixel: [u32; 2], arithmetic: Arithmetic, room: usize) -> Result<Events, CutOff> {
    let run = |arithmetic| until_cut_off(|| record(scene, Part::Pixel(pixel), arithmetic, Recorder::of_at_most(room)));
    let mut events = run(arithmetic)?;
    if let Arithmetic::Perturbed(seed) = arithmetic {
        digits::put_into(&mut events, seed, run)?;
    }
    Ok(events)
}

/// Hands what `make` makes of each pixel to `take`, in the order of the pixels; `make` runs on these threads.
///
/// # Errors
/// The first of `take`, after which nothing more is made.
pub fn in_order<T: Send>(
    pixels: impl Iterator<Item = [u32; 2]> + Send,
    threads: &Threads,
    make: impl Fn([u32; 2]) -> T + Sync,
    mut take: impl FnMut([u32; 2], T) -> io::Result<()>,
) -> io::Result<()> {
    /// Pixels a thread at a time: so many that one that takes long keeps nobody waiting for long.
    const EACH: usize = 32;
    let mut left = pixels;
    let each = EACH * threads.count();
    let piece = || {
        let piece: Vec<_> = left.by_ref().take(each).collect();
        (!piece.is_empty()).then(|| piece.into_par_iter().map(|pixel| (pixel, make(pixel))).collect::<Vec<_>>())
    };
    threads.hand_over(piece, |made| made.into_iter().try_for_each(|(pixel, made)| take(pixel, made)))
}
