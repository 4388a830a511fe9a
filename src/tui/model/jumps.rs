//! The steps that jumps began at, and the way back to them, also from another pixel.

use crate::log::tree::Place;

/// A step that can be gone back to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spot {
    /// Its pixel; none in the log of a ray or a region.
    pub pixel: Option<[u32; 2]>,
    /// Its event in the log of that pixel.
    pub event: usize,
    /// Where that is, in any log.
    pub place: Place,
}

/// The steps that jumps began at.
#[derive(Clone, Debug, Default)]
pub struct Jumps {
    /// All that one can go back to, the latest last.
    list: Vec<Spot>,
    /// The latest, to which one can go over and back.
    last: Option<Spot>,
    /// The one before it that isn't the same: where the latest jump doesn't move, it is this that one comes back to.
    other: Option<Spot>,
}

/// So many are remembered.
const MOST: usize = 1000;

impl Jumps {
    /// The next jump begins here. Whether it moves isn't known yet.
    fn turn_at(&mut self, here: Spot) {
        if self.last.as_ref() != Some(&here) {
            self.other = self.last.replace(here);
        }
    }

    /// Remembers where a jump begins.
    pub fn remember(&mut self, here: Spot) {
        if self.list.len() == MOST {
            self.list.remove(0);
        }
        self.list.push(here.clone());
        self.turn_at(here);
    }

    /// Where the latest jump began that can be gone back to from here; it is forgotten.
    pub fn back(&mut self, here: Spot) -> Option<Spot> {
        // A jump that led nowhere, such as to a pixel that can't be traced, isn't a way back.
        while let Some(spot) = self.list.pop() {
            if spot != here {
                self.turn_at(here);
                return Some(spot);
            }
        }
        None
    }

    /// Where the latest jump began that has moved.
    pub fn turned(&self, here: &Spot) -> Option<Spot> {
        // A jump that doesn't move, such as to the step where one is, hides none that did.
        [&self.last, &self.other].into_iter().flatten().find(|spot| *spot != here).cloned()
    }
}
