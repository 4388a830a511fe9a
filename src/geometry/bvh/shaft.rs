//! Shafts: what can lie on any of the segments from a point to a light, found by one walk through the tree. `docs/acceleration.md` derives
//! the margins.

use super::block::{Block, SphereBlock, TriangleBlock};
use super::lanes::{Eight, Instructions, Lanes, Plain};
use super::node::{Child, Content, Node};
use super::space::{Space, U, up};
use super::{Bounds, Bvh};
use arrayvec::ArrayVec;
use glam::{BVec4A, DVec3, Vec3, Vec4};

/// All segments from a point to the points of a light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaft {
    /// Where the segments begin.
    pub point: DVec3,
    /// A box around the light.
    pub light: Bounds,
    /// Centre and radius of a ball around the light.
    pub ball: (DVec3, f64),
    /// A unit vector along which all segments rise, and how much at least.
    rise: Option<(DVec3, f64)>,
}

/// A walk looks at so many nodes before it gives up: what it would spare were it to find nothing is worth no more.
const MOST_NODES: usize = 24;

/// The children that wait, at the most.
const STACK: usize = 7 * MOST_NODES + 1;

/// The least rise along a normal that counts, as a part of all coordinates that it is made of: far more than all roundings.
const LEAST_RISE: f64 = 1e-6;

impl Shaft {
    /// The segments from a point to the points of a light, which lies in a box and in a ball.
    pub fn new(point: DVec3, light: Bounds, ball: (DVec3, f64)) -> Shaft {
        Shaft { point, light, ball, rise: None }
    }

    /// How much the segments rise along a vector, at least and at most; 0 within rounding.
    pub fn rise_along(&self, vector: DVec3) -> [f64; 2] {
        let (center, half) = (self.light.center(), (self.light.max - self.light.min) * 0.5);
        let (middle, off) = (vector.dot(center - self.point), vector.abs().dot(half));
        let size = vector.abs().dot(center.abs() + half + self.point.abs());
        let sure = |rise: f64| if rise.abs() > LEAST_RISE * size { rise } else { 0.0 };
        [sure(middle - off), sure(middle + off)]
    }

    /// The shaft, with a unit vector along which all segments rise so much at least.
    #[must_use]
    pub fn rising(self, along: DVec3, least: f64) -> Shaft {
        Shaft { rise: Some((along, least)), ..self }
    }
}

impl Bvh {
    /// Shows `found` every thing that may meet a segment of the shaft, those beside the tree first; `found` says whether to go on. Returns
    /// whether all were shown.
    pub fn between(&self, shaft: &Shaft, mut found: impl FnMut(u32) -> bool) -> bool {
        if !self.beside.iter().all(|thing| found(*thing)) {
            return false;
        }
        let Some(root) = self.root else { return true };
        let Some(local) = LocalShaft::new(&self.space, shaft) else { return false };
        match self.instructions {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2(avx2) => avx2.run(
                #[inline(always)]
                || self.walk_shaft(avx2, root, &local, found),
            ),
            Instructions::Plain(Plain) => self.walk_shaft(Plain, root, &local, found),
        }
    }

    #[inline(always)]
    fn walk_shaft<L: Lanes>(
        &self,
        lanes: L,
        root: Child,
        local: &LocalShaft,
        mut found: impl FnMut(u32) -> bool,
    ) -> bool {
        let shaft = LaneShaft { lanes, local };
        let mut waiting: ArrayVec<Child, STACK> = ArrayVec::new();
        let mut nodes = 0;
        let mut child = root;
        loop {
            let (bits, things) = match child.content() {
                Content::Node(number) => {
                    nodes += 1;
                    if nodes > MOST_NODES {
                        return false;
                    }
                    let node = &self.nodes[number as usize];
                    let mut bits = shaft.nodes(node);
                    while bits != 0 {
                        waiting.push(node.child(bits.trailing_zeros() as usize));
                        bits &= bits - 1;
                    }
                    (0, [0; 8])
                }
                Content::Triangles(number) => {
                    let block = &self.triangles[number as usize];
                    (shaft.triangles(block), block.things())
                }
                Content::Spheres(number) => {
                    let block = &self.spheres[number as usize];
                    (shaft.spheres(block), block.things())
                }
                Content::Thing(thing) => (1, [thing; 8]),
            };
            let mut bits = bits;
            while bits != 0 {
                if !found(things[bits.trailing_zeros() as usize & 7]) {
                    return false;
                }
                bits &= bits - 1;
            }
            match waiting.pop() {
                Some(next) => child = next,
                None => return true,
            }
        }
    }
}

