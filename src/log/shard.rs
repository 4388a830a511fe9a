//! One of several equal parts of a piece of work, so that several machines can share it.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::ops::Range;
use std::str::FromStr;

/// The most shards.
pub const MAX_SHARDS: u32 = 1 << 20;

/// One of several shards.
///
/// What each has depends on the two numbers and on the work alone. Pieces of a picture are dealt out in turn, since neighbours take
/// about as long as each other; what must stay in one order is cut into stretches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "[u32; 2]", into = "[u32; 2]")]
pub struct Shard {
    number: u32,
    of: u32,
}

impl Shard {
    /// The only one.
    pub const WHOLE: Shard = Shard { number: 1, of: 1 };

    /// The shard with this number, from 1, of `of` shards; `None` where there is none.
    pub fn new(number: u32, of: u32) -> Option<Shard> {
        ((1..=of).contains(&number) && of <= MAX_SHARDS).then_some(Shard { number, of })
    }

    /// Its number, from 1.
    pub fn number(self) -> u32 {
        self.number
    }

    /// How many there are.
    pub fn of(self) -> u32 {
        self.of
    }

    /// Whether it has a piece, of those numbered from 0.
    pub fn has(self, piece: u32) -> bool {
        piece % self.of == self.number - 1
    }

    /// Its stretch of `count` items.
    pub fn stretch(self, count: u64) -> Range<u64> {
        // No product overflows: more than 2^64 items would be needed.
        let end = |number: u32| (u128::from(count) * u128::from(number) / u128::from(self.of)) as u64;
        end(self.number - 1)..end(self.number)
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Shard, String> {
        let numbers = text.split_once('/').and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
        let shard = numbers.and_then(|(number, of)| Shard::new(number, of));
        shard.ok_or_else(|| {
            format!("expected I/N, the shard I from 1 to N of N shards (at most {MAX_SHARDS}), found `{text}`")
        })
    }
}

impl TryFrom<[u32; 2]> for Shard {
    type Error = String;

    fn try_from([number, of]: [u32; 2]) -> Result<Shard, String> {
        Shard::new(number, of).ok_or_else(|| format!("there is no shard {number} of {of}"))
    }
}

impl From<Shard> for [u32; 2] {
    fn from(shard: Shard) -> [u32; 2] {
        [shard.number, shard.of]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_piece_and_every_thing_has_one_shard() {
        for (of, count) in [(1, 0), (1, 5), (3, 5), (5, 3), (7, 700), (MAX_SHARDS, 9)] {
            let shards = || (1..=of.min(20)).filter_map(|number| Shard::new(number, of));
            for piece in 0..of.min(20) {
                assert_eq!(shards().filter(|shard| shard.has(piece)).count(), 1);
            }
            let all = (1..=of).filter_map(|number| Shard::new(number, of));
            let last = all.fold(0, |end, shard| {
                let stretch = shard.stretch(count);
                assert_eq!(stretch.start, end);
                assert!(stretch.end - stretch.start <= count / u64::from(of) + 1);
                stretch.end
            });
            assert_eq!(last, count);
        }
        assert_eq!(Shard::new(MAX_SHARDS, MAX_SHARDS).map(|shard| shard.stretch(u64::MAX).end), Some(u64::MAX));
    }

    #[test]
    fn as_text() {
        assert_eq!("2/5".parse(), Ok(Shard { number: 2, of: 5 }));
        for text in ["", "2", "0/3", "4/3", "1/0", "-1/2", "1/2/3", "1/1048577", "a/b", "1/"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
        assert_eq!(Shard { number: 2, of: 5 }.to_string(), "2/5");
    }
}
