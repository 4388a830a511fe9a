//! The random numbers of one sample.

use super::permutation::permuted;
use super::sobol::{self, Scrambling};
use super::{Dimension, Partner, Stratum, hash, unit};

/// How the samples of a pixel share the range of a dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arrangement {
    /// Each by itself.
    Independent,
    /// One in each of as many strata as there are samples.
    Stratified {
        /// The samples of the pixel.
        count: u32,
    },
    /// As the points of a sequence of low discrepancy, of which any beginning is well spread.
    Sobol {
        /// What is spread jointly with the places in the pixel.
        partner: Partner,
    },
}

/// How the samples of a pixel follow each other in a dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Order {
    /// By their numbers: the places in the pixel are taken in their order, so that a log reads row by row.
    Own,
    /// In the order of the partner, in which Sobol points are spread jointly with the places in the pixel.
    Partner,
    /// In an order that belongs to the dimension.
    Shuffled,
}

/// The random numbers of one sample: pure functions of (seed, place, sample, dimension).
///
/// Over the samples of a pixel each dimension is spread by the [`Arrangement`] (stratified together). Which of its strata a sample
/// gets in a dimension is a permutation that belongs to the dimension (decorrelated): knowing where in the pixel a sample lies
/// says nothing of where on the lens it lies. One pair is better still with Sobol points: the place and its [`Partner`] are spread over all
/// four of their coordinates. See `docs/sampling.md`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Draws {
    origin: Origin,
    /// The sample's number, from 0.
    number: u32,
    arrangement: Arrangement,
}

/// What all samples of a place have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Origin {
    /// To be hashed when a number is asked for, so that a sample that draws none doesn't pay for it.
    Given {
        seed: u64,
        /// Column and row of the pixel that the sample belongs to.
        place: [u32; 2],
        grid: Grid,
    },
    /// The hash of it.
    Hashed(u64),
}

impl Origin {
    #[inline]
    fn hash(self) -> u64 {
        let (seed, [column, row], grid) = match self {
            Origin::Given { seed, place, grid } => (seed, place.map(u64::from), grid),
            Origin::Hashed(hash) => return hash,
        };
        let grid = match grid {
            Grid::Pixels => hash(seed, 0),
            Grid::Corners(n) => hash(hash(seed, 1), n.into()),
            Grid::NestedCorners(n) => hash(hash(seed, 2), n.into()),
        };
        hash(grid, column << 32 | row)
    }
}

/// The random numbers of all samples of a pixel: what they have in common is hashed once.
#[derive(Clone, Copy, Debug)]
pub struct OfPixel {
    hash: u64,
    arrangement: Arrangement,
    /// The key of the places in the pixel.
    key: u64,
    /// Their scrambling, if they are Sobol points.
    scrambling: Scrambling,
}

impl OfPixel {
    /// Those of a pixel with samples in this arrangement.
    #[inline]
    pub fn new(seed: u64, place: [u32; 2], arrangement: Arrangement) -> OfPixel {
        let origin = Origin::Given { seed, place, grid: Grid::Pixels }.hash();
        let key = hash(origin, Dimension::Pixel.word());
        OfPixel { hash: origin, arrangement, key, scrambling: Scrambling::new(key) }
    }

    /// The numbers of the sample with this number, from 0, and its place in the pixel.
    #[inline]
    pub fn sample(&self, number: u32) -> (Draws, Pick) {
        let draws = Draws { origin: Origin::Hashed(self.hash), number, arrangement: self.arrangement };
        let pick = match self.arrangement {
            Arrangement::Sobol { .. } => Pick { stratum: Stratum::WHOLE, jitter: self.scrambling.point(number) },
            _ => draws.pick_under(self.key, Order::Own),
        };
        (draws, pick)
    }
}

