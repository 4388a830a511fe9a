//! Leaves: blocks of eight triangles or spheres in single precision, and the conservative tests that find which of them a ray can
//! meet. `docs/acceleration.md` derives the margins.

use super::lanes::{Eight, Lanes};
use super::space::{LocalRay, Space, U, up};
use glam::DVec3;

/// How many primitives a block has room for.
pub(super) const BLOCK: usize = 8;

/// A kind of primitives that share blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u32)]
pub(super) enum Kind {
    Triangle,
    Sphere,
    Other,
}

impl Kind {
    /// How much of a block one takes. What shares no block has a place in a node, which costs as much.
    #[inline(always)]
    pub fn room(self) -> u32 {
        match self {
            Kind::Triangle | Kind::Sphere => 1,
            Kind::Other => BLOCK as u32,
        }
    }
}

/// What replaces a primitive in an unused lane.
const NOTHING: u32 = u32::MAX;

/// Eight triangles: a corner of each, and two edges from it.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub(super) struct TriangleBlock {
    pub(super) corner: [Eight; 3],
    pub(super) to_b: [Eight; 3],
    pub(super) to_c: [Eight; 3],
    primitives: [u32; 8],
    /// At least as long as each of these edges.
    pub(super) longest: f32,
}

/// Eight spheres.
#[derive(Clone, Debug)]
#[repr(C, align(32))]
pub(super) struct SphereBlock {
    pub(super) center: [Eight; 3],
    pub(super) radius: Eight,
    primitives: [u32; 8],
}

const _: () = assert!(size_of::<TriangleBlock>() <= 8 * 44 && size_of::<SphereBlock>() <= 8 * 20);

/// What blocks have in common.
pub(super) trait Block: Sized {
    /// What a lane is made of.
    type Form;

    /// The block of these primitives, eight at most.
    fn new(space: &Space, primitives: impl Iterator<Item = (u32, Self::Form)>) -> Self;

    /// The primitives of all lanes.
    fn primitives(&self) -> [u32; 8];

    /// The primitive of a lane.
    #[inline(always)]
    fn primitive(&self, lane: usize) -> u32 {
        self.primitives()[lane & 7]
    }

    /// A bit for each lane that is used.
    fn used(&self) -> u32 {
        let primitives = self.primitives();
        (0..8).fold(0, |bits, lane| bits | u32::from(primitives[lane] != NOTHING) << lane)
    }

    /// The primitives of the lanes that are used.
    fn used_primitives(&self) -> impl Iterator<Item = u32> {
        self.primitives().into_iter().filter(|primitive| *primitive != NOTHING)
    }

    /// The lanes that the ray may hit by `t_max`, and those that it certainly crosses between the two distances that `sure` gives, if it gives
    /// any.
    fn filtered<L: Lanes>(
        &self,
        lanes: L,
        ray: &LeafRay<L>,
        t_max: L::Eight,
        sure: &impl Fn() -> Option<[f32; 2]>,
    ) -> Sorted;
}

/// The lanes of a block that matter, a bit for each.
#[derive(Clone, Copy)]
pub(super) struct Sorted {
    /// Those that the ray may hit.
    pub possible: u32,
    /// Those of them that it certainly crosses.
    pub sure: u32,
}

impl Sorted {
    /// Lanes that may be hit, none certainly.
    pub const fn possible(bits: u32) -> Sorted {
        Sorted { possible: bits, sure: 0 }
    }
}

/// A ray, ready for the primitives of leaves.
#[derive(Clone, Copy)]
pub(super) struct LeafRay<L: Lanes> {
    pub origin: [L::Eight; 3],
    pub direction: [L::Eight; 3],
    pub t_min: L::Eight,
    pub slack: f32,
}

impl<L: Lanes> LeafRay<L> {
    #[inline(always)]
    pub fn new(lanes: L, ray: &LocalRay) -> LeafRay<L> {
        let splat = |numbers: [f32; 3]| numbers.map(|x| lanes.splat(x));
        let t_min = lanes.splat(ray.t_min);
        LeafRay { origin: splat(ray.origin), direction: splat(ray.direction), t_min, slack: ray.slack }
    }
}

/// Sets the lanes of some primitives, and says which they are.
fn lanes_of<F>(primitives: impl Iterator<Item = (u32, F)>, mut set: impl FnMut(usize, F)) -> [u32; 8] {
    let mut numbers = [NOTHING; 8];
    for (lane, (primitive, form)) in primitives.take(8).enumerate() {
        numbers[lane] = primitive;
        set(lane, form);
    }
    numbers
}

fn set(eights: &mut [Eight; 3], lane: usize, vector: DVec3) {
    for axis in 0..3 {
        eights[axis][lane] = vector[axis] as f32;
    }
}

/// Lanes that pass no test.
const UNUSED: [Eight; 3] = [[f32::NAN; 8]; 3];

