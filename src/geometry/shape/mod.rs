//! The shapes. Each has its own file, which implements `Kernel`; CONTRIBUTING.md says what else one needs.

mod axis;
mod cone;
mod cuboid;
mod cylinder;
mod disk;
mod dispatch;
mod doubled_chord;
mod edge;
mod ellipsoid;
mod fan;
mod flat;
mod intersect;
mod kernel;
mod mesh;
mod moving;
mod outline;
mod plane;
pub(in crate::geometry) mod polygon;
mod quick;
mod roots;
mod round;
mod sphere;
mod sphere_method;
pub(in crate::geometry) mod triangle;

pub use cone::Cone;
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use disk::Disk;
pub use ellipsoid::Ellipsoid;
pub use intersect::{Intersect, Target};
pub use kernel::{Approach, Kernel};
pub use mesh::TriangleMesh;
pub use moving::Moving;
pub use outline::{Polyline, circle};
pub use plane::Plane;
pub use polygon::Polygon;
pub use round::Round;
pub use sphere::Sphere;
pub use sphere_method::SphereMethod;
pub use triangle::Triangle;

use super::bounds::Bounds;
use super::bvh::{Form, Shaft};
use super::ray::{Crossing, Leaving, Ray, Side};
use crate::probe::{ROUNDINGS, Silent};
use glam::DVec3;
use kernel::decide;
use std::sync::Arc;

/// A surface that rays hit.
// With a tag of its own, which is quicker to test than one hidden in the variants. Shapes larger than a sphere lie elsewhere, so that a million
// spheres don't take the room of a million triangles.
#[derive(Clone, Debug, PartialEq)]
#[repr(u8)]
pub enum Shape {
    /// An infinite plane.
    Plane(Plane),
    /// A sphere.
    Sphere(Sphere),
    /// An ellipsoid.
    Ellipsoid(Box<Ellipsoid>),
    /// A triangle.
    Triangle(Box<Triangle>),
    /// A flat polygon.
    Polygon(Box<Polygon>),
    /// A box along the axes.
    Cuboid(Cuboid),
    /// A cylinder, open or with caps.
    Cylinder(Box<Cylinder>),
    /// A cone or frustum, open or with caps.
    Cone(Box<Cone>),
    /// A flat disk.
    Disk(Box<Disk>),
    /// A mesh of triangles, which has a test for each. Several objects may share it.
    Mesh(Arc<TriangleMesh>),
    /// One of these that moves.
    Moving(Box<Moving<Shape>>),
}

const _: () = assert!(size_of::<Shape>() <= 72 && size_of::<Triangle>() <= 104 && size_of::<Polygon>() <= 128);

impl Shape {
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
    /// corner. Their distances alone say which of them a ray hits first.
    pub(in crate::geometry) fn are_neighbors(&self, one: u32, other: u32) -> bool {
        match self.at_rest() {
            Shape::Mesh(mesh) => mesh.are_neighbors(one, other),
            _ => true,
        }
    }

    /// Whether a ray along a segment of the shaft can cross the shape, as far as a quick look tells; `leaving` as in
    /// [`TriangleMesh::can_be_crossed_in`].
    pub fn can_be_crossed_in(&self, shaft: &Shaft, leaving: Option<Leaving>) -> bool {
        match self {
            Shape::Mesh(mesh) => mesh.can_be_crossed_in(shaft, leaving),
            Shape::Moving(_) => true,
            _ if leaving.is_some_and(|leaving| !self.can_self_intersect(leaving.side)) => false,
            Shape::Plane(plane) => plane.can_be_crossed_in(shaft),
            _ => true,
        }
    }

    /// The corners of a triangle of a mesh; other shapes have one surface, of which no part is neighbour to another.
    pub(in crate::geometry) fn corners_of(&self, triangle: u32) -> Option<[DVec3; 3]> {
        match self.at_rest() {
            Shape::Mesh(mesh) => Some(mesh.corners_of(triangle)),
            _ => None,
        }
    }

    /// Whether [`Shape::can_be_crossed_in`] may tell more of it than a ball around it does.
    pub fn is_told_by_a_shaft(&self) -> bool {
        matches!(self, Shape::Mesh(_) | Shape::Plane(_))
    }

    /// The shape itself, where it is at time 0.
    pub fn at_rest(&self) -> &Shape {
        match self {
            Shape::Moving(moving) => moving.shape(),
            _ => self,
        }
    }

    /// Whether the surface is convex as seen from a point: the ways to points on it, which lie between the ways to others on it, meet it. Of a
    /// solid that is told from outside a box around it only.
    pub fn is_convex_from(&self, point: DVec3) -> bool {
        match self {
            Shape::Plane(_) | Shape::Triangle(_) | Shape::Disk(_) => true,
            Shape::Polygon(polygon) => polygon.is_convex(),
            Shape::Sphere(sphere) => {
                (point - sphere.center).length_squared() > sphere.radius * sphere.radius * (1.0 + 1e-9)
            }
            Shape::Ellipsoid(_) | Shape::Cuboid(_) | Shape::Cylinder(_) | Shape::Cone(_) => {
                self.inside().is_some() && self.bounds().is_some_and(|bounds| !bounds.contains(point))
            }
            Shape::Mesh(_) | Shape::Moving(_) => false,
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

    /// Whether hits name the triangle of the file.
    pub fn is_mesh(&self) -> bool {
        matches!(self.at_rest(), Shape::Mesh(_))
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

    /// The side of the surface from which a ray can hit the surface again, the back where there is none. A query that
    /// doesn't know on which side its ray sets off asks from there: the root that it has left is left out either way.
    pub fn returning_side(&self) -> Side {
        if !self.is_mesh() && self.can_self_intersect(Side::Front) { Side::Front } else { Side::Back }
    }
}
