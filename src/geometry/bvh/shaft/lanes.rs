//! Which of eight boxes, triangles or spheres may meet a shaft.

use super::{Limit, LocalShaft};
use crate::geometry::bvh::block::{SphereBlock, TriangleBlock};
use crate::geometry::bvh::lanes::{Eight, Lanes};
use crate::geometry::bvh::node::Node;
use crate::geometry::bvh::space::U;

/// A shaft, for eight primitives at once.
pub(super) struct LaneShaft<'a, L> {
    pub lanes: L,
    pub local: &'a LocalShaft,
}

impl<L: Lanes> LaneShaft<'_, L> {
    /// The parts of the way, from the first that may lie in boxes to the last; `shift` picks what the limits subtract.
    #[inline(always)]
    fn within(
        &self,
        least: [L::Eight; 3],
        greatest: [L::Eight; 3],
        shift: impl Fn(&Limit) -> &[f32; 4] + Copy,
    ) -> [L::Eight; 2] {
        let lanes = self.lanes;
        let [near_x, far_x] = self.within_slab(0, least[0], greatest[0], shift);
        let [near_y, far_y] = self.within_slab(1, least[1], greatest[1], shift);
        let [near_z, far_z] = self.within_slab(2, least[2], greatest[2], shift);
        let near = lanes.max(lanes.max(near_x, near_y), lanes.max(near_z, lanes.splat(0.0)));
        let far = lanes.min(lanes.min(far_x, far_y), lanes.min(far_z, lanes.splat(1.0)));
        [near, far]
    }

    /// The same for an axis.
    #[inline(always)]
    fn within_slab(
        &self,
        axis: usize,
        least: L::Eight,
        greatest: L::Eight,
        shift: impl Fn(&Limit) -> &[f32; 4],
    ) -> [L::Eight; 2] {
        let LaneShaft { lanes, local: LocalShaft { lesser, greater, .. } } = self;
        let at =
            |x, limit: &Limit| lanes.times_minus(x, lanes.splat(limit.inverse[axis]), lanes.splat(shift(limit)[axis]));
        [
            lanes.max(at(least, &lesser.near), at(greatest, &greater.near)),
            lanes.min(at(least, &lesser.far), at(greatest, &greater.far)),
        ]
    }

    #[inline(always)]
    fn splat(&self, numbers: [f32; 3]) -> [L::Eight; 3] {
        let [x, y, z] = numbers;
        [self.lanes.splat(x), self.lanes.splat(y), self.lanes.splat(z)]
    }

    /// Vectors from P to these points.
    #[inline(always)]
    fn seen(&self, points: &[Eight; 3]) -> [L::Eight; 3] {
        let lanes = self.lanes;
        let seen = |axis: usize| lanes.sub(lanes.load(&points[axis]), lanes.splat(self.local.from[axis]));
        [seen(0), seen(1), seen(2)]
    }

    /// A bit for each box that may meet a segment.
    #[inline(always)]
    pub fn nodes(&self, node: &Node) -> u32 {
        let (lanes, local) = (self.lanes, self.local);
        let [[x_0, x_1], [y_0, y_1], [z_0, z_1]] = &node.planes;
        let least = [lanes.load(x_0), lanes.load(y_0), lanes.load(z_0)];
        let greatest = [lanes.load(x_1), lanes.load(y_1), lanes.load(z_1)];
        let [near, far] = self.within(least, greatest, |limit| &limit.shift);
        let top = |axis: usize| lanes.load(&node.planes[axis][usize::from(local.rise[axis] > 0.0)]);
        let top = [top(0), top(1), top(2)];
        let height = lanes.sub(lanes.dot(top, self.splat(local.rise)), lanes.splat(local.foot));
        lanes.at_least(lanes.min(height, far), near)
    }

    /// A bit for each triangle that may meet a segment.
    #[inline(always)]
    pub fn triangles(&self, block: &TriangleBlock) -> u32 {
        let (lanes, local) = (self.lanes, self.local);
        let load = |eights: &[Eight; 3]| [lanes.load(&eights[0]), lanes.load(&eights[1]), lanes.load(&eights[2])];
        let (a, to_b, to_c) = (self.seen(&block.corner), load(&block.to_b), load(&block.to_c));
        let zero = lanes.splat(0.0);
        let least = |axis: usize| lanes.add(a[axis], lanes.min(lanes.min(to_b[axis], to_c[axis]), zero));
        let greatest = |axis: usize| lanes.add(a[axis], lanes.max(lanes.max(to_b[axis], to_c[axis]), zero));
        let (least, greatest) = ([least(0), least(1), least(2)], [greatest(0), greatest(1), greatest(2)]);
        let [near, far] = self.within(least, greatest, |limit| &limit.beside);
        let rise = self.splat(local.rise);
        let (height_b, height_c) = (lanes.dot(to_b, rise), lanes.dot(to_c, rise));
        let highest = lanes.max(lanes.max(height_b, height_c), zero);
        let height = lanes.add(lanes.add(lanes.dot(a, rise), highest), lanes.splat(local.over));
        let far = lanes.min(height, far);
        let bits = lanes.at_least(far, near);
        if bits == 0 {
            return 0;
        }
        // Where the segments cross the triangle's plane, which lies so far from P along its normal.
        let size = |x| lanes.max(x, lanes.sub(zero, x));
        let normal = lanes.cross(to_b, to_c);
        let distance = lanes.dot(normal, a);
        let along = lanes.negated_as(lanes.dot(normal, self.splat(local.middle)), distance);
        let [x, y, z] = normal;
        let off = lanes.dot([size(x), size(y), size(z)], self.splat(local.half));
        let square = lanes.splat(block.longest * block.longest);
        let off = lanes.times_plus(square, lanes.splat(16.0 * U * local.way), off);
        let margin = lanes.mul(square, lanes.splat(local.margin));
        let distance = size(distance);
        let [least, most] = [lanes.sub(along, off), lanes.add(along, off)];
        let farthest = lanes.max(lanes.mul(most, near), lanes.mul(most, far));
        let nearest = lanes.min(lanes.mul(least, near), lanes.mul(least, far));
        bits & lanes.at_least(farthest, lanes.sub(distance, margin))
            & lanes.at_least(lanes.add(distance, margin), nearest)
    }

    /// A bit for each sphere that may meet a segment.
    #[inline(always)]
    pub fn spheres(&self, block: &SphereBlock) -> u32 {
        let (lanes, local) = (self.lanes, self.local);
        let (center, radius) = (self.seen(&block.center), lanes.load(&block.radius));
        let [x, y, z] = center;
        let least = [lanes.sub(x, radius), lanes.sub(y, radius), lanes.sub(z, radius)];
        let greatest = [lanes.add(x, radius), lanes.add(y, radius), lanes.add(z, radius)];
        let [near, far] = self.within(least, greatest, |limit| &limit.beside);
        let height = lanes.dot(center, self.splat(local.rise));
        let height = lanes.times_plus(radius, lanes.splat(local.per_rise), lanes.add(height, lanes.splat(local.over)));
        let far = lanes.min(height, far);
        let bits = lanes.at_least(far, near);
        if bits == 0 {
            return 0;
        }
        // What the shaft holds at the part s of the way lies within s·R of P + s(C − P). Its least distance from the sphere is that of a
        // quadratic.
        let (of_center, of_radius) = (lanes.dot(center, center), lanes.mul(radius, radius));
        let linear = lanes.times_plus(radius, lanes.splat(local.radius), lanes.dot(center, self.splat(local.ball)));
        let at = lanes.min(lanes.max(lanes.mul(linear, lanes.splat(local.per_square)), near), far);
        let rest = lanes.times_minus(at, lanes.splat(local.square), lanes.add(linear, linear));
        let apart = lanes.times_plus(at, rest, lanes.sub(of_center, of_radius));
        let size = lanes.add(lanes.add(of_center, of_radius), lanes.splat(local.size));
        let by_margin =
            lanes.mul(lanes.add(radius, lanes.splat(local.radius + local.margin)), lanes.splat(4.0 * local.margin));
        let margin = lanes.times_plus(size, lanes.splat(32.0 * U), by_margin);
        bits & lanes.at_least(margin, apart)
    }
}
