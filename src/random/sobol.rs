//! The first two dimensions of Sobol's sequence, scrambled by Owen's method.
//!
//! The first 2^k points have one in each of the 2^k parts into which halvings of the sides cut the square, however the
//! halvings are shared between the sides: a (0, 2)-sequence. Scrambling keeps that, and makes each point uniform by itself, so that
//! a mean over the points has no bias (Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995). The same points in the order of the
//! [`partner`]s make four dimensions of which the first 4^k points have one in each of the 4^k boxes into which quarterings of the sides cut them: a
//! (0, 4)-sequence in base 4. More dimensions are further pairs, each scrambled by itself and taken in an order of its own (Burley, "Practical
//! hash-based Owen scrambling", 2020). Written out here because 24 bits, which the crates for it give, are too few for f64.

use super::{GOLDEN, hash, mix, unit};

/// A scrambling of the sequence, one of 2⁶⁴.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Scrambling {
    /// The coins of each coordinate.
    coins: [u64; 2],
}

impl Scrambling {
    /// The scrambling with this key.
    #[inline]
    pub fn new(key: u64) -> Scrambling {
        Scrambling { coins: [0, 1].map(|axis| mix(hash(key, axis) ^ GOLDEN)) }
    }

    /// The point with this number, its coordinates as binary fractions.
    #[inline]
    pub fn digits(&self, index: u32) -> [u64; 2] {
        let coordinate = |digits: u32, axis: usize| scrambled(digits.into(), self.coins[axis]).reverse_bits();
        [coordinate(index, 0), coordinate(second(index), 1)]
    }

    /// The same as numbers in [0, 1) with all 53 bits.
    #[inline]
    pub fn point(&self, index: u32) -> [f64; 2] {
        let [x, y] = self.digits(index);
        [unit(x), unit(y)]
    }
}

/// Which point is the partner of the one with this number, with which it is spread jointly.
///
/// Faure's matrices over a field of four elements are powers of Pascal's triangle, one for each element a: the digit r in base 4 is the sum
/// of C(c, r)·a^(c − r) times the digit c, and any four coordinates by different elements are a (0, 4)-sequence ("Discrépance de suites associées
/// à un système de numération", 1982, for primes; Niederreiter, "Point sets and sequences with small discrepancy", 1987). The elements are 0, 1,
/// α and α² = α + 1. Those of 0 and 1 are the two coordinates of the sequence, if the bits of the second one's digits are added up in pairs, which
/// keeps what quarterings need. By P(a + b) = P(a)·P(b) those of α and α² are the same two coordinates of the index P(α)·i. (Ahmed et al., "SZ
/// sequences: binary-constructed (0, 2^q)-sequences", 2025, have the whole family of such pairs.)
///
/// P(α)·i is made of the digits of the index in base 4, the first one last; the first bit of a digit, last too, counts 1 and the other α. As in `second`,
/// one power of two after the other is taken out of c − r, for which a digit is multiplied by α^(2^k): α, α², α⁴ = α, …
#[inline]
pub fn partner(index: u32) -> u32 {
    const WITHOUT: [u32; 4] = [0x3333_3333, 0x0F0F_0F0F, 0x00FF_00FF, 0x0000_FFFF];
    WITHOUT.iter().enumerate().fold(index, |digits, (level, without)| {
        let moved = digits >> (2 << level) & without;
        let (first, second) = (moved & 0x5555_5555, moved >> 1 & 0x5555_5555);
        let both = first ^ second;
        digits ^ if level % 2 == 0 { second | both << 1 } else { both | first << 1 }
    })
}

/// The second coordinate as a binary fraction, its first digit last: Pascal's triangle modulo 2 (Kollig and Keller, "Efficient
/// multidimensional sampling", 2002). The binomial coefficient of d over i is odd where d has all ones of i (Lucas, 1878), so a digit i is
/// the sum of all digits of the index whose numbers have all ones of i; the ones of a number are taken one after the other.
#[inline]
fn second(index: u32) -> u32 {
    const WITHOUT: [u32; 5] = [0x5555_5555, 0x3333_3333, 0x0F0F_0F0F, 0x00FF_00FF, 0x0000_FFFF];
    WITHOUT.iter().enumerate().fold(index, |digits, (bit, without)| digits ^ digits >> (1 << bit) & without)
}

