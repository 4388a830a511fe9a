//! The serde mirror of a line of a log, as it is read. Unknown fields are skipped: a later version may add some.

use super::mark::{Enter, Mark};
use super::spelling::Word;
use crate::log::name::Name;
use crate::log::value::Value;
use crate::log::whole::{Whole, whole};
use serde::de::{Deserializer, IgnoredAny, MapAccess, Visitor};
use serde::{Deserialize, de};
use std::fmt;

/// A line of a log after the header (in a nested document: an element of `children`, without its own).
#[derive(Deserialize)]
pub(super) struct Line<'t> {
    pub at: Option<Whole<u32>>,
    pub node: Option<Whole<u32>>,
    #[serde(borrow)]
    pub enter: Option<Enter<'t>>,
    #[serde(default)]
    pub parent: Whole<u32>,
    #[serde(borrow)]
    pub note: Option<Word<'t>>,
    #[serde(borrow, default)]
    pub form: Word<'t>,
    pub value: Option<Value>,
    #[serde(borrow)]
    pub mark: Option<Mark<'t>>,
    pub leave: Option<Empty>,
    pub result: Option<PixelResult>,
    #[serde(default)]
    pub given: Given,
    pub digits: Option<Value>,
    #[serde(default)]
    pub decision_differs: bool,
    pub end: Option<End>,
    /// What a line has no place for.
    pub children: Option<IgnoredAny>,
}

#[derive(Deserialize)]
pub(super) struct Empty {}

#[derive(Deserialize)]
pub(super) struct PixelResult {
    pub color: [f64; 3],
}

/// The last line: how many events there are, and the digest of all lines before it.
#[derive(Deserialize, Clone, PartialEq, Debug)]
pub(super) struct End {
    #[serde(deserialize_with = "whole")]
    pub events: u64,
    pub digest: Option<String>,
}

impl End {
    /// Whether this is its digest.
    pub fn has(&self, digest: blake3::Hash) -> bool {
        self.digest.as_deref().and_then(|text| text.strip_prefix("blake3:")) == Some(&*digest.to_hex())
    }
}

/// Reads a value.
#[inline]
pub(super) fn from_text<'t, T: Deserialize<'t>>(text: &'t [u8]) -> Result<T, serde_json::Error> {
    serde_json::from_slice(text)
}

/// The most inputs of an event: some thirty are the most that raywalk writes.
pub const MAX_INPUTS: usize = 1 << 10;

/// The inputs of an event, in the order of the table, whatever order the file has.
#[derive(Default)]
pub(super) struct Given {
    pub inputs: Vec<(Name, Value)>,
    /// The keys that aren't in the table.
    pub unknown: Vec<String>,
}

impl<'de> Deserialize<'de> for Given {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pairs;
        impl<'de> Visitor<'de> for Pairs {
            type Value = Given;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object of quantities")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Given, A::Error> {
                let (mut inputs, mut unknown) = (Vec::new(), Vec::new());
                while let Some(Word(key)) = map.next_key()? {
                    match Name::find(&key, "") {
                        Some(_) if inputs.len() == MAX_INPUTS => {
                            let message =
                                format!("too many inputs of an event, expected at most {MAX_INPUTS}, found more");
                            return Err(de::Error::custom(message));
                        }
                        Some(name) => inputs.push((name, map.next_value()?)),
                        None => {
                            map.next_value::<IgnoredAny>()?;
                            unknown.push(key.into_owned());
                        }
                    }
                }
                inputs.sort_by_key(|(name, _)| *name);
                // There are as many of them as events, and most are short.
                inputs.shrink_to_fit();
                Ok(Given { inputs, unknown })
            }
        }
        deserializer.deserialize_map(Pairs)
    }
}