impl Block for TriangleBlock {
    type Form = [DVec3; 3];

    fn new(space: &Space, primitives: impl Iterator<Item = (u32, [DVec3; 3])>) -> TriangleBlock {
        let (mut corner, mut to_b, mut to_c) = (UNUSED, UNUSED, UNUSED);
        let mut longest: f64 = 0.0;
        let primitives = lanes_of(primitives, |lane, [a, b, c]: [DVec3; 3]| {
            let [b, c] = [b, c].map(|end| DVec3::from_array((end - a).to_array().map(|x| space.length(x))));
            longest = longest.max(b.dot(b)).max(c.dot(c));
            set(&mut corner, lane, space.point(a));
            set(&mut to_b, lane, b);
            set(&mut to_c, lane, c);
        });
        TriangleBlock { corner, to_b, to_c, primitives, longest: up(longest.sqrt()) }
    }

    #[inline(always)]
    fn primitives(&self) -> [u32; 8] {
        self.primitives
    }

    /// Möller and Trumbore's test (1997) of the ray's line, and of the distance where the ray isn't along the triangle.
    #[inline(always)]
    fn filtered<L: Lanes>(
        &self,
        lanes: L,
        ray: &LeafRay<L>,
        t_max: L::Eight,
        sure: &impl Fn() -> Option<[f32; 2]>,
    ) -> Sorted {
        let load = |eights: &[Eight; 3]| [lanes.load(&eights[0]), lanes.load(&eights[1]), lanes.load(&eights[2])];
        let (corner, to_b, to_c) = (load(&self.corner), load(&self.to_b), load(&self.to_c));
        let seen: [_; 3] = std::array::from_fn(|axis| lanes.sub(ray.origin[axis], corner[axis]));
        let across = lanes.cross(ray.direction, to_c);
        let det = lanes.dot(to_b, across);
        let turned = lanes.cross(seen, to_b);
        let of_b = lanes.negated_as(lanes.dot(seen, across), det);
        let of_c = lanes.negated_as(lanes.dot(ray.direction, turned), det);
        let size = lanes.negated_as(det, det);
        let of_a = lanes.sub(lanes.sub(size, of_b), of_c);
        let (e, slack) = (self.longest, ray.slack);
        let margin = lanes.splat(-e * (OF_WEIGHT + 2.0 * slack + PARALLEL * e));
        let margin_a = lanes.splat(-e * (OF_LAST_WEIGHT + 4.0 * slack + (PARALLEL + 16.0 * U) * e));
        let inside = lanes.at_least(lanes.min(of_b, of_c), margin) & lanes.at_least(of_a, margin_a);
        if inside == 0 {
            return Sorted::possible(0);
        }
        let distance = lanes.negated_as(lanes.dot(to_c, turned), det);
        let e2 = e * e;
        let at = lanes.splat(e2 * (OF_DISTANCE + 2.0 * slack));
        let by_t = lanes.splat(e2 * PARALLEL);
        let size_of = |t| lanes.max(t, lanes.sub(lanes.splat(0.0), t));
        let lower = lanes.sub(lanes.sub(lanes.mul(size, ray.t_min), at), lanes.mul(by_t, size_of(ray.t_min)));
        let upper = lanes.add(lanes.add(lanes.mul(size, t_max), at), lanes.mul(by_t, size_of(t_max)));
        let within = lanes.at_least(distance, lower) & lanes.at_least(upper, distance);
        let possible = inside & (within | lanes.at_least(by_t, size));
        if possible == 0 {
            return Sorted::possible(0);
        }
        let sure = match sure() {
            Some([after, before]) => {
                // What errors may take on one side they may add on the other. Where the ray runs steeply, nothing here is an end of it.
                let minus = |x| lanes.sub(lanes.splat(0.0), x);
                let inside =
                    lanes.at_least(lanes.min(of_b, of_c), minus(margin)) & lanes.at_least(of_a, minus(margin_a));
                let at = lanes.splat(e2 * (OF_DISTANCE + 4.0 * slack));
                let [of_after, of_before] =
                    [after, before].map(|t| lanes.add(at, lanes.mul(by_t, lanes.splat(t.abs()))));
                let lower = lanes.times_plus(size, lanes.splat(after), of_after);
                let upper = lanes.times_minus(size, lanes.splat(before), of_before);
                let within = lanes.at_least(distance, lower) & lanes.at_least(upper, distance);
                inside & within & lanes.at_least(size, lanes.splat(e2 * STEEP))
            }
            None => 0,
        };
        Sorted { possible, sure: possible & sure }
    }
}

/// The part of the square of the longest edge that a determinant is at least, for a ray that certainly crosses a triangle.
const STEEP: f32 = 1.0 / 128.0;

/// The error of a weight, as a part of the longest edge.
const OF_WEIGHT: f32 = 50.0 * U;

/// The error of the weight that is the rest of the others.
const OF_LAST_WEIGHT: f32 = 112.0 * U;

