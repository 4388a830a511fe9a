//! Walks over JSON text without building anything, to find places in it.
//!
//! The text is usually good as far as it is scanned, because a parser has been there; where it is not, the scanner stops
//! early and never panics.

use std::ops::Range;

/// A position in JSON text.
pub struct Scanner<'t> {
    text: &'t [u8],
    /// Byte offset of the next byte.
    pub at: usize,
}

impl<'t> Scanner<'t> {
    /// Starts at the first byte.
    pub fn new(text: &'t str) -> Self {
        Self { text: text.as_bytes(), at: 0 }
    }

    /// The next byte that is no white space, not taken.
    pub fn peek(&mut self) -> Option<u8> {
        while let Some(b' ' | b'\t' | b'\n' | b'\r') = self.text.get(self.at) {
            self.at += 1;
        }
        self.text.get(self.at).copied()
    }

    /// Takes a byte after white space, if it is the one given.
    pub fn take(&mut self, byte: u8) -> bool {
        let is_next = self.peek() == Some(byte);
        self.at += usize::from(is_next);
        is_next
    }

    /// Skips one value, however deep, and says where it was.
    pub fn skip_value(&mut self) -> Range<usize> {
        self.peek();
        let start = self.at;
        let mut depth = 0_usize;
        loop {
            match self.peek() {
                None => break,
                Some(b'"') => self.skip_string(),
                Some(b'{' | b'[') => {
                    depth += 1;
                    self.at += 1;
                }
                Some(b'}' | b']') if depth > 0 => {
                    depth -= 1;
                    self.at += 1;
                }
                Some(b',' | b':') if depth > 0 => self.at += 1,
                Some(b'}' | b']' | b',' | b':') => break,
                Some(_) => self.skip_word(),
            }
            if depth == 0 {
                break;
            }
        }
        start..self.at
    }

    /// Skips a string that starts here, its quotes included.
    pub fn skip_string(&mut self) {
        self.at += 1;
        while let Some(byte) = self.text.get(self.at) {
            match byte {
                b'"' => {
                    self.at += 1;
                    return;
                }
                b'\\' => self.at = (self.at + 2).min(self.text.len()),
                _ => self.at += 1,
            }
        }
    }

    fn skip_word(&mut self) {
        let ends_word = |byte: &u8| b" \t\r\n,:[]{}\"".contains(byte);
        let length = self.text[self.at..].iter().position(ends_word);
        self.at = length.map_or(self.text.len(), |length| self.at + length);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn skips(text: &str, value: &str) {
        let range = Scanner::new(text).skip_value();
        assert_eq!(&text[range], value);
    }

    #[test]
    fn a_number_ends_at_the_comma() {
        skips("  -1.5e3, 2", "-1.5e3");
    }

    #[test]
    fn brackets_in_strings_do_not_count() {
        skips(r#"{"a]\"}": [1, "}"]} ]"#, r#"{"a]\"}": [1, "}"]}"#);
    }

    #[test]
    fn a_cut_value_ends_with_the_text() {
        skips("[1, {\"a\": \"b\\", "[1, {\"a\": \"b\\");
    }

    #[test]
    fn nothing_is_empty() {
        skips("  ", "");
    }
}
