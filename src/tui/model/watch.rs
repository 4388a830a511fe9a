//! Quantities that are watched: by their keys, so that they are found in any log, with their values in the one that is shown.

use super::quantity::{self, Part, value_at};
use crate::log::{Events, Name, Step, Tree, Unit, Value};
use std::collections::HashMap;

/// What is watched.
#[derive(Clone, Debug, Default)]
pub struct Watches {
    /// What is pinned, in the order in which it was.
    pub pinned: Vec<Watched>,
    /// What the history was last asked of.
    pub history: Option<Watched>,
}

/// A quantity, or a number of it.
#[derive(Clone, Debug)]
pub struct Watched {
    /// It by any of its formulas.
    pub names: Vec<Name>,
    /// Which number of it.
    pub part: Part,
    /// The events that compute it or are given it, in order.
    pub events: Vec<u32>,
    /// How their values are spread.
    pub spread: Option<Spread>,
}

/// The most bars of a spread.
const MOST_BARS: usize = 24;

impl Watched {
    /// A quantity that wasn't looked for yet, by any of its names.
    pub fn new(name: Name, part: Part) -> Watched {
        Watched { names: Name::all().filter(|other| other.is(name)).collect(), part, events: Vec::new(), spread: None }
    }

    /// What it is called on the screen: `N·L`, `N.x`.
    pub fn shown(&self) -> String {
        self.called(quantity::shown)
    }

    /// What it is called in a log: `shade.n_dot_l`, `hit.normal.x`.
    pub fn key(&self) -> String {
        self.called(Name::key)
    }

    fn called(&self, name: fn(Name) -> &'static str) -> String {
        let Some(first) = self.names.first() else { return String::new() };
        let letters = if first.unit() == Unit::Intensity { ["r", "g", "b"] } else { ["x", "y", "z"] };
        match self.part {
            Part::Whole => name(*first).to_owned(),
            Part::Component(index) => format!("{}.{}", name(*first), letters[index.min(2)]),
            Part::Length => format!("|{}|", name(*first)),
        }
    }

    /// Whether both are the same.
    pub fn is(&self, other: &Watched) -> bool {
        self.names.first() == other.names.first() && self.part == other.part
    }

    /// What it is of a value.
    pub fn of(&self, value: &Value) -> Option<Value> {
        match self.part {
            Part::Whole => Some(*value),
            part => part.of(value).map(Value::Number),
        }
    }

    /// Its value at an event.
    pub fn value(&self, events: &Events, event: usize) -> Option<Value> {
        value_at(events, event, |name| self.names.contains(&name)).and_then(|value| self.of(&value))
    }

    /// Looks for it in a log. An input that the same ray was given before counts once.
    pub fn find(&mut self, events: &Events, tree: &Tree) {
        let mut is_name = vec![false; Name::all().count()];
        self.names.iter().for_each(|name| is_name[*name as usize] = true);
        let ray = |event: usize| {
            let is_ray = |node: &usize| matches!(tree.nodes()[*node].step, Some(Step::Ray { .. }));
            tree.around(tree.owner(event)).find(is_ray)
        };
        self.events.clear();
        let mut latest: HashMap<Option<usize>, Value> = HashMap::new();
        for (at, happening) in events.iter().enumerate() {
            let noted = happening.noted().filter(|(name, _)| is_name[*name as usize]);
            let given = || events.given(happening).iter().find(|(name, _)| is_name[*name as usize]);
            let value = match (noted, noted.is_none().then(given).flatten()) {
                (Some((_, value)), _) => value,
                (None, Some((_, value))) => {
                    if latest.get(&ray(at)).is_some_and(|known| known.same_bits(value)) {
                        continue;
                    }
                    *value
                }
                (None, None) => continue,
            };
            latest.insert(ray(at), value);
            self.events.push(at as u32);
        }
        self.spread = self.spread_of(events, self.events.len());
    }

    /// How the values of the first events of it are spread, triples by their lengths; nothing of a single one.
    pub fn spread_of(&self, events: &Events, count: usize) -> Option<Spread> {
        let number = |event: &u32| match self.value(events, *event as usize)? {
            Value::Number(x) => Some(x),
            triple => Part::Length.of(&triple),
        };
        let numbers: Vec<_> = self.events.iter().take(count).filter_map(number).collect();
        Spread::of(&numbers, MOST_BARS).filter(|_| numbers.len() > 1)
    }
}

/// How some numbers are spread.
#[derive(Clone, Debug, PartialEq)]
pub struct Spread {
    /// The least of those that are finite.
    pub least: f64,
    /// The greatest.
    pub greatest: f64,
    /// Bars in order, each as a part of the way from the least to the greatest; `None` where no number is finite.
    pub bars: Vec<Option<f64>>,
}

impl Spread {
    /// That of these numbers in this many bars at most, of which each is the mean of its numbers; `None` where none is finite.
    pub fn of(numbers: &[f64], most_bars: usize) -> Option<Spread> {
        let finite = || numbers.iter().copied().filter(|x| x.is_finite());
        let least = finite().reduce(f64::min)?;
        let greatest = finite().reduce(f64::max)?;
        let count = numbers.len().min(most_bars.max(1));
        let bar = |bar: usize| {
            let own = &numbers[bar * numbers.len() / count..(bar + 1) * numbers.len() / count];
            let own = own.iter().copied().filter(|x| x.is_finite());
            // Halves, so that no difference overflows.
            let part = |x: f64| match greatest / 2.0 - least / 2.0 {
                0.0 => 0.5,
                range => (x / 2.0 - least / 2.0) / range,
            };
            let (sum, count) = own.fold((0.0, 0_u32), |(sum, count), x| (sum + part(x), count + 1));
            (count > 0).then(|| sum / f64::from(count))
        };
        Some(Spread { least, greatest, bars: (0..count).map(bar).collect() })
    }
}
