//! Random numbers as a hash of (seed, pixel, sample, dimension).
//!
//! There is no running state: whoever asks for the number of a dimension of a sample gets the same bits, whatever was asked
//! before, in whatever crop, order or thread. [`Draws`] are the numbers of one sample; a [`Dimension`] says what a number decides. This
//! module knows nothing of scenes and rays.

mod dimension;
mod draws;
pub mod permutation;
pub mod sobol;
mod splits;
mod strata;
pub mod warp;

pub use dimension::{Dimension, Partner, Route};
pub use draws::{Arrangement, Draws, OfPixel, Pick};
pub use splits::Splits;
pub use strata::Stratum;

/// The hash of a word under a key. Distinct words give distinct hashes under a key, and distinct keys of a word.
#[inline(always)]
pub fn hash(key: u64, word: u64) -> u64 {
    mix(key ^ mix(word.wrapping_add(GOLDEN)))
}

/// 53 bits of a hash as a number in [0, 1).
#[inline(always)]
pub fn unit(bits: u64) -> f64 {
    (bits >> 11) as f64 * (1.0 / (1_u64 << 53) as f64)
}

/// 2⁶⁴ over the golden ratio: multiples of it are spread evenly.
pub const GOLDEN: u64 = 0x9E37_79B9_7F4A_7C15;

/// Each bit of the result depends on every bit given: the finaliser of SplitMix64 (Steele, Lea and Flood, "Fast splittable
/// pseudorandom number generators", 2014; constants of Stafford's variant 13). It can be undone, so that nothing collides.
#[inline(always)]
pub fn mix(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_lie_in_the_unit_interval() {
        assert_eq!(unit(0), 0.0);
        assert_eq!(unit(u64::MAX), 1.0 - f64::EPSILON / 2.0);
    }

    /// Chi-square of 2¹⁶ numbers in 256 bins, at three standard deviations, for words that count up and keys that count up.
    #[test]
    fn hashes_of_neighbours_are_uniform_and_unrelated() {
        let spread = |hash_of: &dyn Fn(u64) -> u64| {
            let mut bins = [0_u32; 256];
            (0..1 << 16).for_each(|k| bins[(unit(hash_of(k)) * 256.0) as usize] += 1);
            bins.iter().map(|count| (f64::from(*count) - 256.0) * (f64::from(*count) - 256.0) / 256.0).sum::<f64>()
        };
        for chi_square in [
            spread(&|k| hash(0, k)),
            spread(&|k| hash(k, 0)),
            spread(&|k| hash(hash(k, 1), 2)),
            // Whether the numbers of neighbouring words, and of neighbouring keys, agree in their first bits.
            spread(&|k| hash(7, k) ^ hash(7, k + 1)),
            spread(&|k| hash(k, 7) ^ hash(k + 1, 7)),
        ] {
            assert!((chi_square - 255.0).abs() < 3.0 * 22.6, "{chi_square}");
        }
    }

    #[test]
    fn each_bit_of_a_word_changes_half_of_the_hash() {
        for bit in 0..64 {
            let changed: u32 = (0..1000).map(|k| (hash(3, k) ^ hash(3, k ^ (1 << bit))).count_ones()).sum();
            let mean = f64::from(changed) / 1000.0;
            assert!((mean - 32.0).abs() < 0.7, "bit {bit}: {mean}");
        }
    }
}
