//! The walk through the tree along a ray.

use super::block::{Block, LeafRay, Sorted};
use super::lanes::Lanes;
use super::node::{BoxRay, Child, Content, Node};
use super::{Bvh, Search};
use crate::geometry::line::RaySource;
use arrayvec::ArrayVec;

/// The most nodes that wait: seven for each level of the deepest tree, and one.
pub(super) const STACK: usize = 7 * super::build::MOST_LEVELS + 1;

/// A walk, and what it is for.
pub(super) struct Walk<'a, S, M> {
    pub tree: &'a Bvh,
    pub source: &'a S,
    pub search: Search,
    /// Shows a primitive, and says whether the ray certainly crosses it; gives the distance up to which primitives still matter, a negative one to end the walk.
    pub meet: M,
}

/// A child that waits, and where the ray enters its box.
type Waiting = (f32, Child);

impl<S: RaySource, M: FnMut(u32, bool) -> f64> Walk<'_, S, M> {
    /// Walks from this child on, up to a distance. Returns how many boxes were tested.
    #[inline(always)]
    pub fn run<L: Lanes>(mut self, lanes: L, root: Child, t_max: f64) -> u64 {
        let tree = self.tree;
        // Each on its own: a ray that came through both would be copied.
        let Some(line) = self.source.line() else { return self.show_all() };
        let Some(ray) = tree.space.ray(&line) else { return self.show_all() };
        let box_ray = BoxRay::new(lanes, &ray);
        let leaf_ray = LeafRay::new(lanes, &ray);
        let distance = ray.distance;
        let (tells_sure_hits, slack, reach) = (self.search.tells_sure_hits, self.source.slack(), t_max);
        let sure = || if tells_sure_hits { distance.surely_within(ray.begin, reach, slack) } else { None };
        let mut t_max = distance.latest(t_max);
        let mut waiting: ArrayVec<Waiting, STACK> = ArrayVec::new();
        let mut nodes_tested = 0;
        let mut child = root;
        loop {
            let leaf = match child.content() {
                Content::Node(number) => {
                    nodes_tested += 1;
                    let node = &tree.nodes[number as usize];
                    let entered = node.entered(lanes, &box_ray, lanes.splat(t_max));
                    if entered.bits != 0 {
                        child = if self.search.nearest_first {
                            nearest_first(node, entered.bits, lanes.store(entered.near), &mut waiting)
                        } else {
                            in_any_order(node, entered.bits, &mut waiting)
                        };
                        continue;
                    }
                    Leaf::NONE
                }
                Content::Triangles(number) => {
                    let block = &tree.triangles[number as usize];
                    Leaf { sorted: self.culled(lanes, block, &leaf_ray, t_max, &sure), primitives: block.primitives() }
                }
                Content::Spheres(number) => {
                    let block = &tree.spheres[number as usize];
                    Leaf { sorted: self.culled(lanes, block, &leaf_ray, t_max, &sure), primitives: block.primitives() }
                }
                Content::Primitive(primitive) => Leaf { sorted: Sorted::possible(1), primitives: [primitive; 8] },
            };
            let Sorted { mut possible, mut sure } = leaf.sorted;
            while possible != 0 {
                // A sure one may end the search.
                let is_sure = sure != 0;
                let lane = if is_sure { sure } else { possible }.trailing_zeros() as usize;
                (possible, sure) = (possible & !(1 << lane), sure & !(1 << lane));
                let limit = (self.meet)(leaf.primitives[lane & 7], is_sure);
                if limit < 0.0 {
                    return 8 * nodes_tested;
                }
                t_max = distance.latest(limit);
            }
            child = match next(&mut waiting, t_max) {
                Some(child) => child,
                None => return 8 * nodes_tested,
            };
        }
    }

    /// Shows everything in the tree; no box is tested.
    #[cold]
    #[inline(never)]
    fn show_all(mut self) -> u64 {
        for primitive in self.tree.primitives() {
            if (self.meet)(primitive, false) < 0.0 {
                break;
            }
        }
        0
    }

    #[inline(always)]
    fn culled<L: Lanes>(
        &self,
        lanes: L,
        block: &impl Block,
        ray: &LeafRay<L>,
        t_max: f32,
        sure: &impl Fn() -> Option<[f32; 2]>,
    ) -> Sorted {
        if self.search.one_by_one {
            block.filtered(lanes, ray, lanes.splat(t_max), sure)
        } else {
            Sorted::possible(block.used())
        }
    }
}

/// The primitives of a leaf that the ray may hit.
struct Leaf {
    sorted: Sorted,
    primitives: [u32; 8],
}

impl Leaf {
    const NONE: Leaf = Leaf { sorted: Sorted::possible(0), primitives: [0; 8] };
}

/// The next child that the ray enters in time.
#[inline(always)]
fn next(waiting: &mut ArrayVec<Waiting, STACK>, t_max: f32) -> Option<Child> {
    loop {
        let (near, child) = waiting.pop()?;
        if near <= t_max {
            return Some(child);
        }
    }
}

/// Takes the first of the children that the ray enters; the others wait, the nearest on top.
#[inline(always)]
fn nearest_first(node: &Node, bits: u32, near: [f32; 8], waiting: &mut ArrayVec<Waiting, STACK>) -> Child {
    let mut bits = bits;
    let mut take = || {
        let lane = bits.trailing_zeros() as usize;
        bits &= bits - 1;
        ((near[lane & 7], node.child(lane)), bits)
    };
    let (mut nearest, rest) = take();
    if rest == 0 {
        return nearest.1;
    }
    let (mut second, rest) = take();
    if second.0 < nearest.0 {
        (nearest, second) = (second, nearest);
    }
    if rest == 0 {
        waiting.push(second);
        return nearest.1;
    }
    let bottom = waiting.len();
    waiting.push(second);
    loop {
        let (mut other, rest) = take();
        if other.0 < nearest.0 {
            (nearest, other) = (other, nearest);
        }
        // Into its place among those that wait, the nearest last.
        let mut at = waiting.len();
        waiting.push(other);
        while at > bottom && waiting[at - 1].0 < other.0 {
            waiting[at] = waiting[at - 1];
            at -= 1;
        }
        waiting[at] = other;
        if rest == 0 {
            return nearest.1;
        }
    }
}

/// Takes the first of the children that the ray enters; the others wait.
#[inline(always)]
fn in_any_order(node: &Node, bits: u32, waiting: &mut ArrayVec<Waiting, STACK>) -> Child {
    let mut bits = bits;
    while bits & (bits - 1) != 0 {
        let lane = 31 - bits.leading_zeros();
        bits ^= 1 << lane;
        waiting.push((f32::NEG_INFINITY, node.child(lane as usize)));
    }
    node.child(bits.trailing_zeros() as usize)
}
