//! The shapes. Each has its own file, which implements `Kernel`; adding one is that file, a variant and an arm here.

mod axis;
mod cone;
mod cuboid;
mod cylinder;
mod disk;
mod doubled_chord;
mod edge;
mod ellipsoid;
mod fan;
mod flat;
mod mesh;
mod moving;
mod outline;
mod plane;
pub(in crate::geometry) mod polygon;
mod roots;
mod sphere;
pub(in crate::geometry) mod triangle;

pub use cone::Cone;
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use disk::Disk;
pub use ellipsoid::Ellipsoid;
pub use mesh::TriangleMesh;
pub use moving::Moving;
pub use outline::{Polyline, circle};
pub use plane::Plane;
pub use polygon::Polygon;
pub use sphere::{Sphere, SphereMethod};
pub use triangle::Triangle;

use super::bounds::Bounds;
use super::bvh::Form;
use super::doubled::Doubled;
use super::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Step};
use crate::probe::Probe;
use glam::DVec3;
use std::sync::Arc;

/// A surface that rays meet.
// With a tag of its own, which is quicker to tell than one hidden in the variants.
#[derive(Clone, Debug, PartialEq)]
#[repr(u8)]
pub enum Shape {
    /// An infinite plane.
    Plane(Plane),
    /// A sphere.
    Sphere(Sphere),
    /// An ellipsoid.
    Ellipsoid(Ellipsoid),
    /// A triangle.
    Triangle(Triangle),
    /// A flat polygon.
    Polygon(Polygon),
    /// A box along the axes.
    Cuboid(Cuboid),
    /// A cylinder, open or with caps.
    Cylinder(Cylinder),
    /// A cone or frustum, open or with caps.
    Cone(Cone),
    /// A flat disk.
    Disk(Disk),
    /// A mesh of triangles, which has a test for each. Several objects may share it.
    Mesh(Arc<TriangleMesh>),
    /// One of these that moves.
    Moving(Box<Moving>),
}

/// Calls a method of the kernel behind a shape, or of a mesh, which is many, or of a moving shape.
macro_rules! kernel {
    ($shape:expr, $kernel:ident => $call:expr, $mesh:ident => $mesh_call:expr) => {
        match $shape {
            Shape::Mesh($mesh) => $mesh_call,
            Shape::Moving($mesh) => $mesh_call,
            Shape::Plane($kernel) => $call,
            Shape::Sphere($kernel) => $call,
            Shape::Ellipsoid($kernel) => $call,
            Shape::Triangle($kernel) => $call,
            Shape::Polygon($kernel) => $call,
            Shape::Cuboid($kernel) => $call,
            Shape::Cylinder($kernel) => $call,
            Shape::Cone($kernel) => $call,
            Shape::Disk($kernel) => $call,
        }
    };
}

/// What a kernel has to know beside the ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Approach {
    /// The side of this very surface on which the ray sets off, if it leaves it.
    pub leaving: Option<Side>,
    /// Whether the surface is absent for rays that arrive at its back.
    pub one_sided: bool,
}

/// How a ray meets one kind of shape.
pub trait Kernel {
    /// The inputs, for the log.
    fn give<P: Probe>(&self, probe: &mut P);

    /// The first point where the ray crosses the surface.
    fn first_crossing<P: Probe>(&self, ray: &Ray, approach: Approach, probe: &mut P) -> Option<Crossing>;

    /// All points where the ray crosses the surface, in its order. A flat shape has no more than one.
    fn all_crossings<P: Probe>(&self, ray: &Ray, approach: Approach, found: &mut Vec<Crossing>, probe: &mut P) {
        found.extend(self.first_crossing(ray, approach, probe));
    }

    /// The surface at a crossing, its normals turned toward the arriving ray.
    fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface;

    /// A box around the shape; `None` for one without end.
    fn bounds(&self) -> Option<Bounds>;

    /// Whether a ray that sets off on this side of the surface can meet the same surface again. Flat shapes can't be.
    fn can_be_met_again(&self, _sets_off: Side) -> bool {
        false
    }

    /// The distance of a crossing with as many digits as the shape can tell, to order crossings that f64 can't.
    fn refined(&self, _ray: &Ray, crossing: Crossing) -> Doubled {
        Doubled::from(crossing.t)
    }

    /// The first point where the ray crosses object `object` of this shape.
    // Each kernel is a function of its own: together in one they would crowd each other out of the registers.
    #[inline(never)]
    fn first_of<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        self.test(object, one_sided, ray, probe, |approach, probe| self.first_crossing(ray, approach, probe))?
    }

    /// All points where the ray crosses object `object` of this shape, in its order.
    #[inline(never)]
    fn all_of<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, found: &mut Vec<Crossing>, probe: &mut P) {
        self.test(object, one_sided, ray, probe, |approach, probe| self.all_crossings(ray, approach, found, probe));
    }

    /// The surface at a crossing, as a function of its own.
    #[inline(never)]
    fn surface_of<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        self.surface(ray, crossing, probe)
    }

    /// Runs `body` as the test of object `object`, unless the ray leaves it and can't meet it again.
    #[inline]
    fn test<P: Probe, T>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        probe: &mut P,
        body: impl FnOnce(Approach, &mut P) -> T,
    ) -> Option<T> {
        let leaving = ray.leaving.filter(|leaving| leaving.object == object).map(|leaving| leaving.side);
        if leaving.is_some_and(|side| !self.can_be_met_again(side)) {
            return None;
        }
        self.give(probe);
        Some(probe.within(Step::Test { object, triangle: None }, |probe| body(Approach { leaving, one_sided }, probe)))
    }
}

