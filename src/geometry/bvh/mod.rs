//! A bounding volume hierarchy (BVH): it finds the primitives that a ray may hit.
//!
//! It only finds candidates; the kernels decide. Boxes and tests are in single precision, in a space of the
//! tree's own, and are conservative by margins that `docs/acceleration.md` derives, so that the answer is that of testing
//! everything.

mod block;
mod build;
mod lanes;
mod node;
mod outliers;
mod packet;
mod packet_lines;
mod shaft;
mod space;
mod split;
mod walk;

use super::bounds::Bounds;
use super::line::RaySource;
use crate::probe::Probe;
use block::{SphereBlock, TriangleBlock};
use glam::DVec3;
use lanes::{Instructions, Lanes, Plain};
use node::{Child, Node};
use packet::PacketWalk;
pub use packet_lines::{PACKET, PerRay, RayMask, each};
pub use shaft::Shaft;
use space::Space;
use walk::Walk;

/// A tree of boxes over numbered primitives, and a list of those that are tested without it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bvh {
    /// The primitives without a box, and those that are so much larger than the others, or so far from them, that they would spoil the tree's
    /// space.
    beside: Vec<u32>,
    /// A box around everything that has one.
    bounds: Option<Bounds>,
    space: Space,
    /// Where the tree begins; `None` if nothing is in it.
    root: Option<Child>,
    nodes: Vec<Node>,
    triangles: Vec<TriangleBlock>,
    spheres: Vec<SphereBlock>,
    instructions: Instructions,
}

/// What the tree knows of a primitive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// A triangle with these corners.
    Triangle([DVec3; 3]),
    /// A sphere.
    Sphere {
        /// Its centre.
        center: DVec3,
        /// Its radius.
        radius: f64,
    },
    /// Any shape in this box.
    Within(Bounds),
}

impl Form {
    /// A box around the primitive.
    #[inline]
    pub fn bounds(&self) -> Bounds {
        match self {
            Form::Triangle(corners) => Bounds::around(*corners),
            Form::Sphere { center, radius } => Bounds { min: *center - *radius, max: *center + *radius },
            Form::Within(bounds) => *bounds,
        }
    }
}

/// How a ray traverses the tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Search {
    /// Whether near primitives come before far ones, roughly. Without an order the traversal is faster.
    pub nearest_first: bool,
    /// Whether triangles and spheres are culled one by one. That is for kernels that certify their decisions: in another arithmetic a ray
    /// may hit what it misses in f64.
    pub one_by_one: bool,
    /// Whether it reports triangles and spheres that the ray certainly crosses, so that no kernel needs to test them. For rays that need
    /// only this answer, before kernels that certify.
    pub tells_sure_hits: bool,
}

impl Search {
    /// Near primitives before far ones.
    pub fn nearest_first<P: Probe>(probe: &P) -> Search {
        Search { nearest_first: true, ..Search::in_any_order(probe) }
    }

    /// Primitives in any order.
    pub fn in_any_order<P: Probe>(probe: &P) -> Search {
        Search { nearest_first: false, one_by_one: probe.certifies(), tells_sure_hits: false }
    }

    /// Any hit at all. A probe that sees tests gets all of them, and no test is skipped as certain.
    pub fn of_any<P: Probe>(probe: &P) -> Search {
        Search { tells_sure_hits: P::IS_SILENT && probe.certifies(), ..Search::in_any_order(probe) }
    }
}

impl Bvh {
    /// A box around everything that has one.
    pub fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    /// Calls `meet` with every primitive that the ray may hit before its end, first those beside the tree, and with whether it certainly crosses it.
    /// `meet` returns the distance up to which primitives still matter; a negative one ends the search. Returns how many boxes were tested.
    ///
    /// For a probe that uses SIMD the traversal is compiled twice, for the processor's best instructions and for any processor; kernels
    /// get the same primitives in both, and a probe's counts are the same.
    #[inline(always)]
    pub fn visit<P: Probe>(
        &self,
        source: &impl RaySource,
        search: Search,
        mut meet: impl FnMut(u32, bool) -> f64,
    ) -> u64 {
        let mut t_max = source.reach();
        for primitive in &self.beside {
            t_max = meet(*primitive, false);
            if t_max < 0.0 {
                return 0;
            }
        }
        match self.root {
            Some(root) => self.visit_tree::<P>(root, source, t_max, search, meet),
            None => 0,
        }
    }

    /// The same for several rays, at most [`PACKET`], of which those in `rays` take part. Calls `meet` with sets of rays that may hit a primitive; it sets
    /// the distances `limits`, up to which primitives still matter to a ray, a negative one to end its search.
    pub fn visit_together<P: Probe, S: RaySource>(
        &self,
        sources: &[S],
        rays: RayMask,
        search: Search,
        limits: &mut PerRay<f64>,
        mut meet: impl FnMut(RayMask, u32, bool, &mut PerRay<f64>),
    ) {
        for primitive in &self.beside {
            let rays: RayMask = each(rays).filter(|ray| limits[*ray] >= 0.0).fold(0, |rays, ray| rays | 1 << ray);
            meet(rays, *primitive, false, limits);
        }
        let Some(root) = self.root else { return };
        let rays: RayMask = each(rays).filter(|ray| limits[*ray] >= 0.0).fold(0, |rays, ray| rays | 1 << ray);
        let alone = if rays.count_ones() > 1 {
            self.visit_tree_together::<P, S>(
                root,
                sources,
                rays,
                search,
                limits,
                #[inline(always)]
                |rays, primitive, is_sure, limits| meet(rays, primitive, is_sure, limits),
            )
        } else {
            rays
        };
        for ray in each(alone) {
            self.visit_tree::<P>(
                root,
                &sources[ray],
                limits[ray],
                search,
                #[inline(always)]
                |primitive, is_sure| {
                    meet(1 << ray, primitive, is_sure, limits);
                    limits[ray]
                },
            );
        }
    }

    #[inline(never)]
    fn visit_tree_together<P: Probe, S: RaySource>(
        &self,
        root: Child,
        sources: &[S],
        rays: RayMask,
        search: Search,
        limits: &mut PerRay<f64>,
        meet: impl FnMut(RayMask, u32, bool, &mut PerRay<f64>),
    ) -> RayMask {
        let walk = PacketWalk { tree: self, sources, search, meet };
        #[cfg(target_arch = "x86_64")]
        if P::USES_SIMD
            && let Instructions::Avx2(avx2) = self.instructions
        {
            // Counts of tests are the same on every machine, so a probe that may count uses no fused operations.
            return avx2.run(
                #[inline(always)]
                || match P::IS_SILENT {
                    true => walk.run(avx2, root, rays, limits),
                    false => walk.run(avx2.unfused(), root, rays, limits),
                },
            );
        }
        walk.run(Plain, root, rays, limits)
    }

    // Outlined, so that a scene without a tree doesn't prepare the ray for it.
    #[inline(never)]
    fn visit_tree<P: Probe>(
        &self,
        root: Child,
        source: &impl RaySource,
        t_max: f64,
        search: Search,
        meet: impl FnMut(u32, bool) -> f64,
    ) -> u64 {
        let walk = Walk { tree: self, source, search, meet };
        #[cfg(target_arch = "x86_64")]
        if P::USES_SIMD
            && let Instructions::Avx2(avx2) = self.instructions
        {
            return avx2.run(
                #[inline(always)]
                || match P::IS_SILENT {
                    true => walk.run(avx2, root, t_max),
                    false => walk.run(avx2.unfused(), root, t_max),
                },
            );
        }
        walk.run(Plain, root, t_max)
    }
}
