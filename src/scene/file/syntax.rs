//! JSON text read strictly, piece by piece: where it stops being JSON, and why, in words that help.

use std::borrow::Cow;
use std::ops::Range;

use crate::files::escape::{is_hidden, quoted};

/// How deeply values may be nested, as in the reader of scenes.
const DEEPEST: usize = 127;

/// Why a text isn't JSON, and where.
#[derive(Debug)]
pub struct Broken {
    /// The place, in bytes.
    pub span: Range<usize>,
    /// What is wrong, what was expected.
    pub message: String,
}

/// A position in a text that is to be JSON.
#[derive(Clone, Copy)]
pub struct Reader<'t> {
    text: &'t str,
    /// Byte offset of the next byte.
    pub at: usize,
    depth: usize,
}

impl<'t> Reader<'t> {
    /// Starts at the first byte.
    pub fn new(text: &'t str) -> Self {
        Self { text, at: 0, depth: 0 }
    }

    /// The next byte that is no white space, not taken.
    pub fn peek(&mut self) -> Option<u8> {
        let rest = &self.text.as_bytes()[self.at..];
        let blank = rest.iter().position(|byte| !matches!(byte, b' ' | b'\t' | b'\n' | b'\r')).unwrap_or(rest.len());
        self.at += blank;
        rest.get(blank).copied()
    }

    /// Takes the bracket that is next.
    pub fn open(&mut self) -> Result<(), Broken> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(self.broken_here(format!("nested too deeply, expected at most {DEEPEST} levels")));
        }
        self.at += 1;
        Ok(())
    }

    /// Whether another item follows, or the bracket that closes the list, which is taken.
    pub fn next(&mut self, close: u8, is_first: bool) -> Result<bool, Broken> {
        let close_alone = || format!("`{}`", char::from(close));
        let found = self.peek();
        if found == Some(close) {
            self.at += 1;
            self.depth -= 1;
            return Ok(false);
        }
        if is_first {
            return if found.is_none() { Err(self.broken(&close_alone())) } else { Ok(true) };
        }
        if found != Some(b',') {
            return Err(self.broken(&if found.is_none() {
                close_alone()
            } else {
                format!("`,` or {}", close_alone())
            }));
        }
        let comma = self.at;
        self.at += 1;
        if self.peek() == Some(close) {
            let message = "a comma before the closing bracket, expected none (JSON has no trailing commas)";
            return Err(Broken { span: comma..comma + 1, message: message.to_owned() });
        }
        Ok(true)
    }

    /// A key with its colon; gives the place of the key, with its quotes.
    pub fn key(&mut self) -> Result<Range<usize>, Broken> {
        if self.peek() != Some(b'"') {
            return Err(self.broken("a key in double quotes"));
        }
        let key = self.string()?;
        if self.peek() != Some(b':') {
            return Err(self.broken("`:`"));
        }
        self.at += 1;
        Ok(key)
    }

    /// Any value, however deep; gives its place.
    pub fn value(&mut self) -> Result<Range<usize>, Broken> {
        self.peek();
        let start = self.at;
        // What closes each list and object that is open.
        let mut open = Vec::new();
        loop {
            let mut is_first = false;
            match self.peek() {
                Some(bracket @ (b'{' | b'[')) => {
                    self.at += 1;
                    self.depth += 1;
                    // They are two before what closes them.
                    open.push(bracket + 2);
                    is_first = true;
                }
                Some(b'"') => {
                    self.string()?;
                }
                _ => self.word()?,
            }
            while let Some(close) = open.last().copied() {
                if self.next(close, is_first)? {
                    if close == b'}' {
                        self.key()?;
                    }
                    break;
                }
                open.pop();
                is_first = false;
            }
            if open.is_empty() {
                return Ok(start..self.at);
            }
        }
    }

    /// The end of the text.
    pub fn end(&mut self) -> Result<(), Broken> {
        match self.peek() {
            None => Ok(()),
            Some(_) => Err(self.broken("the end of the file after the scene")),
        }
    }

    /// A number, `true`, `false` or `null`.
    fn word(&mut self) -> Result<(), Broken> {
        let word = word_at(&self.text[self.at..]);
        let is_number = is_number(word.as_bytes());
        // Only a number with an exponent, or a very long one, may be too large.
        let is_long = word.len() > 300 || word.bytes().any(|byte| byte | 0x20 == b'e');
        if is_number && is_long && word.parse::<f64>().is_ok_and(f64::is_infinite) {
            let message = "the number is too large, expected at most 1.797e308 in size";
            return Err(Broken { span: self.at..self.at + word.len(), message: message.to_owned() });
        }
        if !is_number && !matches!(word, "true" | "false" | "null") {
            return Err(self.broken("a value"));
        }
        self.at += word.len();
        Ok(())
    }

    /// A string that starts here; gives its place, with its quotes.
    fn string(&mut self) -> Result<Range<usize>, Broken> {
        let start = self.at;
        let bytes = self.text.as_bytes();
        self.at += 1;
        loop {
            match bytes.get(self.at) {
                None => return Err(self.broken("the end of a string, `\"`")),
                Some(b'"') => break,
                Some(b'\\') => self.escape()?,
                Some(0..0x20) => {
                    let message = "in a string, expected it as an escape (\\n, \\t, \\u001b)";
                    return Err(self.broken_here(format!("found {} {message}", self.found())));
                }
                Some(_) => self.at += 1,
            }
        }
        self.at += 1;
        Ok(start..self.at)
    }

    /// An escape, or the two of a surrogate pair.
    fn escape(&mut self) -> Result<(), Broken> {
        match self.text.as_bytes().get(self.at + 1) {
            None => {
                self.at += 1;
                return Err(self.broken("the end of a string, `\"`"));
            }
            Some(b'"' | b'\\' | b'/' | b'b' | b'f' | b'n' | b'r' | b't') => {
                self.at += 2;
                return Ok(());
            }
            _ => {}
        }
        let message = match self.surrogate(self.at) {
            None => "unknown escape in a string, expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u",
            Some(0xd800..0xdc00) if matches!(self.surrogate(self.at + 6), Some(0xdc00..0xe000)) => {
                self.at += 12;
                return Ok(());
            }
            Some(0xd800..0xe000) => "half a surrogate pair (\\ud800 to \\udfff) in a string, expected both halves",
            Some(_) => {
                self.at += 6;
                return Ok(());
            }
        };
        Err(self.broken_here(message.to_owned()))
    }

    /// The number of an escape `\u0000`.
    fn surrogate(&self, at: usize) -> Option<u32> {
        let digits = self.text.get(at..at + 6)?.strip_prefix("\\u")?;
        let are_digits = digits.bytes().all(|byte| byte.is_ascii_hexdigit());
        are_digits.then(|| u32::from_str_radix(digits, 16).ok()).flatten()
    }

    /// What is wrong here, where something else was expected.
    fn broken(&self, expected: &str) -> Broken {
        let rest = &self.text[self.at..];
        if self.text.trim().is_empty() {
            return Broken { span: 0..0, message: "the file is empty, expected a scene, `{…}`".to_owned() };
        }
        if rest.trim().is_empty() {
            let end = self.text.trim_end().len();
            return Broken { span: end..end, message: format!("the file ends too early, expected {expected}") };
        }
        let word = word_at(rest);
        match hint(rest, word) {
            Some(message) => Broken { span: self.at..self.at + word.len().max(1), message },
            None => self.broken_here(format!("expected {expected}, found {}", self.found())),
        }
    }

    /// A mistake about the next character.
    fn broken_here(&self, message: String) -> Broken {
        let length = self.text[self.at..].chars().next().map_or(0, char::len_utf8);
        Broken { span: self.at..self.at + length, message }
    }

    /// The next character, as messages show it.
    fn found(&self) -> String {
        match self.text[self.at..].chars().next() {
            None => "the end of the file".to_owned(),
            Some(character) if is_hidden(character) => character.escape_default().to_string(),
            Some(character) => format!("`{character}`"),
        }
    }
}

