//! Text from outside, made safe to print: a file must not be able to drive the terminal.

use std::borrow::Cow;

/// The text with control characters, and characters that change the direction of writing, escaped (`\u{1b}`).
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.chars().any(is_hidden) {
        return Cow::Borrowed(text);
    }
    let mut escaped = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        if is_hidden(character) {
            escaped.extend(character.escape_unicode());
        } else {
            escaped.push(character);
        }
    }
    Cow::Owned(escaped)
}

/// Whether a character would not be seen as itself.
pub fn is_hidden(character: char) -> bool {
    let turns_writing = matches!(
        character,
        '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}'
    );
    character.is_control() || turns_writing
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
    fn long_text_is_cut_between_characters() {
        assert_eq!(shortened("ñandú", 3), "ñan…");
    }
}
