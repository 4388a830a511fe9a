//! Several points that one sample draws at once: shadow rays to a light, the zones of a blurred bounce.

use super::draws::Order;
use super::{Dimension, Draws, Pick, Stratum, hash, unit};

/// Several points that one sample draws in a dimension: each has a stratum for itself, in which the samples of the pixel are arranged.
#[derive(Clone, Copy, Debug)]
pub struct Splits<'d> {
    draws: &'d Draws,
    /// The hash that all of them have in common.
    key: u64,
    /// The order of a single point.
    order: Order,
    parts: u32,
    /// Of several Sobol points the one that all of them are made of.
    shared: Option<[u64; 2]>,
}

impl<'d> Splits<'d> {
    /// The points of a sample in a dimension, this many.
    pub fn new(draws: &'d Draws, dimension: Dimension, parts: u32) -> Splits<'d> {
        let (key, order) = (draws.key_of(dimension), draws.order_of(dimension));
        let shared = (draws.is_sobol() && parts > 1).then(|| draws.sobol_digits(key, order));
        Splits { draws, key, order, parts, shared }
    }

    /// The point with this number, from 0.
    ///
    /// Several Sobol points are one, of which each part turns other digits: a digital shift keeps elementary intervals, and shifts that know
    /// nothing of each other make points that don't either. It takes a hash, where a scrambling of its own takes seven.
    #[inline]
    pub fn pick(&self, part: u32) -> Pick {
        if self.parts == 1 {
            return self.draws.pick_under(self.key, self.order);
        }
        let key = hash(self.key, part.into());
        let jitter = match self.shared {
            Some([x, y]) => [unit(x ^ key & SHIFTED), unit(y ^ key << 32)],
            None => self.draws.pick_under(key, Order::Shuffled).point(),
        };
        Pick { stratum: Stratum::of(part, self.parts), jitter }
    }
}

/// The digits of a coordinate that a shift turns: the first 32.
const SHIFTED: u64 = !0 << 32;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{Arrangement, Partner, Route};

    const STRATIFIED: Arrangement = Arrangement::Stratified { count: 64 };
    const SOBOL: Arrangement = Arrangement::Sobol { partner: Partner::Nothing };
    const JOINTLY: Arrangement = Arrangement::Sobol { partner: Partner::Surface };

    fn split(draws: &Draws, dimension: Dimension, part: u32, parts: u32) -> Pick {
        Splits::new(draws, dimension, parts).pick(part)
    }

    #[test]
    fn splits_have_a_stratum_each_and_share_it_among_the_samples() {
        let dimension = Dimension::Reflection { route: Route::CAMERA.reflected(0) };
        for arrangement in [STRATIFIED, SOBOL, JOINTLY] {
            for part in 0..16 {
                let mut taken = [false; 64];
                for number in 0..64 {
                    let [x, y] = split(&Draws::of_pixel(5, [3, 4], number, arrangement), dimension, part, 16).point();
                    let inside = [x * 4.0 - f64::from(part % 4), y * 4.0 - f64::from(part / 4)];
                    assert!(inside.iter().all(|x| (0.0..1.0).contains(x)), "{inside:?}");
                    taken[(inside[1] * 8.0) as usize * 8 + (inside[0] * 8.0) as usize] = true;
                }
                assert!(taken.iter().all(|is_taken| *is_taken), "{arrangement:?} {part}");
            }
        }
    }

    /// Parts of a pixel are shifts of each other, so that they may run alike in one pixel; over many pixels they have nothing to do with each
    /// other (four standard errors of the pixels' own means).
    #[test]
    fn parts_are_unrelated() {
        let dimension = Dimension::Light { route: Route::CAMERA, light: 0 };
        for arrangement in [Arrangement::Independent, STRATIFIED, SOBOL, JOINTLY] {
            for axes in [[0, 0], [0, 1], [1, 0], [1, 1]] {
                let of_pixel = |pixel| {
                    let products = (0..16).map(|number| {
                        let draws = Draws::of_pixel(0, [pixel, 9], number, arrangement);
                        let of = |part: usize| split(&draws, dimension, part as u32, 4).jitter[axes[part]] - 0.5;
                        of(0) * of(1)
                    });
                    products.sum::<f64>() / 16.0
                };
                let means: Vec<_> = (0..1600).map(of_pixel).collect();
                let (sum, squares) = (means.iter().sum::<f64>(), means.iter().map(|mean| mean * mean).sum::<f64>());
                assert!(sum.abs() < 4.0 * squares.sqrt(), "{arrangement:?} {axes:?}: {sum}, {squares}");
            }
        }
    }
}
