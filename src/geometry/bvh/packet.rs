//! The walk of several rays at once. Neighbouring rays look at the same nodes, and so what is done for a node is done once for all of them:
//! one test tells which of its boxes any ray can enter, one more for each of these which rays do. Each ray finds the hits that it would find alone.

use super::block::{Block, LeafRay, Sorted};
use super::lanes::{Eight, Lanes};
use super::node::{BoxRay, Child, Content, Frustum};
use super::packet_lines::{Lines, Local, PACKET, PerRay, RayMask, each};
use super::space::{Distance, WIDEST};
use super::walk::STACK;
use super::{Bvh, Search};
use crate::geometry::line::RaySource;
use arrayvec::ArrayVec;

/// A walk of several rays, and what it is for.
pub(super) struct PacketWalk<'a, S, M> {
    pub tree: &'a Bvh,
    /// At most [`PACKET`] of them.
    pub sources: &'a [S],
    pub search: Search,
    /// Shows a primitive that these rays may hit, and says whether they certainly cross it; sets the distances up to which primitives still matter, a
    /// negative one for a ray whose walk ends.
    pub meet: M,
}

/// A child that waits: where the first ray enters its box, and the rays that do.
type Waiting = (f32, Child, RayMask);

impl<S: RaySource, M: FnMut(RayMask, u32, bool, &mut PerRay<f64>)> PacketWalk<'_, S, M> {
    /// Walks from this child on, up to a distance for each ray. Rays that don't run with the first one, or of which little is known, go on
    /// alone: returns them.
    #[inline(always)]
    pub fn run<L: Lanes>(mut self, lanes: L, root: Child, rays: RayMask, reach: &mut PerRay<f64>) -> RayMask {
        let tree = self.tree;
        let mut local = Local::NONE;
        let mut together: RayMask = 0;
        let mut lines = Lines::NONE;
        let mut lined: RayMask = 0;
        for at in each(rays) {
            if let Some(line) = self.sources[at].line() {
                lines.set(at, &line, reach[at]);
                lined |= 1 << at;
            }
        }
        tree.space.rays(&lines, &mut local);
        let mut first = None;
        for at in each(lined) {
            let side = [local.direction[0][at], local.direction[1][at], local.direction[2][at]];
            let side = [side[0].is_sign_negative(), side[1].is_sign_negative(), side[2].is_sign_negative()];
            if local.slack[at] < WIDEST && *first.get_or_insert(side) == side {
                together |= 1 << at;
            } else {
                local.t_max[at] = f32::NEG_INFINITY;
            }
        }
        let Some(side) = first else { return rays };
        local.near_side = [usize::from(side[0]), usize::from(side[1]), usize::from(side[2])];
        if self.search.tells_sure_hits {
            for at in each(together) {
                let (begin, slack) = (lines.t_min[at], self.sources[at].slack());
                local.sure[at] = local.distance[at].surely_within(begin, reach[at], slack);
            }
        }
        if together.count_ones() > 1 {
            self.walk(lanes, root, together, &mut local, reach);
            rays & !together
        } else {
            rays
        }
    }

    #[inline(always)]
    fn walk<L: Lanes>(&mut self, lanes: L, root: Child, rays: RayMask, local: &mut Local, limits: &mut PerRay<f64>) {
        let tree = self.tree;
        let frustum = frustum(lanes, rays, local);
        let mut waiting: ArrayVec<Waiting, STACK> = ArrayVec::new();
        let mut farthest = local.farthest();
        let (mut child, mut rays) = (root, rays);
        loop {
            match child.content() {
                Content::Node(number) => {
                    let node = &tree.nodes[number as usize];
                    let bottom = waiting.len();
                    if rays.is_power_of_two() {
                        let at = rays.trailing_zeros() as usize & 7;
                        let ray = box_ray(lanes, local, at);
                        let entered = node.entered(lanes, &ray, lanes.splat(local.t_max[at]));
                        let near = lanes.store(entered.near);
                        for lane in each(entered.bits) {
                            self.wait((near[lane], node.child(lane), rays), &mut waiting, bottom);
                        }
                    } else {
                        let entered = node.entered_by_some(lanes, &frustum, lanes.splat(farthest));
                        let near = lanes.store(entered.near);
                        let all = all_rays(lanes, local);
                        let t_max = lanes.load(&local.t_max);
                        for lane in each(entered.bits) {
                            let entering = rays & node.entering(lanes, lane, &all, t_max);
                            if entering != 0 {
                                self.wait((near[lane], node.child(lane), entering), &mut waiting, bottom);
                            }
                        }
                    }
                }
                Content::Triangles(number) => {
                    let block = &tree.triangles[number as usize];
                    self.meet_block(lanes, block, rays, local, limits);
                    farthest = local.farthest();
                }
                Content::Spheres(number) => {
                    let block = &tree.spheres[number as usize];
                    self.meet_block(lanes, block, rays, local, limits);
                    farthest = local.farthest();
                }
                Content::Primitive(primitive) => {
                    (self.meet)(rays, primitive, false, limits);
                    for at in each(rays) {
                        local.t_max[at] = latest(&local.distance[at], limits[at]);
                    }
                    farthest = local.farthest();
                }
            }
            loop {
                let Some((near, next, entering)) = waiting.pop() else { return };
                if near <= farthest {
                    let alive = lanes.at_least(lanes.load(&local.t_max), lanes.splat(near));
                    (child, rays) = (next, entering & alive);
                    if rays != 0 {
                        break;
                    }
                }
            }
        }
    }

    /// Lets a child wait among those of its node, the nearest on top.
    #[inline(always)]
    fn wait(&self, child: Waiting, waiting: &mut ArrayVec<Waiting, STACK>, bottom: usize) {
        let mut at = waiting.len();
        waiting.push(child);
        while self.search.nearest_first && at > bottom && waiting[at - 1].0 < child.0 {
            waiting[at] = waiting[at - 1];
            at -= 1;
        }
        waiting[at] = child;
    }

    /// Shows the primitives of a block, one ray after the other.
    #[inline(always)]
    fn meet_block<L: Lanes>(
        &mut self,
        lanes: L,
        block: &impl Block,
        rays: RayMask,
        local: &mut Local,
        limits: &mut PerRay<f64>,
    ) {
        let (mut possible, mut sure) = ([0_u8; PACKET], [0_u8; PACKET]);
        let (mut any, mut any_sure) = (0, 0);
        for at in each(rays) {
            let sorted = if self.search.one_by_one {
                let sure = local.sure[at];
                block.filtered(lanes, &leaf_ray(lanes, local, at), lanes.splat(local.t_max[at]), &|| sure)
            } else {
                Sorted::possible(block.used())
            };
            (possible[at], sure[at]) = (sorted.possible as u8, sorted.sure as u8);
            (any, any_sure) = (any | sorted.possible, any_sure | sorted.sure);
        }
        // Sure ones may end a search.
        let mut rest = rays;
        for lane in each(any_sure) {
            let these = rest & of_lane(&sure, lane);
            if these != 0 {
                (self.meet)(these, block.primitive(lane), true, limits);
                rest &= !ended(these, limits);
            }
        }
        for lane in each(any) {
            let these = rest & of_lane(&possible, lane) & !of_lane(&sure, lane);
            if these != 0 {
                (self.meet)(these, block.primitive(lane), false, limits);
                rest &= !ended(these, limits);
            }
        }
        for at in each(rays) {
            if possible[at] != 0 {
                local.t_max[at] = latest(&local.distance[at], limits[at]);
            }
        }
    }
}

