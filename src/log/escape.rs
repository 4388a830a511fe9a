//! Text from outside, made safe to print: a file must not be able to drive the terminal.

use std::borrow::Cow;
use unicode_segmentation::UnicodeSegmentation;
use unicode_width::UnicodeWidthStr;

/// The text with what would not be seen as itself escaped (`\u{1b}`): control characters, characters that change the direction
/// of writing, and joiners where no script is spelt with them.
pub fn visible(text: &str) -> Cow<'_, str> {
    let mut escaped = String::new();
    let mut copied = 0;
    for (at, character) in hidden(text) {
        escaped.push_str(&text[copied..at]);
        escaped.extend(character.escape_unicode());
        copied = at + character.len_utf8();
    }
    if copied == 0 {
        return Cow::Borrowed(text);
    }
    escaped.push_str(&text[copied..]);
    Cow::Owned(escaped)
}

/// The characters of a text that would not be seen as themselves, with their places in bytes.
pub fn hidden(text: &str) -> impl Iterator<Item = (usize, char)> {
    let mut before = None;
    text.char_indices().filter(move |(at, character)| {
        let before = before.replace(*character);
        let is_joiner = matches!(character, '\u{200c}' | '\u{200d}');
        let after = || text[at + character.len_utf8()..].chars().next();
        is_hidden(*character) && !(is_joiner && before.is_some_and(|before| may_join(before, after())))
    })
}

/// Whether a joiner (U+200C, U+200D) between these changes what is seen: behind a letter or sign of a script whose letters join or
/// are stacked, Arabic to Sinhala or another one of Asia and Africa, as in Persian می‌خواهم and Hindi क्‍षि; or between two pictures.
fn may_join(before: char, after: Option<char>) -> bool {
    let is_of_script = matches!(
        before,
        '\u{610}'..='\u{61a}' | '\u{620}'..='\u{dff}' | '\u{f00}'..='\u{109f}' | '\u{1700}'..='\u{180d}' | '\u{180f}'..='\u{1cff}'
            | '\u{a800}'..='\u{abff}' | '\u{fb50}'..='\u{fdff}' | '\u{fe70}'..='\u{fefc}' | '\u{10a00}'..='\u{11fff}'
            | '\u{1e900}'..='\u{1e95f}'
    );
    let is_picture = |character| matches!(character, '\u{2190}'..='\u{2bff}' | '\u{1f000}'..='\u{1faff}');
    is_of_script || ((is_picture(before) || before == '\u{fe0f}') && after.is_some_and(is_picture))
}

/// Whether a character would not be seen as itself; of a joiner, [`hidden`] says where it is.
pub fn is_hidden(character: char) -> bool {
    let turns_writing = matches!(
        character,
        '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
    );
    character.is_control() || turns_writing
}

/// What a person takes for the characters of a text, each with the columns that it takes on a terminal.
pub fn cells(text: &str) -> impl Iterator<Item = (&str, usize)> {
    text.graphemes(true).map(|cell| (cell, cell.width()))
}

/// The columns that a text takes on a terminal.
pub fn width(text: &str) -> usize {
    cells(text).map(|(_, width)| width).sum()
}

/// At most `limit` characters of the text, made visible, with `…` for what was cut.
pub fn shortened(text: &str, limit: usize) -> String {
    match text.char_indices().nth(limit) {
        None => visible(text).into_owned(),
        Some((end, _)) => format!("{}…", visible(&text[..end])),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn escape_sequences_are_shown_not_sent() {
        assert_eq!(visible("a\u{1b}[2Jb\0"), "a\\u{1b}[2Jb\\u{0}");
    }

    #[test]
    fn other_scripts_stay_as_they_are() {
        assert_eq!(visible("esfera ñ 球"), "esfera ñ 球");
    }

    #[test]
    fn joiners_stay_where_a_script_is_spelt_with_them() {
        for text in ["کره‌ی قرمز", "क्‍ष गोला", "अवन्‌", "അവന്‍", "ක්‍ෂ", "👩‍🔬", "👩🏽‍🔬", "❤️‍🔥"]
        {
            assert_eq!(visible(text), text);
            assert_eq!(hidden(text).count(), 0);
        }
        for text in
            ["a\u{200d}b", "\u{200c}ی", "ی\u{200c}\u{200c}ی", "é\u{200d}ب", "👩\u{200d}", "a\u{200c}ی", "ی \u{200d}ی"]
        {
            assert_eq!(hidden(text).count(), 1, "{text:?}");
            assert_eq!(visible(text).matches("\\u{200").count(), 1, "{text:?}");
        }
    }

    #[test]
    fn what_turns_the_writing_is_escaped_beside_letters_too() {
        for mark in "\u{61c}\u{200e}\u{200f}\u{202e}\u{2066}\u{2060}\u{200b}\u{feff}".chars() {
            let text = format!("کره{mark}ی");
            assert_eq!(visible(&text), format!("کره{}ی", mark.escape_unicode()));
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
