//! More samples where they are needed: cells that are cut in four (Ramos, section 1.4.2; Whitted, "An improved illumination
//! model for shaded display", 1980).
//!
//! A cell is cut when the colours at its corners differ by more than the threshold, when its corners see different objects, or when
//! an object reaches into it that is small enough to be missed and that no corner sees. The pixel is the mean of its leaf cells,
//! each the mean of its corners, weighted by area. Corners are those of the finest grid of the whole picture, so that
//! neighbours have the same, and a picture traces each once (`render`).

use super::mean::Sum;
use super::outline::Rectangle;
use super::shared::Corners;
use super::small_objects::{self, SmallObject};
use crate::log::{Acceptance, Decision, Name, Split};
use crate::probe::Probe;
use crate::scene::file::validate::limits::MAX_ADAPTIVE_DEPTH;
use crate::scene::{Color, Scene};
use crate::trace::Seen;
use arrayvec::ArrayVec;
use std::collections::HashMap;

/// How a pixel is cut.
#[derive(Clone, Copy)]
pub struct Cutting<'s> {
    /// The scene.
    pub scene: &'s Scene,
    /// The difference that cuts, as a part of white.
    pub threshold: f64,
    /// How often a side may be halved.
    pub depth: u32,
    /// Column and row.
    pub pixel: [u32; 2],
    /// The small objects that reach into the pixel.
    pub small: &'s [&'s SmallObject],
}

/// The colour of a pixel that shares no samples: its own corners, in the order in which they are needed.
pub fn pixel<P: Probe>(scene: &Scene, threshold: f64, depth: u32, pixel: [u32; 2], probe: &mut P) -> Color {
    let small = small_objects::of_rectangle(scene, rectangle(pixel));
    let small: Vec<_> = small.iter().collect();
    let cutting = Cutting { scene, threshold, depth, pixel, small: &small };
    let mut known: HashMap<[u32; 2], Seen> = HashMap::new();
    cutting.color(probe, |within, probe| {
        let number = known.len() as u32 + 1;
        let corners = Corners::Nested { depth };
        *known.entry(within).or_insert_with(|| corners.sample(scene, pixel, within, number, probe))
    })
}

/// The rectangle of a pixel in the picture.
pub fn rectangle([column, row]: [u32; 2]) -> Rectangle {
    let [left, top] = [f64::from(column), f64::from(row)];
    [left, top, left + 1.0, top + 1.0]
}

/// A square of the pixel, in steps of the finest grid.
#[derive(Clone, Copy)]
struct Cell {
    left: u32,
    top: u32,
    side: u32,
}

/// The most cells that wait: three of each size, and one.
const MOST_OPEN: usize = 3 * MAX_ADAPTIVE_DEPTH as usize + 1;

impl Cutting<'_> {
    /// The colour of the pixel. `seen` gives what the ray through a corner sees; corners are numbered from the pixel's
    /// top left one.
    pub fn color<P: Probe>(&self, probe: &mut P, mut seen: impl FnMut([u32; 2], &mut P) -> Seen) -> Color {
        let mut sum = Sum::ZERO;
        let mut open: ArrayVec<Cell, MOST_OPEN> = ArrayVec::new();
        open.push(Cell { left: 0, top: 0, side: 1 << self.depth });
        while let Some(cell) = open.pop() {
            let Cell { left, top, side } = cell;
            let corners = [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[x, y]| seen([left + x * side, top + y * side], probe));
            if self.cuts(cell, &corners, probe) {
                let half = side / 2;
                // The last is looked at first: from the top left to the bottom right.
                let quarters = [[1, 1], [0, 1], [1, 0], [0, 0]];
                open.extend(quarters.map(|[x, y]| Cell { left: left + x * half, top: top + y * half, side: half }));
            } else {
                // A power of two, by which nothing is rounded.
                let weight = self.in_pixels(side) * self.in_pixels(side);
                corners.iter().for_each(|corner| sum.add(corner.color * weight));
            }
        }
        probe.note(Name::PixelMeanOfCells, sum.over(4.0))
    }

    fn in_pixels(&self, steps: u32) -> f64 {
        f64::from(steps) / f64::from(1_u32 << self.depth)
    }

    /// Decides whether a cell is cut, and says why.
    fn cuts<P: Probe>(&self, cell: Cell, corners: &[Seen; 4], probe: &mut P) -> bool {
        let place = [cell.left, cell.top, cell.side].map(|steps| self.in_pixels(steps));
        let mut why_cut = None;
        if self.differ(corners, probe) {
            why_cut = Some((Split::Color, None));
        } else if corners.iter().any(|corner| corner.object != corners[0].object) {
            why_cut = Some((Split::Objects, None));
        } else if let Some(object) = self.missed(place, corners) {
            why_cut = Some((Split::SmallObject, Some(object)));
        }
        match why_cut {
            Some((why, object)) if cell.side > 1 => {
                probe.mark(Decision::Subdivided { cell: place, why, object });
                true
            }
            found => {
                let why = if found.is_some() { Acceptance::Depth } else { Acceptance::Alike };
                probe.given(Name::CellArea, place[2] * place[2]);
                probe.mark(Decision::Accepted { cell: Some(place), why });
                false
            }
        }
    }

    /// Whether the corners' colours differ by more than the threshold in any channel.
    fn differ<P: Probe>(&self, corners: &[Seen; 4], probe: &mut P) -> bool {
        let [a, b, c, d] = corners.map(|corner| corner.color);
        let names = [Name::CellColor1, Name::CellColor2, Name::CellColor3, Name::CellColor4];
        names.into_iter().zip([a, b, c, d]).for_each(|(name, color)| probe.given(name, color));
        let range = a.max(b).max(c.max(d)) - a.min(b).min(c.min(d));
        let difference = probe.note(Name::CellDifference, range.max_element());
        probe.given(Name::CellThreshold, self.threshold);
        probe.given(Name::OutputWhite, self.scene.output.white);
        let limit = probe.note(Name::CellLimit, self.threshold * self.scene.output.white);
        difference > limit
    }

    /// A small object that reaches into the cell and that none of its corners sees.
    fn missed(&self, [left, top, side]: [f64; 3], corners: &[Seen; 4]) -> Option<u32> {
        let [column, row] = self.pixel.map(f64::from);
        let rectangle = [column + left, row + top, column + left + side, row + top + side];
        let is_seen = |small: &SmallObject| corners.iter().any(|corner| corner.object == Some(small.object));
        let is_missed =
            |small: &&&SmallObject| small.may_be_missed(side) && !is_seen(small) && small.reaches_into(rectangle);
        self.small.iter().find(is_missed).map(|small| small.object)
    }
}
