//! A shape that moves. The ray is carried into the shape's own frame, where the shape's kernel intersects it, and the surface is
//! carried back. A rigid motion keeps distances along the ray and the length of its direction.

use super::Shape;
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::motion::{Motion, Pose};
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Ray, Surface};
use crate::log::Step;
use crate::probe::{Probe, Silent};

/// A shape with its motion, in a scene of which the shutter is open for some time.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving {
    shape: Shape,
    motion: Motion,
    object: u32,
    bounds: Option<Bounds>,
}

impl Moving {
    /// The shape of object `object`, which moves; rays have times between the shutter's opening and its closing.
    pub fn new(shape: Shape, motion: Motion, object: u32, shutter: [f64; 2]) -> Moving {
        let bounds = shape.bounds().map(|bounds| motion.sweep(bounds.widened(), shutter));
        Moving { shape, motion, object, bounds }
    }

    /// The shape in its own frame, where it is at time 0.
    pub fn shape(&self) -> &Shape {
        &self.shape
    }

    /// Where it is at a time.
    pub fn at<P: Probe>(&self, time: f64, probe: &mut P) -> Pose {
        self.motion.at(time, probe)
    }

    /// A box around the shape at all times of the shutter; `None` for one without end.
    pub fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    /// Shows `nearest` the points where the ray crosses the object that may be its nearest crossing.
    #[inline(never)]
    pub fn nearest<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, nearest: &mut Nearest, probe: &mut P) {
        let found = self.in_own_frame(ray, probe, |own, probe| {
            let mut found = Nearest::of(own);
            self.shape.nearest(object, one_sided, own, &mut found, probe);
            found
        });
        // How close crossings are is decided in the scene, together with those of other objects.
        nearest.join(found, ray, probe);
    }

    /// Shows the log the crossing of a ray that begins on the object and goes through it.
    #[inline(never)]
    pub fn touch<P: Probe>(&self, object: u32, primitive: u32, ray: &Ray, probe: &mut P) {
        self.in_own_frame(ray, probe, |own, probe| self.shape.touch(object, primitive, own, probe));
    }

    /// The size of the numbers that define the surface and where it is.
    pub fn size(&self, primitive: u32) -> f64 {
        self.shape.size(primitive) + self.bounds.map_or(0.0, Bounds::size) + self.motion.size()
    }

    /// Whether the ray crosses the object at all.
    #[inline(never)]
    pub fn is_crossed<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, probe: &mut P) -> bool {
        self.in_own_frame(ray, probe, |own, probe| self.shape.is_crossed(object, one_sided, own, probe))
    }

    /// All points where the ray crosses the object, in the order of the ray.
    #[inline(never)]
    pub fn all_crossings<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        found: &mut Vec<Crossing>,
        probe: &mut P,
    ) {
        self.in_own_frame(ray, probe, |own, probe| self.shape.all_crossings(object, one_sided, own, found, probe));
    }

    /// The surface at a crossing, its normals turned toward the arriving ray.
    #[inline(never)]
    pub fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let (pose, own) = probe.within(Step::Motion { object: self.object }, |probe| {
            let pose = self.motion.at(ray.time, probe);
            let own = pose.own_ray(ray, probe);
            probe.given(crate::log::Name::RayOrigin, own.origin);
            probe.given(crate::log::Name::RayDirection, own.direction);
            (pose, self.shape.surface(&own, crossing, probe))
        });
        pose.surface(own, probe)
    }

    /// The distance of a crossing as exactly as the shape can compute it.
    pub(super) fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        let own = self.motion.at(ray.time, &mut Silent).own_ray(ray, &mut Silent);
        self.shape.refined(&own, crossing)
    }

    fn in_own_frame<P: Probe, T>(&self, ray: &Ray, probe: &mut P, meet: impl FnOnce(&Ray, &mut P) -> T) -> T {
        probe.within(Step::Motion { object: self.object }, |probe| {
            let pose = self.motion.at(ray.time, probe);
            let own = pose.own_ray(ray, probe);
            meet(&own, probe)
        })
    }
}
