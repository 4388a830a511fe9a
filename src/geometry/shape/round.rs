//! Shapes whose outline, seen from a point, is an ellipse.

use super::Shape;
use glam::DVec3;

/// A ball that a linear map may have stretched, or a flat disk.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Round {
    /// The image of the unit ball.
    Ball {
        /// Its centre.
        center: DVec3,
        /// The half axes, which needn't be perpendicular.
        half_axes: [DVec3; 3],
    },
    /// A disk.
    Disk {
        /// Its centre.
        center: DVec3,
        /// The unit normal of its plane.
        normal: DVec3,
        /// Its radius.
        radius: f64,
    },
}

impl Round {
    /// The centre.
    pub fn center(&self) -> DVec3 {
        match self {
            Round::Ball { center, .. } | Round::Disk { center, .. } => *center,
        }
    }
}

impl Shape {
    /// The shape as a ball or a disk; `None` for another one, and for one that moves.
    pub fn round(&self) -> Option<Round> {
        match self {
            Shape::Sphere(sphere) => {
                let half_axes = DVec3::AXES.map(|axis| axis * sphere.radius);
                Some(Round::Ball { center: sphere.center, half_axes })
            }
            Shape::Ellipsoid(ellipsoid) => {
                Some(Round::Ball { center: ellipsoid.center, half_axes: ellipsoid.half_axes() })
            }
            Shape::Disk(disk) => {
                Some(Round::Disk { center: disk.center, normal: disk.unit_normal, radius: disk.radius })
            }
            _ => None,
        }
    }
}
