//! A shape that moves. The ray is carried into the shape's own frame, where the shape's kernel intersects it, and the surface is
//! carried back. A rigid motion keeps distances along the ray and the length of its direction.

use super::intersect::{Intersect, Target};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::line::RaySource;
use crate::geometry::motion::{Motion, Pose};
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Name, Step};
use crate::probe::{Probe, Silent};

/// A shape with its motion, in a scene of which the shutter is open for some time.
#[derive(Clone, Debug, PartialEq)]
pub struct Moving<S> {
    shape: S,
    motion: Motion,
    object: u32,
    bounds: Option<Bounds>,
}

impl<S: Intersect> Moving<S> {
    /// The shape of object `object`, which moves; rays have times between the shutter's opening and its closing.
    pub fn new(shape: S, motion: Motion, object: u32, shutter: [f64; 2]) -> Moving<S> {
        let bounds = shape.bounds().map(|bounds| motion.sweep(bounds.widened(), shutter));
        Moving { shape, motion, object, bounds }
    }

    /// The shape in its own frame, where it is at time 0.
    pub fn shape(&self) -> &S {
        &self.shape
    }

    /// Where it is at a time.
    pub fn at<P: Probe>(&self, time: f64, probe: &mut P) -> Pose {
        self.motion.at(time, probe)
    }

    fn in_own_frame<P: Probe, T>(&self, ray: &Ray, probe: &mut P, meet: impl FnOnce(&Ray, &mut P) -> T) -> T {
        probe.within(Step::Motion { object: self.object }, |probe| {
            let pose = self.motion.at(ray.time, probe);
            let own = pose.own_ray(ray, probe);
            meet(&own, probe)
        })
    }
}

impl<S: Intersect> Intersect for Moving<S> {
    #[inline(never)]
    fn nearest<P: Probe>(&self, target: Target, ray: &Ray, nearest: &mut Nearest, probe: &mut P) {
        let found = self.in_own_frame(ray, probe, |own, probe| {
            let mut found = Nearest::of(own);
            self.shape.nearest(target, own, &mut found, probe);
            found
        });
        // How close crossings are is decided in the scene, together with those of other objects.
        nearest.join(found, ray, probe);
    }

    #[inline(never)]
    fn is_crossed<P: Probe>(&self, target: Target, source: &impl RaySource, probe: &mut P) -> bool {
        self.in_own_frame(source.ray(), probe, |own, probe| self.shape.is_crossed(target, own, probe))
    }

    #[inline(never)]
    fn all_crossings<P: Probe>(&self, target: Target, ray: &Ray, found: &mut Vec<Crossing>, probe: &mut P) {
        self.in_own_frame(ray, probe, |own, probe| self.shape.all_crossings(target, own, found, probe));
    }

    #[inline(never)]
    fn touch<P: Probe>(&self, target: Target, primitive: u32, ray: &Ray, probe: &mut P) {
        self.in_own_frame(ray, probe, |own, probe| self.shape.touch(target, primitive, own, probe));
    }

    #[inline(never)]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        let (pose, own) = probe.within(Step::Motion { object: self.object }, |probe| {
            let pose = self.motion.at(ray.time, probe);
            let own = pose.own_ray(ray, probe);
            probe.given(Name::RayOrigin, own.origin);
            probe.given(Name::RayDirection, own.direction);
            (pose, self.shape.surface(&own, crossing, probe))
        });
        pose.surface(own, probe)
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        let own = self.motion.at(ray.time, &mut Silent).own_ray(ray, &mut Silent);
        self.shape.refined(&own, crossing)
    }

    /// A box around the shape at all times of the shutter.
    fn bounds(&self) -> Option<Bounds> {
        self.bounds
    }

    fn size(&self, primitive: u32) -> f64 {
        self.shape.size(primitive) + self.bounds.map_or(0.0, Bounds::size) + self.motion.size()
    }

    fn can_self_intersect(&self, sets_off: Side) -> bool {
        self.shape.can_self_intersect(sets_off)
    }
}
