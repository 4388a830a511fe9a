//! The serde mirror of a line of a log, as it is read. Unknown fields are passed over: a later version may add some.

use crate::log::event::Value;
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, de};
use std::fmt;

/// A line of a log after the header (in a nested document: an element of `children`).
#[derive(Deserialize)]
pub(super) struct Line {
    pub at: Option<u32>,
    pub node: Option<u32>,
    pub enter: Option<Enter>,
    #[serde(default)]
    pub parent: u32,
    pub note: Option<String>,
    #[serde(default)]
    pub form: String,
    pub value: Option<Value>,
    pub mark: Option<Mark>,
    pub leave: Option<Empty>,
    pub result: Option<PixelResult>,
    #[serde(default)]
    pub given: Given,
    pub digits: Option<Value>,
    #[serde(default)]
    pub decision_differs: bool,
    pub end: Option<End>,
    #[serde(default)]
    pub children: Vec<Line>,
}

#[derive(Deserialize)]
pub(super) struct Empty {}

#[derive(Deserialize)]
pub(super) struct PixelResult {
    pub color: [f64; 3],
}

/// The last line: how many events there are, and the digest of all bytes before it.
#[derive(Deserialize, Clone, PartialEq, Debug)]
pub(super) struct End {
    pub events: u64,
    pub digest: String,
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Enter {
    Pixel([u32; 2]),
    Sample {
        number: u32,
    },
    Ray {
        kind: String,
        depth: u32,
        light: Option<String>,
        #[serde(default)]
        split: u32,
    },
    Motion {
        object: String,
    },
    Zone {
        what: String,
        number: u32,
    },
    Test {
        object: String,
        triangle: Option<u32>,
    },
    Shade {
        object: String,
    },
    Light {
        light: String,
        #[serde(default)]
        split: u32,
    },
    Combine {},
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Mark {
    Hit {},
    Miss { why: String },
    Outside {},
    Inside {},
    Nearest { object: String },
    Background {},
    Occluded { object: String },
    Attenuated { object: String, factor: [f64; 3] },
    Undefined { quantity: String },
    TotalInternalReflection {},
    DepthLimit { what: String },
    LeakGuard { what: String },
    Rejected { what: String },
    Skipped { what: String, why: String },
    Subdivided { cell: [f64; 3], why: String, object: Option<String> },
    Accepted { cell: Option<[f64; 3]>, why: String },
    MoreSamples { from: u32, to: u32 },
}

/// The inputs of an event, in the order of the file.
#[derive(Default)]
pub(super) struct Given(pub Vec<(String, Value)>);

impl<'de> Deserialize<'de> for Given {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pairs;
        impl<'de> Visitor<'de> for Pairs {
            type Value = Given;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("an object of quantities")
            }
            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Given, A::Error> {
                let mut pairs = Vec::new();
                while let Some(pair) = map.next_entry()? {
                    pairs.push(pair);
                }
                Ok(Given(pairs))
            }
        }
        deserializer.deserialize_map(Pairs)
    }
}

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NumberOrTriple;
        impl<'de> Visitor<'de> for NumberOrTriple {
            type Value = Value;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a number or three numbers")
            }
            fn visit_f64<E: de::Error>(self, x: f64) -> Result<Value, E> {
                Ok(Value::Number(x))
            }
            fn visit_i64<E: de::Error>(self, x: i64) -> Result<Value, E> {
                Ok(Value::Number(x as f64))
            }
            fn visit_u64<E: de::Error>(self, x: u64) -> Result<Value, E> {
                Ok(Value::Number(x as f64))
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut seq: A) -> Result<Value, A::Error> {
                let mut triple = [0.0; 3];
                for (index, component) in triple.iter_mut().enumerate() {
                    *component = seq.next_element()?.ok_or_else(|| de::Error::invalid_length(index, &self))?;
                }
                match seq.next_element::<f64>()? {
                    None => Ok(Value::Triple(triple)),
                    Some(_) => Err(de::Error::invalid_length(4, &self)),
                }
            }
        }
        deserializer.deserialize_any(NumberOrTriple)
    }
}
