//! A quantity at a path: `shade.n_dot_l@C R`, or a component of one: `hit.point.y@C`.

use super::path::{PathError, PathPattern};
use crate::files::suggest;
use crate::log::Name;
use std::fmt;
use std::str::FromStr;

/// A quantity of the rays with a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ValueAt {
    /// The quantity, by whatever formula.
    pub name: Name,
    /// The component of a triple that is meant; `None` for all of the quantity.
    pub component: Option<Component>,
    /// Where.
    pub path: PathPattern,
}

/// A component of a triple.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Component {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

/// What is wrong with a quantity at a path.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ValueError {
    /// There is no such quantity; the key that is nearest.
    #[error("{}", unknown(.0, *.1))]
    Key(String, Option<&'static str>),
    /// A number has no components.
    #[error("{0} is a number and has no components")]
    Component(&'static str),
    /// The path.
    #[error(transparent)]
    Path(#[from] PathError),
}

fn unknown(found: &str, near: Option<&str>) -> String {
    let found = crate::files::escape::quoted(found);
    match near {
        Some(near) => format!("unknown quantity {found}, did you mean `{near}`? `raywalk log schema` lists all"),
        None => format!("unknown quantity {found}; `raywalk log schema` lists all"),
    }
}

impl ValueAt {
    /// Whether it has three numbers.
    pub fn is_triple(&self) -> bool {
        self.component.is_none() && self.name.is_triple()
    }

    /// The quantity as it is asked for, without its path.
    pub fn key(&self) -> String {
        let component = self.component.map_or("", |component| [".x", ".y", ".z"][component as usize]);
        format!("{}{component}", self.name.key())
    }

    /// Reads a quantity, at this path if the text says none.
    ///
    /// # Errors
    /// [`ValueError`].
    pub fn read(text: &str, usual: impl FnOnce() -> PathPattern) -> Result<ValueAt, ValueError> {
        let (key, path) = match text.split_once('@') {
            Some((key, path)) => (key.trim(), Some(path)),
            None => (text.trim(), None),
        };
        let (name, component) = quantity(key)?;
        Ok(ValueAt { name, component, path: path.map_or_else(|| Ok(usual()), str::parse)? })
    }

    pub(super) fn file_name(&self) -> String {
        let (key, path) = (self.key().replace('.', "-"), self.path.to_string().replace('.', "-").replace(' ', "_"));
        if path.is_empty() { key } else { format!("{key}-{path}") }
    }
}

impl FromStr for ValueAt {
    type Err = ValueError;

    fn from_str(text: &str) -> Result<ValueAt, ValueError> {
        ValueAt::read(text, PathPattern::of_camera)
    }
}

impl fmt::Display for ValueAt {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        write!(f, "{}@{}", self.key(), self.path)
    }
}

fn quantity(key: &str) -> Result<(Name, Option<Component>), ValueError> {
    if let Some(name) = Name::with_key(key) {
        return Ok((name, None));
    }
    let component = |letter: &str| match letter {
        "x" | "r" => Some(Component::X),
        "y" | "g" => Some(Component::Y),
        "z" | "b" => Some(Component::Z),
        _ => None,
    };
    let of_triple = key.rsplit_once('.').and_then(|(key, letter)| Some((Name::with_key(key)?, component(letter)?)));
    match of_triple {
        Some((name, component)) if name.is_triple() => Ok((name, Some(component))),
        Some((name, _)) => Err(ValueError::Component(name.key())),
        None => {
            let near = suggest(key, Name::all().map(Name::key)).or_else(|| by_end(key));
            Err(ValueError::Key(key.to_owned(), near))
        }
    }
}

/// The only key that ends so behind a dot: `n_dot_l`.
fn by_end(end: &str) -> Option<&'static str> {
    let mut keys = Name::all().map(Name::key).filter(|key| key.rsplit_once('.').is_some_and(|(_, own)| own == end));
    let first = keys.next()?;
    keys.all(|key| key == first).then_some(first)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn a_component_of_a_triple_and_a_key_that_looks_like_one() {
        let value: ValueAt = "hit.point.g@C R".parse().unwrap();
        assert_eq!((value.name.key(), value.component, value.is_triple()), ("hit.point", Some(Component::Y), false));
        let value: ValueAt = "pixel.x".parse().unwrap();
        assert_eq!((value.name.key(), value.component, value.to_string().as_str()), ("pixel.x", None, "pixel.x@C"));
    }

    #[test]
    fn what_is_misspelt_gets_a_suggestion() {
        let near = |text: &str| match text.parse::<ValueAt>() {
            Err(ValueError::Key(_, near)) => near,
            other => panic!("{other:?}"),
        };
        assert_eq!(near("shade.n_dotl"), Some("shade.n_dot_l"));
        assert_eq!(near("n_dot_l@C"), Some("shade.n_dot_l"));
        assert_eq!(near("quux"), None);
        assert_eq!("shade.n_dot_l.x".parse::<ValueAt>(), Err(ValueError::Component("shade.n_dot_l")));
    }
}
