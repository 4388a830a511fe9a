//! The random numbers of one sample.

use super::permutation::permuted;
use super::{Dimension, Stratum, hash, sobol, unit};

/// How the samples of a pixel share the range of a dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// Each by itself.
    Independent,
    /// One in each of so many strata as there are samples.
    Stratified {
        /// The samples of the pixel.
        count: u32,
    },
    /// As the points of a sequence of low discrepancy, of which any beginning is well spread.
    Sobol,
}

/// The random numbers of one sample: pure functions of (seed, place, sample, dimension).
///
/// Over the samples of a pixel each dimension is spread by the [`Arrangement`] (stratified together). Which of its strata a sample
/// gets in a dimension is a permutation that belongs to the dimension (decorrelated): knowing where in the pixel a sample lies
/// says nothing of where on the lens it lies. See `docs/sampling.md`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Draws {
    seed: u64,
    /// Column and row of the pixel that the sample belongs to.
    place: [u32; 2],
    grid: Grid,
    /// The sample's number, from 0.
    number: u32,
    arrangement: Arrangement,
}

/// Several points that one sample draws in a dimension.
#[derive(Clone, Copy, Debug)]
pub struct Splits<'d> {
    draws: &'d Draws,
    /// The hash that all of them have in common.
    key: u64,
    /// Whether a single point has its strata out of order.
    shuffles: bool,
    parts: u32,
}

impl Splits<'_> {
    /// The point with this number, from 0.
    pub fn pick(&self, part: u32) -> Pick {
        if self.parts == 1 {
            return self.draws.pick_under(self.key, self.shuffles);
        }
        let within = self.draws.pick_under(hash(self.key, part.into()), true);
        Pick { stratum: Stratum::of(part, self.parts), jitter: within.point() }
    }
}

/// What a place is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Grid {
    Pixels,
    /// Pixels with so many corners to a side.
    Corners(u32),
    /// The same, where coarse corners come first.
    NestedCorners(u32),
}

/// A random point with the way it came to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// The part of the square that it was to lie in.
    pub stratum: Stratum,
    /// Where in that part, each from 0 to 1.
    pub jitter: [f64; 2],
}

impl Pick {
    /// The point.
    pub fn point(&self) -> [f64; 2] {
        // Rounding may reach 1, which no random number is.
        self.stratum.at(self.jitter).map(|x| x.min(1.0 - f64::EPSILON / 2.0))
    }
}

impl Draws {
    /// The numbers of a sample of a pixel: its number from 0, and how the pixel's samples are arranged.
    #[inline]
    pub fn of_pixel(seed: u64, place: [u32; 2], number: u32, arrangement: Arrangement) -> Draws {
        Draws { seed, place, grid: Grid::Pixels, number, arrangement }
    }

    /// The numbers of a sample that pixels share: they belong to its place in the picture, in steps of 1/n of a pixel. The n² corners
    /// of a pixel that lie to its left and top, and within it, are stratified together.
    #[inline]
    pub fn of_corner(seed: u64, corner: [u32; 2], n: u32) -> Draws {
        let [across, down] = corner.map(|step| step % n);
        let place = corner.map(|step| step / n);
        let arrangement = Arrangement::Stratified { count: n * n };
        Draws { seed, place, grid: Grid::Corners(n), number: down * n + across, arrangement }
    }

    /// The same for a grid of 2^depth steps a pixel of which the coarse corners are used first: those of each coarser grid are
    /// a beginning of the pixel's Sobol points.
    #[inline]
    pub fn of_nested_corner(seed: u64, corner: [u32; 2], depth: u32) -> Draws {
        let n = 1 << depth;
        // The first two digits of the number say which half across and down, the next two which quarter, and so on.
        let digit = |step: u32, level: u32| step >> (depth - 1 - level) & 1;
        let [across, down] = corner.map(|step| step % n);
        let digits = |level: u32| (digit(across, level) | digit(down, level) << 1) << (2 * level);
        let number = (0..depth).fold(0, |number, level| number | digits(level));
        let place = corner.map(|step| step / n);
        Draws { seed, place, grid: Grid::NestedCorners(n), number, arrangement: Arrangement::Sobol }
    }

    /// A number in [0, 1).
    pub fn number(&self, dimension: Dimension) -> f64 {
        self.number_under(self.key_of(dimension))
    }

    /// A point in the unit square.
    pub fn point(&self, dimension: Dimension) -> [f64; 2] {
        self.pick(dimension).point()
    }

    /// A point in the unit square with its stratum.
    pub fn pick(&self, dimension: Dimension) -> Pick {
        // The places in the pixel are taken in their order, so that a log reads row by row.
        self.pick_under(self.key_of(dimension), dimension != Dimension::Pixel)
    }

    /// Of several numbers that one sample draws in a dimension, one with each part of [0, 1) for itself.
    pub fn split_number(&self, dimension: Dimension, part: u32, parts: u32) -> f64 {
        let within = self.number_under(hash(self.key_of(dimension), part.into()));
        ((f64::from(part) + within) / f64::from(parts)).min(1.0 - f64::EPSILON / 2.0)
    }

    /// Of several points that one sample draws in a dimension, the one with this number: see [`Draws::splits`].
    pub fn split(&self, dimension: Dimension, part: u32, parts: u32) -> Pick {
        self.splits(dimension, parts).pick(part)
    }

