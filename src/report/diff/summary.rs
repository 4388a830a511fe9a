//! How much two logs differ, over all their pixels.

use super::{Comparison, Entry, Side, Statement};

/// A pixel by column and row; `None` where there is one only, or a ray.
pub type Pixel = Option<[u32; 2]>;

/// Counts over all pixels, and the largest difference.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Summary {
    /// How many pixels (or rays) both logs have.
    pub pixels: usize,
    /// How many of them differ in something.
    pub differing_pixels: usize,
    /// Pixels that only A has.
    pub pixels_only_in_a: usize,
    /// Pixels that only B has.
    pub pixels_only_in_b: usize,
    /// How many values both logs have, inputs among them.
    pub values: usize,
    /// How many of them differ by more than is tolerated.
    pub differing_values: usize,
    /// How many decisions differ.
    pub decisions: usize,
    /// How many steps only A has; a node counts as one, with all that it holds.
    pub only_in_a: usize,
    /// How many steps only B has.
    pub only_in_b: usize,
    /// The value with the largest absolute difference.
    pub largest: Option<(Pixel, Entry)>,
    /// The value with the largest relative difference.
    pub largest_relative: Option<(Pixel, Entry)>,
}

impl Summary {
    /// Whether nothing differs.
    pub fn is_same(&self) -> bool {
        let differing = self.differing_pixels + self.pixels_only_in_a + self.pixels_only_in_b;
        differing == 0
    }

    /// Adds what was found in a pixel.
    pub fn add(&mut self, pixel: Pixel, found: &Comparison) {
        self.pixels += 1;
        self.differing_pixels += usize::from(!found.differences.is_empty());
        self.values += found.values;
        for difference in &found.differences {
            match &difference.entry.what {
                Statement::Value { .. } => {
                    self.differing_values += 1;
                    keep_larger(&mut self.largest, pixel, &difference.entry, |distance| distance.absolute);
                    keep_larger(&mut self.largest_relative, pixel, &difference.entry, |distance| distance.relative);
                }
                Statement::Decision { .. } => self.decisions += 1,
                Statement::Only { side: Side::A, .. } => self.only_in_a += 1,
                Statement::Only { side: Side::B, .. } => self.only_in_b += 1,
            }
        }
    }

    /// Adds a pixel that only one log has.
    pub fn add_alone(&mut self, side: Side) {
        match side {
            Side::A => self.pixels_only_in_a += 1,
            Side::B => self.pixels_only_in_b += 1,
        }
    }
}

/// Of equal ones the first is kept, and what is no number counts as the largest.
fn keep_larger(kept: &mut Option<(Pixel, Entry)>, pixel: Pixel, entry: &Entry, size: fn(&super::Distance) -> f64) {
    let of = |entry: &Entry| match &entry.what {
        Statement::Value { distance, .. } => size(distance),
        _ => 0.0,
    };
    if kept.as_ref().is_none_or(|(_, before)| of(entry).total_cmp(&of(before)).is_gt()) {
        *kept = Some((pixel, entry.clone()));
    }
}
