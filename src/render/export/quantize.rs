//! From traced values to the levels of an integer format.

use crate::render::Film;
use crate::scene::{Output, Transfer};

/// The levels 0 to `highest` of each channel, and how many pixels were clipped.
pub(super) fn levels(film: &Film, output: &Output, highest: u16) -> (Vec<u16>, u64) {
    let scale = libm::exp2(output.exposure) / output.white;
    let mut clipped_pixels = 0;
    let mut levels = Vec::with_capacity(film.pixels().len() * 3);
    for pixel in film.pixels() {
        let shown = (*pixel * scale).to_array();
        clipped_pixels += u64::from(shown.iter().any(|x| !(0.0..=1.0).contains(x)));
        levels.extend(shown.map(|x| level(x, output.transfer, highest)));
    }
    (levels, clipped_pixels)
}

/// The levels 0 to 255 of one colour, brighter by so many stops than the output has it.
pub fn levels_of(color: [f64; 3], output: &Output, stops: f64) -> [u8; 3] {
    let scale = libm::exp2(output.exposure + stops) / output.white;
    color.map(|x| level(x * scale, output.transfer, 255) as u8)
}

fn level(x: f64, transfer: Transfer, highest: u16) -> u16 {
    let clipped = x.clamp(0.0, 1.0);
    let curved = match transfer {
        Transfer::Linear => clipped,
        Transfer::Srgb => srgb(clipped),
    };
    // Rounded half up; the conversion can't overflow.
    (curved * f64::from(highest) + 0.5) as u16
}

/// IEC 61966-2-1.
fn srgb(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { 12.92 * linear } else { 1.055 * libm::pow(linear, 1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Color;

    const OUTPUT: Output = Output { white: 255.0, transfer: Transfer::Linear, exposure: 0.0 };

    #[track_caller]
    fn becomes(color: [f64; 3], output: Output, expected: [u16; 3], clipped: u64) {
        let mut film = Film::new([0, 0, 1, 1]);
        film.put([0, 0, 1, 1], &[Color::from_array(color)]);
        assert_eq!(levels(&film, &output, 255), (expected.to_vec(), clipped));
    }

    #[test]
    fn white_is_the_highest_level() {
        becomes([0.0, 127.5, 255.0], OUTPUT, [0, 128, 255], 0);
    }

    #[test]
    fn what_is_too_bright_is_clipped_and_counted_once() {
        becomes([393.05, 311.67, 100.0], OUTPUT, [255, 255, 100], 1);
    }

    #[test]
    fn a_stop_doubles() {
        becomes([50.0, 60.0, 70.0], Output { exposure: 1.0, ..OUTPUT }, [100, 120, 140], 0);
    }

    #[test]
    fn the_srgb_curve() {
        let srgb = Output { white: 1.0, transfer: Transfer::Srgb, exposure: 0.0 };
        becomes([0.0, 0.215_860_5, 1.0], srgb, [0, 128, 255], 0);
    }
}
