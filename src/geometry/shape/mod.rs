//! The shapes. Each has its own file; adding one is that file, a variant here, and its arms.

mod plane;
mod sphere;

pub use plane::Plane;
pub use sphere::{Sphere, SphereMethod};

use super::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Step};
use crate::probe::Probe;

/// A surface that rays meet.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// An infinite plane.
    Plane(Plane),
    /// A sphere.
    Sphere(Sphere),
}

impl Shape {
    /// The first point where the ray crosses object `object` of this shape.
    pub fn first_crossing<P: Probe>(&self, object: u32, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        let leaving = self.side_left(object, ray);
        if leaving.is_some_and(|side| !self.can_be_met_again(side)) {
            return None;
        }
        self.give(probe);
        probe.within(Step::Test { object, triangle: None }, |probe| match self {
            Shape::Plane(plane) => plane.crossing(ray, probe),
            Shape::Sphere(sphere) => sphere.first_crossing(ray, leaving, probe),
        })
    }

    /// All points where the ray crosses the object, at most two, in the order of the ray.
    // Rare beside `first_crossing`, which runs faster without it in the same loop.
    #[inline(never)]
    pub fn all_crossings<P: Probe>(&self, object: u32, ray: &Ray, probe: &mut P) -> [Option<Crossing>; 2] {
        let leaving = self.side_left(object, ray);
        if leaving.is_some_and(|side| !self.can_be_met_again(side)) {
            return [None; 2];
        }
        self.give(probe);
        probe.within(Step::Test { object, triangle: None }, |probe| match self {
            Shape::Plane(plane) => [plane.crossing(ray, probe), None],
            Shape::Sphere(sphere) => sphere.all_crossings(ray, leaving, probe),
        })
    }

    /// The surface at a crossing, its normal turned toward the arriving ray.
    pub fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        match self {
            Shape::Plane(plane) => plane.surface(ray, crossing, probe),
            Shape::Sphere(sphere) => sphere.surface(ray, crossing, probe),
        }
    }

    /// The inputs of the kernel, for the log.
    fn give<P: Probe>(&self, probe: &mut P) {
        match self {
            Shape::Plane(plane) => plane.give(probe),
            Shape::Sphere(sphere) => sphere.give(probe),
        }
    }

    /// Whether a ray that sets off on this side of the surface can meet the same surface again.
    fn can_be_met_again(&self, side: Side) -> bool {
        match self {
            Shape::Plane(_) => false,
            Shape::Sphere(_) => side == Side::Back,
        }
    }

    /// The side on which the ray leaves this object, if it does.
    fn side_left(&self, object: u32, ray: &Ray) -> Option<Side> {
        match ray.leaving {
            Some(leaving) if leaving.object == object => Some(leaving.side),
            _ => None,
        }
    }
}

/// Marks a candidate as hit or missed by whether the ray reaches it.
#[inline]
fn decide<P: Probe>(ray: &Ray, candidate: Crossing, probe: &mut P) -> Option<Crossing> {
    if ray.reaches(candidate.t) {
        probe.mark(Decision::Hit);
        Some(candidate)
    } else {
        let why = if candidate.t >= ray.t_max { Miss::Beyond } else { Miss::Behind };
        probe.mark(Decision::Miss { why });
        None
    }
}
