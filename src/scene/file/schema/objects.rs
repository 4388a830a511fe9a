//! The objects and lights of a scene as they are read: as many objects as there are, unless most of them are refused anyway.

use std::collections::HashSet;
use std::fmt;
use std::hash::{DefaultHasher, Hash, Hasher};

use serde::de::{Deserializer, Error, SeqAccess, Visitor};

use super::{Light, Object};

/// Reading stops after this many objects with a name that is taken. Up to then each is reported.
pub const MAX_DUPLICATES: usize = 1 << 16;

/// Reads the objects. A file of nothing but copies would fill the memory before anybody could say what is wrong with it.
pub fn objects<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Object>, D::Error> {
    deserializer.deserialize_seq(Objects)
}

struct Objects;

impl<'de> Visitor<'de> for Objects {
    type Value = Vec<Object>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an array")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Vec<Object>, A::Error> {
        let mut objects: Vec<Object> = Vec::new();
        let mut names = HashSet::new();
        let mut duplicates = 0;
        while let Some(object) = seq.next_element::<Object>()? {
            let is_taken = !object.name.is_empty() && !names.insert(digest(&object.name));
            duplicates += usize::from(is_taken);
            if duplicates > MAX_DUPLICATES {
                let message = format!("names must be unique, found more than {MAX_DUPLICATES} that are taken");
                return Err(A::Error::custom(message));
            }
            objects.push(object);
        }
        Ok(objects)
    }
}

/// The most lights of a scene. Each is asked for a shadow ray at every hit, and takes many times the bytes of its text.
pub const MAX_LIGHTS: usize = 1 << 17;

/// Reads the lights.
pub fn lights<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Light>, D::Error> {
    deserializer.deserialize_seq(Lights)
}

struct Lights;

impl<'de> Visitor<'de> for Lights {
    type Value = Vec<Light>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an array")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Vec<Light>, A::Error> {
        let mut lights: Vec<Light> = Vec::new();
        while let Some(light) = seq.next_element()? {
            if lights.len() == MAX_LIGHTS {
                return Err(A::Error::custom(format!("too many lights, expected at most {MAX_LIGHTS}, found more")));
            }
            lights.push(light);
        }
        Ok(lights)
    }
}

/// A number that stands for a name, which takes less room.
pub fn digest(name: &str) -> u64 {
    let mut hasher = DefaultHasher::new();
    name.hash(&mut hasher);
    hasher.finish()
}
