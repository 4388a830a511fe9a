//! The surfaces of area lights.

pub use super::file::schema::By;
use crate::geometry::Ray;
use glam::DVec3;

/// The surface of an area light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LightSurface {
    /// A parallelogram: from the centre to the middle of two of its sides.
    Rectangle {
        /// The centre.
        center: DVec3,
        /// Half of one edge, and half of the other.
        edges: [DVec3; 2],
    },
    /// A flat disk: two perpendicular radii.
    Disk {
        /// The centre.
        center: DVec3,
        /// The radii.
        edges: [DVec3; 2],
    },
    /// A sphere.
    Sphere {
        /// The centre.
        center: DVec3,
        /// The radius.
        radius: f64,
    },
}

impl LightSurface {
    /// A parallelogram by a corner and the edges from there.
    pub fn rectangle(corner: DVec3, edge_u: DVec3, edge_v: DVec3) -> LightSurface {
        let edges = [edge_u * 0.5, edge_v * 0.5];
        LightSurface::Rectangle { center: corner + edges[0] + edges[1], edges }
    }

    /// A disk by its centre, a normal of any length, and its radius.
    pub fn disk(center: DVec3, normal: DVec3, radius: f64) -> LightSurface {
        let normal = Ray::along(center, normal).direction;
        let across = normal.cross(least_axis(normal));
        let across = across / across.length();
        LightSurface::Disk { center, edges: [across * radius, normal.cross(across) * radius] }
    }

    /// Its centre.
    pub fn center(&self) -> DVec3 {
        let (LightSurface::Rectangle { center, .. }
        | LightSurface::Disk { center, .. }
        | LightSurface::Sphere { center, .. }) = self;
        *center
    }
}

/// The axis along which a vector has its least component, of equals the first: the vector is far from parallel to it.
pub fn least_axis(vector: DVec3) -> DVec3 {
    let size = vector.abs();
    if size.x <= size.y && size.x <= size.z {
        DVec3::X
    } else if size.y <= size.z {
        DVec3::Y
    } else {
        DVec3::Z
    }
}
