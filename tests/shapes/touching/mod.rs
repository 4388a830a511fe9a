//! Surfaces in the same place: what touches, lies in one plane, or stands in a scene twice.

mod bounds;
mod doubled;
mod flat;
mod stacks;
mod world;
