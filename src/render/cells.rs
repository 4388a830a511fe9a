//! Pixels from cells that are cut where it matters: each corner that any pixel needs is traced once.
//!
//! A corner inside of a pixel belongs to that pixel, one between pixels of a tile to the tile, and one between tiles to all of them:
//! whoever needs it first traces it, and others wait for that. What a corner sees depends on its place alone, so that it
//! doesn't matter who was first, and every corner is counted once.

use super::task::{TILE, Task};
use super::{Counter, Film};
use crate::probe::{Probe, Saving};
use crate::random::hash;
use crate::record::Computation;
use crate::sampling::adaptive::{Cutting, rectangle};
use crate::sampling::outline::Rectangle;
use crate::sampling::shared::Corners;
use crate::sampling::small_objects::{self, SmallObject};
use crate::scene::Color;
use crate::trace::Seen;
use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// How many tiles high a strip is. What lies between tiles is kept for one strip.
const TILES_IN_STRIP: u32 = 4;

/// The picture; `None` when the work is to stop.
pub(super) fn by_cells(task: &Task, (threshold, depth): (f64, u32)) -> Option<(Film, Counter)> {
    let [left, top, right, bottom] = task.settings.crop;
    let small = small_objects::of(task.scene);
    let mut between_tiles = Shared::new();
    let mut film = Film::new(task.settings.crop);
    let mut counter = Counter::default();
    for strip_top in (top..bottom).step_by((TILE * TILES_IN_STRIP) as usize) {
        let strip = [left, strip_top, right, bottom.min(strip_top + TILE * TILES_IN_STRIP)];
        let small = small_objects::within(&small, in_picture(strip));
        task.fill(&mut film, strip, &mut counter, |area, counter| {
            let small = small_objects::within(small.iter().copied(), in_picture(area));
            Tile { task, threshold, depth, area, small, between_tiles: &between_tiles }.render(counter)
        })?;
        between_tiles.forget_above(strip[3] << depth);
    }
    Some((film, counter))
}

fn in_picture(area: [u32; 4]) -> Rectangle {
    area.map(f64::from)
}

/// A part of the picture that one thread renders.
struct Tile<'t> {
    task: &'t Task<'t>,
    threshold: f64,
    depth: u32,
    /// Left, top, right, bottom.
    area: [u32; 4],
    small: Vec<&'t SmallObject>,
    between_tiles: &'t Shared,
}

impl Tile<'_> {
    /// The pixels row by row; `None` when the work is to stop.
    fn render(&self, counter: &mut Counter) -> Option<Vec<Color>> {
        let mut known = Known::of(self.area);
        let mut alone = 0;
        let colors = self.task.each(self.area, |pixel| {
            let small = small_objects::within(self.small.iter().copied(), rectangle(pixel));
            known.inside.clear();
            let computation = Pixel { tile: self, pixel, small: &small, known: &mut known };
            let color = self.task.color_of(computation, counter);
            alone += known.asked.len() as u64;
            known.asked.clear();
            color
        })?;
        if self.task.settings.counts_rays {
            counter.rays_saved(Saving::Shared, alone - counter.samples());
        }
        Some(self.task.done(colors))
    }

    /// What a corner sees that other pixels have, too: those of other tiles, if it lies on the edge.
    fn corner(&self, place: [u32; 2], trace: impl FnOnce() -> Seen) -> Seen {
        if self.has_on_edge(place) { self.between_tiles.get(place, trace) } else { trace() }
    }

    /// Whether a corner of the picture's grid lies on the tile's edge.
    fn has_on_edge(&self, [column, row]: [u32; 2]) -> bool {
        let [left, top, right, bottom] = self.area.map(|side| side << self.depth);
        column == left || column == right || row == top || row == bottom
    }
}

/// What the corners of a tile see.
struct Known {
    /// Those of whole pixels, row by row: most pixels need no others.
    of_pixels: Vec<Option<Seen>>,
    area: [u32; 4],
    /// Those on the edges of pixels.
    between_pixels: ByPlace<Seen>,
    /// Those inside of the pixel at hand.
    inside: ByPlace<Seen>,
    /// Where rays are counted, the corners that the pixel at hand has asked for: as many as it would trace by itself.
    asked: ByPlace<()>,
}

impl Known {
    fn of(area @ [left, top, right, bottom]: [u32; 4]) -> Known {
        let corners = (right - left + 1) * (bottom - top + 1);
        Known {
            of_pixels: vec![None; corners as usize],
            area,
            between_pixels: HashMap::default(),
            inside: HashMap::default(),
            asked: HashMap::default(),
        }
    }

    /// The corner of a pixel with this column and row.
    fn of_pixel(&mut self, [column, row]: [u32; 2]) -> &mut Option<Seen> {
        let [left, top, right, _] = self.area;
        &mut self.of_pixels[((row - top) * (right - left + 1) + (column - left)) as usize]
    }
}

/// The computation of a pixel that shares corners with its neighbours.
struct Pixel<'t> {
    tile: &'t Tile<'t>,
    pixel: [u32; 2],
    small: &'t [&'t SmallObject],
    known: &'t mut Known,
}

