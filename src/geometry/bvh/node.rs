//! A node of the tree: eight boxes and what is in them.

use super::lanes::{Eight, Lanes};
use super::space::{LocalRay, OF_BOX, U, down, up};
use glam::DVec3;

/// What a box holds: two bits for the kind, the others for a place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Child(u32);

/// What a box holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Content {
    /// A node with this number.
    Node(u32),
    /// A block of triangles with this number.
    Triangles(u32),
    /// A block of spheres with this number.
    Spheres(u32),
    /// This very primitive.
    Primitive(u32),
}

impl Child {
    const PLACE: u32 = (1 << 30) - 1;

    /// Of a content whose number is less than 2³⁰.
    pub fn new(content: Content) -> Child {
        let (kind, place) = match content {
            Content::Node(place) => (0, place),
            Content::Triangles(place) => (1, place),
            Content::Spheres(place) => (2, place),
            Content::Primitive(place) => (3, place),
        };
        debug_assert!(place <= Child::PLACE);
        Child(kind << 30 | place)
    }

    #[inline(always)]
    pub fn content(self) -> Content {
        let place = self.0 & Child::PLACE;
        match self.0 >> 30 {
            0 => Content::Node(place),
            1 => Content::Triangles(place),
            2 => Content::Spheres(place),
            _ => Content::Primitive(place),
        }
    }

    /// The same child of a tree that others come before.
    pub fn moved(self, before: [u32; 3]) -> Child {
        match self.content() {
            Content::Node(place) => Child::new(Content::Node(place + before[0])),
            Content::Triangles(place) => Child::new(Content::Triangles(place + before[1])),
            Content::Spheres(place) => Child::new(Content::Spheres(place + before[2])),
            Content::Primitive(_) => self,
        }
    }
}

/// A box in single precision, rounded outward.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Box32 {
    pub min: [f32; 3],
    pub max: [f32; 3],
}

impl Box32 {
    /// Of bounds in the tree's space.
    pub fn around(min: DVec3, max: DVec3) -> Box32 {
        Box32 { min: min.to_array().map(down), max: max.to_array().map(up) }
    }
}

/// Eight boxes and what is in them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(32))]
pub(super) struct Node {
    /// By axis: the least coordinates of the boxes, and the greatest.
    pub(super) planes: [[Eight; 2]; 3],
    children: [Child; 8],
}

/// A ray, ready for the boxes of nodes.
#[derive(Clone, Copy)]
pub(super) struct BoxRay<L: Lanes> {
    pub inverse: [L::Eight; 3],
    pub near: [L::Eight; 3],
    pub far: [L::Eight; 3],
    pub near_side: [usize; 3],
    pub t_min: L::Eight,
}

/// Several rays whose directions have the same signs, ready for the boxes of nodes.
#[derive(Clone, Copy)]
pub(super) struct Frustum<L: Lanes> {
    /// By axis: the least and the greatest of 1 over the component of the direction.
    inverse: [[L::Eight; 2]; 3],
    /// By axis: the coordinate among those of the origins that is farthest toward the near sides of boxes, and toward the far ones.
    origin: [[L::Eight; 2]; 3],
    /// How much earlier than computed a box may be entered, and later left, by axis.
    around: [L::Eight; 3],
    near_side: [usize; 3],
    t_min: L::Eight,
}

impl<L: Lanes> Frustum<L> {
    /// Of rays with these ranges of origins and of 1 over the components of their directions.
    #[inline(always)]
    pub fn new(
        lanes: L,
        origins: [[f32; 2]; 3],
        inverses: [[f32; 2]; 3],
        near_side: [usize; 3],
        slack: f32,
        t_min: f32,
    ) -> Frustum<L> {
        let splat = |[one, other]: [f32; 2]| [lanes.splat(one), lanes.splat(other)];
        let toward = |axis: usize| {
            let [least, greatest] = origins[axis];
            splat(if near_side[axis] == 0 { [greatest, least] } else { [least, greatest] })
        };
        let around = |axis: usize| {
            let [least, greatest] = inverses[axis];
            lanes.splat(least.abs().max(greatest.abs()) * (OF_BOX + slack) * (1.0 + 8.0 * U))
        };
        Frustum {
            inverse: [splat(inverses[0]), splat(inverses[1]), splat(inverses[2])],
            origin: [toward(0), toward(1), toward(2)],
            around: [around(0), around(1), around(2)],
            near_side,
            t_min: lanes.splat(t_min),
        }
    }
}

impl<L: Lanes> BoxRay<L> {
    #[inline(always)]
    pub fn new(lanes: L, ray: &LocalRay) -> BoxRay<L> {
        let splat = |numbers: [f32; 3]| numbers.map(|x| lanes.splat(x));
        BoxRay {
            inverse: splat(ray.inverse),
            near: splat(ray.near),
            far: splat(ray.far),
            near_side: ray.near_side,
            t_min: lanes.splat(ray.t_min),
        }
    }
}

