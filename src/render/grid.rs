//! Pixels from corners that they share: each corner of the grid is traced once.

use super::task::Task;
use super::{Counter, Film, Settings};
use crate::probe::{Probe, Saving};
use crate::record::{Computation, Corner};
use crate::sampling::mean::Sum;
use crate::sampling::shared::{add_cells, mean};
use crate::scene::Color;

/// About how many corners are held at a time.
const CORNERS_AT_A_TIME: usize = 1 << 17;

/// The picture; `None` when the work is to stop.
///
/// Corners are traced strip by strip, so that memory doesn't grow with the picture's height, and pixels add them in the
/// order of [`pixel`](crate::sampling::shared::pixel).
pub(super) fn by_corners(task: &Task, n: u32) -> Option<(Film, Counter)> {
    let [left, top, right, bottom] = task.settings.crop;
    // The grid's columns and rows that bound the crop, both ends included.
    let (first, last) = ([left * n, top * n], [right * n, bottom * n]);
    let across = (last[0] - first[0]) as usize + 1;
    let strip_height = (CORNERS_AT_A_TIME / across).max(1) as u32;
    let grid = Grid { task, n, first };
    let mut pixels = Pixels::new(task.settings, n);
    let mut counter = Counter::default();
    let mut upper: Vec<Color> = Vec::new();
    let mut row = first[1];
    while row <= last[1] {
        let end = (row + strip_height).min(last[1] + 1);
        let strip = [first[0], row, last[0] + 1, end];
        let mut corners = Film::new(strip);
        task.fill(&mut corners, strip, &mut counter, |tile, counter| grid.tile(tile, counter))?;
        for (row, lower) in (row..).zip(corners.pixels().chunks(across)) {
            if row > first[1] {
                pixels.add(row, &upper, lower);
            }
            upper.clear();
            upper.extend_from_slice(lower);
        }
        row = end;
    }
    if task.settings.counts_rays {
        let of_a_pixel = u64::from(n + 1) * u64::from(n + 1);
        let alone = u64::from(right - left) * u64::from(bottom - top) * of_a_pixel;
        counter.rays_saved(Saving::Shared, alone - counter.samples());
    }
    Some((pixels.film, counter))
}

/// The grid of corners.
struct Grid<'t> {
    task: &'t Task<'t>,
    n: u32,
    /// The crop's top left corner.
    first: [u32; 2],
}

impl Grid<'_> {
    /// The corners of a rectangle of the picture's grid, row by row.
    fn tile(&self, tile: [u32; 4], counter: &mut Counter) -> Option<Vec<Color>> {
        let Task { scene, progress, .. } = *self.task;
        let corners =
            self.task.each(tile, |corner| self.task.color_of(Corner { scene, n: self.n, corner }, counter))?;
        progress(self.pixels_completed_by(tile));
        Some(corners)
    }

    /// How many pixels have their bottom right corner in a tile; over all tiles that is every pixel once.
    fn pixels_completed_by(&self, [left, top, right, bottom]: [u32; 4]) -> u64 {
        let multiples = |from: u32, to: u32, first: u32| {
            let up_to = |end: u32| u64::from(end.saturating_sub(first + 1) / self.n);
            up_to(to) - up_to(from)
        };
        multiples(left, right, self.first[0]) * multiples(top, bottom, self.first[1])
    }
}

/// The pixels, as their cells are added up.
struct Pixels<'s> {
    film: Film,
    settings: &'s Settings,
    n: u32,
    /// The sums of the pixel row that is being added up.
    sums: Vec<Sum>,
}

/// The mean of the cells of a pixel.
struct Mean {
    sum: Sum,
    n: u32,
    pixel: [u32; 2],
}

impl Computation for Mean {
    fn run<P: Probe>(self, probe: &mut P) -> Color {
        mean(self.sum, self.n, probe)
    }

    fn pixel(&self) -> [u32; 2] {
        self.pixel
    }
}

impl<'s> Pixels<'s> {
    fn new(settings: &'s Settings, n: u32) -> Pixels<'s> {
        let film = Film::new(settings.crop);
        Pixels { sums: vec![Sum::ZERO; film.width() as usize], film, settings, n }
    }

    /// Adds the row of cells between two rows of corners, `row` being the lower one's number in the picture's grid.
    fn add(&mut self, row: u32, upper: &[Color], lower: &[Color]) {
        let n = self.n as usize;
        for (column, sum) in self.sums.iter_mut().enumerate() {
            let corners = column * n..=column * n + n;
            add_cells(sum, &upper[corners.clone()], &lower[corners]);
        }
        if row.is_multiple_of(self.n) {
            let [left, _, right, _] = self.settings.crop;
            let bottom = row / self.n;
            let (n, arithmetic) = (self.n, self.settings.arithmetic);
            let mean = |(column, sum): (u32, &mut Sum)| {
                let sum = std::mem::replace(sum, Sum::ZERO);
                arithmetic.color(Mean { sum, n, pixel: [column, bottom - 1] })
            };
            let finished: Vec<_> = (left..).zip(&mut self.sums).map(mean).collect();
            self.film.put([left, bottom - 1, right, bottom], &finished);
        }
    }
}
