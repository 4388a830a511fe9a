//! Rays and shapes: hits, shared edges, walks of the kernels, and the tree of boxes.

#[path = "../support/random.rs"]
mod random;
#[path = "../support/rays.rs"]
mod rays;
#[path = "../support/shared.rs"]
mod shared;
#[path = "../support/solids.rs"]
mod solids;
#[path = "../support/mod.rs"]
mod support;

mod boxes;
mod coincident;
mod filters_are_conservative;
mod flat;
mod flat_formulas;
mod grazed_cone;
mod grazed_cylinder;
mod ladder;
mod large;
mod leaks;
mod meshes;
mod packets;
mod patterns;
mod quadrics;
mod quadrics_random;
mod robust;
mod segments;
mod shafts;
mod shape_walks;
mod shared_edges;
mod stress;
mod touching;
mod worlds;
