//! Pictures of how many digits of each pixel can be trusted.

use super::scale::inferno;
use super::{Counter, Film, Progress, RenderError, Rendered, Settings, by_pixels, on_threads};
use crate::probe::Silent;
use crate::record::Pixel;
use crate::record::digits::{ALL_DIGITS, of_color};
use crate::scene::{Color, Scene};
use std::sync::atomic::AtomicBool;

/// Renders the number of significant digits of each pixel's final colour, in all three channels, as
/// [`of_color`] has it from runs perturbed by `seed` and its successors. The arithmetic of the settings is ignored.
///
/// Where pixels share samples, each pixel traces its own, as its log does. Rays of all runs are counted.
///
/// # Errors
/// As [`render`](super::render).
pub fn render_digits(
    scene: &Scene,
    settings: &Settings,
    seed: u64,
    progress: impl Fn(u64) + Sync,
    stop: &AtomicBool,
) -> Result<Rendered, RenderError> {
    on_threads(settings, || digits_in(scene, settings, seed, &progress, stop))
}

/// The same on the threads of the pool that this is called in; `None` when the work is to stop.
pub(super) fn digits_in(
    scene: &Scene,
    settings: &Settings,
    seed: u64,
    progress: Progress,
    stop: &AtomicBool,
) -> Option<(Film, Counter)> {
    let of_pixel = |pixel: [u32; 2], counter: &mut Counter| {
        let pixel = Pixel { scene, pixel };
        if !settings.counts_rays {
            return Color::splat(of_color(pixel, seed, Silent).0);
        }
        let (digits, counted) = of_color(pixel, seed, std::mem::take(counter));
        *counter = counted;
        Color::splat(digits)
    };
    by_pixels(settings, of_pixel, progress, stop)
}

/// A picture of digits in false colours, from 0 to 1: bright yellow is none, then orange, red, violet, and black all digits. The place on
/// the scale is the square root of the digits lost, so that it tells 15 from 14 as well as 8 from 3.
pub fn false_colors(digits: &Film) -> Film {
    let mut film = Film::new([0, 0, digits.width(), digits.height()]);
    let colors: Vec<_> = digits.pixels().iter().map(|pixel| false_color(pixel.x)).collect();
    film.put([0, 0, digits.width(), digits.height()], &colors);
    film
}

fn false_color(digits: f64) -> Color {
    let lost = ((ALL_DIGITS - digits) / ALL_DIGITS).clamp(0.0, 1.0);
    inferno(lost.sqrt())
}

/// What a picture of digits comes to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// The fewest digits of a pixel.
    pub fewest: f64,
    /// As many pixels have fewer digits as have more.
    pub median: f64,
    /// Pixels without a digit.
    pub without: usize,
}

impl Summary {
    /// That of a picture of at least one pixel.
    pub fn of(digits: &Film) -> Summary {
        let mut digits: Vec<f64> = digits.pixels().iter().map(|pixel| pixel.x).collect();
        digits.sort_unstable_by(f64::total_cmp);
        let at = |index: usize| digits.get(index).copied().unwrap_or(ALL_DIGITS);
        let without = digits.iter().filter(|digits| **digits == 0.0).count();
        Summary { fewest: at(0), median: at(digits.len() / 2), without }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_darkens_with_every_digit() {
        // ITU-R BT.709.
        let luminance = |color: Color| color.dot(Color::new(0.2126, 0.7152, 0.0722));
        let scale: Vec<_> = (0..=159).map(|tenths| luminance(false_color(f64::from(tenths) / 10.0))).collect();
        assert!(scale.windows(2).all(|pair| pair[1] < pair[0]), "{scale:?}");
        assert_eq!(false_color(0.0), Color::new(252.0, 255.0, 164.0) / 255.0);
        assert_eq!(false_color(ALL_DIGITS), Color::new(0.0, 0.0, 4.0) / 255.0);
    }

    #[test]
    fn a_summary() {
        let mut film = Film::new([0, 0, 3, 1]);
        film.put([0, 0, 3, 1], &[14.0, 0.0, 15.0].map(Color::splat));
        assert_eq!(Summary::of(&film), Summary { fewest: 0.0, median: 14.0, without: 1 });
    }
}
