//! Which characters are not seen as themselves, and which texts look alike.
//!
//! The joiners U+200C and U+200D are seen by what they do to their neighbours, and so is what chooses between two forms of a picture. They
//! are let pass where they do that, by the rules of RFC 5892, Appendix A.1 and A.2 (CONTEXTJ), for scripts, and by those of Unicode
//! Standard Annex 29 (GB11) for pictures, and count as hidden anywhere else.

use std::borrow::Cow;
use unicode_joining_type::{JoiningType, get_joining_type};
use unicode_normalization::UnicodeNormalization;
use unicode_normalization::char::canonical_combining_class;
use unicode_segmentation::UnicodeSegmentation;

const NON_JOINER: char = '\u{200c}';
const JOINER: char = '\u{200d}';

/// The canonical combining class of signs that say that a consonant has no vowel of its own.
const VIRAMA: u8 = 9;

/// Whether a character would not be seen as itself; of a joiner and of what chooses a form, [`hidden`] says where it is.
///
/// These are control characters; what Unicode calls default ignorable, assigned or not (fillers, joiners, what turns the direction of
/// writing, what chooses a form, tags); what ends lines; annotations; the controls of hieroglyphs and of musical notes; and fillers with a
/// glyph of nothing.
pub fn is_hidden(character: char) -> bool {
    if character.is_ascii() {
        return character.is_ascii_control();
    }
    let is_ignorable = matches!(
        character,
        '\u{ad}' | '\u{34f}' | '\u{61c}' | '\u{115f}' | '\u{1160}' | '\u{17b4}' | '\u{17b5}' | '\u{180b}'..='\u{180f}'
            | '\u{200b}'..='\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{3164}'
            | '\u{fe00}'..='\u{fe0f}' | '\u{feff}' | '\u{ffa0}' | '\u{fff0}'..='\u{fff8}' | '\u{1bca0}'..='\u{1bca3}'
            | '\u{1d173}'..='\u{1d17a}' | '\u{e0000}'..='\u{e0fff}'
    );
    let is_like_them = matches!(
        character,
        '\u{2028}' | '\u{2029}' | '\u{fff9}'..='\u{fffc}' | '\u{13430}'..='\u{1343f}' | '\u{16fe4}' | '\u{1d159}'
    );
    character.is_control() || is_ignorable || is_like_them
}

/// The characters of a text that would not be seen as themselves, with their places in bytes.
pub fn hidden(text: &str) -> impl Iterator<Item = (usize, char)> {
    text.char_indices().filter(|(at, character)| {
        is_hidden(*character) && !is_spelt(&text[..*at], *character, &text[at + character.len_utf8()..])
    })
}

/// Whether a hidden character has a visible effect in its place.
fn is_spelt(before: &str, character: char, after: &str) -> bool {
    let (last, next) = (before.chars().next_back(), after.chars().next());
    match character {
        NON_JOINER | JOINER if last.is_some_and(|last| canonical_combining_class(last) == VIRAMA) => true,
        NON_JOINER => parts_letters(before, after),
        JOINER => next.is_some_and(|next| joins_pictures(before, next)),
        '\u{fe0e}' | '\u{fe0f}' if last.is_some_and(is_picture) => true,
        // A key: a digit, its form as a picture, and the frame around it.
        '\u{fe0f}' => matches!(last, Some('0'..='9' | '#' | '*')) && next == Some('\u{20e3}'),
        _ => false,
    }
}

/// Whether the letters around a non-joiner would be joined without it.
fn parts_letters(before: &str, after: &str) -> bool {
    let is_transparent = |character: &char| get_joining_type(*character) == JoiningType::Transparent;
    let (last, next) = (before.chars().rev().find(|c| !is_transparent(c)), after.chars().find(|c| !is_transparent(c)));
    let joins_left = |c| matches!(get_joining_type(c), JoiningType::LeftJoining | JoiningType::DualJoining);
    let joins_right = |c| matches!(get_joining_type(c), JoiningType::RightJoining | JoiningType::DualJoining);
    last.is_some_and(joins_left) && next.is_some_and(joins_right)
}

/// Whether a joiner makes one picture of two: then no character of a person ends behind it.
fn joins_pictures(before: &str, next: char) -> bool {
    // A picture, its colour of skin or its form.
    const MOST: usize = 2;
    let start = before.char_indices().rev().take(MOST).last().map_or(0, |(at, _)| at);
    is_picture(next)
        && format!("{}{JOINER}{next}", &before[start..])
            .graphemes(true)
            .next_back()
            .is_some_and(|last| last.contains(JOINER))
}

/// Whether a character is one that pictures are made of: a joiner makes one of it and another.
fn is_picture(character: char) -> bool {
    format!("{character}{JOINER}\u{1f52c}").graphemes(true).count() == 1
}

