//! Permutations that are computed and not kept.

use super::hash;

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
    let shift = bits / 2 + 1;
    let mut place = index;
    loop {
        for round in 0..4 {
            let word = hash(key, round);
            // An odd factor can be undone modulo a power of two, and so can what is added.
            place = place.wrapping_mul(word as u32 | 1).wrapping_add((word >> 32) as u32) & mask;
            place ^= place >> shift.min(31);
        }
        if place < count {
            break;
        }
    }
    // Turned by the same amount for every index, so that each place is equally likely for each index.
    ((u64::from(place) + hash(key, 4) % u64::from(count)) % u64::from(count)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

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

    /// Pairs of places of two indices, over many keys: none is preferred (chi-square at four standard deviations).
    #[test]
    fn every_order_is_about_as_likely() {
        for (count, one, other) in [(8, 0, 1), (8, 2, 6), (7, 0, 3), (16, 0, 8), (16, 14, 15)] {
            let mut pairs = vec![0_u32; (count * count) as usize];
            let keys = 20_000;
            for key in 0..keys {
                let (one, other) = (permuted(one, count, key), permuted(other, count, key));
                pairs[(one * count + other) as usize] += 1;
            }
            let expected = keys as f64 / f64::from(count * (count - 1));
            let off_diagonal = (0..count * count).filter(|pair| pair / count != pair % count);
            let deviation = |pair: u32| f64::from(pairs[pair as usize]) - expected;
            let chi_square: f64 = off_diagonal.map(|pair| deviation(pair) * deviation(pair) / expected).sum();
            let freedom = f64::from(count * (count - 1)) - 1.0;
            let limit = freedom + 4.0 * libm::sqrt(2.0 * freedom);
            assert!(chi_square < limit, "{count}, {one}, {other}: {chi_square} > {limit}");
        }
    }
}