/// Owen's scrambling of a binary fraction whose first digit is the last bit: whether a digit is turned depends on the digits before it,
/// and on nothing else. The first digits have a coin for each beginning; the sequels of these beginnings are scrambled each by itself.
#[inline]
fn scrambled(digits: u64, coins: u64) -> u64 {
    let beginning = digits & (SIX - 1);
    let sequel = scrambled_roughly(digits >> 6, mix(coins.wrapping_add(beginning.wrapping_mul(GOLDEN))));
    sequel << 6 | scrambled_six(beginning, coins)
}

/// The index in an order that belongs to a key: scrambled in the same way from its first digit on, so that aligned runs of 2^k indices stay
/// together. Here it is the last six digits that have coins: they say how the points
/// of a pixel follow each other.
#[inline]
pub fn shuffled(index: u32, key: u64) -> u32 {
    let (block, place) = (index >> 6, index << 26);
    let coins = mix(key.wrapping_add(u64::from(block).wrapping_mul(GOLDEN)));
    let place = scrambled_six(place.reverse_bits().into(), coins) as u32;
    let block = (scrambled_roughly((block << 6).reverse_bits().into(), key) as u32).reverse_bits();
    block >> 6 << 6 | place.reverse_bits() >> 26
}

/// As many beginnings as six digits have.
const SIX: u64 = 1 << 6;

/// Six digits with a coin for each beginning of less than six: the 63 of them are bits of a word.
#[inline]
fn scrambled_six(digits: u64, coins: u64) -> u64 {
    (0..6).fold(digits, |scrambled, level| {
        let before = digits & ((1 << level) - 1);
        scrambled ^ (coins >> (1 << level | before) & 1) << level
    })
}

