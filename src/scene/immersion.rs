//! Which media hold the point where a ray begins.

use super::{Camera, Object, Scene};
use crate::geometry::{Intersect, Ray, Side, Target};
use crate::probe::{Probe, Silent};
use glam::DVec3;

/// The media that hold the eye.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum AroundEye {
    /// None.
    #[default]
    Nothing,
    /// These objects, the innermost last.
    Objects(Vec<u32>),
    /// It depends on the ray: the eye is a lens, or something transmitting moves.
    EachRay,
}

impl AroundEye {
    /// What holds the eye of a scene with this camera and these objects.
    pub fn of(camera: &Camera, objects: &[Object]) -> AroundEye {
        let mut media = objects.iter().filter(|object| object.inside.is_some()).peekable();
        if media.peek().is_none() {
            return AroundEye::Nothing;
        }
        if camera.lens.is_some() || media.any(|object| object.shape.is_moving()) {
            return AroundEye::EachRay;
        }
        match holding(objects, &Ray::along(camera.position(), camera.direction())) {
            held if held.is_empty() => AroundEye::Nothing,
            held => AroundEye::Objects(held),
        }
    }
}

impl Scene {
    /// The objects whose media hold the origin of a ray, the innermost last: in the order in which the ray leaves them, the first
    /// last. Of several that it leaves in one place the later in the scene is the inner one.
    pub fn media_around(&self, ray: &Ray) -> Vec<u32> {
        holding(&self.objects, ray)
    }
}

fn holding(objects: &[Object], ray: &Ray) -> Vec<u32> {
    let exit = |(number, object): (u32, &Object)| Some((exit(object, number, ray)?, number));
    let mut held: Vec<(f64, u32)> = (0..).zip(objects).filter_map(exit).collect();
    held.sort_by(|(one, _), (other, _)| other.total_cmp(one));
    // Coincident exits are ordered as in the scene, which the roundings of their distances may have changed.
    let is_close = |(far, _): &(f64, u32), (near, _): &(f64, u32)| {
        let size = 2.0 * (ray.origin.abs().element_sum() + near);
        far == near || far - near <= Silent.slack(size)
    };
    held.chunk_by_mut(is_close).for_each(|place| place.sort_by_key(|(_, number)| *number));
    held.into_iter().map(|(_, number)| number).collect()
}

/// How far along the ray an object is left whose medium holds the origin; infinite if the ray never leaves it. `None` where it doesn't
/// hold it.
fn exit(object: &Object, number: u32, ray: &Ray) -> Option<f64> {
    let inside = object.inside?;
    let first = |direction: DVec3| {
        let along = Ray { time: ray.time, ..Ray::along(ray.origin, direction) };
        object.shape.first_crossing(Target::two_sided(number), &along, &mut Silent)
    };
    let is_left = |side: Side| side == inside;
    if let Some(crossing) = first(ray.vector) {
        return is_left(crossing.side).then_some(crossing.t);
    }
    // A half space may hold a ray that never leaves it. Some other way meets its plane.
    let is_endless = object.shape.bounds().is_none();
    let ways = [-ray.vector, DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let crossing = ways.into_iter().filter(|_| is_endless).find_map(first)?;
    is_left(crossing.side).then_some(f64::INFINITY)
}
