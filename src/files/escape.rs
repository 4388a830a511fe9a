//! Text from outside, made safe to print: a file must not be able to drive the terminal.

pub use super::hidden::{hidden, is_hidden, look};
use std::borrow::Cow;
use unicode_segmentation::UnicodeSegmentation;
use unicode_width::UnicodeWidthStr;

/// The text with what would not be seen as itself escaped (`\n`, `\u{1b}`): control characters, invisible ones, characters that change the
/// direction of writing, and joiners where no script is spelt with them.
pub fn escape_hidden(text: &str) -> Cow<'_, str> {
    replaced(text, hidden(text), |escaped, character| escaped.extend(character.escape_default()))
}

/// The text with these characters, in order, written otherwise.
fn replaced<'t>(
    text: &'t str,
    characters: impl Iterator<Item = (usize, char)>,
    write: impl Fn(&mut String, char),
) -> Cow<'t, str> {
    let mut escaped = String::new();
    let mut copied = 0;
    for (at, character) in characters {
        escaped.push_str(&text[copied..at]);
        write(&mut escaped, character);
        copied = at + character.len_utf8();
    }
    if copied == 0 {
        return Cow::Borrowed(text);
    }
    escaped.push_str(&text[copied..]);
    Cow::Owned(escaped)
}

/// The text with each of its lines made [`escape_hidden`]: for messages of several lines.
pub fn escape_hidden_lines(text: &str) -> String {
    text.split('\n').map(escape_hidden).collect::<Vec<_>>().join("\n")
}

/// A text of JSON with what would not be seen as itself escaped in its strings (`\u009b`), which means the same to whoever reads it.
pub fn escape_hidden_json(text: &str) -> Cow<'_, str> {
    if text.is_ascii() && !text.contains('\u{7f}') {
        return Cow::Borrowed(text);
    }
    // Between strings JSON has no such characters but the ends of lines.
    let characters = hidden(text).filter(|(_, character)| !matches!(character, '\n' | '\r' | '\t'));
    replaced(text, characters, |escaped, character| {
        character.encode_utf16(&mut [0; 2]).iter().for_each(|unit| *escaped += &format!("\\u{unit:04x}"));
    })
}

/// What a person takes for the characters of a text, each with the columns that it takes on a terminal.
pub fn cells(text: &str) -> impl Iterator<Item = (&str, usize)> {
    text.graphemes(true).map(|cell| (cell, cell.width()))
}

/// The columns that a text takes on a terminal.
pub fn width(text: &str) -> usize {
    cells(text).map(|(_, width)| width).sum()
}

/// How many characters of a name or a text from outside a message repeats.
pub const QUOTED: usize = 40;

/// A name or a text from outside as a message repeats it.
pub fn quoted(text: &str) -> String {
    format!("`{}`", shortened(text, QUOTED))
}

/// At most `limit` characters of the text, made visible, with `…` for what was cut.
pub fn shortened(text: &str, limit: usize) -> String {
    match text.char_indices().nth(limit) {
        None => escape_hidden(text).into_owned(),
        Some((end, _)) => format!("{}…", escape_hidden(&text[..end])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escape_sequences_are_shown_not_sent() {
        assert_eq!(escape_hidden("a\u{1b}[2Jb\0"), "a\\u{1b}[2Jb\\u{0}");
    }

    #[test]
    fn other_scripts_stay_as_they_are() {
        assert_eq!(escape_hidden("esfera ñ 球"), "esfera ñ 球");
    }

    #[test]
    fn joiners_stay_where_a_script_is_spelt_with_them() {
        for text in ["کره‌ی قرمز", "क्‍ष गोला", "अवन्‌", "അവന്‍", "ක්‍ෂ", "👩‍🔬", "👩🏽‍🔬", "❤️‍🔥"]
        {
            assert_eq!(escape_hidden(text), text);
        }
        for text in
            ["a\u{200d}b", "\u{200c}ی", "ی\u{200c}\u{200c}ی", "é\u{200d}ب", "👩\u{200d}", "a\u{200c}ی", "ی \u{200d}ی"]
        {
            assert!(escape_hidden(text).contains("\\u{200"), "{text:?}");
        }
    }

    #[test]
    fn escaped_json_means_the_same() {
        let text = "{\n\t\"a\u{9b}\u{202e}\": \"\u{e0041}ball\u{7f}\"}";
        assert_eq!(escape_hidden_json(text), "{\n\t\"a\\u009b\\u202e\": \"\\udb40\\udc41ball\\u007f\"}");
        let read = |text: &str| serde_json::from_str::<serde_json::Value>(text).expect("JSON");
        assert_eq!(read(&escape_hidden_json(text)), read(text));
        assert!(matches!(escape_hidden_json("{\"name\": \"کره‌ی\"}"), Cow::Borrowed(_)));
    }

    #[test]
    fn lines_of_a_message_stay_lines() {
        assert_eq!(escape_hidden_lines("a\u{1b}[2J\nb\r\n"), "a\\u{1b}[2J\nb\\r\n");
    }

    #[test]
    fn what_turns_the_writing_is_escaped_beside_letters_too() {
        for mark in "\u{61c}\u{200e}\u{200f}\u{202e}\u{2066}\u{2060}\u{200b}\u{feff}".chars() {
            let text = format!("کره{mark}ی");
            assert_eq!(escape_hidden(&text), format!("کره{}ی", mark.escape_default()));
        }
    }

    #[test]
    fn columns_are_those_of_a_terminal() {
        assert_eq!(["abc", "漢字の", "کره‌ی", "سلام", "क्‍ष", "👩‍🔬", "é\u{301}"].map(width), [3, 6, 4, 4, 2, 2, 1]);
    }

    #[test]
    fn long_text_is_cut_between_characters() {
        assert_eq!(shortened("ñandú", 3), "ñan…");
    }
}
