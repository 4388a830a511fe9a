//! Which number a name has: the names themselves are in the header only, of which there may be a million.

use crate::log::header::Header;
use std::hash::{BuildHasher, RandomState};

/// A header, with the numbers of the names in it.
pub(super) struct Lookup {
    pub header: Header,
    objects: Numbers,
    lights: Numbers,
}

impl Lookup {
    /// Those of a header.
    pub fn of(header: Header) -> Lookup {
        Lookup { objects: Numbers::of(&header.objects), lights: Numbers::of(&header.lights), header }
    }

    /// The object of this name.
    pub fn object(&self, name: &str) -> Result<u32, String> {
        self.objects.find(&self.header.objects, name).ok_or_else(|| format!("object `{name}` isn't in the header"))
    }

    /// The light of this name.
    pub fn light(&self, name: &str) -> Result<u32, String> {
        self.lights.find(&self.header.lights, name).ok_or_else(|| format!("light `{name}` isn't in the header"))
    }
}

/// The numbers of names, found by their hashes.
struct Numbers {
    /// As many as a power of two, half of them [`NONE`] or more. A name is where its hash says, or in the next places behind.
    places: Vec<u32>,
    hasher: RandomState,
}

/// A free place.
const NONE: u32 = u32::MAX;

impl Numbers {
    /// Those of these names. The first of equal names wins, as it does in a scene.
    fn of(names: &[String]) -> Numbers {
        let places = vec![NONE; (names.len() * 2).next_power_of_two()];
        let mut numbers = Numbers { places, hasher: RandomState::new() };
        for (number, name) in (0..).zip(names) {
            let place = numbers.place(names, name);
            if numbers.places[place] == NONE {
                numbers.places[place] = number;
            }
        }
        numbers
    }

    /// The number of one of the names.
    #[inline]
    fn find(&self, names: &[String], name: &str) -> Option<u32> {
        Some(self.places[self.place(names, name)]).filter(|number| *number != NONE)
    }

    /// Where a name is, or is to be.
    fn place(&self, names: &[String], name: &str) -> usize {
        let mut place = self.hasher.hash_one(name) as usize;
        loop {
            place &= self.places.len() - 1;
            let number = self.places[place];
            if number == NONE || names[number as usize] == name {
                return place;
            }
            place += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_has_the_number_of_the_first_like_it() {
        for count in [0, 1, 2, 3, 1000] {
            let names: Vec<String> = (0..count).map(|number| format!("n{}", number * 7 % 500)).collect();
            let numbers = Numbers::of(&names);
            for name in &names {
                let first = names.iter().position(|other| other == name).map(|number| number as u32);
                assert_eq!(numbers.find(&names, name), first);
            }
            assert_eq!(numbers.find(&names, "other"), None);
        }
    }
}
