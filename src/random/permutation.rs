//! Permutations that are computed and not kept.

use super::{GOLDEN, hash, mix};

/// How often a number is scrambled. With six rounds some pairs of places of sixteen are preferred, with eight none of 3 to 16.
const ROUNDS: u64 = 8;

/// The word of the last turn, beyond those of the rounds and of the jitter, which has the same key.
const TURN: u64 = u64::MAX;

/// Where the permutation that `key` chooses puts `index` among `count` places.
///
/// A number of as many bits as the places need is scrambled by steps that can be undone, until it is that of a place ("cycle
/// walking"; Kensler, "Correlated multi-jittered sampling", 2013, section 3, whose way of doing it this follows).
pub fn permuted(index: u32, count: u32, key: u64) -> u32 {
    debug_assert!(index < count, "an index is one of the places");
    if count < 2 {
        return 0;
    }
    let bits = 32 - (count - 1).leading_zeros();
    let mask = u32::MAX >> (32 - bits);
    // Of two bits one moves: a shift by both would leave the lower one to odd factors, which keep its order.
    let shift = (bits / 2).max(1);
    let mut place = index;
    loop {
        for round in 0..ROUNDS {
            let word = mix(key.wrapping_add((round + 1).wrapping_mul(GOLDEN)));
            // An odd factor can be undone modulo a power of two, and so can what is added.
            place = place.wrapping_mul(word as u32 | 1).wrapping_add((word >> 32) as u32) & mask;
            place ^= place >> shift;
        }
        if place < count {
            break;
        }
    }
    // Turned by the same amount for every index, so that each place is equally likely for each index.
    ((u64::from(place) + hash(key, TURN) % u64::from(count)) % u64::from(count)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;

    #[test]
    fn every_place_is_taken_once() {
        for count in (1..70).chain([100, 1000, 4096, 5000]) {
            for key in 0..5 {
                let mut taken = vec![false; count as usize];
                (0..count).for_each(|index| taken[permuted(index, count, key) as usize] = true);
                assert!(taken.iter().all(|is_taken| *is_taken), "{count}, key {key}");
            }
        }
    }

    /// Pairs of places of two indices, over many keys: none is preferred (chi-square of 559 pairs, at five standard deviations).
    #[test]
    fn every_order_is_about_as_likely() {
        let keys = 10_000;
        for count in 3..=16 {
            let orders: Vec<Vec<u32>> =
                (0..keys).map(|key| (0..count).map(|index| permuted(index, count, key)).collect()).collect();
            let freedom = f64::from(count * (count - 1)) - 1.0;
            let limit = freedom + 5.0 * libm::sqrt(2.0 * freedom);
            let expected = keys as f64 / f64::from(count * (count - 1));
            for (one, other) in (0..count as usize).flat_map(|other| (0..other).map(move |one| (one, other))) {
                let mut pairs = vec![0_u32; (count * count) as usize];
                orders.iter().for_each(|order| pairs[(order[one] * count + order[other]) as usize] += 1);
                let off_diagonal = (0..count * count).filter(|pair| pair / count != pair % count);
                let deviation = |pair: u32| f64::from(pairs[pair as usize]) - expected;
                let chi_square: f64 = off_diagonal.map(|pair| deviation(pair) * deviation(pair) / expected).sum();
                assert!(chi_square < limit, "{count}, {one}, {other}: {chi_square} > {limit}");
            }
        }
    }

    /// All 3!, 4! and 5! orders come, each about as often (five standard deviations).
    #[test]
    fn few_places_have_all_their_orders() {
        for (count, orders) in [(3, 6), (4, 24), (5, 120)] {
            let keys = 200 * orders;
            let mut seen: BTreeMap<Vec<u32>, f64> = BTreeMap::new();
            for key in 0..keys {
                *seen.entry((0..count).map(|index| permuted(index, count, key)).collect()).or_default() += 1.0;
            }
            assert_eq!(seen.len() as u64, orders, "{count}");
            let chi_square: f64 = seen.values().map(|found| (found - 200.0) * (found - 200.0) / 200.0).sum();
            let freedom = orders as f64 - 1.0;
            assert!(chi_square < freedom + 5.0 * libm::sqrt(2.0 * freedom), "{count}: {chi_square}");
        }
    }
}
