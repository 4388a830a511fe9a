//! Follows a worked example: the computation goes on with the numbers that are listed, and all others are rounded by hand.

use super::DIGITS;
use crate::log::tree::path_of_child;
use crate::log::{Log, Name, Step, Tree, Value, What};
use crate::probe::{Alteration, Altered, Erased, Quantity, Silent, round_half_away};
use crate::sampling;
use crate::scene::Scene;
use std::collections::HashMap;

/// Where a quantity is in a walk.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Place {
    /// The path of its ray.
    pub path: String,
    /// Its key.
    pub key: &'static str,
    /// Which of several with this key on this path, from 0.
    pub nth: usize,
}

/// Numbers that go on in place of what they were computed as: as many components as are known.
pub(super) type Listed = HashMap<Place, Vec<f64>>;

/// The quantities of a walk in its order, with their places.
#[derive(Debug, Default)]
pub(super) struct Values {
    in_order: Vec<(Place, Value)>,
    count: HashMap<(String, &'static str), usize>,
}

impl Values {
    /// Those of a log.
    pub fn of(log: &Log) -> Values {
        let tree = Tree::of(&log.events);
        let mut values = Values::default();
        for (event, happening) in log.events.iter().enumerate() {
            if let What::Note { name, value } = happening.what {
                let place = values.next_place(&tree.path(tree.owner(event)), name.key());
                values.in_order.push((place, value));
            }
        }
        values
    }

    /// What each quantity comes to from the listed values before it.
    pub fn following(scene: &Scene, pixel: [u32; 2], listed: &Listed) -> Values {
        let alteration = Following { listed, paths: Vec::new(), recomputed: Values::default() };
        let mut following = Altered { alteration, probe: Silent };
        sampling::pixel(scene, pixel, &mut Erased::of(&mut following));
        following.alteration.recomputed
    }

    /// The places in the order of the walk.
    pub fn places(&self) -> impl Iterator<Item = &Place> {
        self.in_order.iter().map(|(place, _)| place)
    }

    /// The value at a place, if there is one in this walk.
    pub fn at(&self, place: &Place) -> Option<Value> {
        self.in_order.iter().find(|(at, _)| at == place).map(|(_, value)| *value)
    }

    /// Its first components, at most this many.
    pub fn components(&self, place: &Place, most: usize) -> Vec<f64> {
        self.at(place).map_or_else(Vec::new, |value| value.components().iter().copied().take(most).collect())
    }

    fn next_place(&mut self, path: &str, key: &'static str) -> Place {
        let count = self.count.entry((path.to_owned(), key)).or_default();
        *count += 1;
        Place { path: path.to_owned(), key, nth: *count - 1 }
    }
}

/// Goes on with the listed values and keeps what they replace.
struct Following<'l> {
    listed: &'l Listed,
    paths: Vec<String>,
    recomputed: Values,
}

impl Following<'_> {
    fn path(&self) -> &str {
        self.paths.last().map_or("", String::as_str)
    }
}

impl Alteration for Following<'_> {
    fn alter<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let rounded = value.map(|_, x| round_half_away(x, DIGITS));
        let path = self.path().to_owned();
        let place = self.recomputed.next_place(&path, name.key());
        let listed = self.listed.get(&place).map_or(&[][..], Vec::as_slice);
        self.recomputed.in_order.push((place, rounded.value()));
        rounded.map(|index, x| listed.get(index).copied().unwrap_or(x))
    }

    fn enter(&mut self, step: Step) {
        self.paths.push(path_of_child(self.path(), step));
    }

    fn leave(&mut self) {
        self.paths.pop();
    }
}
