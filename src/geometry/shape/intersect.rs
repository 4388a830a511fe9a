//! What rays ask of the shape of an object, whatever it is made of.

use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::line::RaySource;
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::probe::Probe;

/// The object whose shape is tested with a ray.
// Two numbers, which are handed on in registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Target {
    /// The object, by its number in the scene.
    pub object: u32,
    /// Whether its surface is absent for rays that arrive at its back.
    pub one_sided: bool,
}

impl Target {
    /// An object with this number, whose surface is there from both sides.
    pub const fn two_sided(object: u32) -> Target {
        Target { object, one_sided: false }
    }
}

/// A shape that rays are tested with. A [`Kernel`](super::Kernel) is one surface with one test; a mesh has a test for each triangle; a moving
/// shape carries the ray into its own frame first.
pub trait Intersect {
    /// Shows `nearest` the points where the ray crosses the target that may be its nearest crossing.
    fn nearest<P: Probe>(&self, target: Target, ray: &Ray, nearest: &mut Nearest, probe: &mut P);

    /// Whether the ray crosses the target at all.
    fn is_crossed<P: Probe>(&self, target: Target, source: &impl RaySource, probe: &mut P) -> bool;

    /// Adds all points where the ray crosses the target, in the order of the ray.
    fn all_crossings<P: Probe>(&self, target: Target, ray: &Ray, found: &mut Vec<Crossing>, probe: &mut P);

    /// Shows the log the crossing of a ray that begins on this primitive of the target and goes through it.
    fn touch<P: Probe>(&self, target: Target, primitive: u32, ray: &Ray, probe: &mut P);

    /// The surface at a crossing, its normals turned toward the arriving ray.
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface;

    /// The distance of a crossing as exactly as the shape can compute it, to order crossings that f64 can't.
    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled;

    /// A box around the shape; `None` for one without end.
    fn bounds(&self) -> Option<Bounds>;

    /// The size of the numbers that define this primitive of the surface, and where it is: their roundings move it.
    fn size(&self, primitive: u32) -> f64;

    /// Whether a ray that sets off on this side of the surface can hit the same surface again (self-intersection).
    fn can_self_intersect(&self, sets_off: Side) -> bool;
}
