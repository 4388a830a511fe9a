//! What a file is, by its first bytes: decided here for every command.

use super::picture_kind::PictureKind;
use super::source::without_mark;
use serde::de::{Deserializer, IgnoredAny, MapAccess, Visitor};
use std::fmt;

/// What a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A part of a picture, as `render --shard` writes it.
    Part,
    /// A log.
    Log(LogForm),
    /// A picture.
    Picture(PictureKind),
    /// A text in UTF-16.
    Utf16,
    /// A scene, a mesh, or nothing that is known.
    Other,
}

/// How a log is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LogForm {
    /// One event per line.
    Lines,
    /// One JSON document.
    Document,
}

/// What a part begins with.
pub const PART: &[u8] = b"{\"part\":\"raywalk-part/";

impl Kind {
    /// What begins like this.
    pub fn of(beginning: &[u8]) -> Kind {
        if beginning.starts_with(PART) {
            Kind::Part
        } else if let Some(form) = log(beginning) {
            Kind::Log(form)
        } else if let Some(kind) = PictureKind::of(beginning) {
            Kind::Picture(kind)
        } else if is_utf16(beginning) {
            Kind::Utf16
        } else {
            Kind::Other
        }
    }

    /// Whether it is a log.
    pub fn is_log(self) -> bool {
        matches!(self, Kind::Log(_))
    }
}

/// Whether a text is UTF-16, by its byte order mark or by the zero in its first letter.
pub fn is_utf16(beginning: &[u8]) -> bool {
    matches!(beginning, [0xff, 0xfe, ..] | [0xfe, 0xff, ..] | [1..128, 0, ..] | [0, 1..128, ..])
}

/// The form of a log, if it is one: other programs put its keys in another order, and blanks between them.
fn log(beginning: &[u8]) -> Option<LogForm> {
    let beginning = without_mark(beginning);
    let mut keys = Vec::new();
    let is_whole = serde_json::Deserializer::from_slice(beginning).deserialize_map(Keys(&mut keys)).is_ok();
    for key in &keys {
        match key.as_str() {
            "log" => return Some(LogForm::Lines),
            "header" | "children" => return Some(LogForm::Document),
            // The key that every scene has.
            "format" => return None,
            _ => {}
        }
    }
    // The beginning may end before that key.
    let has_key_of_header = || {
        keys.iter().any(|key| {
            ["version", "scene", "pixel", "ray", "region", "arithmetic", "frame", "shard"].contains(&key.as_str())
        }) || ["objects", "lights"].iter().any(|key| lists_names(beginning, key))
    };
    (!is_whole && has_key_of_header()).then_some(LogForm::Lines)
}

/// Whether this key has a list of names, as in a header; in a scene it has a list of objects.
fn lists_names(text: &[u8], key: &str) -> bool {
    let key = format!("\"{key}\"");
    let value = memchr::memmem::find(text, key.as_bytes()).map(|at| &text[at + key.len()..]).unwrap_or_default();
    let first = value.iter().find(|byte| !byte.is_ascii_whitespace() && !b":[".contains(byte));
    first == Some(&b'"')
}

/// Collects the keys of an object up to where its text ends.
struct Keys<'k>(&'k mut Vec<String>);

impl<'de> Visitor<'de> for Keys<'_> {
    type Value = ();

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an object")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<(), A::Error> {
        while let Some(key) = map.next_key()? {
            self.0.push(key);
            map.next_value::<IgnoredAny>()?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn is(beginning: &str, expected: bool) {
        assert_eq!(Kind::of(beginning.as_bytes()).is_log(), expected, "{beginning}");
    }

    #[test]
    fn a_log_is_one_whatever_the_order_of_its_keys() {
        is("{\"log\":\"raywalk-log/1\"", true);
        is("\u{feff} \r\n{ \"version\" : \"1\",\t\"log\" : \"raywalk-log/1\" }\n{", true);
        is("{\"arithmetic\":\"f64\",\"li", true);
        is("{\"sampling\":{\"none\":{}},\"objects\":[\"plane\",\"sph", true);
        is("{\"seed\": 1, \"lights\" : [ \"a", true);
        is("{\"children\":[{\"at\":1", true);
        is("{\n  \"header\": {", true);
    }

    #[test]
    fn what_is_no_log_is_distinguished_from_one() {
        is("", false);
        is("{}", false);
        is("{\"version\":1}", false);
        is("{\"version\":1,\"format\":\"raywalk-scene/1\",\"log\":1", false);
        is("{\"objects\":[{\"name\":\"log\",\"shape\":{", false);
        is("{\"lights\":[],\"objects\":[{\"name\":\"objects\",", false);
        is("{\"camera\":{\"position\":[1", false);
        is("[{\"log\":1}]", false);
    }

    #[test]
    fn utf_16_has_a_mark_or_zeros() {
        let units = |text: &str| text.encode_utf16().collect::<Vec<_>>();
        for text in ["{\"log\"", "\u{feff}{", "\n{"] {
            assert!(is_utf16(&units(text).iter().flat_map(|unit| unit.to_le_bytes()).collect::<Vec<_>>()), "{text}");
            assert!(is_utf16(&units(text).iter().flat_map(|unit| unit.to_be_bytes()).collect::<Vec<_>>()), "{text}");
            assert!(!is_utf16(text.as_bytes()), "{text}");
        }
        assert!(!is_utf16(&[0, 0]) && !is_utf16(b"{"));
    }
}
