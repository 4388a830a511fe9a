//! Pixels whose numbers of samples the pilots around them decide (`sampling/guided.rs`): each pilot is traced once.

use super::{Counter, Film, Progress, Settings, color_of, tiles_of};
use crate::probe::Probe;
use crate::record::{Arithmetic, Computation};
use crate::sampling::guided::{Guide, Pilot, around, guided, is_alone, pilot, pilots_of_row};
use crate::sampling::mean::Sum;
use crate::scene::{Color, Guided, Scene};
use rayon::prelude::*;
use std::sync::atomic::{AtomicBool, Ordering};

/// About how many pilots are held at a time.
const PILOTS_AT_A_TIME: u32 = 1 << 17;

/// The picture; `None` when the work is to stop.
///
/// Pilots are traced strip by strip, so that memory doesn't grow with the picture's height. Those around the crop are traced, too, but not
/// counted: rays are those of the samples that make up the pixels, so that parts of a picture have together as many as the whole.
pub(super) fn by_pilots(
    scene: &Scene,
    settings: &Settings,
    wanted: Guided,
    progress: Progress,
    stop: &AtomicBool,
) -> Option<(Film, Counter)> {
    let crop @ [left, top, right, bottom] = settings.crop;
    let strip_height = (PILOTS_AT_A_TIME / (right - left)).max(1).next_multiple_of(super::TILE);
    let [first_column, first_row, end_column, _] = around(scene, crop);
    let mut known = Known { area: [first_column, first_row, end_column, first_row], pilots: Vec::new() };
    let mut film = Film::new(crop);
    let mut counter = Counter::default();
    for strip_top in (top..bottom).step_by(strip_height as usize) {
        let strip = [left, strip_top, right, bottom.min(strip_top + strip_height)];
        let pilots = Pilots { scene, settings, wanted, stop };
        pilots.know(&mut known, around(scene, strip), &mut counter)?;
        let tiles = tiles_of(strip, settings.order);
        let of_tile = |tile: &[u32; 4]| pilots.tile(&known, *tile, progress);
        let rendered = tiles.par_iter().map(of_tile).collect::<Option<Vec<_>>>()?;
        for (tile, (colors, counted)) in tiles.iter().zip(rendered) {
            film.put(*tile, &colors);
            counter.add(&counted);
        }
    }
    Some((film, counter))
}

/// The pilots of an area.
struct Known {
    /// Left, top, right and bottom, the last two exclusive.
    area: [u32; 4],
    /// Row by row.
    pilots: Vec<Pilot>,
}

impl Known {
    fn place(&self, [column, row]: [u32; 2]) -> usize {
        let [left, top, right, _] = self.area;
        (row - top) as usize * (right - left) as usize + (column - left) as usize
    }

    /// Forgets the rows above this one.
    fn forget_above(&mut self, row: u32) {
        self.pilots.drain(..self.place([self.area[0], row]));
        self.area[1] = row;
    }

    fn guide(&self, scene: &Scene, [column, row]: [u32; 2]) -> Guide {
        let [left, top, right, bottom] = around(scene, [column, row, column + 1, row + 1]);
        let own = if is_alone(scene) { usize::MAX } else { self.place([column, row]) };
        let around = (top..bottom).flat_map(|row| self.place([left, row])..self.place([right, row]));
        Guide::of(around.filter(|at| *at != own).map(|at| &self.pilots[at]))
    }
}

/// How pilots and pixels are traced.
struct Pilots<'s> {
    scene: &'s Scene,
    settings: &'s Settings,
    wanted: Guided,
    stop: &'s AtomicBool,
}

impl Pilots<'_> {
    /// Goes on to the pilots of an area that has the known columns and begins no higher; `None` when the work is to stop.
    fn know(&self, known: &mut Known, [_, top, _, bottom]: [u32; 4], counter: &mut Counter) -> Option<()> {
        known.forget_above(top);
        let [left, _, right, known_bottom] = known.area;
        let width = (right - left) as usize;
        let tiles = tiles_of([left, known_bottom, right, bottom], self.settings.order);
        let traced = tiles.par_iter().map(|tile| self.trace(*tile)).collect::<Option<Vec<_>>>()?;
        known.area[3] = bottom;
        known.pilots.resize((bottom - top) as usize * width, Pilot::NONE);
        for ([left, top, right, _], (pilots, counted)) in tiles.into_iter().zip(traced) {
            for (row, pilots) in (top..).zip(pilots.chunks((right - left) as usize)) {
                let start = known.place([left, row]);
                known.pilots[start..start + pilots.len()].copy_from_slice(pilots);
            }
            counter.add(&counted);
        }
        Some(())
    }

    /// The pilots of a tile, in the arithmetic in which they decide.
    fn trace(&self, [left, top, right, bottom]: [u32; 4]) -> Option<(Vec<Pilot>, Counter)> {
        let mut counter = Counter::default();
        let mut pilots = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
        for row in top..bottom {
            // Those of a row that are counted lie side by side.
            let [first, end] = self.counted(row).map(|column| column.clamp(left, right));
            for (columns, is_counted) in [(left..first, false), (first..end, true), (end..right, false)] {
                if self.stop.load(Ordering::Relaxed) {
                    return None;
                }
                if is_counted {
                    pilots.extend(columns.map(|column| pilot(self.scene, self.wanted, [column, row], &mut counter)));
                } else {
                    pilots_of_row(self.scene, self.wanted, row, columns, |pilot| pilots.push(pilot));
                }
            }
        }
        Some((pilots, counter))
    }

    /// From which column of a row up to which the rays of pilots count as those of the picture. In another arithmetic a pixel's samples are traced, and
    /// counted, by themselves.
    fn counted(&self, row: u32) -> [u32; 2] {
        let Settings { crop: [left, top, right, bottom], counts_rays, arithmetic, .. } = *self.settings;
        let is_counted = counts_rays && (top..bottom).contains(&row) && arithmetic == Arithmetic::F64;
        if is_counted { [left, right] } else { [0, 0] }
    }

    /// The pixels of a tile row by row; `None` when the work is to stop.
    fn tile(
        &self,
        known: &Known,
        [left, top, right, bottom]: [u32; 4],
        progress: Progress,
    ) -> Option<(Vec<Color>, Counter)> {
        let mut counter = Counter::default();
        let mut colors = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
        for row in top..bottom {
            for column in left..right {
                if self.stop.load(Ordering::Relaxed) {
                    return None;
                }
                let pixel = [column, row];
                let begun = known.pilots[known.place(pixel)].sum;
                let begun = (self.settings.arithmetic == Arithmetic::F64).then_some(begun);
                let guide = known.guide(self.scene, pixel);
                let computation = Pixel { scene: self.scene, wanted: self.wanted, pixel, guide, begun };
                colors.push(color_of(self.settings, computation, &mut counter));
            }
        }
        progress(colors.len() as u64);
        Some((colors, counter))
    }
}

/// The computation of a pixel of which the pilots are known.
struct Pixel<'s> {
    scene: &'s Scene,
    wanted: Guided,
    pixel: [u32; 2],
    guide: Guide,
    begun: Option<Sum>,
}

impl Computation for Pixel<'_> {
    fn run<P: Probe>(self, probe: &mut P) -> Color {
        guided(self.scene, self.wanted, self.pixel, self.guide, self.begun, probe)
    }

    fn pixel(&self) -> [u32; 2] {
        self.pixel
    }
}
