//! From traced values to the levels of an integer format.

use crate::render::Film;
use crate::scene::file::validate::limits::MAX_EXPOSURE;
use crate::scene::{Output, Transfer};

/// What an integer format could not hold of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Clipped {
    /// How many pixels had a value below black or above white.
    pub pixels: u64,
    /// The exposure in stops, in whole tenths, at which no pixel is clipped and the brightest is as bright as it can be. `None` if no
    /// exposure does that: where a value is negative or no number, or all are 0.
    pub fitting_exposure: Option<f64>,
}

/// The levels 0 to `highest` of each channel, and what was clipped.
pub(super) fn levels(film: &Film, output: &Output, highest: u16) -> (Vec<u16>, Clipped) {
    let scale = scale(output.exposure, output);
    let mut pixels = 0;
    let mut levels = Vec::with_capacity(film.pixels().len() * 3);
    for pixel in film.pixels() {
        let shown = (*pixel * scale).to_array();
        pixels += u64::from(!shown.iter().all(|x| is_shown(*x)));
        levels.extend(shown.map(|x| level(x, output.transfer, highest)));
    }
    (levels, Clipped { pixels, fitting_exposure: if pixels > 0 { fitting_exposure(film, output) } else { None } })
}

/// What values are multiplied by before the transfer curve: 2 to the exposure, over white.
fn scale(exposure: f64, output: &Output) -> f64 {
    libm::exp2(exposure) / output.white
}

/// Whether a format can hold a scaled value.
fn is_shown(x: f64) -> bool {
    (0.0..=1.0).contains(&x)
}

/// The largest exposure in whole tenths of a stop at which nothing is clipped, if there is one.
fn fitting_exposure(film: &Film, output: &Output) -> Option<f64> {
    let mut brightest = 0.0_f64;
    for x in film.pixels().iter().flat_map(|pixel| pixel.to_array()) {
        if !(x.is_finite() && x >= 0.0) {
            return None;
        }
        brightest = brightest.max(x);
    }
    let fits = |tenths: f64| is_shown(brightest * scale(tenths / 10.0, output));
    // The logarithm may err by a rounding, where white is an exact power of two away: the scale itself decides.
    let near = (10.0 * libm::log2(output.white / brightest)).floor();
    let tenths = [near + 1.0, near, near - 1.0].into_iter().find(|tenths| fits(*tenths))?;
    (tenths.abs() <= 10.0 * MAX_EXPOSURE).then_some(tenths / 10.0)
}

