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
use super::nearest::{Contenders, Hit};
use super::ray::{Crossing, Ray, Side, Surface};
use crate::log::{Decision, Miss, Name, Step};
use crate::probe::{Probe, ROUNDINGS, Silent};
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

    /// The size of the numbers that define the surface, whose roundings move it: its greatest coordinate.
    fn size(&self) -> f64 {
        self.bounds().map_or(0.0, Bounds::size)
    }

    /// The part of the ray's direction that is along the normal at a crossing: how fast the ray leaves the surface.
    fn slope(&self, ray: &Ray, crossing: Crossing) -> f64 {
        self.surface(ray, crossing, &mut Silent).geometric_normal().dot(ray.direction).abs()
    }

    /// Whether a crossing near an end of the ray is that end, as far as rounding can tell: where the ray begins, or where the light is. Then
    /// it is a miss, and why.
    #[cold]
    #[inline(never)]
    fn at_an_end(&self, ray: &Ray, approach: Approach, crossing: Crossing) -> Option<Miss> {
        at_an_end(ray, approach.leaving.is_none(), crossing.t, self.slope(ray, crossing), self.size())
    }

    /// Marks the only candidate of a flat shape as hit or missed.
    #[inline(always)]
    fn decide<P: Probe>(&self, ray: &Ray, approach: Approach, candidate: Crossing, probe: &mut P) -> Option<Crossing> {
        // A call at the end, before which no register need be saved.
        if ray.is_near_an_end(candidate.t) {
            return self.decide_near_end(ray, approach, candidate, probe);
        }
        decide(ray, approach, candidate, None, probe)
    }

    /// The rest of [`Kernel::decide`].
    #[cold]
    #[inline(never)]
    fn decide_near_end<P: Probe>(
        &self,
        ray: &Ray,
        approach: Approach,
        candidate: Crossing,
        probe: &mut P,
    ) -> Option<Crossing> {
        decide(ray, approach, candidate, self.at_an_end(ray, approach, candidate), probe)
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

    /// Shows the log the crossing of a ray that begins on the surface and goes through it.
    fn touch<P: Probe>(&self, object: u32, probe: &mut P) {
        self.give(probe);
        probe.within(Step::Test { object, triangle: None }, touched);
    }
}

/// A test whose answer is known before: the ray begins on the surface.
fn touched<P: Probe>(probe: &mut P) {
    probe.note(Name::TouchT, 0.0);
    probe.mark(Decision::Hit);
}

