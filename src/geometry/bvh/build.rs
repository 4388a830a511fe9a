//! Building a bounding volume hierarchy.

use super::{Bvh, Node, STACK};
use crate::geometry::bounds::Bounds;
use std::ops::Range;

/// The most things in a leaf.
const LEAF: usize = 4;
/// In how many slices the surface area heuristic cuts a node (Wald, 2007).
const BINS: usize = 16;

/// A thing with its box.
#[derive(Clone, Copy)]
struct Boxed {
    thing: u32,
    bounds: Bounds,
}

/// A tree that grows over a list of things, which it puts in order.
struct Builder {
    nodes: Vec<Node>,
    things: Vec<Boxed>,
    /// How many places of the order come before the tree's.
    before: usize,
}

impl Bvh {
    /// The tree over things with boxes, and things without one.
    pub fn new(unbounded: Vec<u32>, bounded: impl IntoIterator<Item = (u32, Bounds)>) -> Bvh {
        let boxed = |(thing, bounds): (u32, Bounds)| Boxed { thing, bounds: bounds.widened() };
        let things: Vec<_> = bounded.into_iter().map(boxed).collect();
        let mut builder = Builder { nodes: Vec::new(), before: unbounded.len(), things };
        if !builder.things.is_empty() {
            builder.build(0..builder.things.len(), 0);
        }
        let mut bvh = Bvh { nodes: builder.nodes, unbounded: unbounded.len() as u32, order: unbounded };
        bvh.order.extend(builder.things.iter().map(|boxed| boxed.thing));
        bvh
    }
}

impl Builder {
    /// Builds the node over a range of the order.
    fn build(&mut self, range: Range<usize>, level: usize) {
        let around = self.things[range.clone()].iter().fold(Bounds::EMPTY, |around, boxed| around.union(boxed.bounds));
        let at = self.nodes.len();
        self.nodes.push(Node { bounds: around, start: (self.before + range.start) as u32, count: range.len() as u32 });
        if range.len() <= LEAF {
            return;
        }
        // Near the end of the stack only halving is sure to end in time.
        let cut = if level < STACK / 2 { self.best_cut(&range) } else { None };
        let middle = match cut {
            Some(middle) => middle,
            None => self.halve(&range),
        };
        self.build(range.start..middle, level + 1);
        self.nodes[at] = Node { bounds: around, start: self.nodes.len() as u32, count: 0 };
        self.build(middle..range.end, level + 1);
    }

    /// Cuts the range where the surface area heuristic says so; `None` if all centres coincide in every axis or all
    /// would land on one side.
    fn best_cut(&mut self, range: &Range<usize>) -> Option<usize> {
        let things = &mut self.things[range.clone()];
        let centers = Bounds::around(things.iter().map(|boxed| boxed.bounds.center()));
        let mut best: Option<(f64, usize, usize)> = None;
        for axis in 0..3 {
            let (low, width) = (centers.min[axis], centers.max[axis] - centers.min[axis]);
            if width <= 0.0 {
                continue;
            }
            let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
            for Boxed { bounds, .. } in &*things {
                let bin = &mut bins[bin_of(bounds.center()[axis], low, width)];
                *bin = (bin.0.union(*bounds), bin.1 + 1);
            }
            for (cut, cost) in cut_costs(&bins) {
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, axis, cut));
                }
            }
        }
        let (_, axis, cut) = best?;
        let (low, width) = (centers.min[axis], centers.max[axis] - centers.min[axis]);
        let is_left = |boxed: &Boxed| bin_of(boxed.bounds.center()[axis], low, width) < cut;
        // Stable, so that the tree doesn't depend on how it was sorted.
        things.sort_by_key(|boxed| !is_left(boxed));
        let left = things.iter().filter(|boxed| is_left(boxed)).count();
        (0 < left && left < range.len()).then_some(range.start + left)
    }

    /// Cuts the range into halves along the longest side of its centres.
    fn halve(&mut self, range: &Range<usize>) -> usize {
        let center = |boxed: &Boxed| boxed.bounds.center();
        let things = &mut self.things[range.clone()];
        let centers = Bounds::around(things.iter().map(center));
        let side = centers.max - centers.min;
        let axis = (0..3).fold(0, |longest, axis| if side[axis] > side[longest] { axis } else { longest });
        things.sort_by(|a, b| center(a)[axis].total_cmp(&center(b)[axis]).then(a.thing.cmp(&b.thing)));
        range.start + range.len() / 2
    }
}

fn bin_of(center: f64, low: f64, width: f64) -> usize {
    (((center - low) / width * BINS as f64) as usize).min(BINS - 1)
}

/// The cost of each cut between two bins: area times number, left and right.
fn cut_costs(bins: &[(Bounds, usize); BINS]) -> impl Iterator<Item = (usize, f64)> {
    let mut right_costs = [0.0; BINS];
    let (mut around, mut count) = (Bounds::EMPTY, 0);
    for cut in (1..BINS).rev() {
        around = around.union(bins[cut].0);
        count += bins[cut].1;
        right_costs[cut] = if count == 0 { f64::INFINITY } else { around.half_area() * count as f64 };
    }
    let bins = *bins;
    let (mut around, mut count) = (Bounds::EMPTY, 0);
    (1..BINS).map(move |cut| {
        around = around.union(bins[cut - 1].0);
        count += bins[cut - 1].1;
        let left = if count == 0 { f64::INFINITY } else { around.half_area() * count as f64 };
        (cut, left + right_costs[cut])
    })
}