/// Which boxes of a node a ray enters, a bit for each, and where.
pub(super) struct Entered<E> {
    pub bits: u32,
    pub near: E,
}

impl Node {
    /// A node without any box.
    pub const EMPTY: Node = Node { planes: [[[f32::INFINITY; 8], [f32::NEG_INFINITY; 8]]; 3], children: [Child(0); 8] };

    /// Fills a lane.
    pub fn set(&mut self, lane: usize, around: &Box32, child: Child) {
        for axis in 0..3 {
            self.planes[axis][0][lane] = around.min[axis];
            self.planes[axis][1][lane] = around.max[axis];
        }
        self.children[lane] = child;
    }

    #[inline(always)]
    pub fn child(&self, lane: usize) -> Child {
        self.children[lane & 7]
    }

    /// What is in its boxes.
    pub fn children(&self) -> impl Iterator<Item = Child> {
        let is_used = |lane: &usize| self.planes[0][0][*lane] < f32::INFINITY;
        (0..8).filter(is_used).map(|lane| self.children[lane])
    }

    /// Moves the node behind others.
    pub fn moved(mut self, before: [u32; 3]) -> Node {
        self.children = self.children.map(|child| child.moved(before));
        self
    }

    /// The boxes that the ray enters by `t_max`. Errs on the side of entering.
    #[inline(always)]
    pub fn entered<L: Lanes>(&self, lanes: L, ray: &BoxRay<L>, t_max: L::Eight) -> Entered<L::Eight> {
        let to = |axis: usize, side: usize, center| {
            let plane = lanes.load(&self.planes[axis][side & 1]);
            lanes.times_minus(plane, ray.inverse[axis], center)
        };
        let [x, y, z] = ray.near_side;
        let (near_x, near_y, near_z) = (to(0, x, ray.near[0]), to(1, y, ray.near[1]), to(2, z, ray.near[2]));
        let (far_x, far_y, far_z) = (to(0, x ^ 1, ray.far[0]), to(1, y ^ 1, ray.far[1]), to(2, z ^ 1, ray.far[2]));
        let near = lanes.max(lanes.max(near_x, near_y), lanes.max(near_z, ray.t_min));
        let far = lanes.min(lanes.min(far_x, far_y), lanes.min(far_z, t_max));
        Entered { bits: lanes.at_least(far, near), near }
    }

    /// The boxes that any of these rays can enter by `t_max`, and before where they don't. Errs on the side of entering.
    #[inline(always)]
    pub fn entered_by_some<L: Lanes>(&self, lanes: L, rays: &Frustum<L>, t_max: L::Eight) -> Entered<L::Eight> {
        let to = |axis: usize, side: usize, which: usize| {
            let plane = lanes.load(&self.planes[axis][side & 1]);
            let way = lanes.sub(plane, rays.origin[axis][which]);
            [lanes.mul(way, rays.inverse[axis][0]), lanes.mul(way, rays.inverse[axis][1])]
        };
        let near = |axis: usize| {
            let [one, other] = to(axis, rays.near_side[axis], 0);
            lanes.sub(lanes.min(one, other), rays.around[axis])
        };
        let far = |axis: usize| {
            let [one, other] = to(axis, rays.near_side[axis] ^ 1, 1);
            lanes.add(lanes.max(one, other), rays.around[axis])
        };
        let near = lanes.max(lanes.max(near(0), near(1)), lanes.max(near(2), rays.t_min));
        let far = lanes.min(lanes.min(far(0), far(1)), lanes.min(far(2), t_max));
        Entered { bits: lanes.at_least(far, near), near }
    }

    /// Which of eight rays, one in each lane, enter the box in this lane of the node by `t_max`. Errs on the side of entering.
    #[inline(always)]
    pub fn entering<L: Lanes>(&self, lanes: L, lane: usize, rays: &BoxRay<L>, t_max: L::Eight) -> u32 {
        let to = |axis: usize, side: usize, center| {
            let plane = lanes.splat(self.planes[axis][side & 1][lane & 7]);
            lanes.times_minus(plane, rays.inverse[axis], center)
        };
        let near = |axis: usize| to(axis, rays.near_side[axis], rays.near[axis]);
        let far = |axis: usize| to(axis, rays.near_side[axis] ^ 1, rays.far[axis]);
        let near = lanes.max(lanes.max(near(0), near(1)), lanes.max(near(2), rays.t_min));
        let far = lanes.min(lanes.min(far(0), far(1)), lanes.min(far(2), t_max));
        lanes.at_least(far, near)
    }
}
