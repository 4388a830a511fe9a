//! Samples, effects and the physics they must keep.

#[path = "../support/edges.rs"]
mod edges;
#[path = "../support/mod.rs"]
mod support;

mod bits;
mod calls;
mod chances;
mod coverage;
mod dimensions;
mod effects_bits;
mod effects_camera;
mod effects_lights;
mod effects_lobes;
mod effects_unbiased;
mod exact;
mod penumbra;
mod physics;
mod quality;
mod shared_samples;
mod small;
mod together;
