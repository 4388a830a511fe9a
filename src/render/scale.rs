//! False colours.

use crate::scene::Color;

/// The scale at equal distances, from dark to light.
const SCALE: [u32; 10] =
    [0x000004, 0x1b0c42, 0x4b0c6b, 0x781c6d, 0xa52c60, 0xcf4446, 0xed6925, 0xfb9a06, 0xf7d03c, 0xfcffa4];

/// The colour of a number from 0 to 1, from 0 to 1 in each channel: black, violet, red, orange, bright yellow.
///
/// The scale is the colour map *inferno* of matplotlib (Smith and van der Walt 2015, CC0): its lightness grows evenly, so that it reads
/// without colours too.
pub fn inferno(x: f64) -> Color {
    let last = SCALE.len() - 1;
    let place = x.clamp(0.0, 1.0) * last as f64;
    let below = (place.floor() as usize).min(last - 1);
    let color = |at: usize| {
        let [_, r, g, b] = SCALE[at].to_be_bytes();
        Color::new(r.into(), g.into(), b.into()) / 255.0
    };
    color(below).lerp(color(below + 1), place - below as f64)
}
