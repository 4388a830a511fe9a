//! Finds the place of a path in the source text, for problems that are found after reading.

use std::ops::Range;

use super::syntax::{Broken, Reader, decoded};
use crate::files::{KeyPath, Step};

/// Where a path leads in a text, in bytes.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Place {
    /// The key of the last step, with its quotes, when that step is a key.
    pub key: Option<Range<usize>>,
    /// The value.
    pub value: Range<usize>,
    /// How many steps of the path were found: fewer than the path has when it leads to a default.
    pub depth: usize,
}

/// The place of one path, or of its longest beginning that the text holds.
pub fn locate(text: &str, path: &KeyPath) -> Place {
    locate_all(text, std::slice::from_ref(path)).pop().unwrap_or_default()
}

/// The places of many paths, in one walk over the text. Of a key that is there several times it is the first.
pub fn locate_all(text: &str, paths: &[KeyPath]) -> Vec<Place> {
    let mut search = Search { text, reader: Reader::new(text), places: vec![Place::default(); paths.len()], paths };
    let everything: Vec<usize> = (0..paths.len()).collect();
    // Where a text isn't JSON the search ends, with what was found until there.
    let _ = search.value(0, None, &everything);
    search.places
}

struct Search<'s> {
    text: &'s str,
    reader: Reader<'s>,
    paths: &'s [KeyPath],
    places: Vec<Place>,
}

impl Search<'_> {
    /// Walks over the value that is next, `depth` steps from the root, where the paths `wanted` lead through it.
    fn value(&mut self, depth: usize, key: Option<Range<usize>>, wanted: &[usize]) -> Result<(), Broken> {
        let next = self.reader.peek();
        let start = self.reader.at;
        for &path in wanted {
            self.places[path] = Place { key: key.clone(), value: start..start, depth };
        }
        let deeper: Vec<usize> =
            wanted.iter().copied().filter(|&path| self.paths[path].steps().len() > depth).collect();
        match next {
            Some(b'{') if !deeper.is_empty() => self.object(depth, &deeper)?,
            Some(b'[') if !deeper.is_empty() => self.array(depth, &deeper)?,
            _ => {
                self.reader.value()?;
            }
        }
        for &path in wanted {
            if self.places[path].depth == depth {
                self.places[path].value.end = self.reader.at;
            }
        }
        Ok(())
    }

    fn object(&mut self, depth: usize, wanted: &[usize]) -> Result<(), Broken> {
        self.reader.open()?;
        let mut is_first = true;
        while self.reader.next(b'}', is_first)? {
            is_first = false;
            let key = self.reader.key()?;
            let name = decoded(&self.text[key.clone()]);
            let found = self.matching(depth, wanted, |step| matches!(step, Step::Key(key) if *key == name));
            self.member(depth, Some(key), &found)?;
        }
        Ok(())
    }

    fn array(&mut self, depth: usize, wanted: &[usize]) -> Result<(), Broken> {
        self.reader.open()?;
        let mut index = 0;
        while self.reader.next(b']', index == 0)? {
            let found = self.matching(depth, wanted, |step| *step == Step::Index(index));
            self.member(depth, None, &found)?;
            index += 1;
        }
        Ok(())
    }

    fn member(&mut self, depth: usize, key: Option<Range<usize>>, found: &[usize]) -> Result<(), Broken> {
        match found.is_empty() {
            true => self.reader.value().map(drop),
            false => self.value(depth + 1, key, found),
        }
    }

    fn matching(&self, depth: usize, wanted: &[usize], leads_here: impl Fn(&Step) -> bool) -> Vec<usize> {
        let is_new = |path: &usize| self.places[*path].depth <= depth;
        wanted.iter().copied().filter(|path| is_new(path) && leads_here(&self.paths[*path].steps()[depth])).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"{"a": [1, {"b": "x"}], "c": {"d": 2, "d": 3}, "\u0065": 4}"#;

    fn path(steps: &[Step]) -> KeyPath {
        steps.iter().cloned().collect()
    }

    #[track_caller]
    fn finds(steps: &[Step], value: &str) {
        let place = locate(TEXT, &path(steps));
        assert_eq!(&TEXT[place.value], value);
    }

    #[test]
    fn the_root_is_the_whole_text() {
        finds(&[], TEXT);
    }

    #[test]
    fn through_arrays_and_objects() {
        finds(&["a".into(), 1.into(), "b".into()], "\"x\"");
    }

    #[test]
    fn the_first_of_repeated_keys() {
        finds(&["c".into(), "d".into()], "2");
    }

    #[test]
    fn keys_spelt_with_escapes() {
        finds(&["e".into()], "4");
    }

    #[test]
    fn a_path_that_ends_early_finds_what_there_is() {
        finds(&["a".into(), 1.into(), "missing".into(), "too".into()], "{\"b\": \"x\"}");
    }

    #[test]
    fn many_paths_in_one_walk() {
        let paths = [path(&["e".into()]), path(&["a".into(), 0.into()]), path(&["a".into()])];
        let found: Vec<&str> = locate_all(TEXT, &paths).into_iter().map(|place| &TEXT[place.value]).collect();
        assert_eq!(found, ["4", "1", "[1, {\"b\": \"x\"}]"]);
    }
}
