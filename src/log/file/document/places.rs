//! Where the contents of nodes are in a document.

use super::MAX_BRACKETS;
use std::ops::Range;

/// The `children` of the document and of the nodes in it, in order of where they begin.
pub(super) struct Places {
    list: Vec<Contents>,
}

/// The `children` of a node.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Contents {
    /// From the bracket that opens to behind the one that closes.
    pub range: Range<usize>,
    /// Which are the next that aren't in these.
    pub after: usize,
}

/// What is open.
#[derive(Clone, Copy)]
enum Open {
    /// The document or an event: an object that may have `children`.
    Node {
        has_key: bool,
        key_is_children: bool,
    },
    /// `children`, by number.
    Contents(usize),
    Other,
}

impl Places {
    /// Those of a document, as far as it is JSON; the place where brackets nest too deep.
    pub fn of(bytes: &[u8]) -> Result<Places, usize> {
        let (mut list, mut open): (Vec<Contents>, Vec<Open>) = (Vec::new(), Vec::new());
        let mut at = 0;
        while let Some(byte) = bytes.get(at) {
            let start = at;
            at += 1;
            match byte {
                b'"' => {
                    at = end_of_string(bytes, at);
                    if let Some(Open::Node { has_key, key_is_children }) = open.last_mut()
                        && !*has_key
                    {
                        (*has_key, *key_is_children) = (true, is_children(&bytes[start..at]));
                    }
                }
                b'{' => open.push(match open.last() {
                    None | Some(Open::Contents(_)) => Open::Node { has_key: false, key_is_children: false },
                    Some(_) => Open::Other,
                }),
                b'[' => open.push(match open.last() {
                    Some(Open::Node { key_is_children: true, .. }) => {
                        list.push(Contents { range: start..bytes.len(), after: 0 });
                        Open::Contents(list.len() - 1)
                    }
                    _ => Open::Other,
                }),
                b'}' | b']' => {
                    if let Some(Open::Contents(number)) = open.pop() {
                        let after = list.len();
                        list[number] = Contents { range: list[number].range.start..at, after };
                    }
                    // Other text may be behind the document.
                    if open.is_empty() {
                        break;
                    }
                }
                b',' => {
                    if let Some(Open::Node { has_key, key_is_children }) = open.last_mut() {
                        (*has_key, *key_is_children) = (false, false);
                    }
                }
                _ => {}
            }
            if open.len() > MAX_BRACKETS {
                return Err(start);
            }
        }
        Ok(Places { list })
    }

    /// The contents with this number.
    pub fn get(&self, number: usize) -> Option<&Contents> {
        self.list.get(number)
    }
}

/// The place behind a string whose first letter is there.
fn end_of_string(bytes: &[u8], mut at: usize) -> usize {
    while let Some(more) = memchr::memchr2(b'"', b'\\', &bytes[at.min(bytes.len())..]) {
        at += more + 1;
        if bytes[at - 1] == b'"' {
            return at;
        }
        // What follows a backslash ends nothing.
        at += 1;
    }
    bytes.len()
}

/// Whether a key, with its quotes, is `children`, also if its letters are spelt with escapes.
fn is_children(key: &[u8]) -> bool {
    key == b"\"children\""
        || (key.contains(&b'\\') && serde_json::from_slice(key).is_ok_and(|key: String| key == "children"))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    #[test]
    fn contents_are_found_however_their_key_is_spelt() {
        let text = r#"{"x":[{"children":[]}],"children":[{"children":[{"a":"]\""}],"n":1},{"m":{"children":[]},"\u0063hildren":[]}]} ["#;
        let places = Places::of(text.as_bytes()).unwrap();
        let found: Vec<_> = places.list.iter().map(|one| (&text[one.range.clone()], one.after)).collect();
        let whole = &text[text.find("[{\"children\":[{").unwrap()..text.len() - 3];
        assert_eq!(found, [(whole, 3), (r#"[{"a":"]\""}]"#, 2), ("[]", 3)]);
    }

    #[test]
    fn endless_brackets_are_reported() {
        assert_eq!(Places::of(&vec![b'['; 2 * MAX_BRACKETS]).err(), Some(MAX_BRACKETS));
    }
}