    /// Several points that one sample draws in a dimension: each has a stratum for itself, in which the samples of the pixel are
    /// arranged.
    pub fn splits(&self, dimension: Dimension, parts: u32) -> Splits<'_> {
        Splits { draws: self, key: self.key_of(dimension), shuffles: dimension != Dimension::Pixel, parts }
    }

    /// The hash of seed, place and dimension. Reckoned where a number is asked for, so that samples which draw none don't pay for it.
    fn key_of(&self, dimension: Dimension) -> u64 {
        let grid = match self.grid {
            Grid::Pixels => hash(self.seed, 0),
            Grid::Corners(n) => hash(hash(self.seed, 1), n.into()),
            Grid::NestedCorners(n) => hash(hash(self.seed, 2), n.into()),
        };
        let [column, row] = self.place.map(u64::from);
        hash(hash(grid, column << 32 | row), dimension.word())
    }

    fn number_under(&self, key: u64) -> f64 {
        match self.arrangement {
            Arrangement::Independent => self.jitter(key)[0],
            Arrangement::Stratified { count } => {
                let stratum = permuted(self.number, count, key);
                ((f64::from(stratum) + self.jitter(key)[0]) / f64::from(count)).min(1.0 - f64::EPSILON / 2.0)
            }
            Arrangement::Sobol => sobol::point_in_order(self.number, hash(key, 2), key)[0],
        }
    }

    fn pick_under(&self, key: u64, shuffles: bool) -> Pick {
        match self.arrangement {
            Arrangement::Independent => Pick { stratum: Stratum::WHOLE, jitter: self.jitter(key) },
            Arrangement::Stratified { count } => {
                let stratum = if shuffles { permuted(self.number, count, key) } else { self.number };
                Pick { stratum: Stratum::of(stratum, count), jitter: self.jitter(key) }
            }
            Arrangement::Sobol => {
                let jitter = match shuffles {
                    true => sobol::point_in_order(self.number, hash(key, 2), key),
                    false => sobol::point(self.number, key),
                };
                Pick { stratum: Stratum::WHOLE, jitter }
            }
        }
    }

    /// Two numbers that nothing else depends on.
    fn jitter(&self, key: u64) -> [f64; 2] {
        let key = hash(key, u64::from(self.number) + 8);
        [unit(hash(key, 0)), unit(hash(key, 1))]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Route;

    const ALL: [Arrangement; 3] = [Arrangement::Independent, Arrangement::Stratified { count: 64 }, Arrangement::Sobol];

    fn draws(number: u32, arrangement: Arrangement) -> Draws {
        Draws::of_pixel(5, [3, 4], number, arrangement)
    }

    #[test]
    fn every_dimension_is_stratified() {
        let dimensions = [Dimension::Pixel, Dimension::Lens, Dimension::Light { route: Route::CAMERA, light: 1 }];
        for arrangement in &ALL[1..] {
            for dimension in dimensions {
                let mut taken = [false; 64];
                for number in 0..64 {
                    let [x, y] = draws(number, *arrangement).point(dimension);
                    taken[(y * 8.0) as usize * 8 + (x * 8.0) as usize] = true;
                }
                assert!(taken.iter().all(|is_taken| *is_taken), "{arrangement:?} {dimension:?}");
            }
            let mut taken = [false; 64];
            (0..64).for_each(|k| taken[(draws(k, *arrangement).number(Dimension::Time) * 64.0) as usize] = true);
            assert!(taken.iter().all(|is_taken| *is_taken), "{arrangement:?} time");
        }
    }

    /// The correlation of two dimensions over many pixels is that of unrelated numbers (four standard deviations).
    #[test]
    fn dimensions_are_unrelated() {
        for arrangement in ALL {
            for (one, other) in [(Dimension::Pixel, Dimension::Lens), (Dimension::Lens, Dimension::Time)] {
                let mut sum = 0.0;
                for pixel in 0..400 {
                    for number in 0..64 {
                        let draws = Draws::of_pixel(0, [pixel, 7], number, arrangement);
                        let other = if other == Dimension::Time { draws.number(other) } else { draws.point(other)[0] };
                        sum += (draws.point(one)[0] - 0.5) * (other - 0.5);
                    }
                }
                let correlation = sum * 12.0 / 25_600.0;
                assert!(correlation.abs() < 4.0 / 160.0, "{arrangement:?} {one:?} {other:?}: {correlation}");
            }
        }
    }

    #[test]
    fn splits_have_a_stratum_each_and_share_it_among_the_samples() {
        let dimension = Dimension::Reflection { route: Route::CAMERA.reflected(0) };
        for arrangement in &ALL[1..] {
            for part in 0..16 {
                let mut taken = [false; 64];
                for number in 0..64 {
                    let [x, y] = draws(number, *arrangement).split(dimension, part, 16).point();
                    let inside = [x * 4.0 - f64::from(part % 4), y * 4.0 - f64::from(part / 4)];
                    assert!(inside.iter().all(|x| (0.0..1.0).contains(x)), "{inside:?}");
                    taken[(inside[1] * 8.0) as usize * 8 + (inside[0] * 8.0) as usize] = true;
                }
                assert!(taken.iter().all(|is_taken| *is_taken), "{arrangement:?} {part}");
            }
        }
    }

    #[test]
    fn each_of_seed_pixel_sample_and_dimension_matters() {
        let of = |seed, pixel, number| Draws::of_pixel(seed, pixel, number, Arrangement::Independent);
        let points = [
            of(0, [1, 2], 0).point(Dimension::Lens),
            of(1, [1, 2], 0).point(Dimension::Lens),
            of(0, [2, 1], 0).point(Dimension::Lens),
            of(0, [1, 2], 1).point(Dimension::Lens),
            of(0, [1, 2], 0).point(Dimension::Pixel),
            Draws::of_corner(0, [1, 2], 1).point(Dimension::Lens),
            Draws::of_corner(0, [1, 2], 2).point(Dimension::Lens),
        ];
        for (k, point) in points.iter().enumerate() {
            assert!(points[..k].iter().all(|other| other[0] != point[0] && other[1] != point[1]), "{k}");
        }
    }
}
