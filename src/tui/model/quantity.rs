//! Quantities by the names that people type: a key of the log, a symbol as it is on the screen, and a number of a value.

use crate::log::scope::{self, Operand};
use crate::log::{Events, Name, Tree, Value, What};
use crate::tui::text::ascii;

/// A number of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// The value itself.
    Whole,
    /// A component of a triple.
    Component(usize),
    /// The length of a triple, the magnitude of a number.
    Length,
}

impl Part {
    /// This number of a value, if it has it.
    pub fn of(self, value: &Value) -> Option<f64> {
        match (self, value) {
            (Part::Whole, Value::Number(number)) => Some(*number),
            (Part::Component(index), Value::Triple(triple)) => triple.get(index).copied(),
            (Part::Length, Value::Number(number)) => Some(number.abs()),
            (Part::Length, Value::Triple([x, y, z])) => Some((x * x + y * y + z * z).sqrt()),
            _ => None,
        }
    }
}

/// The letters of the components behind a dot: those of points and those of colours.
const COMPONENTS: [&str; 3] = ["xr", "yg", "zb"];

/// The component that a letter stands for.
pub fn component(letter: &str) -> Option<usize> {
    COMPONENTS.iter().position(|both| letter.len() == 1 && both.contains(letter))
}

/// The quantities that a text names and which number of them: `N·L`, `ray.direction.y`, `|N|`.
pub fn named(text: &str) -> Option<(Vec<Name>, Part)> {
    let text = text.trim();
    let whole = called(text);
    if !whole.is_empty() {
        return Some((whole, Part::Whole));
    }
    if let Some(inner) = text.strip_prefix('|').and_then(|text| text.strip_suffix('|')) {
        let names = called(inner);
        return Some((names, Part::Length)).filter(|(names, _)| !names.is_empty());
    }
    let (before, letter) = text.rsplit_once('.')?;
    let component = component(letter)?;
    Some((called(before), Part::Component(component))).filter(|(names, _)| !names.is_empty())
}

/// The quantities with this key or symbol; symbols also as they are written in ASCII.
pub fn called(text: &str) -> Vec<Name> {
    let bare: String = text.chars().filter(|c| *c != ' ').collect();
    let is_called = |name: &Name| name.key() == bare || name.symbol() == bare || ascii(name.symbol()) == bare;
    Name::all().filter(is_called).collect()
}

/// All that a quantity may be called.
pub fn words() -> impl Iterator<Item = &'static str> {
    Name::all().flat_map(|name| [name.key(), name.symbol()])
}

/// What a quantity is called on the screen: its symbol, or its key where others have that symbol, too.
pub fn shown(name: Name) -> &'static str {
    let has_rivals = Name::all().any(|other| other.symbol() == name.symbol() && !other.is(name));
    if has_rivals { name.key() } else { name.symbol() }
}

/// What an event has of one of these quantities: noted, or among its inputs.
pub fn value_at(events: &Events, event: usize, is_it: impl Fn(Name) -> bool) -> Option<Value> {
    let happening = events.get(event)?;
    match happening.what {
        What::Note { name, value } if is_it(name) => Some(value),
        _ => events.given(happening).iter().find(|(name, _)| is_it(*name)).map(|(_, value)| *value),
    }
}

/// The latest value of one of these quantities, which have one symbol, that is seen from an event, as a formula there takes it.
pub fn latest(events: &Events, tree: &Tree, event: usize, names: &[Name]) -> Option<Operand> {
    let symbol = names.first()?.symbol();
    let found = scope::operand(events, tree, event, symbol)?;
    if value_at(events, found.event, |name| names.contains(&name)).is_some_and(|value| value.same_bits(&found.value)) {
        return Some(found);
    }
    scope::operand_among(events, tree, event, names)
}