impl Shape {
    /// The first point where the ray crosses object `object` of this shape.
    #[inline(always)]
    pub fn first_crossing<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        kernel!(
            self,
            kernel => kernel.first_of(object, one_sided, ray, probe),
            mesh => mesh.first_crossing(object, one_sided, ray, probe)
        )
    }

    /// Whether the ray crosses the object at all.
    #[inline(always)]
    pub fn is_crossed<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, probe: &mut P) -> bool {
        match self {
            Shape::Mesh(mesh) => mesh.is_crossed(object, one_sided, ray, probe),
            Shape::Moving(moving) => moving.is_crossed(object, one_sided, ray, probe),
            _ => self.first_crossing(object, one_sided, ray, probe).is_some(),
        }
    }

    /// All points where the ray crosses the object, in the order of the ray.
    #[inline(always)]
    pub fn all_crossings<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        found: &mut Vec<Crossing>,
        probe: &mut P,
    ) {
        kernel!(
            self,
            kernel => kernel.all_of(object, one_sided, ray, found, probe),
            mesh => mesh.all_crossings(object, one_sided, ray, found, probe)
        );
    }

    /// The surface at a crossing, its normals turned toward the arriving ray.
    #[inline(always)]
    pub fn surface<P: Probe>(&self, ray: &Ray, crossing: Crossing, probe: &mut P) -> Surface {
        kernel!(self, kernel => kernel.surface_of(ray, crossing, probe), mesh => mesh.surface(ray, crossing, probe))
    }

    /// The distance of a crossing with as many digits as the shape can tell, to order crossings that f64 can't.
    pub(crate) fn refined(&self, ray: &Ray, crossing: Crossing) -> Doubled {
        match self {
            Shape::Moving(moving) => moving.refined(ray, crossing),
            _ => kernel!(self, kernel => kernel.refined(ray, crossing), mesh => mesh.refined(ray, crossing)),
        }
    }

    /// The shape itself, where it is at time 0.
    pub fn at_rest(&self) -> &Shape {
        match self {
            Shape::Moving(moving) => moving.shape(),
            _ => self,
        }
    }

    /// Whether this part of the surface (see [`Crossing::primitive`]) is flat.
    pub fn is_flat(&self, primitive: u32) -> bool {
        match self.at_rest() {
            Shape::Sphere(_) | Shape::Ellipsoid(_) => false,
            Shape::Cylinder(_) | Shape::Cone(_) => primitive != axis::LATERAL,
            Shape::Plane(_)
            | Shape::Triangle(_)
            | Shape::Polygon(_)
            | Shape::Cuboid(_)
            | Shape::Disk(_)
            | Shape::Mesh(_)
            | Shape::Moving(_) => true,
        }
    }

    /// How many triangles the file of a mesh has; `None` for another shape.
    pub fn triangle_count(&self) -> Option<usize> {
        match self.at_rest() {
            Shape::Mesh(mesh) => Some(mesh.mesh().faces.len()),
            _ => None,
        }
    }

    /// Whether hits tell which triangle of a file was met.
    pub fn is_mesh(&self) -> bool {
        matches!(self.at_rest(), Shape::Mesh(_))
    }

    /// A box around the shape; `None` for one without end.
    pub fn bounds(&self) -> Option<Bounds> {
        kernel!(self, kernel => kernel.bounds(), mesh => mesh.bounds())
    }

    /// What a tree over shapes knows of this one; `None` for one without end.
    pub fn form(&self) -> Option<Form> {
        match self {
            Shape::Sphere(sphere) => sphere.form(),
            Shape::Triangle(triangle) => Some(Form::Triangle(triangle.corners())),
            _ => self.bounds().map(Form::Within),
        }
    }

    /// Points whose convex hull holds the shape, no larger than the shape is narrow; `None` for a shape without end.
    pub fn corners(&self) -> Option<Vec<DVec3>> {
        Some(match self {
            Shape::Triangle(triangle) => triangle.corners().to_vec(),
            Shape::Polygon(polygon) => polygon.corners().to_vec(),
            Shape::Cylinder(cylinder) => cylinder.corners().to_vec(),
            Shape::Cone(cone) => cone.corners().to_vec(),
            _ => self.bounds()?.corners().collect(),
        })
    }

    /// The side of the surface from which a ray can meet the surface again, the back where there is none. A query that
    /// doesn't know on which side its ray sets off asks from there: the root that it has left is left out either way.
    pub fn returning_side(&self) -> Side {
        let can_return = kernel!(self.at_rest(), kernel => kernel.can_be_met_again(Side::Front), _mesh => false);
        if can_return { Side::Front } else { Side::Back }
    }
}

impl Approach {
    /// Whether the surface is there for a ray that arrives on this side.
    #[inline]
    pub fn shows(self, side: Side) -> bool {
        !self.one_sided || side == Side::Front
    }
}

/// Marks a candidate as hit or missed: by its side, and by whether the ray reaches it.
#[inline]
fn decide<P: Probe>(ray: &Ray, approach: Approach, candidate: Crossing, probe: &mut P) -> Option<Crossing> {
    let why = match () {
        _ if !approach.shows(candidate.side) => Miss::FacesAway,
        _ if ray.reaches(candidate.t) => {
            probe.mark(Decision::Hit);
            return Some(candidate);
        }
        _ if candidate.t >= ray.t_max => Miss::Beyond,
        _ => Miss::Behind,
    };
    probe.mark(Decision::Miss { why });
    None
}
