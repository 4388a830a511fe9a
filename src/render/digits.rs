//! Pictures of how many digits of each pixel can be trusted.

use super::scale::inferno;
use super::task::Task;
use super::{Counter, Film};
use crate::probe::Silent;
use crate::record::Pixel;
use crate::record::digits::{ALL_DIGITS, of_color};
use crate::scene::Color;

/// The number of significant digits of each pixel's final colour, in all three channels, as [`of_color`] has it.
pub(super) fn digits(task: &Task, seed: u64) -> Option<(Film, Counter)> {
    task.by_pixels(|pixel, counter| {
        let pixel = Pixel { scene: task.scene, pixel };
        if !task.settings.counts_rays {
            return Color::splat(of_color(pixel, seed, Silent).0);
        }
        let (digits, counted) = of_color(pixel, seed, std::mem::take(counter));
        *counter = counted;
        Color::splat(digits)
    })
}

/// A picture of digits in false colours, from 0 to 1: bright yellow is none, then orange, red, violet, and black all digits. The place on
/// the scale is the square root of the digits lost, so that it tells 15 from 14 as well as 8 from 3.
pub fn false_colors(digits: &Film) -> Film {
    digits.map(|pixel| false_color(pixel.x))
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