/// A text as a person tells it from others: without what may be invisible, with any number of blanks of any kind as one space and none at the
/// ends, and with letters and their marks in the order and the form that Unicode takes for the same (NFC).
pub fn look(text: &str) -> Cow<'_, str> {
    let bytes = text.as_bytes();
    let has_blanks_inside = !text.starts_with(' ') && !text.ends_with(' ') && !bytes.windows(2).any(|two| two == b"  ");
    if has_blanks_inside && bytes.iter().all(|byte| matches!(byte, b' '..=b'~')) {
        return Cow::Borrowed(text);
    }
    let mut seen = String::new();
    let mut is_behind_blank = false;
    for character in text.chars().filter(|character| !is_hidden(*character)).nfc() {
        // The pattern of no dots is a blank, too.
        if character.is_whitespace() || character == '\u{2800}' {
            is_behind_blank = !seen.is_empty();
            continue;
        }
        if std::mem::take(&mut is_behind_blank) {
            seen.push(' ');
        }
        seen.push(character);
    }
    Cow::Owned(seen)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_invisible_is_hidden_wherever_it_is() {
        let marks = "\u{1b}\u{7f}\u{9b}\u{ad}\u{34f}\u{61c}\u{115f}\u{1160}\u{17b4}\u{180b}\u{180e}\u{200b}\u{200e}\u{200f}\u{2028}\u{202e}\u{2060}\
                     \u{2064}\u{2065}\u{2066}\u{206f}\u{3164}\u{fe00}\u{feff}\u{ffa0}\u{fff0}\u{fff9}\u{fffb}\u{13430}\u{1bca0}\u{1d173}\u{e0001}\
                     \u{e0020}\u{e007f}\u{e0100}\u{e01ef}\u{e0fff}";
        for mark in marks.chars() {
            for (before, after) in [("", ""), ("ba", "ll"), ("کره", "ی"), ("क्", "ष"), ("👩", "🔬"), ("한", "글")]
            {
                let text = format!("{before}{mark}{after}");
                let found: Vec<_> = hidden(&text).collect();
                assert_eq!(found, [(before.len(), mark)], "{text:?}");
                assert_eq!(look(&text), look(&format!("{before}{after}")), "{text:?}");
            }
        }
    }

    #[test]
    fn what_is_seen_is_not_hidden() {
        for text in [
            "esfera ñ é e\u{301} Å",
            "球",
            "ลูกบอล กำแพง",
            "गेंद",
            "หนึ่ง",
            "بيت",
            "کُره",
            "סַפִּיר",
            "ⵣ",
            "ཀྵ",
            "မြန်မာ",
            "한글",
            "ᠮᠣᠩᠭᠣᠯ",
            "👩🏽",
            "🇪🇸",
            "½ ⁿ ™",
        ] {
            assert_eq!(hidden(text).next(), None, "{text:?}");
        }
    }

    /// RFC 5892, Appendix A.1 and A.2.
    #[test]
    fn joiners_pass_where_a_script_is_spelt_with_them() {
        for text in [
            // Between joining letters, and with signs on them.
            "کره\u{200c}ی قرمز",
            "می\u{200c}خواهم",
            "ب\u{64e}\u{200c}\u{64e}ب",
            "ܒ\u{200c}ܒ",
            "ߓ\u{200c}ߓ",
            // Behind a virama.
            "क्\u{200d}ष गोला",
            "अवन्\u{200c}",
            "അവന\u{d4d}\u{200d}",
            "ක\u{dca}\u{200d}ෂ",
            "ক\u{9cd}\u{200c}ষ",
            "க\u{bcd}\u{200c}ஷ",
        ] {
            assert_eq!(hidden(text).next(), None, "{text:?}");
        }
        for text in [
            "ba\u{200c}ll",
            "ba\u{200d}ll",
            "ball\u{200c}",
            "\u{200d}ball",
            "\u{200c}ی",
            "ی\u{200c}",
            "a\u{200c}ی",
            "ی\u{200c}a",
            // These letters join anyway, or never on that side.
            "ب\u{200d}ب",
            "د\u{200c}ب",
            "ه\u{200d}",
            "ر\u{200c}ه",
            // A consonant without the sign, a letter with another one.
            "क\u{200d}ष",
            "क\u{200c}ष",
            "é\u{200d}ب",
            "كا\u{200c} ب",
        ] {
            assert_eq!(hidden(text).count(), 1, "{text:?}");
        }
        assert_eq!(hidden("ی\u{200c}\u{200c}ی").count(), 2);
    }

    #[test]
    fn joiners_and_forms_pass_within_pictures() {
        for text in [
            "👩\u{200d}🔬",
            "👩🏽\u{200d}🔬",
            "❤\u{fe0f}\u{200d}🔥",
            "👨\u{200d}👩\u{200d}👧",
            "❤\u{fe0f}",
            "☀\u{fe0e} und ☀\u{fe0f}",
            "1\u{fe0f}\u{20e3}",
            "🏳\u{fe0f}\u{200d}🌈",
        ] {
            assert_eq!(hidden(text).next(), None, "{text:?}");
        }
        for text in [
            "👩\u{200d}",
            "👩\u{200d}a",
            "a\u{200d}👩",
            "\u{200d}👩",
            "ball\u{fe0f}",
            "ball\u{fe0e}",
            "1\u{fe0f}",
            "球\u{fe00}",
            "a\u{fe0f}\u{20e3}",
            "👩\u{200d}\u{301}",
            "🏴\u{e0067}",
        ] {
            assert_eq!(hidden(text).count(), 1, "{text:?}");
        }
        assert_eq!(hidden("❤\u{fe0f}\u{fe0f}").count(), 1);
        assert_eq!(hidden("👩\u{200d}\u{200d}🔬").count(), 2);
    }

    #[test]
    fn texts_that_look_alike_are_the_same_look() {
        for (a, b) in [
            ("ball", "ball "),
            ("ball", "\u{a0}ball"),
            ("red ball", "red\u{3000}ball"),
            ("red ball", "red  ball"),
            ("ball", "ball\u{2800}"),
            ("é", "e\u{301}"),
            ("ḍ\u{307}", "d\u{307}\u{323}"),
            ("❤", "❤\u{fe0f}"),
            ("می\u{200c}خواهم", "میخواهم"),
            ("Å", "\u{212b}"),
            ("", " \u{2003}"),
        ] {
            assert_eq!(look(a), look(b));
        }
        for (a, b) in [("ball", "Ball"), ("red ball", "redball"), ("e", "é"), ("o", "о"), ("²", "2")] {
            assert_ne!(look(a), look(b));
        }
        assert!(matches!(look("red ball-3"), Cow::Borrowed("red ball-3")));
    }
}
