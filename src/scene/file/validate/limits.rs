//! How large a scene may ask the work to be. Within these no product of sizes overflows.

/// The longest side of a picture in pixels.
pub const MAX_SIDE: u32 = 65_535;

/// The most pixels of a picture, 2²⁸.
pub const MAX_PIXELS: u64 = 1 << 28;

/// The deepest recursion.
pub const MAX_DEPTH: u32 = 256;

/// The most rays per pixel, or shadow rays per light, or rays per blurry bounce: 2²⁰.
pub const MAX_SAMPLES: u32 = 1 << 20;

/// The fewest samples that tell a variance: two pairs.
pub const MIN_STATISTICAL: u32 = 4;

/// The fewest samples of a pilot: a variance needs two.
pub const MIN_GUIDED: u32 = 2;

/// The most cells a side of regular sampling, √[`MAX_SAMPLES`].
pub const MAX_GRID: u32 = 1 << 10;

/// How often adaptive sampling may halve a cell: the smallest cells make a grid of [`MAX_GRID`] a side.
pub const MAX_ADAPTIVE_DEPTH: u32 = 10;

/// The most frames of an animation.
pub const MAX_FRAMES: u32 = 1_000_000;

/// The largest exposure in stops, up or down.
pub const MAX_EXPOSURE: f64 = 100.0;

/// The shortest vector that is a direction, and the shortest axis of a cylinder or cone: its square must not vanish.
pub const MIN_LENGTH: f64 = 1e-150;

/// The largest coordinate or size: squares, and squares of their products with directions, must stay finite.
pub const MAX_COORDINATE: f64 = 1e100;

/// The largest refractive index, and 1 over the smallest; and how much the radius of a cone may gain per unit along its axis.
pub const MAX_RATIO: f64 = 1e50;

/// How many problems are kept; further ones are counted.
pub const MAX_PROBLEMS: usize = 20;
