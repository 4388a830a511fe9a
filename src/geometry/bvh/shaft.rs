//! Shafts: what can lie on any of the segments from a point to a light, found by one walk through the tree. `docs/acceleration.md` derives
//! the margins.

mod lanes;

use super::block::Block;
use super::lanes::{Instructions, Lanes};
use super::node::{Child, Content};
use super::space::{Space, U, up};
use super::{Bounds, Bvh};
use arrayvec::ArrayVec;
use glam::{BVec4A, DVec3, Vec3, Vec4};
use lanes::LaneShaft;

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

/// A walk looks at this many nodes before it gives up: proving that nothing is in the way isn't worth more.
const MOST_NODES: usize = 24;

/// The children that wait, at most.
const STACK: usize = 7 * MOST_NODES + 1;

/// The least rise along a normal that counts, as a part of all coordinates that it is made of: far more than all roundings.
const LEAST_RISE: f64 = 1e-6;

impl Shaft {
    /// The segments from a point to the points of a light, which lies in a box and in a ball but for 10⁻⁹ of their sizes.
    pub fn new(point: DVec3, light: Bounds, (center, radius): (DVec3, f64)) -> Shaft {
        const OFF: f64 = 1e-9;
        let off = (light.max - light.min) * OFF;
        let light = Bounds { min: light.min - off, max: light.max + off };
        Shaft { point, light, ball: (center, radius * (1.0 + OFF)), rise: None }
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
    /// Shows `found` every primitive that may meet a segment of the shaft, those beside the tree first; `found` says whether to go on. Returns
    /// whether all were shown.
    ///
    /// Pictures and counts depend on what is found, so no operation is fused, which not every machine can do.
    pub fn between(&self, shaft: &Shaft, mut found: impl FnMut(u32) -> bool) -> bool {
        if !self.beside.iter().all(|primitive| found(*primitive)) {
            return false;
        }
        let Some(root) = self.root else { return true };
        let Some(errors) = Errors::of(&self.space, shaft) else { return false };
        let local = LocalShaft::new(&self.space, shaft, errors);
        match self.instructions {
            #[cfg(target_arch = "x86_64")]
            Instructions::Avx2(avx2) => avx2.run(
                #[inline(always)]
                || self.walk_shaft(avx2.unfused(), root, &local, found),
            ),
            Instructions::Plain(plain) => self.walk_shaft(plain, root, &local, found),
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
            let (bits, primitives) = match child.content() {
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
                    (shaft.triangles(block), block.primitives())
                }
                Content::Spheres(number) => {
                    let block = &self.spheres[number as usize];
                    (shaft.spheres(block), block.primitives())
                }
                Content::Primitive(primitive) => (1, [primitive; 8]),
            };
            let mut bits = bits;
            while bits != 0 {
                if !found(primitives[bits.trailing_zeros() as usize & 7]) {
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

/// With a greater margin boxes exclude nothing.
const WIDEST: f64 = 1.0 / 64.0;

/// The longest way of a light that is looked for.
const LONGEST: f64 = 1e15;

/// The least part of the square of a ball's distance that is left without the square of its radius.
const NEAREST: f32 = 1.0 / 64.0;

/// The least component of a way.
const LEAST: f32 = 1e-18;

/// A bound of the part of the way at which the shaft meets a box, by axis: x·inverse − shift for a coordinate x of the box, x·inverse − beside
/// for one that is counted from P on.
#[derive(Clone, Copy)]
struct Limit {
    inverse: [f32; 4],
    shift: [f32; 4],
    beside: [f32; 4],
}

/// The bounds for a side of boxes, of which one is none: no part of the way before `near` meets the box, nor one beyond `far`.
struct Limits {
    near: Limit,
    far: Limit,
}

/// A shaft in the tree's space. What it holds at the part s of the way, from 0 to 1, lies in the box from P + s·l to P + s·h.
struct LocalShaft {
    /// P
    from: [f32; 3],
    /// How far something that is hit may lie beside the shaft, with all roundings.
    margin: f32,
    /// Of the sides with lesser coordinates.
    lesser: Limits,
    /// Of the sides with greater coordinates.
    greater: Limits,
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
    /// How long the way is, at most.
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

/// How far rounding moves something that is hit: in f64, and with single precision.
struct Errors {
    off: f64,
    margin: f64,
}

impl Errors {
    /// `None` where the point or the light is so far away that all may hit anything.
    #[inline(always)]
    fn of(space: &Space, shaft: &Shaft) -> Option<Errors> {
        let scale = space.length(1.0);
        let from = space.point(shaft.point).abs();
        let way =
            (shaft.light.min - shaft.point).abs().max((shaft.light.max - shaft.point).abs()).element_sum() * scale;
        let off = ROUNDINGS * (from.element_sum() + way + shaft.point.abs().element_sum() * scale + 8.0);
        let margin = OF_PLACE * (1.0 + from.max_element()) + 2.0 * off;
        (margin < WIDEST && way < LONGEST).then_some(Errors { off, margin })
    }
}

impl LocalShaft {
    #[inline(always)]
    fn new(space: &Space, shaft: &Shaft, Errors { off, margin }: Errors) -> LocalShaft {
        let scale = space.length(1.0);
        let from = space.point(shaft.point);
        let [low, high] = [shaft.light.min, shaft.light.max].map(|end| (end - shaft.point) * scale);
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
        let [lesser, greater] = limits(from, margin, low, high);
        LocalShaft {
            from: from.to_array(),
            margin,
            lesser,
            greater,
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
        }
    }
}

/// The limits of the sides of boxes with lesser and with greater coordinates. A side x bounds the part s of the way by s·h ≥ x − P − m where it
/// is the lesser one, by s·l ≤ x − P + m where it is the greater one.
#[inline(always)]
fn limits(from: Vec3, margin: f32, low: Vec3, high: Vec3) -> [Limits; 2] {
    let (low, high, from, margin) = (low.extend(-1.0), high.extend(1.0), from.extend(0.0), Vec4::splat(margin));
    // Outward, so that none is 0.
    let least = Vec4::splat(LEAST);
    let low = Vec4::select(low.abs().cmplt(least), -least, low);
    let high = Vec4::select(high.abs().cmplt(least), least, high);
    let limit = |is_one: BVec4A, way: Vec4, margin: Vec4, none: f32| {
        let inverse = Vec4::ONE / way;
        let or_none = |x: Vec4, none: f32| Vec4::select(is_one, x, Vec4::splat(none)).to_array();
        Limit {
            inverse: or_none(inverse, 0.0),
            shift: or_none((from + margin) * inverse, none),
            beside: or_none(margin * inverse, none),
        }
    };
    let (never_near, never_far) = (f32::INFINITY, f32::NEG_INFINITY);
    let (is_up, is_down) = (high.cmpgt(Vec4::ZERO), low.cmplt(Vec4::ZERO));
    [
        Limits { near: limit(is_up, high, margin, never_near), far: limit(!is_up, high, margin, never_far) },
        Limits { near: limit(is_down, low, -margin, never_near), far: limit(!is_down, low, -margin, never_far) },
    ]
}
