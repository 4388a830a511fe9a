//! Keys that are written down, for a screenshot or a test.

use super::{NAMES, parse, rows};
use crate::files::suggest;
use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// What a script of keys holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Typed {
    /// A key.
    Key(KeyEvent),
    /// A space between two words: the key where a line is typed, otherwise nothing.
    Gap(KeyEvent),
}

/// The keys that a text such as `nnn 5j Tab ^d` or `nnn5j<Tab>^d` spells: names of keys stand alone or in angle brackets, other
/// characters are keys themselves, and spaces separate.
pub fn script(text: &str) -> Vec<Typed> {
    let mut typed = Vec::new();
    let space = KeyEvent::new(KeyCode::Char(' '), KeyModifiers::NONE);
    for word in text.split_whitespace() {
        let begins_with_a_name = bracketed(word).is_some() || (word.chars().nth(1).is_some() && parse(word).is_some());
        // Who names the key means it alone.
        let is_after_one = typed.last().is_none_or(|last| *last == Typed::Key(space));
        if !is_after_one && !begins_with_a_name {
            typed.push(Typed::Gap(space));
        }
        let mut rest = word;
        while let Some((key, after)) = first_key(rest) {
            typed.push(Typed::Key(key));
            rest = after;
        }
    }
    typed
}

/// The keys of a [`script`] without its gaps.
pub fn sequence(text: &str) -> Vec<KeyEvent> {
    let key = |typed| match typed {
        Typed::Key(key) => Some(key),
        Typed::Gap(_) => None,
    };
    script(text).into_iter().filter_map(key).collect()
}

/// What a script has in place of the name of a key, but is none: in angle brackets, or a word of its own like `Retrun`. Words of a line that is
/// typed are no keys.
pub fn unknown_name(text: &str) -> Option<&str> {
    let mut is_in_line = false;
    for word in text.split_whitespace() {
        let bracketed = word.split('<').skip(1).filter_map(|rest| rest.split_once('>')).map(|(name, _)| name);
        let looks_like_a_name = |name: &&str| {
            name.chars().nth(1).is_some() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '^')
        };
        if let Some(unknown) = bracketed.filter(looks_like_a_name).find(|name| named(name).is_none()) {
            return Some(unknown);
        }
        if !is_in_line && is_misspelled(word) {
            return Some(word);
        }
        let mut rest = word;
        while let Some((key, after)) = first_key(rest) {
            is_in_line = match key.code {
                KeyCode::Enter | KeyCode::Esc => false,
                // These begin a line.
                KeyCode::Char('/' | ':' | 'b' | 'f' | '=') => true,
                _ => is_in_line,
            };
            rest = after;
        }
    }
    None
}

/// Whether a word can only be meant as the name of a key: it begins like one, and has a letter that is no key, or is nearly a name.
fn is_misspelled(word: &str) -> bool {
    let begins_like_a_name =
        word.starts_with(|c: char| c.is_ascii_uppercase()) && word.chars().skip(1).all(|c| c.is_ascii_lowercase());
    let is_key = |c: char| rows().any(|row| row.keys.iter().any(|key| key.strip_prefix(c) == Some("")));
    let is_near = || suggest(word, NAMES.iter().map(|(name, _)| *name)).is_some();
    begins_like_a_name && word.len() > 3 && parse(word).is_none() && (is_near() || !word.chars().all(is_key))
}

/// The key with this name in angle brackets, where capitals don't count.
fn named(name: &str) -> Option<KeyEvent> {
    if name.eq_ignore_ascii_case("lt") {
        return parse("<");
    }
    let known = NAMES.iter().map(|(known, _)| *known).find(|known| known.eq_ignore_ascii_case(name));
    parse(known.unwrap_or(name)).or_else(|| parse(&name.to_ascii_uppercase()))
}

/// The key in angle brackets that a text begins with, and what follows it.
fn bracketed(text: &str) -> Option<(KeyEvent, &str)> {
    let (name, after) = text.strip_prefix('<')?.split_once('>')?;
    Some((named(name)?, after))
}

/// The key that a word begins with, and what follows it.
fn first_key(word: &str) -> Option<(KeyEvent, &str)> {
    let first = word.chars().next()?;
    let whole = || parse(word).map(|key| (key, ""));
    let control = || {
        let pair = word.get(..2).filter(|pair| first == '^' && pair.ends_with(|c: char| c.is_ascii_alphabetic()))?;
        Some((parse(pair)?, &word[2..]))
    };
    let itself = || Some((parse(&word[..first.len_utf8()])?, &word[first.len_utf8()..]));
    bracketed(word).or_else(whole).or_else(control).or_else(itself)
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::name;
    use super::*;

    #[track_caller]
    fn spells(text: &str, expected: &[&str]) {
        let names: Vec<_> = sequence(text).into_iter().map(|key| name(key).unwrap()).collect();
        assert_eq!(names, expected, "{text}");
    }

    #[test]
    fn sequences_of_keys() {
        spells("n5j Tab ^d?^uz", &["n", "5", "j", "Tab", "^d", "?", "^u", "z"]);
        spells("l<Down><Space>n<^u><x", &["l", "Down", "Space", "n", "^u", "<", "x"]);
        spells("Tab Shift-Tab l<Shift-Tab>", &["Tab", "Shift-Tab", "l", "Shift-Tab"]);
        spells("<C-o> C-d C", &["^o", "^d", "C"]);
        // As other programs call them.
        spells("<S-Tab><CR><c-d><BS><PageDown><esc>", &["Shift-Tab", "Enter", "^d", "Backspace", "PgDn", "Esc"]);
        spells("<lt>", &["<"]);
        spells("PageUp Return <RETURN> <f1>", &["PgUp", "Enter", "Enter", "F1"]);
    }

    #[test]
    fn a_space_may_be_of_a_line() {
        let gaps = |text: &str| script(text).iter().filter(|typed| matches!(typed, Typed::Gap(_))).count();
        assert_eq!([gaps(":pixel 3 4 <Enter>"), gaps("/ Tab ^d"), gaps("a b"), gaps(" a")], [2, 0, 1, 0]);
        assert_eq!([gaps("object <Space> ball"), gaps("object<Space>ball")], [0, 0]);
    }

    #[test]
    fn names_that_are_none_are_found() {
        assert_eq!(unknown_name("n<Nope>"), Some("Nope"));
        assert_eq!(unknown_name("<Tab><Retrun>x"), Some("Retrun"));
        assert_eq!(unknown_name("nn Retrun"), Some("Retrun"));
        assert_eq!(unknown_name("Fyxwv nn"), Some("Fyxwv"));
        assert_eq!(unknown_name("/ plane Enter Spcae"), Some("Spcae"));
        for fine in [
            "/ Sphere Enter n",
            "Gkk",
            "Qnnn",
            "/Local model Enter",
            "b object Wall <Enter>",
            "<Tab>",
            "T2_A<0 a>b",
            "<<<>>",
            "<x>",
            "b T2<A>",
            "<C-o><^o>",
        ] {
            assert_eq!(unknown_name(fine), None, "{fine}");
        }
    }
}
