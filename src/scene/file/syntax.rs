//! Why a text is not JSON, in words that help: the parser's message, improved by a look at the text in that place.

use std::ops::Range;

use super::escape::{is_hidden, shortened};

/// The place and the message for a syntax error that the parser noticed at a byte.
pub fn explain(text: &str, offset: usize, said: &str) -> (Range<usize>, String) {
    let offset = floor_to_character(text, offset);
    if text.trim().is_empty() {
        return (0..0, "the file is empty, expected a scene, `{…}`".to_string());
    }
    if said.starts_with("EOF") {
        let end = text.trim_end().len();
        return (end..end, format!("the file ends too early, {}", wanted_at_end(said)));
    }
    if said == "trailing comma" {
        let comma = text[..offset].rfind(',').unwrap_or(offset);
        let message = "a comma before the closing bracket, expected none (JSON has no trailing commas)";
        return (comma..comma + 1, message.to_string());
    }
    let start = start_of_word(text, offset);
    let word = word_at(text, start);
    match hint(&text[start..], word) {
        Some(message) => (start..start + word.len().max(1), message),
        None => {
            let end = offset + text[offset..].chars().next().map_or(0, char::len_utf8);
            (offset..end, reworded(said, &text[offset..]))
        }
    }
}

fn wanted_at_end(said: &str) -> &'static str {
    match said {
        "EOF while parsing a list" => "expected `]`",
        "EOF while parsing an object" => "expected `}`",
        "EOF while parsing a string" => "expected the end of a string, `\"`",
        _ => "expected a value",
    }
}

/// What is commonly written in the belief that it is JSON.
fn hint(rest: &str, word: &str) -> Option<String> {
    if rest.starts_with("//") || rest.starts_with("/*") || rest.starts_with('#') {
        return Some("comments are not part of JSON, expected none".to_string());
    }
    if rest.starts_with('\'') {
        return Some("strings and keys need double quotes in JSON, found a single quote".to_string());
    }
    if rest.starts_with('\0') {
        return Some("found a NUL byte, expected JSON text".to_string());
    }
    match word.trim_start_matches(['-', '+']).to_ascii_lowercase().as_str() {
        "nan" | "inf" | "infinity" => Some(format!("`{word}` is no number in JSON, expected a finite number")),
        "none" | "nil" | "undefined" => Some(format!("`{word}` is no value in JSON, leave the key out instead")),
        "true" | "false" if !matches!(word, "true" | "false") => {
            Some(format!("`{word}` is no value in JSON, expected `true` or `false`"))
        }
        lower => is_odd_number(word, lower)
            .then(|| format!("`{}` is no number in JSON, expected one like 12, -0.5 or 1e3", shortened(word, 40))),
    }
}

/// Whether a word looks like a number of another language: `.5`, `5.`, `+1`, `01`, `0x10`, `1_000`, `2f`.
fn is_odd_number(word: &str, unsigned: &str) -> bool {
    let begins_like_number = unsigned.trim_start_matches('.').starts_with(|c: char| c.is_ascii_digit());
    begins_like_number && serde_json::from_str::<serde::de::IgnoredAny>(word).is_err()
}

fn reworded(said: &str, rest: &str) -> String {
    let found = match rest.chars().next() {
        None => "the end of the file".to_string(),
        Some(character) if is_hidden(character) => character.escape_unicode().to_string(),
        Some(character) => format!("`{character}`"),
    };
    match said {
        "trailing characters" => {
            format!("expected the end of the file after the scene, found {found}")
        }
        "number out of range" => "the number is too large, expected at most 1.797e308 in size".to_string(),
        "recursion limit exceeded" => "nested too deeply, expected at most 128 levels".to_string(),
        "key must be a string" => format!("expected a key in double quotes, found {found}"),
        "expected value" | "expected ident" => format!("expected a value, found {found}"),
        "invalid number" => format!("expected a digit, found {found}"),
        "lone leading surrogate in hex escape" | "unexpected end of hex escape" => {
            "half a surrogate pair (\\ud800 to \\udfff) in a string, expected both halves".to_string()
        }
        "invalid escape" => {
            "unknown escape in a string, expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\u".to_string()
        }
        _ if said.starts_with("control character") => {
            format!("found {found} in a string, expected it as an escape (\\n, \\t, \\u001b)")
        }
        _ if said.starts_with("expected ") => format!("{said}, found {found}"),
        _ => said.to_string(),
    }
}

/// The parser may notice a bad word only at its second or a later letter.
fn start_of_word(text: &str, offset: usize) -> usize {
    let before = &text[..offset];
    before.trim_end_matches(is_in_word).len()
}

fn word_at(text: &str, start: usize) -> &str {
    let rest = &text[start..];
    &rest[..rest.len() - rest.trim_start_matches(is_in_word).len()]
}

fn is_in_word(character: char) -> bool {
    character.is_alphanumeric() || matches!(character, '-' | '+' | '.' | '_')
}

fn floor_to_character(text: &str, offset: usize) -> usize {
    (0..=offset.min(text.len())).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(0)
}
