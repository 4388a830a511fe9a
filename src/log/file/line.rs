//! The serde mirror of a line of a log, as it is read. Unknown fields are passed over: a later version may add some.

use crate::log::name::Name;
use crate::log::value::Value;
use serde::de::{Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, de};
use std::borrow::Cow;
use std::fmt;
use std::ops::Deref;

/// A line of a log after the header (in a nested document: an element of `children`).
#[derive(Deserialize)]
pub(super) struct Line<'t> {
    pub at: Option<u32>,
    pub node: Option<u32>,
    #[serde(borrow)]
    pub enter: Option<Enter<'t>>,
    #[serde(default)]
    pub parent: u32,
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
    #[serde(borrow, default)]
    pub children: Vec<Line<'t>>,
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
    pub events: u64,
    pub digest: Option<String>,
}

impl End {
    /// Whether this is its digest.
    pub fn has(&self, digest: blake3::Hash) -> bool {
        self.digest.as_deref().and_then(|text| text.strip_prefix("blake3:")) == Some(&*digest.to_hex())
    }
}

/// Reads a value in which other programs may have written whole numbers as 1.0 or 1e0.
#[inline]
pub(super) fn from_text<'t, T: Deserialize<'t>>(text: &'t [u8]) -> Result<T, serde_json::Error> {
    serde_json::from_slice(text).or_else(|error| with_whole_numbers(error, || serde_json::from_slice(text)))
}

/// Reads a value again whose numbers may be why it couldn't be read.
pub(super) fn with_whole_numbers<'t, T: Deserialize<'t>>(
    error: serde_json::Error,
    again: impl FnOnce() -> Result<serde_json::Value, serde_json::Error>,
) -> Result<T, serde_json::Error> {
    let read = if error.is_data() { again().ok() } else { None };
    read.and_then(|value| T::deserialize(whole_numbers(value)).ok()).ok_or(error)
}

/// The value with every number that is whole as an integer.
fn whole_numbers(mut value: serde_json::Value) -> serde_json::Value {
    /// Up to there every whole number is one of f64, too.
    const MOST: f64 = 9_007_199_254_740_992.0;
    match &mut value {
        serde_json::Value::Number(number) => match number.as_f64() {
            Some(x) if number.is_f64() && x == x.trunc() && x.abs() < MOST && (x != 0.0 || x.is_sign_positive()) => {
                *number = (x as i64).into();
            }
            _ => {}
        },
        serde_json::Value::Array(items) => {
            items.iter_mut().for_each(|item| *item = whole_numbers(item.take()));
        }
        serde_json::Value::Object(fields) => {
            fields.values_mut().for_each(|field| *field = whole_numbers(field.take()));
        }
        _ => {}
    }
    value
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Enter<'t> {
    Pixel([u32; 2]),
    Sample {
        number: u32,
    },
    Ray {
        #[serde(borrow)]
        kind: Word<'t>,
        depth: u32,
        #[serde(borrow)]
        light: Option<Word<'t>>,
        #[serde(default)]
        split: u32,
    },
    Motion {
        #[serde(borrow)]
        object: Word<'t>,
    },
    Zone {
        #[serde(borrow)]
        what: Word<'t>,
        number: u32,
    },
    Test {
        #[serde(borrow)]
        object: Word<'t>,
        triangle: Option<u32>,
    },
    Shade {
        #[serde(borrow)]
        object: Word<'t>,
    },
    Light {
        #[serde(borrow)]
        light: Word<'t>,
        #[serde(default)]
        split: u32,
    },
    Combine {},
}

#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Mark<'t> {
    Hit {},
    Miss {
        #[serde(borrow)]
        why: Word<'t>,
    },
    Outside {},
    Inside {},
    Nearest {
        #[serde(borrow)]
        object: Word<'t>,
    },
    Coincident {
        #[serde(borrow)]
        object: Word<'t>,
        triangle: Option<u32>,
    },
    Immersed {
        #[serde(borrow)]
        object: Word<'t>,
    },
    Bent {
        #[serde(borrow)]
        what: Word<'t>,
    },
    Background {},
    Free {},
    Occluded {
        #[serde(borrow)]
        object: Word<'t>,
    },
    Attenuated {
        #[serde(borrow)]
        object: Word<'t>,
        factor: [f64; 3],
    },
    Undefined {
        #[serde(borrow)]
        quantity: Word<'t>,
    },
    TotalInternalReflection {},
    DepthLimit {
        #[serde(borrow)]
        what: Word<'t>,
    },
    LeakGuard {
        #[serde(borrow)]
        what: Word<'t>,
    },
    Rejected {
        #[serde(borrow)]
        what: Word<'t>,
    },
    Skipped {
        #[serde(borrow)]
        what: Word<'t>,
        #[serde(borrow)]
        why: Word<'t>,
    },
    Subdivided {
        cell: [f64; 3],
        #[serde(borrow)]
        why: Word<'t>,
        #[serde(borrow)]
        object: Option<Word<'t>>,
    },
    Accepted {
        cell: Option<[f64; 3]>,
        #[serde(borrow)]
        why: Word<'t>,
    },
    Asked {
        #[serde(borrow)]
        light: Word<'t>,
        #[serde(borrow)]
        why: Word<'t>,
        points: u32,
        #[serde(borrow)]
        object: Option<Word<'t>>,
    },
    MoreSamples {
        from: u32,
        to: u32,
    },
}

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

/// A word that is borrowed from the text, unless it is escaped there.
#[derive(Default)]
pub(super) struct Word<'t>(pub Cow<'t, str>);

impl<'de: 't, 't> Deserialize<'de> for Word<'t> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Text;
        impl<'de> Visitor<'de> for Text {
            type Value = Word<'de>;
            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("a string")
            }
            fn visit_borrowed_str<E: de::Error>(self, text: &'de str) -> Result<Word<'de>, E> {
                Ok(Word(Cow::Borrowed(text)))
            }
            fn visit_str<E: de::Error>(self, text: &str) -> Result<Word<'de>, E> {
                Ok(Word(Cow::Owned(text.to_owned())))
            }
        }
        deserializer.deserialize_str(Text)
    }
}

impl Deref for Word<'_> {
    type Target = str;
    fn deref(&self) -> &str {
        &self.0
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
