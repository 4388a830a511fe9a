//! Rays by their origins and directions of any length.

use crate::geometry::Ray;
use crate::geometry::unit::middling;
use crate::log::{Decision, Name};
use crate::probe::Probe;
use glam::DVec3;

/// A ray that is asked for by its origin and its direction, of any length.
pub fn ray_along<P: Probe>(origin: DVec3, vector: DVec3, probe: &mut P) -> Option<Ray> {
    probe.given(Name::RayOrigin, origin);
    probe.given(Name::RayVector, vector);
    along(origin, vector, probe)
}

/// The ray from `origin` along `vector`, which is normalised (Ramos, section 1.3, step 1); `None` where an arithmetic of few
/// digits makes nothing of its length.
#[inline(always)]
pub(super) fn along<P: Probe>(origin: DVec3, vector: DVec3, probe: &mut P) -> Option<Ray> {
    let length = probe.note(Name::RayLength, probe.dot(vector, vector).sqrt());
    if length == 0.0 {
        probe.mark(Decision::Undefined { quantity: Name::RayDirection });
        return None;
    }
    let unit = vector / length;
    let direction = probe.note(Name::RayDirection, unit);
    // An arithmetic that goes on with another direction is to go on with that one only.
    let vector = if direction == unit { middling(vector) } else { direction };
    Some(Ray { vector, ..Ray::new(origin, direction) })
}