/// The levels 0 to 255 of one colour, brighter by this many stops than the output has it.
pub fn levels_of(color: [f64; 3], output: &Output, stops: f64) -> [u8; 3] {
    let scale = scale(output.exposure + stops, output);
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
    use proptest::prelude::*;

    const OUTPUT: Output = Output { white: 255.0, transfer: Transfer::Linear, exposure: 0.0 };

    fn of(colors: &[[f64; 3]]) -> Film {
        let area = [0, 0, colors.len() as u32, 1];
        let mut film = Film::new(area);
        film.put(area, &colors.iter().map(|color| Color::from_array(*color)).collect::<Vec<_>>());
        film
    }

    #[track_caller]
    fn becomes(color: [f64; 3], output: Output, expected: [u16; 3], clipped: u64) {
        let (levels, found) = levels(&of(&[color]), &output, 255);
        assert_eq!((levels, found.pixels), (expected.to_vec(), clipped));
    }

    #[track_caller]
    fn fits(colors: &[[f64; 3]], output: Output, exposure: Option<f64>) {
        assert_eq!(levels(&of(colors), &output, 255).1.fitting_exposure, exposure);
    }

    #[test]
    fn white_is_the_highest_level() {
        becomes([0.0, 127.5, 255.0], OUTPUT, [0, 128, 255], 0);
    }

    #[test]
    fn what_is_too_bright_is_clipped_and_counted_once() {
        becomes([393.05, 311.67, 100.0], OUTPUT, [255, 255, 100], 1);
        becomes([-1.0, f64::NAN, 100.0], OUTPUT, [0, 0, 100], 1);
    }

    #[test]
    fn a_stop_doubles() {
        becomes([50.0, 60.0, 70.0], Output { exposure: 1.0, ..OUTPUT }, [100, 120, 140], 0);
        becomes([400.0, 60.0, 2.0], Output { exposure: -1.0, ..OUTPUT }, [200, 30, 1], 0);
        // Half a stop is the root of 2: 100 · 1.41421… = 141.4, 180 · 1.41421… = 254.6.
        becomes([100.0, 180.0, 0.0], Output { exposure: 0.5, ..OUTPUT }, [141, 255, 0], 0);
    }

    #[test]
    fn the_srgb_curve() {
        let srgb = Output { white: 1.0, transfer: Transfer::Srgb, exposure: 0.0 };
        becomes([0.0, 0.215_860_5, 1.0], srgb, [0, 128, 255], 0);
        // The curve comes after the exposure.
        becomes([0.0, 0.863_442, 4.0], Output { exposure: -2.0, ..srgb }, [0, 128, 255], 0);
    }

    #[test]
    fn the_exposure_that_fits_is_rounded_down() {
        // log₂(255/394.134) = -0.628.
        fits(&[[1.0; 3], [394.134, 312.0, 371.0]], OUTPUT, Some(-0.7));
        // What it is now plays no part.
        fits(&[[394.134; 3]], Output { exposure: 3.0, ..OUTPUT }, Some(-0.7));
        fits(&[[510.0; 3]], OUTPUT, Some(-1.0));
        fits(&[[1e150; 3]], OUTPUT, None);
        fits(&[[300.0, -1.0, 0.0]], OUTPUT, None);
        fits(&[[300.0, f64::NAN, 0.0]], OUTPUT, None);
        // Where nothing is clipped nobody asks.
        fits(&[[255.0; 3]], OUTPUT, None);
    }

    proptest! {
        #[test]
        fn a_level_is_the_scaled_value_through_the_curve(
            color in [0.0..2.0_f64, 0.0..2.0, 0.0..2.0], white in 0.1..10.0_f64, exposure in -8.0..8.0_f64, is_srgb: bool, is_16: bool,
        ) {
            let transfer = if is_srgb { Transfer::Srgb } else { Transfer::Linear };
            let highest = if is_16 { 65535 } else { 255 };
            let (found, clipped) = levels(&of(&[color]), &Output { white, transfer, exposure }, highest);
            let shown = color.map(|x| x * libm::exp2(exposure) / white);
            prop_assert_eq!(clipped.pixels, u64::from(shown.iter().any(|x| *x > 1.0)));
            for (found, shown) in found.into_iter().zip(shown) {
                let shown = shown.min(1.0);
                // IEC 61966-2-1.
                let curved = match is_srgb {
                    true if shown <= 0.003_130_8 => 12.92 * shown,
                    true => 1.055 * libm::pow(shown, 1.0 / 2.4) - 0.055,
                    false => shown,
                };
                // Half a level from the exact one, and a rounding.
                prop_assert!((f64::from(found) - curved * f64::from(highest)).abs() < 0.5 + 1e-9);
            }
        }

        #[test]
        fn at_the_fitting_exposure_nothing_is_clipped_and_a_tenth_above_it_something(
            colors in prop::collection::vec([0.0..1e6_f64, 0.0..1e6, 0.0..1e6], 1..5), white in 1e-3..1e3_f64,
        ) {
            let clipped = |exposure| levels(&of(&colors), &Output { white, transfer: Transfer::Linear, exposure }, 255).1;
            if let Some(exposure) = clipped(0.0).fitting_exposure {
                prop_assert_eq!(clipped(exposure).pixels, 0);
                prop_assert!(clipped(exposure + 0.1).pixels > 0);
            }
        }
    }
}