/// The errors of a plane's place along the shaft, and of heights, as a part of the coordinates that they are made of.
const OF_PLACE: f64 = 32.0 * U as f64;

/// Roundings in f64, as a part of all coordinates that they are made of together.
const ROUNDINGS: f64 = 24.0 * f64::EPSILON;

/// With a greater margin boxes tell nothing.
const WIDEST: f64 = 1.0 / 64.0;

/// The longest way of a light that is looked for.
const LONGEST: f64 = 1e15;

/// The least part of the square of a ball's distance that is left without the square of its radius.
const NEAREST: f32 = 1.0 / 64.0;

/// The least component of a way.
const LEAST: f32 = 1e-18;

/// Bounds of the part of the way at which the shaft meets a box, by axis: x·inverse − shift for a coordinate x of the box, x·inverse − beside
/// for one that is counted from P on.
#[derive(Clone, Copy)]
struct Limits {
    inverse: [f32; 4],
    shift: [f32; 4],
    beside: [f32; 4],
}

/// A shaft in the tree's space. What it holds at the part s of the way, from 0 to 1, lies in the box from P + s·l to P + s·h.
struct LocalShaft {
    /// P
    from: [f32; 3],
    /// How far something that is met may lie beside the shaft, with all roundings.
    margin: f32,
    /// Which side of a box the shaft meets first, by axis: 0 the lesser coordinate.
    first: [usize; 3],
    /// Of that side.
    near: Limits,
    /// Of the other side, where the shaft widens both ways; else they are none.
    also_near: Limits,
    /// Of the other side, where it doesn't.
    far: Limits,
    /// The vector along which the shaft rises, divided by the least rise; 0 where it rises along none.
    rise: [f32; 3],
    /// Its length.
    per_rise: f32,
    /// What the height over P and the margin counts from.
    foot: f32,
    /// The margin as a height.
    over: f32,
    /// The middle of the light's box from P on, and half its sides.
    middle: [f32; 3],
    half: [f32; 3],
    /// How long the way is, at the most.
    way: f32,
    /// Centre and radius of the light's ball from P on.
    ball: [f32; 3],
    radius: f32,
    /// The square of the centre's distance less that of the radius, and 1 over it.
    square: f32,
    per_square: f32,
    /// Their sum; infinite where the point is so near the ball that nothing is said of it.
    size: f32,
}

