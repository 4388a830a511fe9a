//! The first two dimensions of Sobol's sequence, scrambled by Owen's method.
//!
//! The first 2^k points have one in each of the 2^k parts into which halvings of the sides cut the square, however the
//! halvings are shared between the sides: a (0, 2)-sequence. Scrambling keeps that, and makes each point uniform by itself, so that
//! a mean over the points has no bias (Owen, "Randomly permuted (t,m,s)-nets and (t,s)-sequences", 1995). More dimensions are
//! further pairs, each scrambled by itself and taken in an order of its own (Burley, "Practical hash-based Owen scrambling",
//! 2020). Written out here because 24 bits, which the crates for it give, are too few for f64.

use super::{GOLDEN, hash, mix, unit};
use pulp::Arch;
use std::array;
use std::sync::LazyLock;

/// The best instructions of the processor. All digits of a number are scrambled at once; they are whole numbers, and have the same
/// bits by whatever instructions.
static INSTRUCTIONS: LazyLock<Arch> = LazyLock::new(Arch::new);

/// The point with this number, its coordinates in [0, 1) with all 53 bits.
pub fn point(index: u32, key: u64) -> [f64; 2] {
    INSTRUCTIONS.dispatch(
        #[inline(always)]
        || point_at(index, key),
    )
}

/// The point with this number of a sequence that stands in an order of its own: aligned runs of 2^k indices stay together.
pub fn point_in_order(index: u32, order: u64, key: u64) -> [f64; 2] {
    INSTRUCTIONS.dispatch(
        #[inline(always)]
        || point_at(scrambled(index, order), key),
    )
}

#[inline(always)]
fn point_at(index: u32, key: u64) -> [f64; 2] {
    [coordinate(index.reverse_bits(), index, hash(key, 0)), coordinate(second(index), index, hash(key, 1))]
}

#[inline(always)]
fn coordinate(bits: u32, index: u32, key: u64) -> f64 {
    // What 32 bits leave open is uniform too.
    unit(u64::from(scrambled(bits, key)) << 32 | hash(key, index.into()) >> 32)
}

/// The second coordinate as a binary fraction: Pascal's triangle modulo 2 (Kollig and Keller, "Efficient multidimensional
/// sampling", 2002).
#[inline(always)]
fn second(index: u32) -> u32 {
    let part = |digit: usize| ROWS[digit] & 0_u32.wrapping_sub(index >> digit & 1);
    (0..32).fold(0, |bits, digit| bits ^ part(digit))
}

/// What each digit of an index adds to it.
const ROWS: [u32; 32] = {
    let mut rows = [1 << 31; 32];
    let mut digit = 1;
    while digit < 32 {
        rows[digit] = rows[digit - 1] ^ rows[digit - 1] >> 1;
        digit += 1;
    }
    rows
};

/// Owen's scrambling of a binary fraction: whether a digit is turned depends on the digits before it, and on nothing else. It is the
/// first bit of the hash of these digits and their number.
#[inline(always)]
fn scrambled(bits: u32, key: u64) -> u32 {
    // Without a branch or a number that the next level needs, so that levels can be taken side by side.
    let turned = |level: usize| {
        let level = level as u64;
        let before = u64::from(bits) << level >> 32;
        let word = (before.wrapping_mul(GOLDEN << 6)).wrapping_add(level.wrapping_mul(GOLDEN));
        mix(key.wrapping_add(word)) >> 63 << (31 - level)
    };
    let turned: [u64; 32] = array::from_fn(turned);
    bits ^ turned.iter().fold(0, |all, turned| all | turned) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Digit by digit, as the method has it.
    #[test]
    fn scrambling_turns_each_digit_by_those_before_it() {
        for k in 0..2000 {
            let (key, bits) = (hash(7, k), (hash(8, k) as u32) >> (k % 33).min(31));
            let turned = |level: u32| {
                let before = u64::from(bits).checked_shr(32 - level).unwrap_or(0);
                let word = (before << 6 | u64::from(level)).wrapping_mul(GOLDEN);
                ((mix(key.wrapping_add(word)) >> 63) as u32) << (31 - level)
            };
            let one_by_one = (0..32).fold(bits, |scrambled, level| scrambled ^ turned(level));
            assert_eq!(scrambled(bits, key), one_by_one, "{bits:x} {key:x}");
            assert_eq!(point(bits, key), point_at(bits, key));
            assert_eq!(point_in_order(bits, key, !key), point_at(one_by_one, !key));
        }
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

    #[test]
    fn a_shuffle_keeps_runs_together() {
        for key in 0..20 {
            for k in 0..8 {
                let run: Vec<_> = (0..1 << k).map(|index| scrambled(index, key) >> k).collect();
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
