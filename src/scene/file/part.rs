//! The JSON Schema of scenes as the walk along a text queries it: what may be in a place, and how messages call it.

use std::collections::BTreeMap;

use serde::de::{Deserialize, Deserializer, Error};
use serde_json::Value;

/// A part of a schema without references.
#[derive(Default, serde::Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub struct Part {
    #[serde(rename = "type")]
    kind: Option<Kind>,
    #[serde(rename = "const")]
    constant: Option<Value>,
    any_of: Vec<Part>,
    one_of: Vec<Part>,
    properties: BTreeMap<String, Part>,
    required: Vec<String>,
    /// What the value of every key may be, where keys are names.
    #[serde(rename = "additionalProperties", deserialize_with = "of_each_name")]
    pub of_each_name: Option<Box<Part>>,
    items: Box<Option<Part>>,
    /// How many elements there must be.
    #[serde(rename = "maxItems")]
    pub length: Option<usize>,
    minimum: Option<Value>,
    maximum: Option<Value>,
}

#[derive(Clone, Copy, PartialEq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
enum Kind {
    Object,
    Array,
    String,
    Boolean,
    Number,
    Integer,
}

impl Part {
    /// Of several types the one that a value with this first byte has; this part itself if it isn't of several types.
    pub fn of_type(&self, first: Option<u8>) -> &Self {
        self.any_of.iter().find(|part| part.takes(first)).unwrap_or(self)
    }

    /// Whether a value with this first byte can be what this part says.
    pub fn takes(&self, first: Option<u8>) -> bool {
        let Some(kind) = self.kind else { return false };
        match first {
            Some(b'{') => kind == Kind::Object,
            Some(b'[') => kind == Kind::Array,
            Some(b'"') => kind == Kind::String,
            Some(b't' | b'f') => kind == Kind::Boolean,
            Some(b'-' | b'0'..=b'9') => matches!(kind, Kind::Number | Kind::Integer),
            _ => false,
        }
    }

    /// Whether it is one of several words.
    pub fn is_of_words(&self) -> bool {
        !self.one_of.is_empty() && self.properties.is_empty()
    }

    /// The words of which it is one. A word without a part is alone, one with a part is the only key of an object.
    pub fn words(&self) -> impl Iterator<Item = (&str, Option<&Self>)> {
        self.one_of.iter().filter(|_| self.is_of_words()).filter_map(|part| match &part.constant {
            Some(word) => Some((word.as_str()?, None)),
            None => part.properties.iter().next().map(|(word, value)| (word.as_str(), Some(value))),
        })
    }

    /// What the value of a key may be, with the key.
    pub fn key(&self, name: &str) -> Option<(&str, &Self)> {
        self.properties.get_key_value(name).map(|(key, part)| (key.as_str(), part))
    }

    /// The keys that must be there.
    pub fn required(&self) -> impl Iterator<Item = &str> + Clone {
        self.required.iter().map(String::as_str)
    }

    /// The keys of which exactly one must be there.
    pub fn exclusive(&self) -> impl Iterator<Item = &str> + Clone {
        self.one_of.iter().flat_map(Self::required)
    }

    /// All keys: first those that must be there.
    pub fn keys(&self) -> Vec<&str> {
        let others = self.properties.keys().filter(|key| !self.required.contains(key));
        self.required().chain(others.map(String::as_str)).collect()
    }

    /// What an element may be.
    pub fn element(&self) -> &Self {
        (*self.items).as_ref().unwrap_or(self)
    }

    /// Whether a number is one of those that may be there, as far as its form goes: what has a limit has 32 bits.
    pub fn takes_number(&self, text: &str) -> bool {
        let highest = if self.maximum.is_some() { u32::MAX.into() } else { u64::MAX };
        self.kind != Some(Kind::Integer) || text.parse().is_ok_and(|number: u64| number <= highest)
    }

    /// A value that may be there.
    pub fn fitting(&self) -> String {
        if let Some(word) = &self.constant {
            return word.to_string();
        }
        match self.kind {
            Some(Kind::Object) => {
                let keys = self.required().chain(self.exclusive().take(1));
                let member = |key: &str| Some(format!("\"{key}\":{}", self.properties.get(key)?.fitting()));
                format!("{{{}}}", keys.filter_map(member).collect::<Vec<_>>().join(","))
            }
            Some(Kind::Array) => {
                let elements = (0..self.length.unwrap_or(0)).map(|_| self.element().fitting());
                format!("[{}]", elements.collect::<Vec<_>>().join(","))
            }
            Some(Kind::String) => "\"\"".to_owned(),
            Some(Kind::Boolean) => "true".to_owned(),
            Some(_) => "1".to_owned(),
            None => self.any_of.first().or(self.one_of.first()).map_or_else(String::new, Self::fitting),
        }
    }

    /// What may be there, in words.
    pub fn in_words(&self) -> String {
        if self.is_of_words() {
            return format!("one of {}", quoted(self.words().map(|(word, _)| word)).join(", "));
        }
        if !self.any_of.is_empty() {
            return self.any_of.iter().map(Self::one_of_several).collect::<Vec<_>>().join(", or ");
        }
        match (self.kind, self.length) {
            (Some(Kind::Object), _) if self.of_each_name.is_some() => "an object with names as keys".to_owned(),
            (Some(Kind::Object), _) => "an object".to_owned(),
            (Some(Kind::Array), None) => "an array".to_owned(),
            (Some(Kind::Array), Some(length)) => format!("an array of {length} elements"),
            (Some(Kind::String), _) => "a string".to_owned(),
            (Some(Kind::Boolean), _) => "`true` or `false`".to_owned(),
            (Some(Kind::Integer), _) => {
                let low = self.minimum.as_ref().unwrap_or(&Value::Null);
                match &self.maximum {
                    None => format!("a whole number, {low} or more"),
                    Some(high) => format!("a whole number from {low} to {high}"),
                }
            }
            (Some(Kind::Number) | None, _) => "a number".to_owned(),
        }
    }

    /// The same where it is beside others.
    fn one_of_several(&self) -> String {
        match (self.kind, self.length) {
            (Some(Kind::Object), _) => format!("an object with {}", quoted(self.required()).join(" and ")),
            (Some(Kind::Array), Some(length)) => format!("an array of {length} numbers"),
            _ => self.in_words(),
        }
    }
}

/// A schema says instead whether there may be other keys than those that it names, where keys aren't names.
fn of_each_name<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Box<Part>>, D::Error> {
    let others = Value::deserialize(deserializer)?;
    others.is_object().then(|| Box::<Part>::deserialize(others)).transpose().map_err(D::Error::custom)
}

/// Names as messages show them.
pub fn quoted<'s>(names: impl IntoIterator<Item = &'s str>) -> Vec<String> {
    names.into_iter().map(|name| format!("`{name}`")).collect()
}