impl LocalShaft {
    /// `None` where the point or the light is so far away that all may meet anything.
    #[inline(always)]
    fn new(space: &Space, shaft: &Shaft) -> Option<LocalShaft> {
        let scale = space.length(1.0);
        let from = space.point(shaft.point);
        let [low, high] = [shaft.light.min, shaft.light.max].map(|end| (end - shaft.point) * scale);
        let way = low.abs().max(high.abs()).element_sum();
        let off = ROUNDINGS * (from.abs().element_sum() + way + shaft.point.abs().element_sum() * scale + 8.0);
        let margin = OF_PLACE * (1.0 + from.abs().max_element()) + 2.0 * off;
        if !(margin < WIDEST && way < LONGEST) {
            return None;
        }
        let (center, radius) = shaft.ball;
        let (along, per_rise) = match shaft.rise {
            Some((along, least)) if least * scale > 1e-12 => (along, 1.0 / (least * scale)),
            _ => (DVec3::ZERO, 0.0),
        };
        let margin = margin as f32 * (1.0 + 4.0 * U);
        let outward = Vec3::splat(off as f32 * (1.0 + 4.0 * U) + f32::MIN_POSITIVE);
        let rounded = |end: DVec3, way: f32| {
            let end = end.as_vec3();
            end + (end.abs() * (4.0 * U) + outward) * way
        };
        let (low, high) = (rounded(low, -1.0), rounded(high, 1.0));
        let (rise, per_rise) = ((along * per_rise).as_vec3(), per_rise as f32);
        let from = from.as_vec3();
        let over = if per_rise > 0.0 { margin * per_rise } else { f32::INFINITY };
        let middle = (low + high) * 0.5;
        let half = (high - low) * 0.5 + (high.abs() + low.abs()) * (2.0 * U);
        let (ball, radius) = (((center - shaft.point) * scale).as_vec3(), up(radius * scale + 2.0 * off));
        let (of_ball, of_radius) = (ball.dot(ball), radius * radius);
        let square = of_ball - of_radius;
        let is_apart = square > of_ball * NEAREST;
        let up = high.extend(1.0).cmpgt(Vec4::ZERO);
        let [near, also_near, far] = limits(from, margin, low, high);
        Some(LocalShaft {
            from: from.to_array(),
            margin,
            first: [0, 1, 2].map(|axis| usize::from(!up.test(axis))),
            near,
            also_near,
            far,
            rise: rise.to_array(),
            per_rise,
            foot: rise.dot(from) - over,
            over,
            middle: middle.to_array(),
            half: half.to_array(),
            way: middle.abs().element_sum() + half.element_sum(),
            ball: ball.to_array(),
            radius,
            square,
            per_square: if is_apart { 1.0 / square } else { 0.0 },
            size: if is_apart { of_ball + of_radius } else { f32::INFINITY },
        })
    }
}

/// The limits of the side of boxes that the shaft meets first, and of the other where it is met first, too, and where it isn't. The lesser side
/// x bounds by s·h ≥ x − P − m, the greater one by s·l ≤ x − P + m.
#[inline(always)]
fn limits(from: Vec3, margin: f32, low: Vec3, high: Vec3) -> [Limits; 3] {
    let (low, high, from, margin) = (low.extend(-1.0), high.extend(1.0), from.extend(0.0), Vec4::splat(margin));
    // Outward, so that none is 0.
    let least = Vec4::splat(LEAST);
    let low = Vec4::select(low.abs().cmplt(least), -least, low);
    let high = Vec4::select(high.abs().cmplt(least), least, high);
    let (by_low, by_high) = (Vec4::ONE / low, Vec4::ONE / high);
    let lesser = [by_high, (from + margin) * by_high, margin * by_high];
    let greater = [by_low, (from - margin) * by_low, -margin * by_low];
    let up = high.cmpgt(Vec4::ZERO);
    let widens = up & low.cmplt(Vec4::ZERO);
    let none = |shift: f32| [Vec4::ZERO, Vec4::splat(shift), Vec4::splat(shift)];
    let either = |mask: BVec4A, a: [Vec4; 3], b: [Vec4; 3]| -> [Vec4; 3] {
        std::array::from_fn(|k| Vec4::select(mask, a[k], b[k]))
    };
    let near = either(up, lesser, greater);
    let also_near = either(widens, greater, none(f32::INFINITY));
    let far = either(widens, none(f32::NEG_INFINITY), either(up, greater, lesser));
    [near, also_near, far].map(|of| {
        let [inverse, shift, beside] = of.map(|vector| vector.to_array());
        Limits { inverse, shift, beside }
    })
}

/// A shaft, for eight things at once.
struct LaneShaft<'a, L> {
    lanes: L,
    local: &'a LocalShaft,
}