impl Computation for Pixel<'_> {
    fn run<P: Probe>(self, probe: &mut P) -> Color {
        let Tile { task: Task { scene, settings, .. }, threshold, depth, .. } = *self.tile;
        let cutting = Cutting { scene, threshold, depth, pixel: self.pixel, small: self.small };
        let n = 1_u32 << depth;
        cutting.color(probe, |within, probe| {
            let place = [0, 1].map(|axis| self.pixel[axis] * n + within[axis]);
            if settings.counts_rays {
                self.known.asked.insert(place, ());
            }
            let trace = || Corners::Nested { depth }.seen(scene, place, probe);
            if within.iter().all(|step| step % n == 0) {
                let known = self.known.of_pixel(place.map(|step| step / n));
                *known.get_or_insert_with(|| self.tile.corner(place, trace))
            } else if within.iter().all(|step| step % n != 0) {
                *self.known.inside.entry(place).or_insert_with(trace)
            } else {
                *self.known.between_pixels.entry(place).or_insert_with(|| self.tile.corner(place, trace))
            }
        })
    }

    fn pixel(&self) -> [u32; 2] {
        self.pixel
    }
}

/// What corners see, or will see when whoever traces them is done.
type Kept = ByPlace<Arc<OnceLock<Seen>>>;

/// Values by their place in the grid of corners.
type ByPlace<T> = HashMap<[u32; 2], T, BuildHasherDefault<PlaceHasher>>;

/// The hash of a place. Places aren't chosen to collide, so a fast hash without a secret is enough.
#[derive(Default)]
struct PlaceHasher(u64);

impl Hasher for PlaceHasher {
    #[inline(always)]
    fn write_u32(&mut self, step: u32) {
        self.0 = hash(self.0, step.into());
    }

    #[inline(always)]
    fn write(&mut self, bytes: &[u8]) {
        for bytes in bytes.chunks(4) {
            self.write_u32(bytes.iter().rev().fold(0, |word, byte| word << 8 | u32::from(*byte)));
        }
    }

    /// How many numbers follow: two.
    #[inline(always)]
    fn write_usize(&mut self, _: usize) {}

    fn finish(&self) -> u64 {
        self.0
    }
}

/// What the corners between tiles see.
struct Shared {
    shards: Vec<Mutex<Kept>>,
}

/// So many that threads seldom want the same.
const SHARDS: usize = 64;

impl Shared {
    fn new() -> Shared {
        Shared { shards: (0..SHARDS).map(|_| Mutex::default()).collect() }
    }

    /// What a corner sees, which is traced unless somebody has done so or is about it.
    fn get(&self, place @ [column, row]: [u32; 2], trace: impl FnOnce() -> Seen) -> Seen {
        let shard = &self.shards[hash(column.into(), row.into()) as usize % SHARDS];
        // A thread that panics leaves no entry half made.
        let entry = shard.lock().unwrap_or_else(PoisonError::into_inner).entry(place).or_default().clone();
        *entry.get_or_init(trace)
    }

    /// Forgets the corners above a row of the grid.
    fn forget_above(&mut self, first: u32) {
        for shard in &mut self.shards {
            shard.get_mut().unwrap_or_else(PoisonError::into_inner).retain(|[_, row], _| *row >= first);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Barrier;
    use std::sync::atomic::{AtomicU32, Ordering};
    use std::thread;

    fn seen([column, row]: [u32; 2]) -> Seen {
        Seen { color: Color::new(column.into(), row.into(), 1.0), object: None }
    }

    /// Threads ask for the same corners at the same time, each in an order of its own: one of them traces each, the others wait for it.
    #[test]
    fn each_corner_is_traced_once_whoever_asks_first() {
        const THREADS: u32 = 8;
        const SIDE: u32 = 24;
        for _ in 0..20 {
            let (shared, start) = (Shared::new(), Barrier::new(THREADS as usize));
            let traced: Vec<AtomicU32> = (0..SIDE * SIDE).map(|_| AtomicU32::new(0)).collect();
            let ask_for_all = |first: u32| {
                start.wait();
                for number in (0..SIDE * SIDE).map(|number| (number + first * SIDE) % (SIDE * SIDE)) {
                    let place = [number % SIDE, number / SIDE];
                    let found = shared.get(place, || {
                        traced[number as usize].fetch_add(1, Ordering::Relaxed);
                        thread::yield_now();
                        seen(place)
                    });
                    assert_eq!(found, seen(place));
                }
            };
            let ask = &ask_for_all;
            thread::scope(|scope| {
                (0..THREADS).for_each(|thread| _ = scope.spawn(move || ask(thread % 3)));
            });
            assert!(traced.iter().all(|count| count.load(Ordering::Relaxed) == 1));
        }
    }

    #[test]
    fn corners_above_a_row_are_forgotten_and_those_from_it_on_are_kept() {
        let mut shared = Shared::new();
        for row in 0..6 {
            shared.get([7, row], || seen([7, row]));
        }
        shared.forget_above(3);
        for row in 0..6 {
            let mut is_traced = false;
            shared.get([7, row], || {
                is_traced = true;
                seen([7, row])
            });
            assert_eq!(is_traced, row < 3, "{row}");
        }
    }
}
