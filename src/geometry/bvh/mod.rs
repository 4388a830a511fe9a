//! A bounding volume hierarchy: which of many things a ray can meet at all.
//!
//! It only narrows down; what passes goes to the kernel, whose decision stands. Boxes are widened and their test errs on
//! the side of meeting, so that the answer is that of testing everything.

mod build;

use super::bounds::{Bounds, Slabs};
use super::ray::Ray;
use arrayvec::ArrayVec;
use std::ops::Range;

/// A tree of boxes over numbered things, and a list of those that have none.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bvh {
    nodes: Vec<Node>,
    /// The things: first those without a box, then so ordered that each leaf has a range of them.
    order: Vec<u32>,
    /// How many things have no box.
    unbounded: u32,
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

/// Deeper than any tree over 2³² things that halves at least every other level.
const STACK: usize = 128;

/// A walk down the tree along a ray.
struct Descent<'b> {
    nodes: &'b [Node],
    /// The ray, once the walk has begun.
    ray: Option<Slabs>,
    /// Nodes that wait, each with the distance where the ray enters its box.
    waiting: ArrayVec<(f64, u32), STACK>,
    tested: u64,
}

impl Bvh {
    /// A box around everything that has one.
    pub fn bounds(&self) -> Option<Bounds> {
        self.nodes.first().map(|root| root.bounds)
    }

    /// Shows `meet` every thing that the ray can meet before its end: first those without a box, then the others roughly
    /// from near to far. `meet` gives the distance up to which things still matter; a negative one ends the search. Returns
    /// how many boxes were tested.
    #[inline]
    pub fn visit(&self, ray: &Ray, mut meet: impl FnMut(u32) -> f64) -> u64 {
        let mut t_max = ray.t_max;
        let mut places = 0..self.unbounded as usize;
        let mut descent = Descent { nodes: &self.nodes, ray: None, waiting: ArrayVec::new(), tested: 0 };
        // One loop for both, so that `meet` is called at one place and can be inlined there.
        loop {
            for thing in &self.order[places] {
                t_max = meet(*thing);
                if t_max < 0.0 {
                    return descent.tested;
                }
            }
            if self.nodes.is_empty() {
                return 0;
            }
            let slabs = match descent.ray {
                Some(slabs) => slabs,
                None => descent.begin(ray, t_max),
            };
            match descent.next_leaf(&slabs, t_max) {
                Some(leaf) => places = leaf,
                None => return descent.tested,
            }
        }
    }
}

impl Descent<'_> {
    /// Looks at the root of a tree that has one.
    // Outlined, so that a scene without a tree doesn't prepare the ray for it.
    #[inline(never)]
    fn begin(&mut self, ray: &Ray, t_max: f64) -> Slabs {
        let slabs = Slabs::new(ray);
        self.waiting.extend(self.entry(&slabs, 0, t_max).map(|near| (near, 0)));
        self.tested += 1;
        self.ray = Some(slabs);
        slabs
    }

    #[inline]
    fn entry(&self, ray: &Slabs, node: u32, t_max: f64) -> Option<f64> {
        self.nodes[node as usize].bounds.entry(ray, t_max)
    }

    /// The places of the next leaf that the ray enters before `t_max`.
    #[inline]
    fn next_leaf(&mut self, ray: &Slabs, t_max: f64) -> Option<Range<usize>> {
        loop {
            let (near, mut at) = self.waiting.pop()?;
            // Equal distances are visited: the first of the scene must win ties.
            if near > t_max {
                continue;
            }
            loop {
                let node = &self.nodes[at as usize];
                if node.count > 0 {
                    return Some(node.start as usize..(node.start + node.count) as usize);
                }
                self.tested += 2;
                let (first, second) = (at + 1, node.start);
                at = match (self.entry(ray, first, t_max), self.entry(ray, second, t_max)) {
                    (None, None) => break,
                    (Some(_), None) => first,
                    (None, Some(_)) => second,
                    (Some(near), Some(far)) => {
                        let (closer, farther) =
                            if near <= far { (first, (far, second)) } else { (second, (near, first)) };
                        self.waiting.push(farther);
                        closer
                    }
                };
            }
        }
    }
}
