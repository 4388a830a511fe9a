//! The way from the root of a JSON document to one of its values: `objects[2].shape.sphere.radius`.

use std::borrow::Cow;
use std::fmt;

use super::escape::escape_hidden;

/// A path of keys and indices; empty at the root.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct KeyPath(Vec<Step>);

/// One step of a [`KeyPath`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Step {
    /// Into an object.
    Key(Cow<'static, str>),
    /// Into an array, from 0.
    Index(usize),
}

impl KeyPath {
    /// Whether this is the root.
    pub fn is_root(&self) -> bool {
        self.0.is_empty()
    }

    /// The steps from the root.
    pub fn steps(&self) -> &[Step] {
        &self.0
    }

    /// Whether this way begins with another one, or is the same.
    pub fn starts_with(&self, beginning: &KeyPath) -> bool {
        self.0.starts_with(&beginning.0)
    }

    /// Goes one step deeper.
    pub fn push(&mut self, step: impl Into<Step>) {
        self.0.push(step.into());
    }

    /// Goes back one step and says which it was.
    pub fn pop(&mut self) -> Option<Step> {
        self.0.pop()
    }

    /// The path one step deeper.
    pub fn join(&self, step: impl Into<Step>) -> Self {
        let mut path = self.clone();
        path.push(step);
        path
    }
}

impl From<usize> for Step {
    fn from(index: usize) -> Self {
        Self::Index(index)
    }
}

impl From<&'static str> for Step {
    fn from(key: &'static str) -> Self {
        Self::Key(Cow::Borrowed(key))
    }
}

impl From<String> for Step {
    fn from(key: String) -> Self {
        Self::Key(Cow::Owned(key))
    }
}

impl FromIterator<Step> for KeyPath {
    fn from_iter<I: IntoIterator<Item = Step>>(steps: I) -> Self {
        Self(steps.into_iter().collect())
    }
}

/// Keys that could be misread as part of the path are in brackets and quotes, `materials["a.b"]`.
impl fmt::Display for KeyPath {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        for (depth, step) in self.0.iter().enumerate() {
            match step {
                Step::Index(index) => write!(formatter, "[{index}]")?,
                Step::Key(key) if !is_plain(key) => write!(formatter, "[\"{}\"]", escape_hidden(key))?,
                Step::Key(key) if depth == 0 => formatter.write_str(key)?,
                Step::Key(key) => write!(formatter, ".{key}")?,
            }
        }
        Ok(())
    }
}

fn is_plain(key: &str) -> bool {
    let is_plain_character = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    !key.is_empty() && key.chars().all(is_plain_character)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn shows(steps: &[Step], text: &str) {
        let path: KeyPath = steps.iter().cloned().collect();
        assert_eq!(path.to_string(), text);
    }

    #[test]
    fn keys_and_indices() {
        shows(&["objects".into(), 2.into(), "shape".into()], "objects[2].shape");
    }

    #[test]
    fn the_root_is_empty() {
        shows(&[], "");
    }

    #[test]
    fn odd_keys_are_quoted_and_escaped() {
        shows(&["materials".into(), "a.b\u{7}".into()], "materials[\"a.b\\u{7}\"]");
    }
}
