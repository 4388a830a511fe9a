//! The tokens of an NFF text.

use std::ops::Range;

use crate::files::without_mark;
use crate::scene::file::foreign::{self, is_blank, is_in_number, without_end_mark};

/// A word or number and where it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token<'t> {
    /// Its bytes, at least one.
    pub text: &'t [u8],
    /// The offset of the first.
    pub start: usize,
}

impl Token<'_> {
    /// Its bytes in the text.
    pub fn span(&self) -> Range<usize> {
        self.start..self.start + self.text.len()
    }

    /// The finite number that it is.
    pub fn number(&self) -> Option<f64> {
        self.any_number().filter(|number| number.is_finite())
    }

    /// The number that it is, which may be infinite or none.
    pub fn any_number(&self) -> Option<f64> {
        foreign::number(self.text)
    }
}

/// The tokens of a text in order, without comments.
#[derive(Debug, Clone)]
pub struct Tokens<'t> {
    text: &'t [u8],
    at: usize,
}

impl<'t> Tokens<'t> {
    /// The tokens of this text.
    pub fn new(text: &'t [u8]) -> Self {
        let text = without_end_mark(text);
        Self { text, at: text.len() - without_mark(text).len() }
    }

    /// The next token, which stays the next.
    pub fn peek(&self) -> Option<Token<'t>> {
        self.clone().next()
    }

    /// Just behind the latest token.
    pub fn end(&self) -> usize {
        self.at
    }

    /// Whether the next token is on the line of the latest one.
    pub fn goes_on_in_line(&self) -> bool {
        let rest = &self.text[self.at..];
        let gap = rest.iter().take_while(|byte| is_space(**byte));
        gap.clone().all(|byte| !ends_line(*byte)) && rest.get(gap.count()).is_some_and(|byte| *byte != b'#')
    }
}

impl<'t> Iterator for Tokens<'t> {
    type Item = Token<'t>;

    fn next(&mut self) -> Option<Token<'t>> {
        let mut start = self.at;
        loop {
            let rest = &self.text[start..];
            start += rest.iter().position(|byte| !is_space(*byte))?;
            if self.text[start] != b'#' {
                break;
            }
            start += self.text[start..].iter().position(|byte| ends_line(*byte))?;
        }
        let ends_word = |at: &usize| match self.text[*at] {
            b'#' => !is_in_number(self.text, start, *at),
            byte => is_space(byte),
        };
        self.at = (start..self.text.len()).find(ends_word).unwrap_or(self.text.len());
        Some(Token { text: &self.text[start..self.at], start })
    }
}

fn is_space(byte: u8) -> bool {
    is_blank(byte) || ends_line(byte)
}

fn ends_line(byte: u8) -> bool {
    byte == b'\n' || byte == b'\r'
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn splits(text: &str, expected: &[&str]) {
        let found: Vec<_> = Tokens::new(text.as_bytes()).map(|token| String::from_utf8_lossy(token.text)).collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn any_white_space_separates() {
        splits(" s\t1\r\n2\x0b3\x0c4\r5", &["s", "1", "2", "3", "4", "5"]);
    }

    #[test]
    fn comments_end_with_the_line() {
        splits("# one\ns 1# two s 3\r\n2 #three", &["s", "1", "2"]);
    }

    #[test]
    fn a_hash_may_be_part_of_a_number() {
        splits("1.#INF -1.#IND#x\n1.#c", &["1.#INF", "-1.#IND", "1."]);
    }

    #[test]
    fn the_end_mark_is_no_token() {
        splits("s 1\r\n\x1a\n", &["s", "1"]);
    }

    #[test]
    fn a_byte_order_mark_is_no_token() {
        splits("\u{feff}b 1", &["b", "1"]);
    }

    #[test]
    fn nothing_has_no_tokens() {
        splits(" \n# nothing", &[]);
    }

    #[test]
    fn numbers_as_c_prints_them() {
        let number = |text: &str| Token { text: text.as_bytes(), start: 0 }.number();
        for (text, expected) in [("-2.5e-17", -2.5e-17), (".8", 0.8), ("3.", 3.0), ("+1E+2", 100.0)] {
            assert_eq!(number(text), Some(expected), "{text}");
        }
        assert_eq!(number("-0").map(f64::to_bits), Some((-0.0_f64).to_bits()));
        for text in ["nan", "-inf", "infinity", "1e999", "0x1", "1,5", "1d3", "1.#INF", "-nan(ind)", "\u{ff}"] {
            assert_eq!(number(text), None, "{text}");
        }
    }
}