/// The rays for which the bit of this lane is set.
#[inline(always)]
fn of_lane(bits: &PerRay<u8>, lane: usize) -> RayMask {
    // Bit `lane` of each byte, gathered by a product.
    let bits = u64::from_le_bytes(*bits) >> (lane & 7) & 0x0101_0101_0101_0101;
    (bits.wrapping_mul(0x0102_0408_1020_4080) >> 56) as RayMask
}

/// Those of the rays whose search has ended.
#[inline(always)]
fn ended(rays: RayMask, limits: &PerRay<f64>) -> RayMask {
    let mut ended = 0;
    for at in each(rays) {
        ended |= u32::from(limits[at] < 0.0) << at;
    }
    ended
}

/// Up to where boxes matter to a ray, nowhere if it has ended.
#[inline(always)]
fn latest(distance: &Distance, limit: f64) -> f32 {
    if limit < 0.0 { f32::NEG_INFINITY } else { distance.latest(limit) }
}

#[inline(always)]
fn all_rays<L: Lanes>(lanes: L, local: &Local) -> BoxRay<L> {
    let load = |eights: &[Eight; 3]| [lanes.load(&eights[0]), lanes.load(&eights[1]), lanes.load(&eights[2])];
    BoxRay {
        inverse: load(&local.inverse),
        near: load(&local.near),
        far: load(&local.far),
        near_side: local.near_side,
        t_min: lanes.load(&local.t_min),
    }
}

#[inline(always)]
fn box_ray<L: Lanes>(lanes: L, local: &Local, at: usize) -> BoxRay<L> {
    let splat =
        |eights: &[Eight; 3]| [lanes.splat(eights[0][at]), lanes.splat(eights[1][at]), lanes.splat(eights[2][at])];
    BoxRay {
        inverse: splat(&local.inverse),
        near: splat(&local.near),
        far: splat(&local.far),
        near_side: local.near_side,
        t_min: lanes.splat(local.t_min[at]),
    }
}

#[inline(always)]
fn leaf_ray<L: Lanes>(lanes: L, local: &Local, at: usize) -> LeafRay<L> {
    let splat =
        |eights: &[Eight; 3]| [lanes.splat(eights[0][at]), lanes.splat(eights[1][at]), lanes.splat(eights[2][at])];
    LeafRay {
        origin: splat(&local.origin),
        direction: splat(&local.direction),
        t_min: lanes.splat(local.t_min[at]),
        slack: local.slack[at],
    }
}

/// What holds all of these rays, whose directions have the same signs.
#[inline(always)]
fn frustum<L: Lanes>(lanes: L, rays: RayMask, local: &Local) -> Frustum<L> {
    let range = |eight: &Eight| {
        let (mut least, mut greatest) = (f32::INFINITY, f32::NEG_INFINITY);
        for at in each(rays) {
            let x = eight[at];
            (least, greatest) = (if x < least { x } else { least }, if x > greatest { x } else { greatest });
        }
        [least, greatest]
    };
    let ranges = |eights: &[Eight; 3]| [range(&eights[0]), range(&eights[1]), range(&eights[2])];
    let (origins, inverses) = (ranges(&local.origin), ranges(&local.inverse));
    let [t_min, _] = range(&local.t_min);
    let [_, slack] = range(&local.slack);
    Frustum::new(lanes, origins, inverses, local.near_side, slack, t_min)
}
