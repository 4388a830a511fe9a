//! The JSON Schema of scenes as the walk along a text asks it: what may be in a place, and how that is said.

use serde_json::Value;

/// A part of a schema.
#[derive(Clone, Copy)]
pub struct Part<'s> {
    /// The whole schema, which holds what parts of it refer to.
    whole: &'s Value,
    this: &'s Value,
}

impl<'s> Part<'s> {
    /// A whole schema.
    pub fn root(schema: &'s Value) -> Self {
        Self { whole: schema, this: schema }
    }

    /// Another part, or what it refers to.
    fn part(self, this: &'s Value) -> Self {
        let name = this.get("$ref").and_then(Value::as_str).and_then(|reference| reference.strip_prefix("#/$defs/"));
        let this = name.and_then(|name| self.whole["$defs"].get(name)).unwrap_or(this);
        Self { whole: self.whole, this }
    }

    fn parts(self, list: &str) -> Option<Vec<Self>> {
        Some(self.this[list].as_array()?.iter().map(|this| self.part(this)).collect())
    }

    fn strings(self, list: &str) -> impl Iterator<Item = &'s str> + use<'s> {
        self.this[list].as_array().into_iter().flatten().filter_map(Value::as_str)
    }

    /// Of several types the one that a value with this first byte has; this part itself if it isn't of several types.
    pub fn of_type(self, first: Option<u8>) -> Self {
        let types = self.parts("anyOf").unwrap_or_default();
        types.into_iter().find(|part| part.takes(first)).unwrap_or(self)
    }

    /// Whether a value with this first byte can be what this part says.
    pub fn takes(self, first: Option<u8>) -> bool {
        match self.this["type"].as_str() {
            Some("object") => first == Some(b'{'),
            Some("array") => first == Some(b'['),
            Some("string") => first == Some(b'"'),
            Some("boolean") => matches!(first, Some(b't' | b'f')),
            Some("number" | "integer") => matches!(first, Some(b'-' | b'0'..=b'9')),
            _ => false,
        }
    }

    /// Whether it is one of several words.
    pub fn is_of_words(self) -> bool {
        self.this.get("oneOf").is_some() && self.this.get("properties").is_none()
    }

    /// The words of which it is one, alone or as the only key of an object.
    pub fn words(self) -> Option<Vec<Word<'s>>> {
        let parts = self.parts("oneOf").filter(|_| self.is_of_words())?;
        let word = |part: Self| match part.this["const"].as_str() {
            Some(name) => Some(Word { name, value: None }),
            None => {
                let name = part.strings("required").next()?;
                Some(Word { name, value: part.key(name) })
            }
        };
        Some(parts.into_iter().filter_map(word).collect())
    }

    /// What the value of a key may be.
    pub fn key(self, name: &str) -> Option<Self> {
        self.this["properties"].get(name).map(|this| self.part(this))
    }

    /// What the value of every key may be, where keys are names.
    pub fn of_each_name(self) -> Option<Self> {
        self.this.get("additionalProperties").filter(|each| each.is_object()).map(|each| self.part(each))
    }

    /// The keys that must be there.
    pub fn required(self) -> Vec<&'s str> {
        self.strings("required").collect()
    }

    /// The keys of which exactly one must be there.
    pub fn exclusive(self) -> Vec<&'s str> {
        self.parts("oneOf").into_iter().flatten().flat_map(|part| part.strings("required")).collect()
    }

    /// All keys: first those that must be there.
    pub fn keys(self) -> Vec<&'s str> {
        let mut keys = self.required();
        let all = self.this["properties"].as_object().into_iter().flat_map(|properties| properties.keys());
        let others: Vec<_> = all.map(String::as_str).filter(|key| !keys.contains(key)).collect();
        keys.extend(others);
        keys
    }

    /// What an element may be.
    pub fn element(self) -> Self {
        self.part(&self.this["items"])
    }

    /// How many elements there must be.
    pub fn length(self) -> Option<u64> {
        self.this["maxItems"].as_u64()
    }

    /// Whether a number is one of those that may be there, as far as its form goes: what has a limit has 32 bits.
    pub fn takes_number(self, text: &str) -> bool {
        let highest = if self.this.get("maximum").is_some() { u32::MAX.into() } else { u64::MAX };
        self.this["type"] != "integer" || text.parse().is_ok_and(|number: u64| number <= highest)
    }

    /// A value that may be there.
    pub fn fitting(self) -> String {
        if let Some(word) = self.this.get("const") {
            return word.to_string();
        }
        match self.this["type"].as_str() {
            Some("object") => {
                let keys = self.required().into_iter().chain(self.exclusive().into_iter().take(1));
                let member = |key: &str| Some(format!("\"{key}\":{}", self.key(key)?.fitting()));
                format!("{{{}}}", keys.filter_map(member).collect::<Vec<_>>().join(","))
            }
            Some("array") => {
                let elements = (0..self.length().unwrap_or(0)).map(|_| self.element().fitting());
                format!("[{}]", elements.collect::<Vec<_>>().join(","))
            }
            Some("string") => "\"\"".to_owned(),
            Some("boolean") => "true".to_owned(),
            Some(_) => "1".to_owned(),
            None => {
                let first = |list| self.parts(list).and_then(|parts| parts.first().copied());
                first("anyOf").or(first("oneOf")).map_or_else(String::new, Self::fitting)
            }
        }
    }

    /// What may be there, in words.
    pub fn in_words(self) -> String {
        if let Some(words) = self.words() {
            let names: Vec<_> = words.iter().map(|word| word.name).collect();
            return format!("one of {}", quoted(&names).join(", "));
        }
        if let Some(types) = self.parts("anyOf") {
            let types: Vec<_> = types.into_iter().map(Self::one_of_several).collect();
            return types.join(", or ");
        }
        match (self.this["type"].as_str(), self.length()) {
            (Some("object"), _) if self.of_each_name().is_some() => "an object with names as keys".to_owned(),
            (Some("object"), _) => "an object".to_owned(),
            (Some("array"), None) => "an array".to_owned(),
            (Some("array"), Some(length)) => format!("an array of {length} elements"),
            (Some("string"), _) => "a string".to_owned(),
            (Some("boolean"), _) => "`true` or `false`".to_owned(),
            (Some("integer"), _) => match [&self.this["minimum"], &self.this["maximum"]] {
                [low, Value::Null] => format!("a whole number, {low} or more"),
                [low, high] => format!("a whole number from {low} to {high}"),
            },
            _ => "a number".to_owned(),
        }
    }

    /// The same where it is beside others.
    fn one_of_several(self) -> String {
        match (self.this["type"].as_str(), self.length()) {
            (Some("object"), _) => format!("an object with {}", quoted(&self.required()).join(" and ")),
            (Some("array"), Some(length)) => format!("an array of {length} numbers"),
            _ => self.in_words(),
        }
    }
}

/// A word of several.
pub struct Word<'s> {
    /// The word.
    pub name: &'s str,
    /// The value that it has as the key of an object; `None` where the word is alone.
    pub value: Option<Part<'s>>,
}

/// Names as messages show them.
pub fn quoted(names: &[&str]) -> Vec<String> {
    names.iter().map(|name| format!("`{name}`")).collect()
}
