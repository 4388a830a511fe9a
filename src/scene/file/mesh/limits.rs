//! How large a mesh may be. Within these the numbers of corners and triangles fit into 32 bits.

/// The largest mesh file: 1 GiB.
pub const MAX_MESH_BYTES: u64 = 1 << 30;

/// The most triangles of a mesh: 2²⁴, about 16.8 million.
pub const MAX_TRIANGLES: usize = 1 << 24;

/// The most vertices, and the most normals, of a mesh: 2²⁵.
pub const MAX_VERTICES: usize = 1 << 25;

/// What tracing needs a triangle, beside the mesh itself: boxes, the tree over them, and room to sort.
pub const TREE_BYTES_PER_TRIANGLE: usize = 128;

/// The most corners of a face with a notch that is cut into triangles inside its outline, which takes cubic time.
pub const MAX_CORNERS_CUT: usize = 500;
