//! The raw files of ray benchmarks: primitives and rays as plain numbers, which programs in any language can read.
//!
//! This module owns the layouts and every sentence about a file that doesn't follow them. All numbers are little-endian, and all
//! coordinates are f32:
//!
//! | file | layout |
//! |---|---|
//! | `X.mesh` | `RWMESH01`, u64 vertices, u64 triangles, 3 coordinates a vertex, 3 u32 a triangle |
//! | `X.spheres` | `RWSPHR01`, u64 count, then centre and radius |
//! | `X.KIND.rays` | `RWRAYS01`, u32 question (0 the nearest hit, 1 whether there is any), u32 width, u32 height, u32 0, u64 count, then origin, t_min, direction and t_max |

mod fields;
mod primitives;
mod rays;
#[cfg(test)]
mod tests;

pub use primitives::{Primitives, RawSphere, parse_mesh, parse_spheres, primitive_files, read_primitives};
pub use rays::{Question, RawRay, RayFile, find_rays, parse_rays, read_rays};

/// The largest raw file: 1 GiB.
pub const MAX_RAW_BYTES: u64 = 1 << 30;