impl<L: Lanes> LaneShaft<'_, L> {
    /// The parts of the way, from the first that may lie in a box to the last.
    #[inline(always)]
    fn within(
        &self,
        side: impl Fn(usize, usize) -> L::Eight,
        shift: impl Fn(&Limits) -> [f32; 4],
    ) -> [L::Eight; 2] {
        let (lanes, local) = (self.lanes, self.local);
        let (mut near, mut far) = (lanes.splat(0.0), lanes.splat(1.0));
        for axis in 0..3 {
            let at = |limits: &Limits, x| {
                lanes.times_minus(x, lanes.splat(limits.inverse[axis]), lanes.splat(shift(limits)[axis]))
            };
            let (first, second) = (side(axis, local.first[axis]), side(axis, local.first[axis] ^ 1));
            // What isn't a number is passed over.
            near = lanes.max(at(&local.near, first), near);
            near = lanes.max(at(&local.also_near, second), near);
            far = lanes.min(at(&local.far, second), far);
        }
        [near, far]
    }

    #[inline(always)]
    fn splat(&self, numbers: [f32; 3]) -> [L::Eight; 3] {
        numbers.map(|x| self.lanes.splat(x))
    }

    /// Vectors from P to these points.
    #[inline(always)]
    fn seen(&self, points: &[Eight; 3]) -> [L::Eight; 3] {
        let lanes = self.lanes;
        std::array::from_fn(|axis| lanes.sub(lanes.load(&points[axis]), lanes.splat(self.local.from[axis])))
    }

    /// A bit for each box that may meet a segment.
    #[inline(always)]
    fn nodes(&self, node: &Node) -> u32 {
        let (lanes, local) = (self.lanes, self.local);
        let side = |axis: usize, side: usize| lanes.load(&node.planes[axis][side & 1]);
        let [near, far] = self.within(side, |limits| limits.shift);
        let top: [_; 3] = std::array::from_fn(|axis| side(axis, usize::from(local.rise[axis] > 0.0)));
        let height = lanes.sub(lanes.dot(top, self.splat(local.rise)), lanes.splat(local.foot));
        lanes.at_least(lanes.min(height, far), near)
    }

    /// A bit for each triangle that may meet a segment.
    #[inline(always)]
    fn triangles(&self, block: &TriangleBlock) -> u32 {
        let (lanes, local) = (self.lanes, self.local);
        let load = |eights: &[Eight; 3]| [lanes.load(&eights[0]), lanes.load(&eights[1]), lanes.load(&eights[2])];
        let (a, to_b, to_c) = (self.seen(&block.corner), load(&block.to_b), load(&block.to_c));
        let zero = lanes.splat(0.0);
        let side = |axis: usize, side: usize| {
            let (b, c) = (to_b[axis], to_c[axis]);
            let least = lanes.min(lanes.min(b, c), zero);
            let greatest = lanes.max(lanes.max(b, c), zero);
            lanes.add(a[axis], if side == 0 { least } else { greatest })
        };
        let [near, far] = self.within(side, |limits| limits.beside);
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
        let off = lanes.dot(normal.map(size), self.splat(local.half));
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
    fn spheres(&self, block: &SphereBlock) -> u32 {
        let (lanes, local) = (self.lanes, self.local);
        let (center, radius) = (self.seen(&block.center), lanes.load(&block.radius));
        let side = |axis: usize, side: usize| {
            if side == 0 { lanes.sub(center[axis], radius) } else { lanes.add(center[axis], radius) }
        };
        let [near, far] = self.within(side, |limits| limits.beside);
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
        let by_margin = lanes.mul(lanes.add(radius, lanes.splat(local.radius + local.margin)), lanes.splat(4.0 * local.margin));
        let margin = lanes.times_plus(size, lanes.splat(32.0 * U), by_margin);
        bits & lanes.at_least(margin, apart)
    }
}