impl Shape {
    /// The first point where the ray crosses object `object` of this shape.
    pub fn first_crossing<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, probe: &mut P) -> Option<Crossing> {
        let mut contenders = Contenders::default();
        let crossing = self.nearest(object, one_sided, ray, &mut contenders, probe)?;
        contenders.place(Hit { object, crossing }, ray, |_| self, probe).first().map(|hit| hit.crossing)
    }

    /// The nearest of the points where the ray crosses object `object` of this shape, and those of a mesh that may be in the same
    /// place.
    #[inline(always)]
    pub fn nearest<P: Probe>(
        &self,
        object: u32,
        one_sided: bool,
        ray: &Ray,
        contenders: &mut Contenders,
        probe: &mut P,
    ) -> Option<Crossing> {
        match self {
            Shape::Mesh(mesh) => mesh.nearest(object, one_sided, ray, contenders, probe),
            Shape::Moving(moving) => moving.nearest(object, one_sided, ray, contenders, probe),
            _ => kernel!(self, kernel => kernel.first_of(object, one_sided, ray, probe), _mesh => None),
        }
    }

    /// Shows the log the crossing of a ray that begins on the object and goes through it.
    pub fn touch<P: Probe>(&self, object: u32, primitive: u32, ray: &Ray, probe: &mut P) {
        match self {
            Shape::Mesh(mesh) => mesh.touch(object, primitive, probe),
            Shape::Moving(moving) => moving.touch(object, primitive, ray, probe),
            _ => kernel!(self, kernel => kernel.touch(object, probe), _mesh => ()),
        }
    }

    /// The size of the numbers that define a part of the surface, whose roundings move it.
    pub(in crate::geometry) fn size(&self, primitive: u32) -> f64 {
        kernel!(self, kernel => kernel.size(), mesh => mesh.size(primitive))
    }

    /// The bound of what the roundings of its numbers do to the surface, in units of length.
    pub fn slack(&self) -> f64 {
        let size = match self {
            Shape::Mesh(mesh) => mesh.bounds().map_or(0.0, Bounds::size),
            _ => self.size(0),
        };
        ROUNDINGS * size
    }

    /// How fast the ray leaves the surface at a crossing: the part of its direction that is along the normal.
    pub(in crate::geometry) fn slope(&self, ray: &Ray, crossing: Crossing) -> f64 {
        self.surface(ray, crossing, &mut Silent).geometric_normal().dot(ray.direction).abs()
    }

    /// Whether two parts of the surface touch without lying in the same place: the triangles of a mesh that share an edge or a
    /// corner. Which of them a ray meets first is told by their distances alone.
    pub(in crate::geometry) fn are_neighbours(&self, one: u32, other: u32) -> bool {
        match self.at_rest() {
            Shape::Mesh(mesh) => mesh.are_neighbours(one, other),
            _ => true,
        }
    }

    /// Whether the ray crosses the object at all.
    #[inline(always)]
    pub fn is_crossed<P: Probe>(&self, object: u32, one_sided: bool, ray: &Ray, probe: &mut P) -> bool {
        match self {
            Shape::Mesh(mesh) => mesh.is_crossed(object, one_sided, ray, probe),
            Shape::Moving(moving) => moving.is_crossed(object, one_sided, ray, probe),
            _ => kernel!(self, kernel => kernel.first_of(object, one_sided, ray, probe).is_some(), _mesh => false),
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

    /// Whether it moves.
    pub fn is_moving(&self) -> bool {
        matches!(self, Shape::Moving(_))
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

    /// The side of the surface on which the solid lies that it encloses; `None` where it encloses none. A plane encloses the half space
    /// behind it.
    pub fn inside(&self) -> Option<Side> {
        match self.at_rest() {
            Shape::Plane(_) | Shape::Ellipsoid(_) | Shape::Cuboid(_) => Some(Side::Back),
            Shape::Sphere(sphere) => Some(sphere.outer.opposite()),
            Shape::Cylinder(cylinder) => cylinder.solid_side(),
            Shape::Cone(cone) => cone.solid_side(),
            Shape::Mesh(mesh) => mesh.inside(),
            Shape::Triangle(_) | Shape::Polygon(_) | Shape::Disk(_) | Shape::Moving(_) => None,
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

/// Whether a crossing, through which the ray passes so fast along the normal, is an end of the ray.
fn at_an_end(ray: &Ray, may_begin: bool, t: f64, slope: f64, size: f64) -> Option<Miss> {
    match () {
        _ if may_begin && ray.holds(t * slope, size) => Some(Miss::BeginsThere),
        _ if ray.holds((ray.t_max - t) * slope, size) => Some(Miss::Beyond),
        _ => None,
    }
}

/// Marks a candidate as hit or missed: by its side, by whether the ray reaches it, and by whether it is an end of the ray.
#[inline]
fn decide<P: Probe>(
    ray: &Ray,
    approach: Approach,
    candidate: Crossing,
    at_an_end: Option<Miss>,
    probe: &mut P,
) -> Option<Crossing> {
    let why = match at_an_end {
        _ if !approach.shows(candidate.side) => Miss::FacesAway,
        Some(why) if ray.reaches(candidate.t) => why,
        None if ray.reaches(candidate.t) => {
            probe.mark(Decision::Hit);
            return Some(candidate);
        }
        _ if candidate.t >= ray.t_max => Miss::Beyond,
        _ => Miss::Behind,
    };
    probe.mark(Decision::Miss { why });
    None
}