/// The error of the distance times the determinant, as a part of the square of the longest edge.
const OF_DISTANCE: f32 = 48.0 * U;

/// The error of the determinant, as a part of the same, and more than it takes to turn its sign.
const PARALLEL: f32 = 22.0 * U;

impl Block for SphereBlock {
    type Form = (DVec3, f64);

    fn new(space: &Space, primitives: impl Iterator<Item = (u32, (DVec3, f64))>) -> SphereBlock {
        let (mut centers, mut radii) = (UNUSED, [f32::NAN; 8]);
        let primitives = lanes_of(primitives, |lane, (center, radius): (DVec3, f64)| {
            set(&mut centers, lane, space.point(center));
            radii[lane] = space.length(radius) as f32;
        });
        SphereBlock { center: centers, radius: radii, primitives }
    }

    #[inline(always)]
    fn primitives(&self) -> [u32; 8] {
        self.primitives
    }

    /// The chord by the way from the centre to the line (Haines et al., Ray Tracing Gems, chapter 7).
    #[inline(always)]
    fn filtered<L: Lanes>(
        &self,
        lanes: L,
        ray: &LeafRay<L>,
        t_max: L::Eight,
        sure: &impl Fn() -> Option<[f32; 2]>,
    ) -> Sorted {
        let seen: [_; 3] = std::array::from_fn(|axis| lanes.sub(lanes.load(&self.center[axis]), ray.origin[axis]));
        let middle = lanes.dot(seen, ray.direction);
        let way: [_; 3] = std::array::from_fn(|axis| lanes.less_times(seen[axis], middle, ray.direction[axis]));
        let radius = lanes.load(&self.radius);
        let r2 = lanes.mul(radius, radius);
        let off = 2.0 * (OF_CHORD_END + ray.slack) * (OF_CHORD_END + ray.slack);
        let by_radius = lanes.mul(radius, lanes.splat(2.0 * (OF_WAY + ray.slack)));
        let margin = lanes.add(lanes.times_plus(r2, lanes.splat(10.0 * U), by_radius), lanes.splat(off));
        let squared = lanes.add(lanes.sub(r2, lanes.dot(way, way)), margin);
        let zero = lanes.splat(0.0);
        let touched = lanes.at_least(squared, zero);
        if touched == 0 {
            return Sorted::possible(0);
        }
        let half = lanes.add(lanes.sqrt(lanes.max(squared, zero)), lanes.splat(OF_CHORD_END + ray.slack));
        let before = lanes.at_least(t_max, lanes.sub(middle, half));
        let behind = lanes.at_least(lanes.add(middle, half), ray.t_min);
        let possible = touched & before & behind;
        if possible == 0 {
            return Sorted::possible(0);
        }
        let sure = match sure() {
            Some([after, before]) => {
                // The chord is as long as this at least, and so much of the direction is along the normal at its ends that neither is an end
                // of the ray.
                let least = lanes.sub(squared, lanes.add(margin, margin));
                let steep = lanes.at_least(least, lanes.mul(r2, lanes.splat(STEEP_CHORD)));
                let short = lanes.sub(lanes.sqrt(lanes.max(least, zero)), lanes.splat(OF_CHORD_END + ray.slack));
                let off = 16.0 * (OF_CHORD_END + ray.slack);
                let (after, before) = (lanes.splat(after + off), lanes.splat(before - off));
                let is_between =
                    |from: L::Eight, to: L::Eight| lanes.at_least(from, after) & lanes.at_least(before, to);
                let first = is_between(lanes.sub(middle, half), lanes.sub(middle, short));
                let last = is_between(lanes.add(middle, short), lanes.add(middle, half));
                steep & (first | last)
            }
            None => 0,
        };
        Sorted { possible, sure: possible & sure }
    }
}

/// The part of the square of the radius that the square of half a chord is at least, for a ray that certainly crosses a sphere.
const STEEP_CHORD: f32 = 1.0 / 64.0;

/// The error of the way from the centre to the line, across the line.
const OF_WAY: f32 = 30.0 * U;

/// The error of the ends of the chord along the line.
const OF_CHORD_END: f32 = 80.0 * U;

impl PartialEq for TriangleBlock {
    fn eq(&self, other: &TriangleBlock) -> bool {
        let bits = |block: &TriangleBlock| [block.corner, block.to_b, block.to_c].map(|eights| eights.map(bits_of));
        self.primitives == other.primitives && bits(self) == bits(other)
    }
}

impl PartialEq for SphereBlock {
    fn eq(&self, other: &SphereBlock) -> bool {
        let bits = |block: &SphereBlock| (block.center.map(bits_of), bits_of(block.radius));
        self.primitives == other.primitives && bits(self) == bits(other)
    }
}

/// For comparing: what isn't a number equals itself.
fn bits_of(eight: Eight) -> [u32; 8] {
    eight.map(f32::to_bits)
}
