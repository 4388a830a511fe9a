//! STUB.

use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::ray::{Crossing, Ray, Surface};
use crate::probe::Probe;
use glam::DVec3;

/// STUB.
#[derive(Clone, Debug, PartialEq)]
pub struct Cone {}

impl Cone {
    /// STUB.
    pub fn new(_base: (DVec3, f64), _apex: (DVec3, f64), _caps: bool, _inward: bool) -> Cone {
        todo!()
    }
}

impl Kernel for Cone {
    fn give<P: Probe>(&self, _probe: &mut P) {
        todo!()
    }

    fn first_crossing<P: Probe>(&self, _ray: &Ray, _approach: Approach, _probe: &mut P) -> Option<Crossing> {
        todo!()
    }

    fn surface<P: Probe>(&self, _ray: &Ray, _crossing: Crossing, _probe: &mut P) -> Surface {
        todo!()
    }

    fn bounds(&self) -> Option<Bounds> {
        todo!()
    }
}
