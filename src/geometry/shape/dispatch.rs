//! From a shape to the code of its kind.

use super::Shape;
use super::intersect::{Intersect, Target};
use crate::geometry::bounds::Bounds;
use crate::geometry::doubled::Doubled;
use crate::geometry::line::RaySource;
use crate::geometry::nearest::Nearest;
use crate::geometry::ray::{Crossing, Ray, Side, Surface};
use crate::probe::Probe;

/// Does the same with a shape of any kind.
macro_rules! dispatch {
    ($shape:expr, $any:ident => $call:expr) => {
        match $shape {
            Shape::Plane($any) => $call,
            Shape::Sphere($any) => $call,
            Shape::Ellipsoid($any) => $call,
            Shape::Triangle($any) => $call,
            Shape::Polygon($any) => $call,
            Shape::Cuboid($any) => $call,
            Shape::Cylinder($any) => $call,
            Shape::Cone($any) => $call,
            Shape::Disk($any) => $call,
            Shape::Mesh($any) => $call,
            Shape::Moving($any) => $call,
        }
    };
}

impl Intersect for Shape {
    #[inline(always)]
    fn nearest<P: Probe>(&self, target: Target, ray: &Ray, nearest: &mut Nearest, probe: &mut P) {
        dispatch!(self, shape => shape.nearest(target, ray, nearest, probe));
    }

    #[inline(always)]
    fn is_crossed<P: Probe>(&self, target: Target, source: &impl RaySource, probe: &mut P) -> bool {
        dispatch!(self, shape => shape.is_crossed(target, source, probe))
    }

    #[inline(always)]
    fn all_crossings<P: Probe>(&self, target: Target, ray: &Ray, found: &mut Vec<Crossing>, probe: &mut P) {
        dispatch!(self, shape => shape.all_crossings(target, ray, found, probe));
    }

    fn touch<P: Probe>(&self, target: Target, primitive: u32, ray: &Ray, probe: &mut P) {
        dispatch!(self, shape => shape.touch(target, primitive, ray, probe));
    }

    #[inline(always)]
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        dispatch!(self, shape => shape.surface(ray, crossing, probe))
    }

    fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        dispatch!(self, shape => shape.refined(ray, crossing))
    }

    fn bounds(&self) -> Option<Bounds> {
        dispatch!(self, shape => shape.bounds())
    }

    fn size(&self, primitive: u32) -> f64 {
        dispatch!(self, shape => shape.size(primitive))
    }

    fn can_self_intersect(&self, sets_off: Side) -> bool {
        dispatch!(self, shape => shape.can_self_intersect(sets_off))
    }
}
