//! The keys that the user has bound: what they do instead of what the table says of them.

use std::collections::BTreeMap;

/// A key, or two characters one after the other.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Chord {
    /// The character before it, such as the first `z` of `zz`.
    pub first: Option<char>,
    /// The name of the key, such as `z`, `^d` or `PgUp`.
    pub key: String,
}

impl Chord {
    /// How it is written.
    pub fn text(&self) -> String {
        self.first.into_iter().map(String::from).chain([self.key.clone()]).collect()
    }
}

/// What a key is bound to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Bound {
    /// Nothing.
    Nothing,
    /// The action with this name.
    Action(String),
    /// A line that is typed behind `:`.
    Line(String),
}

/// The keys that the user has bound otherwise than the table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Bindings {
    /// In the panes, and wherever keys do the same.
    pub keys: BTreeMap<Chord, Bound>,
    /// In lists whose entries can be deleted: whether the key deletes.
    pub in_lists: BTreeMap<Chord, bool>,
}

impl Bindings {
    /// The keys that are bound to a line, with it.
    pub fn lines(&self) -> impl Iterator<Item = (&Chord, &str)> {
        self.keys.iter().filter_map(|(chord, bound)| match bound {
            Bound::Line(line) => Some((chord, line.as_str())),
            _ => None,
        })
    }

    /// Whether a key does nothing that does something by the table.
    pub fn is_unbound(&self, chord: &Chord) -> bool {
        self.keys.get(chord) == Some(&Bound::Nothing) || self.in_lists.get(chord) == Some(&false)
    }

    /// Whether every key does what the table says.
    pub fn is_empty(&self) -> bool {
        self.keys.is_empty() && self.in_lists.is_empty()
    }
}
