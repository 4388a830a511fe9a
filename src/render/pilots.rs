//! Pixels whose numbers of samples the pilots around them decide (`sampling/guided.rs`): each pilot is traced once.

use super::task::{TILE, Task};
use super::{Counter, Film, Settings};
use crate::probe::Probe;
use crate::record::{Arithmetic, Computation};
use crate::sampling::guided::{Guide, Pilot, around, guided, is_alone, pilot, pilots_of_row};
use crate::sampling::mean::Sum;
use crate::scene::{Color, Guided, Scene};

/// About how many pilots are held at a time.
const PILOTS_AT_A_TIME: u32 = 1 << 17;

/// The picture; `None` when the work is to stop.
///
/// Pilots are traced strip by strip, so that memory doesn't grow with the picture's height. Those around the crop are traced, too, but not
/// counted: rays are those of the samples that make up the pixels, so that parts of a picture have together as many as the whole.
pub(super) fn by_pilots(task: &Task, wanted: Guided) -> Option<(Film, Counter)> {
    let crop @ [left, top, right, bottom] = task.settings.crop;
    let strip_height = (PILOTS_AT_A_TIME / (right - left)).max(1).next_multiple_of(TILE);
    let [first_column, first_row, end_column, _] = around(task.scene, crop);
    let mut known = Known { area: [first_column, first_row, end_column, first_row], pilots: Vec::new() };
    let pilots = Pilots { task, wanted };
    let mut film = Film::new(crop);
    let mut counter = Counter::default();
    for strip_top in (top..bottom).step_by(strip_height as usize) {
        let strip = [left, strip_top, right, bottom.min(strip_top + strip_height)];
        pilots.know(&mut known, around(task.scene, strip), &mut counter)?;
        task.fill(&mut film, strip, &mut counter, |tile, counter| pilots.tile(&known, tile, counter))?;
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
struct Pilots<'t> {
    task: &'t Task<'t>,
    wanted: Guided,
}

impl Pilots<'_> {
    /// Goes on to the pilots of an area that has the known columns and begins no higher; `None` when the work is to stop.
    fn know(&self, known: &mut Known, [_, top, _, bottom]: [u32; 4], counter: &mut Counter) -> Option<()> {
        known.forget_above(top);
        let [left, _, right, known_bottom] = known.area;
        let area = [left, known_bottom, right, bottom];
        let mut traced = Film::filled(area, Pilot::NONE);
        self.task.fill(&mut traced, area, counter, |tile, counter| self.trace(tile, counter))?;
        known.area[3] = bottom;
        known.pilots.extend(traced.into_pixels());
        Some(())
    }

    /// The pilots of a tile, in the arithmetic in which they decide.
    fn trace(&self, [left, top, right, bottom]: [u32; 4], counter: &mut Counter) -> Option<Vec<Pilot>> {
        let scene = self.task.scene;
        let mut pilots = Vec::with_capacity(((right - left) * (bottom - top)) as usize);
        for row in top..bottom {
            // Those of a row that are counted lie side by side.
            let [first, end] = self.counted(row).map(|column| column.clamp(left, right));
            for (columns, is_counted) in [(left..first, false), (first..end, true), (end..right, false)] {
                self.task.go_on()?;
                if is_counted {
                    pilots.extend(columns.map(|column| pilot(scene, self.wanted, [column, row], counter)));
                } else {
                    pilots_of_row(scene, self.wanted, row, columns, |pilot| pilots.push(pilot));
                }
            }
        }
        Some(pilots)
    }

    /// From which column of a row up to which the rays of pilots count as those of the picture. In another arithmetic a pixel's samples are traced, and
    /// counted, by themselves.
    fn counted(&self, row: u32) -> [u32; 2] {
        let Settings { crop: [left, top, right, bottom], counts_rays, arithmetic, .. } = *self.task.settings;
        let is_counted = counts_rays && (top..bottom).contains(&row) && arithmetic == Arithmetic::F64;
        if is_counted { [left, right] } else { [0, 0] }
    }

    /// The pixels of a tile row by row; `None` when the work is to stop.
    fn tile(&self, known: &Known, tile: [u32; 4], counter: &mut Counter) -> Option<Vec<Color>> {
        let Task { scene, settings, .. } = *self.task;
        let colors = self.task.each(tile, |pixel| {
            let begun = known.pilots[known.place(pixel)].sum;
            let begun = (settings.arithmetic == Arithmetic::F64).then_some(begun);
            let guide = known.guide(scene, pixel);
            self.task.color_of(Pixel { scene, wanted: self.wanted, pixel, guide, begun }, counter)
        })?;
        Some(self.task.done(colors))
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
