//! A text in lines of words, without copies: each word is a range of bytes.

use std::ops::Range;

use crate::files::escape::{QUOTED, shortened};
use crate::scene::file::foreign::{is_blank, is_in_number};

/// Goes over a text word by word and line by line.
pub struct Words<'t> {
    text: &'t [u8],
    /// The place of the next byte.
    pub at: usize,
    syntax: Syntax,
}

/// What the text has beside words and ends of lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Syntax {
    /// Nothing.
    Plain,
    /// Comments from `#` on, and lines that go on after a backslash.
    Obj,
}

impl<'t> Words<'t> {
    /// Starts at a place of the text, which is the beginning of a line.
    pub fn new(text: &'t [u8], at: usize, syntax: Syntax) -> Words<'t> {
        Words { text, at, syntax }
    }

    /// The whole text.
    pub fn text(&self) -> &'t [u8] {
        self.text
    }

    /// The next word of this line.
    pub fn next(&mut self) -> Option<Range<usize>> {
        loop {
            match *self.text.get(self.at)? {
                byte if is_blank(byte) => self.at += 1,
                b'\n' | b'\r' => return None,
                b'#' if self.syntax == Syntax::Obj => {
                    self.skip_to_end_of_line();
                    return None;
                }
                b'\\' => match self.joint() {
                    Some(blanks) => self.skip_end_of_line(1 + blanks),
                    None => break,
                },
                _ => break,
            }
        }
        let start = self.at;
        // Directly behind a number; a name may hold a `#`.
        let begins_number = matches!(self.text[start], b'0'..=b'9' | b'+' | b'-' | b'.');
        let may_have_comment = self.syntax == Syntax::Obj && begins_number;
        while let Some(byte) = self.text.get(self.at) {
            let ends_word = match byte {
                b'\n' | b'\r' => true,
                b'#' => may_have_comment && !is_in_number(self.text, start, self.at),
                b'\\' => self.joint().is_some(),
                byte => is_blank(*byte),
            };
            if ends_word {
                break;
            }
            self.at += 1;
        }
        Some(start..self.at)
    }

    /// Goes to the next line; `false` at the end of the text.
    pub fn next_line(&mut self) -> bool {
        while self.next().is_some() {}
        self.skip_end_of_line(0);
        self.at < self.text.len()
    }

    /// The bytes of a word.
    pub fn bytes(&self, word: &Range<usize>) -> &'t [u8] {
        &self.text[word.clone()]
    }

    /// A word as a message shows it.
    pub fn shown(&self, word: &Range<usize>) -> String {
        // Cut first: a word may be the whole file.
        let start = &self.text[word.start..word.end.min(word.start + 8 * QUOTED)];
        shortened(&String::from_utf8_lossy(start), QUOTED)
    }

    /// The place here, for what is missing.
    pub fn here(&self) -> Range<usize> {
        self.at..self.at
    }

    /// How many blanks are between the backslash here and the end of its line, if nothing else is: then the line goes on.
    fn joint(&self) -> Option<usize> {
        let rest = &self.text[self.at + 1..];
        let blanks = rest.iter().take_while(|byte| is_blank(**byte)).count();
        let ends_line = matches!(rest.get(blanks), None | Some(b'\n' | b'\r'));
        (self.syntax == Syntax::Obj && ends_line).then_some(blanks)
    }

    fn skip_to_end_of_line(&mut self) {
        let rest = &self.text[self.at..];
        let length = rest.iter().position(|byte| matches!(byte, b'\n' | b'\r'));
        self.at += length.unwrap_or(rest.len());
    }

    /// Skips one end of a line, which begins `ahead` bytes further on.
    fn skip_end_of_line(&mut self, ahead: usize) {
        self.at += ahead;
        match self.text[self.at..] {
            [b'\r', b'\n', ..] => self.at += 2,
            [_, ..] => self.at += 1,
            [] => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn splits(text: &str, expected: &[&[&str]]) {
        let mut words = Words::new(text.as_bytes(), 0, Syntax::Obj);
        let mut lines = Vec::new();
        loop {
            let line: Vec<&str> = std::iter::from_fn(|| words.next()).map(|word| &text[word]).collect();
            lines.push(line);
            if !words.next_line() {
                break;
            }
        }
        assert_eq!(lines, expected);
    }

    #[test]
    fn lines_of_words() {
        splits("v 1  2\t3\nf\x0b1\x0c2\n", &[&["v", "1", "2", "3"], &["f", "1", "2"]]);
    }

    #[test]
    fn every_kind_of_line_end() {
        splits("a\r\nb\rc\n\nd", &[&["a"], &["b"], &["c"], &[], &["d"]]);
    }

    #[test]
    fn comments_end_with_their_line() {
        splits("# C:\\\nv 1 # x\n#", &[&[], &["v", "1"], &[]]);
        splits("v 1.0#c\nf 1#\n2", &[&["v", "1.0"], &["f", "1"], &["2"]]);
        splits("usemtl a#1 # c", &[&["usemtl", "a#1"]]);
        splits("vn 1.#IND -1.#QNAN00# c", &[&["vn", "1.#IND", "-1.#QNAN00"]]);
    }

    #[test]
    fn a_backslash_joins_lines() {
        splits("f 1 \\\n2\\\r\n3\nv\\x", &[&["f", "1", "2", "3"], &["v\\x"]]);
        splits("f 1\\ \t\n2 \\\x0c\r\n3 \\ 4\nv \\ ", &[&["f", "1", "2", "3", "\\", "4"], &["v"]]);
    }

    #[test]
    fn nothing_is_one_empty_line() {
        splits("", &[&[]]);
    }
}
