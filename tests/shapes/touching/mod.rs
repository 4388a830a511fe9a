//! Coincident surfaces: what touches, lies in one plane, or is in a scene twice.

mod arithmetics;
mod bounds;
mod cases;
mod doubled;
mod eye;
mod flat;
mod gaps;
mod glass;
mod smooth;
mod stacks;
mod world;
