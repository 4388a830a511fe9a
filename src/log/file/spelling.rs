//! How words and numbers are spelled in a log.

use crate::log::value::Value;
use serde::de::{Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, de};
use std::borrow::Cow;
use std::fmt;
use std::ops::Deref;

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

pub(super) fn value(out: &mut Vec<u8>, value: Value) {
    match value {
        Value::Number(x) => number(out, x),
        Value::Triple(xyz) => triple(out, &xyz),
    }
}

pub(super) fn triple(out: &mut Vec<u8>, [x, y, z]: &[f64; 3]) {
    text(out, "[");
    number(out, *x);
    text(out, ",");
    number(out, *y);
    text(out, ",");
    number(out, *z);
    text(out, "]");
}

/// The shortest text that reads back as the same bits; whole numbers without a decimal point, but for `-0.0`.
fn number(out: &mut Vec<u8>, x: f64) {
    debug_assert!(x.is_finite(), "a log holds finite numbers only");
    if x == x.trunc() && x.abs() < 1e15 && !(x == 0.0 && x.is_sign_negative()) {
        text(out, &(x as i64).to_string());
    } else if serde_json::to_writer(&mut *out, &x).is_err() {
        // Writing to memory can't fail.
        text(out, "0");
    }
}

pub(super) fn string(out: &mut Vec<u8>, content: &str) {
    // Control characters are escaped by serde_json; writing to memory can't fail.
    let _ = serde_json::to_writer(out, content);
}

pub(super) fn text(out: &mut Vec<u8>, content: &str) {
    out.extend_from_slice(content.as_bytes());
}
