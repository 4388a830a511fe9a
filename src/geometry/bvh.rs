//! A bounding volume hierarchy: which of many things a ray can meet at all.
//!
//! It only narrows down; what passes goes to the kernel, whose decision stands. Boxes are widened and their test errs on
//! the side of meeting, so that the answer is that of testing everything.

use super::bounds::{Bounds, Slabs};
use super::ray::Ray;
use std::ops::Range;

/// A tree of boxes over things that are numbered from 0.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// The things, so ordered that each leaf has a range of them.
    order: Vec<u32>,
}

/// A box with what it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Node {
    bounds: Bounds,
    /// A leaf's first place in the order, or a branch's second child; the first child is the next node.
    start: u32,
    /// How many things a leaf has; 0 marks a branch.
    count: u32,
}

/// The most things in a leaf.
const LEAF: usize = 4;
/// In how many slices the surface area heuristic cuts a node (Wald, 2007).
const BINS: usize = 16;
/// Deeper than any tree over 2³² things that halves at least every other level.
const STACK: usize = 128;

impl Bvh {
    /// The tree over things with these boxes.
    pub fn new(bounds: &[Bounds]) -> Bvh {
        let widened: Vec<_> = bounds.iter().map(|bounds| bounds.widened()).collect();
        let mut bvh = Bvh { nodes: Vec::new(), order: (0..bounds.len() as u32).collect() };
        if !bounds.is_empty() {
            bvh.build(&widened, 0..bounds.len(), 0);
        }
        bvh
    }

    /// A box around everything.
    pub fn bounds(&self) -> Option<Bounds> {
        self.nodes.first().map(|root| root.bounds)
    }

    /// Shows `meet` every thing that the ray can meet before `t_max`, roughly from near to far. `meet` gives the new
    /// `t_max`; a negative one ends the search. Returns how many boxes were tested.
    #[inline]
    pub fn visit(&self, ray: &Ray, mut t_max: f64, mut meet: impl FnMut(u32) -> f64) -> u64 {
        let slabs = Slabs::new(ray);
        let mut tested = 1;
        let entry = |node: u32, t_max: f64| self.nodes[node as usize].bounds.entry(&slabs, t_max);
        let Some(root) = (!self.nodes.is_empty()).then(|| entry(0, t_max)).flatten() else { return tested };
        let mut stack = [(0.0, 0_u32); STACK];
        let mut depth = 1;
        stack[0] = (root, 0);
        while depth > 0 {
            depth -= 1;
            let (near, mut at) = stack[depth];
            // Equal distances are visited: the first of the scene must win ties.
            if near > t_max {
                continue;
            }
            loop {
                let node = &self.nodes[at as usize];
                if node.count > 0 {
                    for place in node.start..node.start + node.count {
                        t_max = meet(self.order[place as usize]);
                        if t_max < 0.0 {
                            return tested;
                        }
                    }
                    break;
                }
                tested += 2;
                let (first, second) = (at + 1, node.start);
                at = match (entry(first, t_max), entry(second, t_max)) {
                    (None, None) => break,
                    (Some(_), None) => first,
                    (None, Some(_)) => second,
                    (Some(near), Some(far)) => {
                        let (closer, farther) =
                            if near <= far { (first, (far, second)) } else { (second, (near, first)) };
                        stack[depth] = farther;
                        depth += 1;
                        closer
                    }
                };
            }
        }
        tested
    }

    /// Builds the node over a range of the order.
    fn build(&mut self, bounds: &[Bounds], range: Range<usize>, level: usize) {
        let of = |thing: &u32| bounds[*thing as usize];
        let things = &self.order[range.clone()];
        let around = things.iter().map(of).fold(Bounds::EMPTY, Bounds::union);
        let at = self.nodes.len();
        self.nodes.push(Node { bounds: around, start: range.start as u32, count: range.len() as u32 });
        if range.len() <= LEAF {
            return;
        }
        // Near the end of the stack only halving is sure to end in time.
        let cut = if level < STACK / 2 { self.best_cut(bounds, &range) } else { None };
        let middle = match cut {
            Some(middle) => middle,
            None => self.halve(bounds, &range),
        };
        self.build(bounds, range.start..middle, level + 1);
        self.nodes[at] = Node { bounds: around, start: self.nodes.len() as u32, count: 0 };
        self.build(bounds, middle..range.end, level + 1);
    }

    /// Cuts the range where the surface area heuristic says so; `None` if all centres coincide in every axis or all
    /// would land on one side.
    fn best_cut(&mut self, bounds: &[Bounds], range: &Range<usize>) -> Option<usize> {
        let things = &self.order[range.clone()];
        let centers = Bounds::around(things.iter().map(|thing| bounds[*thing as usize].center()));
        let mut best: Option<(f64, usize, usize)> = None;
        for axis in 0..3 {
            let (low, width) = (centers.min[axis], centers.max[axis] - centers.min[axis]);
            if width <= 0.0 {
                continue;
            }
            let mut bins = [(Bounds::EMPTY, 0_usize); BINS];
            for thing in things {
                let bounds = bounds[*thing as usize];
                let bin = &mut bins[bin_of(bounds.center()[axis], low, width)];
                *bin = (bin.0.union(bounds), bin.1 + 1);
            }
            for (cut, cost) in cut_costs(&bins) {
                if best.is_none_or(|(least, ..)| cost < least) {
                    best = Some((cost, axis, cut));
                }
            }
        }
        let (_, axis, cut) = best?;
        let (low, width) = (centers.min[axis], centers.max[axis] - centers.min[axis]);
        let is_left = |thing: &u32| bin_of(bounds[*thing as usize].center()[axis], low, width) < cut;
        // Stable, so that the tree doesn't depend on how it was sorted.
        self.order[range.clone()].sort_by_key(|thing| !is_left(thing));
        let left = self.order[range.clone()].iter().filter(|thing| is_left(thing)).count();
        (0 < left && left < range.len()).then_some(range.start + left)
    }

    /// Cuts the range into halves along the longest side of its centres.
    fn halve(&mut self, bounds: &[Bounds], range: &Range<usize>) -> usize {
        let center = |thing: &u32| bounds[*thing as usize].center();
        let centers = Bounds::around(self.order[range.clone()].iter().map(center));
        let side = centers.max - centers.min;
        let axis = (0..3).fold(0, |longest, axis| if side[axis] > side[longest] { axis } else { longest });
        self.order[range.clone()].sort_by(|a, b| center(a)[axis].total_cmp(&center(b)[axis]).then(a.cmp(b)));
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