/// Sums and products of whole numbers, read from the last bit on, have what a scrambling asks for (Laine and Karras, "Stratified
/// sampling for stochastic transparency", 2011), but fewer coins than beginnings: of the four for the third digit three decide the
/// last one.
#[inline]
fn scrambled_roughly(digits: u64, coins: u64) -> u64 {
    let mut x = digits.wrapping_add(coins);
    // A product with an even number has in each digit only those before it.
    x ^= x.wrapping_mul(0x6C50_B47C_3D20_ADEA);
    x = x.wrapping_mul(coins.rotate_right(32) | 1);
    x ^ x.wrapping_mul(0xB82F_1E52_0552_6C56)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(index: u32, key: u64) -> [f64; 2] {
        Scrambling::new(key).point(index)
    }

    /// Whether the digit after the beginning `before` of `level` digits is turned.
    fn is_turned(level: u32, before: u64, key: u64) -> bool {
        scrambled(before, key) >> level & 1 == 1
    }

    #[test]
    fn a_digit_is_turned_by_those_before_it() {
        for k in 0..2000 {
            let (key, digits) = (hash(7, k), hash(8, k) >> 32);
            let one_by_one = (0..40).fold(0, |all, level| {
                let before = digits & ((1 << level) - 1);
                all | ((digits >> level & 1) ^ u64::from(is_turned(level, before, key))) << level
            });
            assert_eq!(scrambled(digits, key) & ((1 << 40) - 1), one_by_one, "{digits:x} {key:x}");
        }
    }

    /// Of the 31 beginnings of less than five digits none is turned more often than not, and no two are turned together more often than
    /// not (five standard deviations).
    #[test]
    fn coins_are_fair_and_unrelated() {
        let keys = 20_000;
        let mut turned = vec![Vec::new(); 31];
        for key in (0..keys).map(|k| hash(3, k)) {
            for level in 0..5 {
                for before in 0..1 << level {
                    turned[((1 << level) - 1 + before) as usize].push(is_turned(level, before, key));
                }
            }
        }
        let is_fair = |count: usize| (count as f64 - keys as f64 / 2.0).abs() < 2.5 * (keys as f64).sqrt();
        for (number, coin) in turned.iter().enumerate() {
            assert!(is_fair(coin.iter().filter(|is_turned| **is_turned).count()), "{number}");
            for other in &turned[..number] {
                assert!(is_fair(coin.iter().zip(other).filter(|(one, other)| one == other).count()), "{number}");
            }
        }
    }

    /// Bit by bit, as the matrix has it.
    #[test]
    fn the_second_coordinate_is_that_of_pascals_triangle() {
        let mut row = 1_u32 << 31;
        for digit in 0..32 {
            assert_eq!(second(1 << digit).reverse_bits(), row, "{digit}");
            row ^= row >> 1;
        }
        assert_eq!(second(0b1011), second(0b1000) ^ second(0b10) ^ second(1));
    }

    #[test]
    fn each_elementary_interval_has_one_point() {
        for (key, start) in [(0, 0), (1, 0), (99, 64)] {
            for k in 0..=8 {
                let start = (start >> k) << k;
                for halvings in 0..=k {
                    let (across, down) = (1_u32 << halvings, 1_u32 << (k - halvings));
                    let mut taken = vec![false; 1 << k];
                    for index in start..start + (1 << k) {
                        let [x, y] = point(index, key);
                        let cell = (y * f64::from(down)) as u32 * across + (x * f64::from(across)) as u32;
                        assert!(!std::mem::replace(&mut taken[cell as usize], true), "{k}, {halvings}");
                    }
                }
            }
        }
    }

    /// However quarterings are shared between the four coordinates of a point and its partner, each box has one of any 4^k successive points.
    #[test]
    fn a_point_and_its_partner_are_spread_jointly() {
        for (keys, start) in [([0, 1], 0), ([5, 9], 0), ([3, 70], 4096)] {
            for k in 0..=4_u32 {
                for halvings in 0..(k + 1).pow(3) {
                    let [a, b, c] = [1, k + 1, (k + 1).pow(2)].map(|unit| halvings / unit % (k + 1));
                    let Some(d) = k.checked_sub(a + b + c) else { continue };
                    let sides = [a, b, c, d].map(|quarterings| 4_usize.pow(quarterings));
                    let mut taken = vec![false; 4_usize.pow(k)];
                    for index in start..start + 4_u32.pow(k) {
                        let ([x, y], [u, v]) = (point(index, keys[0]), point(partner(index), keys[1]));
                        let parts = [x, y, u, v].into_iter().zip(sides);
                        let cell = parts.fold(0, |cell, (x, side)| cell * side + (x * side as f64) as usize);
                        assert!(!std::mem::replace(&mut taken[cell], true), "{k}, {sides:?}");
                    }
                }
            }
        }
    }

    /// A partner is a (0, 2)-sequence in base 2 by itself.
    #[test]
    fn a_partner_has_the_points_of_the_sequence_in_another_order() {
        for k in 0..=10 {
            for start in [0, 3 << k] {
                let mut places: Vec<_> = (start..start + (1 << k)).map(|index| partner(index) >> k).collect();
                places.dedup();
                assert_eq!(places.len(), 1, "a run of {k} stays together");
            }
        }
        let mut all: Vec<_> = (0..4096).map(partner).collect();
        all.sort_unstable();
        assert!(all.iter().copied().eq(0..4096));
    }

    #[test]
    fn a_shuffle_keeps_runs_together() {
        for key in 0..20 {
            for k in 0..8 {
                let run: Vec<_> = (0..1 << k).map(|index| shuffled(index, key) >> k).collect();
                assert!(run.iter().all(|block| *block == run[0]), "{k}: {run:?}");
            }
        }
    }

    #[test]
    fn each_point_is_uniform_by_itself() {
        for index in [0, 1, 5, 100] {
            for axis in [0, 1] {
                let mut bins = [0_i32; 64];
                (0..6400).for_each(|key| bins[(point(index, key)[axis] * 64.0) as usize] += 1);
                let chi_square: f64 = bins.iter().map(|count| f64::from((count - 100) * (count - 100)) / 100.0).sum();
                assert!(chi_square < 63.0 + 4.0 * 11.3, "point {index}, axis {axis}: {chi_square}");
            }
        }
    }
}
