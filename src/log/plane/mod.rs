//! Layers of a picture that have names of their own: a quantity at a path, what one light brings, what the paths of a class bring.
//!
//! Here they are names only. The renderer catches what they name, the viewer completes and explains them.

mod class;
mod path;
mod value;

pub use class::{Class, ClassError, Emitter, class_word};
pub use path::{PathError, PathPattern, PathStep};
pub use value::{Component, ValueAt, ValueError};

use std::fmt;
use std::str::FromStr;

/// What a layer shows of each pixel by its name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Plane {
    /// `value:shade.n_dot_l@C R`: a quantity at a path.
    Value(ValueAt),
    /// `light:lamp`: what a light brings to the pixel; `light:ambient` and `light:background` what comes from no light.
    Light(String),
    /// `class:LDSE`: what the paths of a class bring.
    Class(Class),
}

/// What is wrong with the name of a plane.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PlaneError {
    /// It begins with none of the three words.
    #[error("expected value:KEY@PATH, light:NAME or class:PATTERN")]
    Kind,
    /// Of a quantity at a path.
    #[error(transparent)]
    Value(#[from] ValueError),
    /// Nothing follows `light:`.
    #[error("expected the name of a light after `light:`")]
    NoLight,
    /// Of a class.
    #[error(transparent)]
    Class(#[from] ClassError),
}

impl Plane {
    /// The word before the colon of each kind.
    pub const KINDS: [&str; 3] = ["value", "light", "class"];

    /// What the light is called that comes from no light but from all directions.
    pub const AMBIENT: &str = "ambient";

    /// What the light is called that rays bring which hit nothing.
    pub const BACKGROUND: &str = "background";

    /// How many numbers it has for a pixel.
    pub fn numbers(&self) -> usize {
        match self {
            Plane::Value(value) if !value.is_triple() => 1,
            _ => 3,
        }
    }

    /// Its name in a file of layers and in names of files: letters, digits, `_`, `-` and `%` only, so that every reader takes it. The dots of a
    /// key become `-`, the blanks of a path `_`; other characters are written as `%` and the two digits of each of their bytes. No two planes
    /// have the same.
    pub fn file_name(&self) -> String {
        let (kind, rest) = match self {
            Plane::Value(value) => ("value", value.file_name()),
            Plane::Light(name) => ("light", escaped(name)),
            Plane::Class(class) => ("class", escaped(class.text())),
        };
        shortened(format!("{kind}-{rest}"))
    }
}

impl FromStr for Plane {
    type Err = PlaneError;

    fn from_str(text: &str) -> Result<Plane, PlaneError> {
        match text.split_once(':') {
            Some(("value", rest)) => Ok(Plane::Value(rest.parse()?)),
            Some(("light", "")) => Err(PlaneError::NoLight),
            Some(("light", name)) => Ok(Plane::Light(name.to_owned())),
            Some(("class", pattern)) => Ok(Plane::Class(pattern.parse()?)),
            _ => Err(PlaneError::Kind),
        }
    }
}

impl fmt::Display for Plane {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Plane::Value(value) => write!(f, "value:{value}"),
            Plane::Light(name) => write!(f, "light:{name}"),
            Plane::Class(class) => write!(f, "class:{}", class.text()),
        }
    }
}

fn escaped(text: &str) -> String {
    let mut name = String::new();
    for byte in text.bytes() {
        match byte {
            b'0'..=b'9' | b'a'..=b'z' | b'A'..=b'Z' | b'_' | b'-' => name.push(byte.into()),
            _ => name += &format!("%{byte:02X}"),
        }
    }
    name
}

/// Names of files and of channels have at most 255 bytes: a longer one ends with its digest.
fn shortened(name: String) -> String {
    const LONGEST: usize = 160;
    const KEPT: usize = 120;
    if name.len() <= LONGEST {
        return name;
    }
    format!("{}-{}", &name[..KEPT], &blake3::hash(name.as_bytes()).to_hex()[..16])
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::log::Name;
    use std::collections::HashSet;

    #[track_caller]
    fn reads_back(text: &str, file_name: &str) {
        let plane: Plane = text.parse().unwrap_or_else(|error| panic!("{text}: {error}"));
        assert_eq!(plane.to_string(), text);
        assert_eq!(plane.file_name(), file_name);
    }

    #[test]
    fn names_read_back() {
        reads_back("value:shade.n_dot_l@C R", "value-shade-n_dot_l-C_R");
        reads_back("value:hit.point.y@3 C R.12 S1.4", "value-hit-point-y-3_C_R-12_S1-4");
        reads_back("light:lamp", "light-lamp");
        reads_back("light:lámp/2", "light-l%C3%A1mp%2F2");
        reads_back("class:L(D|S)E", "class-L%28D%7CS%29E");
    }

    #[test]
    fn what_names_nothing_is_refused() {
        for text in ["", "depth", "value", "value:", "light:", "class:", "values:shade.local@C", "value:shade.local@X"]
        {
            assert!(text.parse::<Plane>().is_err(), "{text}");
        }
    }

    #[test]
    fn no_two_quantities_have_the_same_file_name() {
        let keys: HashSet<&str> = Name::all().map(Name::key).collect();
        let names: HashSet<String> =
            keys.iter().map(|key| format!("value:{key}").parse::<Plane>().unwrap().file_name()).collect();
        assert_eq!(names.len(), keys.len());
    }

    #[test]
    fn a_long_name_is_shortened_and_stays_its_own() {
        let [one, other] = ["a", "b"].map(|end| Plane::Light(format!("{}{end}", "ñ".repeat(200))).file_name());
        assert!(one.len() < 200 && one.is_ascii());
        assert_ne!(one, other);
    }
}
