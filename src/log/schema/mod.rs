//! The format of a log as a JSON Schema of its lines, and as a table for people.
//!
//! Quantities come from the table of names, words from the enums of the events: what is missing here is missing there.

mod json;
mod kinds;
mod text;

pub use json::json_schema;
pub use kinds::{Field, Kind, MARKS, Of, STEPS};
pub use text::{quantities, text};

use super::name::Name;

/// The keys of all quantities in the order of the table, each once, with the names that share it.
pub fn keys() -> Vec<(&'static str, Vec<Name>)> {
    let mut keys: Vec<(&'static str, Vec<Name>)> = Vec::new();
    let mut places = std::collections::HashMap::new();
    for name in Name::all() {
        let place = *places.entry(name.key()).or_insert(keys.len());
        if place == keys.len() {
            keys.push((name.key(), Vec::new()));
        }
        keys[place].1.push(name);
    }
    keys
}
