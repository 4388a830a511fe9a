//! How threads take turns on the pixels of a rectangle, whatever is made of them.

use super::{Counter, Film, Progress, Settings, TileOrder};
use crate::random::permutation::permuted;
use crate::record::Computation;
use crate::scene::{Color, Scene};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

/// The side of a tile. Tiles are what threads take turns on, and what progress counts.
pub(super) const TILE: u32 = 16;

/// What is rendered, on the threads of the pool that it is called in. Every method gives `None` when the work is to stop.
pub(super) struct Task<'t> {
    pub scene: &'t Scene,
    pub settings: &'t Settings,
    pub progress: Progress<'t>,
    pub stop: &'t AtomicBool,
}

impl Task<'_> {
    /// The picture, pixel by pixel.
    pub fn by_pixels<T: Copy + Default + Send>(
        &self,
        of_pixel: impl Fn([u32; 2], &mut Counter) -> T + Sync,
    ) -> Option<(Film<T>, Counter)> {
        self.by_tiles(|tile, counter| self.each(tile, |pixel| of_pixel(pixel, counter)).map(|found| self.done(found)))
    }

    /// The picture, tile by tile: `of_tile` gives the pixels of one row by row.
    pub fn by_tiles<T: Copy + Default + Send>(
        &self,
        of_tile: impl Fn([u32; 4], &mut Counter) -> Option<Vec<T>> + Sync,
    ) -> Option<(Film<T>, Counter)> {
        let (mut film, mut counter) = (Film::new(self.settings.crop), Counter::default());
        self.fill(&mut film, self.settings.crop, &mut counter, of_tile)?;
        Some((film, counter))
    }

    /// Puts the tiles of an area into a film, and counts what they took.
    pub fn fill<T: Copy + Send>(
        &self,
        film: &mut Film<T>,
        area: [u32; 4],
        counter: &mut Counter,
        of_tile: impl Fn([u32; 4], &mut Counter) -> Option<Vec<T>> + Sync,
    ) -> Option<()> {
        let film = Mutex::new(film);
        let put = |tile: [u32; 4]| {
            let mut counter = Counter::default();
            let pixels = of_tile(tile, &mut counter)?;
            film.lock().unwrap_or_else(PoisonError::into_inner).put(tile, &pixels);
            Some(counter)
        };
        // Collected by the order of the list, so that nothing depends on which thread was first.
        let counters = tiles_of(area, self.settings.order).into_par_iter().map(put).collect::<Option<Vec<_>>>()?;
        counters.iter().for_each(|counted| counter.add(counted));
        Some(())
    }

    /// Something of each pixel of a tile, row by row.
    pub fn each<T>(
        &self,
        [left, top, right, bottom]: [u32; 4],
        mut of_pixel: impl FnMut([u32; 2]) -> T,
    ) -> Option<Vec<T>> {
        let mut found = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
        for row in top..bottom {
            for column in left..right {
                self.go_on()?;
                found.push(of_pixel([column, row]));
            }
        }
        Some(found)
    }

    /// Whether to go on.
    #[inline]
    pub fn go_on(&self) -> Option<()> {
        (!self.stop.load(Ordering::Relaxed)).then_some(())
    }

    /// Reports that these pixels are done.
    pub fn done<T>(&self, pixels: Vec<T>) -> Vec<T> {
        (self.progress)(pixels.len() as u64);
        pixels
    }

    /// The colour of a computation, which is counted if rays are.
    pub fn color_of(&self, computation: impl Computation, counter: &mut Counter) -> Color {
        if !self.settings.counts_rays {
            return self.settings.arithmetic.color(computation);
        }
        let (color, counted) = self.settings.arithmetic.run(std::mem::take(counter), computation);
        *counter = counted;
        color
    }
}

/// The tiles that cover a rectangle, row by row.
pub(super) fn tiles([left, top, right, bottom]: [u32; 4]) -> Vec<[u32; 4]> {
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
