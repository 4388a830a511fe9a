//! Samples that pixels share (Ramos, section 1.4.2, figure 21): rays through the corners of n × n cells of each pixel.
//!
//! A corner is numbered by its column and row in the grid of the whole picture, n steps per pixel. A picture traces each
//! corner once (`render`); a single pixel traces its own, and gets the same bits, because both add in the same order and the
//! corner's random numbers belong to its place. What else a corner decides is spread over the corners of a pixel.

use super::mean::{self, Sum};
use super::place::ray_through;
use crate::log::{Name, Step};
use crate::probe::Probe;
use crate::random::Draws;
use crate::scene::{Color, Scene};
use crate::trace::Seen;

/// The corners of a picture.
#[derive(Clone, Copy, Debug)]
pub enum Corners {
    /// All of a grid of this many steps per pixel.
    All {
        /// Steps a pixel.
        n: u32,
    },
    /// Those that are needed of a grid that halves a pixel so often, the coarse ones first.
    Nested {
        /// Halvings.
        depth: u32,
    },
}

impl Corners {
    /// Steps a pixel.
    pub fn steps(self) -> u32 {
        match self {
            Corners::All { n } => n,
            Corners::Nested { depth } => 1 << depth,
        }
    }

    /// What the ray through a corner sees.
    pub fn seen<P: Probe>(self, scene: &Scene, corner: [u32; 2], probe: &mut P) -> Seen {
        let place = corner.map(|step| f64::from(step) / f64::from(self.steps()));
        let draws = match self {
            Corners::All { n } => Draws::of_corner(scene.seed, corner, n),
            Corners::Nested { depth } => Draws::of_nested_corner(scene.seed, corner, depth),
        };
        ray_through(scene, place, &draws, probe)
    }

    /// The same as a node of its own, a sample of a pixel; the corner is numbered from the pixel's, the sample from 1.
    pub fn sample<P: Probe>(
        self,
        scene: &Scene,
        pixel: [u32; 2],
        within: [u32; 2],
        number: u32,
        probe: &mut P,
    ) -> Seen {
        let [x, y] = within.map(|step| f64::from(step) / f64::from(self.steps()));
        probe.given(Name::SampleX, x);
        probe.given(Name::SampleY, y);
        if let Corners::All { n } = self {
            // How many cells of the pixel have the corner.
            let cells = within.map(|step| if step == 0 || step == n { 1.0 } else { 2.0 });
            probe.given(Name::SampleWeight, cells[0] * cells[1]);
        }
        let corner = [0, 1].map(|axis| pixel[axis] * self.steps() + within[axis]);
        probe.within(Step::Sample { number }, |probe| self.seen(scene, corner, probe))
    }
}

/// The colour of a pixel: the mean over its cells of the mean of their corners. Its samples are the corners, row by row.
pub fn pixel<P: Probe>(scene: &Scene, n: u32, pixel: [u32; 2], probe: &mut P) -> Color {
    let mut number = 0;
    let mut corner_row = |down: u32, probe: &mut P| -> Vec<Color> {
        let sample = |across: u32| {
            number += 1;
            Corners::All { n }.sample(scene, pixel, [across, down], number, probe).color
        };
        (0..=n).map(sample).collect()
    };
    let mut upper = corner_row(0, probe);
    let mut sum = Sum::ZERO;
    for down in 1..=n {
        let lower = corner_row(down, probe);
        add_cells(&mut sum, &upper, &lower);
        upper = lower;
    }
    mean(sum, n, probe)
}

/// Adds a row of cells, each the sum of its corners; the slices are the corners above and below them.
pub fn add_cells(sum: &mut Sum, upper: &[Color], lower: &[Color]) {
    for (above, below) in upper.windows(2).zip(lower.windows(2)) {
        for corner in [above[0], above[1], below[0], below[1]] {
            sum.add(corner);
        }
    }
}

/// The pixel's colour from the sum of its n × n cells.
pub fn mean<P: Probe>(sum_of_cells: Sum, n: u32, probe: &mut P) -> Color {
    let n = f64::from(n);
    mean::of_pixel(Name::PixelMeanOfCorners, sum_of_cells, 4.0 * n * n, probe)
}
