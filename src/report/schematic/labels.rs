//! Where the texts of the schematic are: each where it covers no other, the first of some places that is free.

use super::{Label, Point, Ray, clip};
use crate::files::escape::{shortened, width};
use crate::report::ray_tree::short;
use std::collections::HashSet;

/// The size of a text: a character's width, and half a line's height.
const CHARACTER: f64 = 6.8;
const HALF_LINE: f64 = 7.5;

/// The longest name, in characters.
const LONGEST: usize = 24;

pub(super) struct Labels<'p> {
    size: [f64; 2],
    rays: &'p [Ray],
    placed: Vec<(Label, [f64; 2])>,
    /// Where rays with letters begin, with the letters.
    lettered: HashSet<([u64; 2], String)>,
}

impl<'p> Labels<'p> {
    pub(super) fn new(size: [f64; 2], rays: &'p [Ray]) -> Labels<'p> {
        Labels { size, rays, placed: Vec::new(), lettered: HashSet::new() }
    }

    pub(super) fn placed(self) -> Vec<Label> {
        self.placed.into_iter().map(|(label, _)| label).collect()
    }

    /// A name beside a point: where it lies on the fewest rays.
    pub(super) fn name(&mut self, point: Point, name: &str) {
        let text = shortened(name, LONGEST);
        let half = half_size(&text);
        let mut best: Option<(usize, Point)> = None;
        for reach in [1.0, 2.2, 3.6] {
            let (across, along) = (half[0] + 7.0 * reach, 6.0 + 6.0 * reach);
            for [x, y] in [[0.0, -1.0], [1.0, -0.4], [-1.0, -0.4], [0.0, 1.0], [1.0, 0.6], [-1.0, 0.6]] {
                let at =
                    [point[0] + x * across, point[1] + y * along + if y == 0.0 { 0.0 } else { y * HALF_LINE / 2.0 }];
                if !self.is_free(at, half) {
                    continue;
                }
                let crossed = self.rays.iter().filter(|ray| crosses(ray, at, half)).count();
                if best.is_none_or(|(fewest, _)| crossed < fewest) {
                    best = Some((crossed, at));
                }
            }
        }
        if let Some((_, at)) = best {
            self.placed.push((Label { at, text, ray: None }, half));
        }
    }

    /// The letter of a ray on its line, where rays of one point have parted.
    pub(super) fn letter(&mut self, ray: &Ray) {
        let text = match ray.kind {
            _ if ray.is_blocked => format!("{}×", short(ray.kind)),
            kind => short(kind),
        };
        // Of many rays from one point to points of one light, one has a letter.
        let beginning = (ray.from.map(f64::to_bits), text.clone());
        if self.lettered.contains(&beginning) {
            return;
        }
        let half = half_size(&text);
        let Some([from, to]) = clip([ray.from, ray.to], [0.0, self.size[0]], [0.0, self.size[1]]) else { return };
        let along = |part: f64| [0, 1].map(|axis| from[axis] + (to[axis] - from[axis]) * part);
        let free = [0.55, 0.65, 0.45, 0.75, 0.35, 0.85, 0.25].into_iter().map(along);
        if let Some(at) = free.into_iter().find(|at| self.is_free(*at, half)) {
            self.placed.push((Label { at, text, ray: Some((ray.kind, ray.is_blocked)) }, half));
            self.lettered.insert(beginning);
        }
    }

    fn is_free(&self, at: Point, half: [f64; 2]) -> bool {
        let is_inside = (0..2).all(|axis| at[axis] - half[axis] >= 0.0 && at[axis] + half[axis] <= self.size[axis]);
        let overlaps = |(label, other): &(Label, [f64; 2])| {
            (0..2).all(|axis| (label.at[axis] - at[axis]).abs() < half[axis] + other[axis] + 1.0)
        };
        is_inside && !self.placed.iter().any(overlaps)
    }
}

fn half_size(text: &str) -> [f64; 2] {
    [width(text) as f64 * CHARACTER / 2.0 + 2.0, HALF_LINE]
}

/// Whether a ray runs through a box: looked for at points that lie closer than the box is high.
fn crosses(ray: &Ray, at: Point, half: [f64; 2]) -> bool {
    let length = (0..2).map(|axis| (ray.to[axis] - ray.from[axis]).abs()).fold(0.0, f64::max);
    let steps = (length / HALF_LINE).ceil().clamp(1.0, 400.0) as u32;
    (0..=steps).any(|step| {
        let part = f64::from(step) / f64::from(steps);
        (0..2).all(|axis| (ray.from[axis] + (ray.to[axis] - ray.from[axis]) * part - at[axis]).abs() < half[axis])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::log::RayKind;

    #[test]
    fn no_two_texts_lie_on_each_other() {
        let ray = |light: u32| {
            let to = [150.0, 50.0 + f64::from(light)];
            Ray { kind: RayKind::Shadow { light }, is_blocked: false, from: [50.0, 50.0], to }
        };
        let rays: Vec<_> = (0..20).map(ray).collect();
        let mut labels = Labels::new([200.0, 120.0], &rays);
        labels.name([50.0, 50.0], "eye");
        labels.name([50.0, 50.0], "another");
        rays.iter().for_each(|ray| labels.letter(ray));
        let placed = labels.placed();
        // The rays lie so close that some letters have no room.
        assert!((4..22).contains(&placed.len()), "{placed:?}");
        for (number, one) in placed.iter().enumerate() {
            for other in &placed[..number] {
                let (half, others) = (half_size(&one.text), half_size(&other.text));
                let apart = (0..2).any(|axis| (one.at[axis] - other.at[axis]).abs() >= half[axis] + others[axis]);
                assert!(apart, "{one:?} lies on {other:?}");
            }
        }
    }
}
