//! STUB.

use super::{Approach, Kernel};
use crate::geometry::bounds::Bounds;
use crate::geometry::ray::{Crossing, Ray, Surface};
use crate::probe::Probe;

/// STUB.
#[derive(Clone, Debug, PartialEq)]
pub struct Triangle {}

impl Triangle {
    /// STUB.
    pub fn new(_vertices: [[f64; 3]; 3], _normals: Option<[[f64; 3]; 3]>) -> Triangle {
        todo!()
    }
}

impl Kernel for Triangle {
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