/// What is commonly written in the belief that it is JSON.
fn hint(rest: &str, word: &str) -> Option<String> {
    if rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with('#') {
        return Some("comments are not part of JSON, expected none".to_owned());
    }
    if rest.starts_with('\'') {
        return Some("strings and keys need double quotes in JSON, found a single quote".to_owned());
    }
    if rest.starts_with('\0') {
        return Some("found a NUL byte, expected JSON text".to_owned());
    }
    match word.trim_start_matches(['-', '+']).to_ascii_lowercase().as_str() {
        "nan" | "inf" | "infinity" => Some(format!("`{word}` is no number in JSON, expected a finite number")),
        "none" | "nil" | "undefined" => Some(format!("`{word}` is no value in JSON, leave the key out instead")),
        "true" | "false" if !matches!(word, "true" | "false") => {
            Some(format!("`{word}` is no value in JSON, expected `true` or `false`"))
        }
        // A number of another language: `.5`, `5.`, `+1`, `01`, `0x10`, `1_000`, `2f`.
        lower => {
            let is_like_number = lower.trim_start_matches('.').starts_with(|c: char| c.is_ascii_digit());
            let is_odd = is_like_number && !is_number(word.as_bytes());
            is_odd.then(|| format!("{} is no number in JSON, expected one like 12, -0.5 or 1e3", quoted(word)))
        }
    }
}

/// The letters and digits at the beginning, with what numbers have.
fn word_at(text: &str) -> &str {
    let is_in_word = |character: char| character.is_alphanumeric() || matches!(character, '-' | '+' | '.' | '_');
    // Nearly every word is of ASCII.
    let is_ascii = |byte: &u8| byte.is_ascii() && is_in_word(char::from(*byte));
    let ascii = text.as_bytes().iter().take_while(|byte| is_ascii(byte)).count();
    &text[..text.len() - text[ascii..].trim_start_matches(is_in_word).len()]
}

/// Whether a word is a number (RFC 8259, section 6).
fn is_number(word: &[u8]) -> bool {
    let digits_of = |text: &'_ [u8]| text.iter().take_while(|byte| byte.is_ascii_digit()).count();
    let mut rest = word.strip_prefix(b"-").unwrap_or(word);
    let whole = digits_of(rest);
    let mut is_good = whole == 1 || (whole > 1 && rest[0] != b'0');
    rest = &rest[whole..];
    if let Some(fraction) = rest.strip_prefix(b".") {
        let digits = digits_of(fraction);
        is_good &= digits > 0;
        rest = &fraction[digits..];
    }
    if let [b'e' | b'E', exponent @ ..] = rest {
        let exponent = exponent.strip_prefix(b"-").or(exponent.strip_prefix(b"+")).unwrap_or(exponent);
        let digits = digits_of(exponent);
        is_good &= digits > 0;
        rest = &exponent[digits..];
    }
    is_good && rest.is_empty()
}

/// The name that a string spells.
pub fn decoded(string: &str) -> Cow<'_, str> {
    match string.contains('\\') {
        true => serde_json::from_str::<String>(string).unwrap_or_else(|_| string.to_owned()).into(),
        false => string.trim_matches('"').into(),
    }
}