/// What a place is counted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Grid {
    Pixels,
    /// Pixels with this many corners to a side.
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
        Draws { origin: Origin::Given { seed, place, grid: Grid::Pixels }, number, arrangement }
    }

    /// The numbers of a sample that pixels share: they belong to its place in the picture, in steps of 1/n of a pixel. The n² corners
    /// of a pixel that lie to its left and top, and within it, are stratified together.
    #[inline]
    pub fn of_corner(seed: u64, corner: [u32; 2], n: u32) -> Draws {
        let [across, down] = corner.map(|step| step % n);
        let place = corner.map(|step| step / n);
        let arrangement = Arrangement::Stratified { count: n * n };
        let origin = Origin::Given { seed, place, grid: Grid::Corners(n) };
        Draws { origin, number: down * n + across, arrangement }
    }

    /// The same for a grid of 2^depth steps per pixel of which the coarse corners are used first: those of each coarser grid are
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
        let origin = Origin::Given { seed, place, grid: Grid::NestedCorners(n) };
        Draws { origin, number, arrangement: Arrangement::Sobol { partner: Partner::Nothing } }
    }

    /// A number in [0, 1).
    pub fn number(&self, dimension: Dimension) -> f64 {
        self.number_under(self.key_of(dimension), self.order_of(dimension))
    }

    /// A point in the unit square with its stratum.
    pub fn pick(&self, dimension: Dimension) -> Pick {
        self.pick_under(self.key_of(dimension), self.order_of(dimension))
    }

    #[inline]
    pub(super) fn order_of(&self, dimension: Dimension) -> Order {
        match self.arrangement {
            _ if dimension == Dimension::Pixel => Order::Own,
            Arrangement::Sobol { partner } if dimension.is_of(partner) => Order::Partner,
            _ => Order::Shuffled,
        }
    }

    #[inline]
    pub(super) fn is_sobol(&self) -> bool {
        matches!(self.arrangement, Arrangement::Sobol { .. })
    }

    /// The hash of seed, place and dimension.
    #[inline]
    pub(super) fn key_of(&self, dimension: Dimension) -> u64 {
        hash(self.origin.hash(), dimension.word())
    }

    fn number_under(&self, key: u64, order: Order) -> f64 {
        match self.arrangement {
            Arrangement::Independent => self.jitter(key)[0],
            Arrangement::Stratified { count } => {
                let stratum = permuted(self.number, count, key);
                ((f64::from(stratum) + self.jitter(key)[0]) / f64::from(count)).min(1.0 - f64::EPSILON / 2.0)
            }
            Arrangement::Sobol { .. } => self.sobol_point(key, order)[0],
        }
    }

    pub(super) fn pick_under(&self, key: u64, order: Order) -> Pick {
        match self.arrangement {
            Arrangement::Independent => Pick { stratum: Stratum::WHOLE, jitter: self.jitter(key) },
            Arrangement::Stratified { count } => {
                let stratum = if order == Order::Own { self.number } else { permuted(self.number, count, key) };
                Pick { stratum: Stratum::of(stratum, count), jitter: self.jitter(key) }
            }
            Arrangement::Sobol { .. } => Pick { stratum: Stratum::WHOLE, jitter: self.sobol_point(key, order) },
        }
    }

    #[inline]
    fn sobol_point(&self, key: u64, order: Order) -> [f64; 2] {
        let [x, y] = self.sobol_digits(key, order);
        [unit(x), unit(y)]
    }

    #[inline]
    pub(super) fn sobol_digits(&self, key: u64, order: Order) -> [u64; 2] {
        let index = match order {
            Order::Own => self.number,
            Order::Partner => sobol::partner(self.number),
            Order::Shuffled => sobol::shuffled(self.number, hash(key, 2)),
        };
        Scrambling::new(key).digits(index)
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

    const ALL: [Arrangement; 6] = [
        Arrangement::Independent,
        Arrangement::Stratified { count: 64 },
        Arrangement::Sobol { partner: Partner::Nothing },
        Arrangement::Sobol { partner: Partner::Lens },
        Arrangement::Sobol { partner: Partner::Time },
        Arrangement::Sobol { partner: Partner::Surface },
    ];

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
                    let [x, y] = draws(number, *arrangement).pick(dimension).point();
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
                        let other =
                            if other == Dimension::Time { draws.number(other) } else { draws.pick(other).point()[0] };
                        sum += (draws.pick(one).point()[0] - 0.5) * (other - 0.5);
                    }
                }
                let correlation = sum * 12.0 / 25_600.0;
                assert!(correlation.abs() < 4.0 / 160.0, "{arrangement:?} {one:?} {other:?}: {correlation}");
            }
        }
    }

    #[test]
    fn each_of_seed_pixel_sample_and_dimension_matters() {
        let of = |seed, pixel, number| Draws::of_pixel(seed, pixel, number, Arrangement::Independent);
        let points = [
            of(0, [1, 2], 0).pick(Dimension::Lens).point(),
            of(1, [1, 2], 0).pick(Dimension::Lens).point(),
            of(0, [2, 1], 0).pick(Dimension::Lens).point(),
            of(0, [1, 2], 1).pick(Dimension::Lens).point(),
            of(0, [1, 2], 0).pick(Dimension::Pixel).point(),
            Draws::of_corner(0, [1, 2], 1).pick(Dimension::Lens).point(),
            Draws::of_corner(0, [1, 2], 2).pick(Dimension::Lens).point(),
        ];
        for (k, point) in points.iter().enumerate() {
            assert!(points[..k].iter().all(|other| other[0] != point[0] && other[1] != point[1]), "{k}");
        }
    }
}
