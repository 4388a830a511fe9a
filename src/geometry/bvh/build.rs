//! Building the tree: from the top, by the surface area heuristic, each node cut into up to eight parts (Wald, 2007). Parts are built in
//! parallel; the tree is the same on any number of threads.

use super::block::{Block, Kind, SphereBlock, TriangleBlock};
use super::lanes::Instructions;
use super::node::{Box32, Child, Content, Node};
use super::outliers::{self, Sorted};
use super::space::Space;
use super::split::{Part, Rough};
use super::{Bvh, Form};
use crate::threads::share;
use arrayvec::ArrayVec;
use rayon::prelude::*;

/// The most levels of nodes. The last of them halve what they have, so that 2³⁰ primitives fit.
pub(super) const MOST_LEVELS: usize = 40;

/// From this level on nodes halve.
const HALVING: usize = 28;

/// Parts of fewer primitives are built on one core.
const MIN_PARALLEL_PRIMITIVES: usize = 1 << 14;

/// How many primitives are made ready at a time.
const CHUNK: usize = 1 << 12;

/// The primitives of a block, as a range of all.
#[derive(Clone, Copy, Debug)]
struct Leaf {
    start: u32,
    count: u32,
}

/// A tree that grows, or a part of it.
#[derive(Default)]
struct Growth {
    nodes: Vec<Node>,
    triangles: Vec<Leaf>,
    spheres: Vec<Leaf>,
}

impl Bvh {
    /// The tree over these primitives, and primitives that have no box.
    pub fn new(unbounded: Vec<u32>, primitives: Vec<u32>, form: impl Fn(u32) -> Form + Sync) -> Bvh {
        share(primitives.len(), || Bvh::of(unbounded, primitives, &form))
    }

    fn of(unbounded: Vec<u32>, primitives: Vec<u32>, form: impl Fn(u32) -> Form + Sync) -> Bvh {
        let mut bvh = Bvh { beside: unbounded, instructions: Instructions::detected(), ..Bvh::default() };
        let bounds_of = |primitive: u32| form(primitive).bounds().widened();
        let is_empty = primitives.is_empty();
        let Sorted { outliers, kept, around } = outliers::sorted(primitives, bounds_of);
        bvh.bounds = (!is_empty).then(|| outliers.iter().fold(around, |all, far| all.union(bounds_of(*far))));
        bvh.beside.extend(outliers);
        if kept.is_empty() {
            return bvh;
        }
        bvh.space = Space::around(around);
        bvh.grow(kept, form);
        bvh
    }

    fn grow(&mut self, primitives: Vec<u32>, form: impl Fn(u32) -> Form + Sync) {
        let space = self.space;
        let rough = |primitive: &u32| {
            let form = form(*primitive);
            let bounds = form.bounds().widened();
            let around = Box32::around(space.point(bounds.min), space.point(bounds.max));
            let kind = match form {
                Form::Triangle(_) => Kind::Triangle,
                Form::Sphere { .. } => Kind::Sphere,
                Form::Within(_) => Kind::Other,
            };
            Rough::new(*primitive, kind, &around)
        };
        let mut roughs: Vec<Rough> = primitives.par_iter().with_min_len(CHUNK).map(rough).collect();
        drop(primitives);
        let mut growth = Growth::default();
        let whole = Part::of(&roughs, 0..roughs.len());
        self.root = Some(growth.grow(&mut roughs, 0, &whole, 0));
        self.nodes = growth.nodes;
        // Only their order is needed from here on: the boxes of a million primitives don't lie beside their blocks.
        let primitives: Vec<u32> = roughs.par_iter().with_min_len(CHUNK).map(Rough::primitive).collect();
        drop(roughs);
        let primitives_of = |leaf: &Leaf| primitives[leaf.start as usize..][..leaf.count as usize].iter().copied();
        let triangles = growth.triangles.par_iter().with_min_len(CHUNK / 8);
        let corners =
            |primitive| if let Form::Triangle(corners) = form(primitive) { Some((primitive, corners)) } else { None };
        self.triangles =
            triangles.map(|leaf| TriangleBlock::new(&space, primitives_of(leaf).filter_map(corners))).collect();
        let spheres = growth.spheres.par_iter().with_min_len(CHUNK / 8);
        let ball = |primitive| match form(primitive) {
            Form::Sphere { center, radius } => Some((primitive, (center, radius))),
            _ => None,
        };
        self.spheres = spheres.map(|leaf| SphereBlock::new(&space, primitives_of(leaf).filter_map(ball))).collect();
    }

    /// All primitives in the tree.
    pub(super) fn primitives(&self) -> impl Iterator<Item = u32> {
        let of_nodes = self.nodes.iter().flat_map(Node::children).chain(self.root);
        let alone = of_nodes.filter_map(|child| match child.content() {
            Content::Primitive(primitive) => Some(primitive),
            _ => None,
        });
        let triangles = self.triangles.iter().flat_map(|block| block.used_primitives());
        let spheres = self.spheres.iter().flat_map(|block| block.used_primitives());
        alone.chain(triangles).chain(spheres)
    }
}

