//! The objects and lights of a scene as they are read: as many objects as there are, unless most of them are refused anyway.

use std::collections::HashSet;
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};

use super::{Light, Object};

/// Reading stops after this many objects with a name that is taken. Up to then each is reported.
pub const MAX_DUPLICATES: usize = 1 << 16;

/// The most lights of a scene. Each is asked for a shadow ray at every hit, and takes many times the bytes of its text.
pub const MAX_LIGHTS: usize = 1 << 17;

/// Reads the objects. A file of nothing but copies would fill the memory before anybody could say what is wrong with it.
pub fn objects<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Object>, D::Error> {
    let mut names = HashSet::new();
    let mut duplicates = 0;
    let check = |object: &Object, _: usize| {
        let is_taken = !object.name.is_empty() && !names.insert(digest(&object.name));
        duplicates += usize::from(is_taken);
        match duplicates > MAX_DUPLICATES {
            true => Err(format!("names must be unique, found more than {MAX_DUPLICATES} that are taken")),
            false => Ok(()),
        }
    };
    deserializer.deserialize_seq(Checked(check, PhantomData))
}

/// Reads the lights.
pub fn lights<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Light>, D::Error> {
    let check = |_: &Light, before: usize| match before < MAX_LIGHTS {
        true => Ok(()),
        false => Err(format!("too many lights, expected at most {MAX_LIGHTS}, found more")),
    };
    deserializer.deserialize_seq(Checked(check, PhantomData))
}

/// A list of which each item is checked, with how many are before it, as soon as it is read.
struct Checked<T, F>(F, PhantomData<T>);

impl<'de, T: Deserialize<'de>, F: FnMut(&T, usize) -> Result<(), String>> Visitor<'de> for Checked<T, F> {
    type Value = Vec<T>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an array")
    }

    fn visit_seq<A: SeqAccess<'de>>(mut self, mut seq: A) -> Result<Vec<T>, A::Error> {
        let mut list = Vec::new();
        while let Some(item) = seq.next_element()? {
            (self.0)(&item, list.len()).map_err(A::Error::custom)?;
            list.push(item);
        }
        Ok(list)
    }
}

/// A number that stands for a name, which takes less room.
pub fn digest(name: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    name.hash(&mut hasher);
    hasher.finish()
}
