//! Rays, shapes and where they meet. This module knows numbers and their names, no materials, lights or scenes.

mod area_normal;
pub(crate) mod bounds;
pub(crate) mod bvh;
mod coincident;
pub(crate) mod doubled;
mod exact;
mod line;
pub mod mesh;
pub(crate) mod motion;
pub(crate) mod nearest;
pub mod processor;
pub(crate) mod ray;
pub mod shape;
pub(crate) mod size;
pub(crate) mod unit;

pub use bounds::Bounds;
pub use bvh::{Bvh, Form, PACKET, PerRay, RayMask, Search, Shaft, each};
pub use line::{Line, RaySource};
pub use mesh::Mesh;
pub use nearest::{Hit, Nearest};
pub use ray::{Crossing, Leaving, Ray, Side, Surface};
pub use shape::{Intersect, Shape, Target};