impl Growth {
    /// Builds what holds these primitives, which come after `before` others.
    fn grow(&mut self, primitives: &mut [Rough], before: usize, part: &Part, level: usize) -> Child {
        if let Some(leaf) = self.leaf(primitives, before, part) {
            return leaf;
        }
        let mut parts: ArrayVec<Part, 8> = ArrayVec::new();
        parts.push(part.clone());
        while !parts.is_full() {
            let size = |part: &Part| if level < HALVING { part.half_area() } else { part.len() as f32 };
            let open = (0..parts.len()).filter(|at| !parts[*at].is_leaf());
            let Some(at) = open.max_by(|a, b| size(&parts[*a]).total_cmp(&size(&parts[*b]))) else { break };
            let [one, other] = parts[at].split(primitives, level >= HALVING);
            parts[at] = one;
            parts.push(other);
        }
        // Shadow rays look at the largest first.
        parts.sort_by(|a, b| b.half_area().total_cmp(&a.half_area()));
        let place = self.nodes.len();
        self.nodes.push(Node::EMPTY);
        let children = self.grow_parts(primitives, before, &parts, level + 1);
        for (lane, (part, child)) in parts.iter().zip(children).enumerate() {
            self.nodes[place].set(lane, &part.around(), child);
        }
        Child::new(Content::Node(place as u32))
    }

    fn grow_parts(
        &mut self,
        primitives: &mut [Rough],
        before: usize,
        parts: &[Part],
        level: usize,
    ) -> ArrayVec<Child, 8> {
        if primitives.len() < MIN_PARALLEL_PRIMITIVES {
            let grow = |part: &Part| {
                let (range, inner) = (part.range(), part.as_whole());
                self.grow(&mut primitives[range.clone()], before + range.start, &inner, level)
            };
            return parts.iter().map(grow).collect();
        }
        let grow = |(part, primitives): (&Part, &mut [Rough])| {
            let mut growth = Growth::default();
            let child = growth.grow(primitives, before + part.range().start, &part.as_whole(), level);
            (growth, child)
        };
        let grown: Vec<(Growth, Child)> = parts.par_iter().zip(slices(primitives, parts)).map(grow).collect();
        grown.into_iter().map(|(growth, child)| self.take_over(growth, child)).collect()
    }

    /// Takes over what was grown elsewhere.
    fn take_over(&mut self, other: Growth, root: Child) -> Child {
        let before = [self.nodes.len(), self.triangles.len(), self.spheres.len()].map(|count| count as u32);
        self.nodes.extend(other.nodes.into_iter().map(|node| node.moved(before)));
        self.triangles.extend(other.triangles);
        self.spheres.extend(other.spheres);
        root.moved(before)
    }

    /// The leaf that holds these primitives, if one can.
    fn leaf(&mut self, primitives: &[Rough], before: usize, part: &Part) -> Option<Child> {
        if !part.is_leaf() {
            return None;
        }
        let range = part.range();
        let leaf = Leaf { start: (before + range.start) as u32, count: range.len() as u32 };
        let content = match primitives[range.start].kind() {
            Kind::Triangle => Content::Triangles(put(&mut self.triangles, leaf)),
            Kind::Sphere => Content::Spheres(put(&mut self.spheres, leaf)),
            Kind::Other => Content::Primitive(primitives[range.start].primitive()),
        };
        Some(Child::new(content))
    }
}

fn put(leaves: &mut Vec<Leaf>, leaf: Leaf) -> u32 {
    leaves.push(leaf);
    leaves.len() as u32 - 1
}

/// The primitives of each part, in the order of the parts.
fn slices<'t>(primitives: &'t mut [Rough], parts: &[Part]) -> Vec<&'t mut [Rough]> {
    let mut by_place: Vec<usize> = (0..parts.len()).collect();
    by_place.sort_by_key(|at| parts[*at].range().start);
    let mut slices: Vec<(usize, &mut [Rough])> = Vec::new();
    let mut rest = primitives;
    for at in by_place {
        let (slice, after) = rest.split_at_mut(parts[at].len());
        slices.push((at, slice));
        rest = after;
    }
    slices.sort_by_key(|(at, _)| *at);
    slices.into_iter().map(|(_, slice)| slice).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::bounds::Bounds;
    use glam::DVec3;

    fn ball(primitive: u32) -> Form {
        let place = |k: u32| f64::from(primitive.wrapping_mul(k) >> 12) / 1e5;
        let center = DVec3::new(place(2_654_435_761), place(2_246_822_519), place(3_266_489_917));
        if primitive.is_multiple_of(5) {
            Form::Within(Bounds::around([center, center + 0.1]))
        } else {
            Form::Sphere { center, radius: 0.1 }
        }
    }

    fn on_threads(count: usize, primitives: &[u32]) -> Option<Bvh> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().ok()?;
        Some(pool.install(|| Bvh::new(Vec::new(), primitives.to_vec(), ball)))
    }

    #[test]
    fn the_tree_is_the_same_on_any_number_of_threads() {
        let primitives: Vec<u32> = (0..3 * MIN_PARALLEL_PRIMITIVES as u32).collect();
        let tree = on_threads(1, &primitives);
        assert!(tree.is_some() && tree == on_threads(3, &primitives));
    }

    #[test]
    fn everything_is_in_the_tree_once() {
        for count in [1, 7, 9, 1000] {
            let primitives: Vec<u32> = (0..count).collect();
            let tree = Bvh::new(Vec::new(), primitives.clone(), ball);
            let mut found: Vec<u32> = tree.primitives().collect();
            found.sort_unstable();
            assert_eq!(found, primitives);
        }
    }

    #[test]
    fn primitives_in_one_place_make_a_tree() {
        let primitives: Vec<u32> = (0..5000).collect();
        let tree = Bvh::new(Vec::new(), primitives, |_| Form::Sphere { center: DVec3::ONE, radius: 1.0 });
        assert_eq!(tree.primitives().count(), 5000);
        assert!(tree.spheres.len() < 1300, "{} blocks", tree.spheres.len());
    }
}
