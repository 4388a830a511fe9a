//! What keys do: what the rows of the table say, and instead of it what the user has bound.

use super::script::{sequence, unknown_name};
use super::{Action, NAMES, Row, Walk, name, rows};
use crate::files::suggest;
use crate::report::language::viewer::Keys;
use crate::tui::model::bindings::{Bindings, Bound, Chord};

/// What the table of keys has where a letter of one's choice follows.
pub const ANY_LETTER: &str = "+letter";

impl Row {
    /// The name of the action, such as `next-value`: that of its text in the help.
    pub fn name(&self) -> String {
        (self.help)(&Keys::NAMES).trim_start_matches("r#").replace('_', "-")
    }

    /// Whether a letter of one's choice follows its key.
    pub fn takes_letter(&self) -> bool {
        self.keys.iter().any(|key| key.ends_with(ANY_LETTER))
    }

    /// Whether its keys are only for lists whose entries can be deleted.
    pub fn is_of_lists(&self) -> bool {
        self.action == Action::Walk(Walk::Delete)
    }
}

/// What a key does.
pub(super) enum Does {
    /// This.
    Action(Action),
    /// This, with the letter that follows.
    Letter(Action),
}

impl Does {
    fn of(row: &Row) -> Does {
        if row.takes_letter() { Does::Letter(row.action) } else { Does::Action(row.action) }
    }
}

/// What a key does in the panes, if it does anything.
pub(super) fn does(bindings: &Bindings, chord: &Chord) -> Option<Does> {
    match bindings.keys.get(chord) {
        Some(Bound::Nothing) => None,
        Some(Bound::Action(name)) => rows().find(|row| row.name() == *name).map(Does::of),
        Some(Bound::Line(_)) => {
            let number = bindings.lines().position(|(one, _)| one == chord)?;
            Some(Does::Action(Action::Line(number.try_into().ok()?)))
        }
        None => usual(chord).map(Does::of),
    }
}

/// The row of the table that has a key in the panes.
fn usual(chord: &Chord) -> Option<&'static Row> {
    rows().find(|row| !row.is_of_lists() && has(row, chord))
}

/// Whether a key deletes the selected entry of a list.
pub(super) fn deletes(bindings: &Bindings, chord: &Chord) -> bool {
    let is_usual = || rows().any(|row| row.is_of_lists() && has(row, chord));
    bindings.in_lists.get(chord).copied().unwrap_or_else(is_usual)
}

/// Whether the table has a key in this row.
fn has(row: &Row, chord: &Chord) -> bool {
    let text = chord.text();
    row.keys.iter().any(|key| without_letter(key) == text && of_table(key).as_ref() == Some(chord))
}

/// The key that stands in the table.
fn of_table(key: &str) -> Option<Chord> {
    chord(without_letter(key))
}

fn without_letter(key: &str) -> &str {
    key.strip_suffix(ANY_LETTER).unwrap_or(key)
}

/// The key, or the two characters, that a text spells as in a script of keys.
pub fn chord(text: &str) -> Option<Chord> {
    let names: Vec<_> = sequence(text).into_iter().map(name).collect::<Option<_>>()?;
    match &names[..] {
        [key] => Some(Chord { first: None, key: key.clone() }),
        [first, key] => Some(Chord { first: Some(character(first)?), key: key.clone() }),
        _ => None,
    }
}

/// The character that a key is named by.
fn character(key: &str) -> Option<char> {
    let mut characters = key.chars();
    characters.next().filter(|_| characters.next().is_none())
}

/// The pairs of characters that do something, those of the table and those of the user.
fn pairs(bindings: &Bindings) -> Vec<Chord> {
    let own = bindings.keys.iter().filter(|(_, bound)| **bound != Bound::Nothing).map(|(chord, _)| chord.clone());
    let of_table = rows().flat_map(|row| row.keys).filter_map(|key| of_table(key));
    let of_table = of_table.filter(|chord| !bindings.keys.contains_key(chord));
    own.chain(of_table).filter(|chord| chord.first.is_some()).collect()
}

/// Whether a character is the first of two, such as the `z` of `zz`.
pub(super) fn begins_a_pair(bindings: &Bindings, first: char) -> bool {
    pairs(bindings).iter().any(|chord| chord.first == Some(first))
}

/// The keys of a row as they are now, as the table has them.
pub fn in_force(bindings: &Bindings, row: &Row) -> Vec<String> {
    if bindings.is_empty() {
        return row.keys.iter().map(|key| (*key).to_owned()).collect();
    }
    let action = Bound::Action(row.name());
    let is_usual = |key: &&&str| match of_table(key) {
        Some(chord) if row.is_of_lists() => deletes(bindings, &chord),
        Some(chord) => bindings.keys.get(&chord).is_none_or(|bound| *bound == action),
        None => true,
    };
    let mut keys: Vec<_> = row.keys.iter().filter(is_usual).map(|key| (*key).to_owned()).collect();
    let ending = if row.takes_letter() { ANY_LETTER } else { "" };
    let own = bindings.keys.iter().filter(|(_, bound)| **bound == action).map(|(chord, _)| chord);
    let in_lists = bindings.in_lists.iter().filter(|(_, is_on)| **is_on && row.is_of_lists()).map(|(chord, _)| chord);
    for chord in own.chain(in_lists) {
        let key = format!("{}{ending}", chord.text());
        if !keys.contains(&key) {
            keys.push(key);
        }
    }
    keys
}

/// A hint such as `w why`, or several, with the keys as they are now. A hint whose keys do nothing any more is left out.
pub fn hint(bindings: &Bindings, hint: &str) -> String {
    if bindings.is_empty() {
        return hint.to_owned();
    }
    let gap = if hint.contains(", ") && !hint.contains("  ") { ", " } else { "  " };
    let now = |part: &str| {
        let mut words: Vec<_> = part.split(' ').filter(|word| !word.is_empty()).map(str::to_owned).collect();
        let is_key = |word: &String| row_of(word).is_some();
        let count = words.iter().take_while(|word| is_key(word)).count();
        let said = words.split_off(count);
        let keys = words.iter().filter_map(|key| in_place_of(bindings, key)).collect::<Vec<_>>();
        (count == 0 || !keys.is_empty()).then(|| keys.into_iter().chain(said).collect::<Vec<_>>().join(" "))
    };
    hint.split(gap).filter_map(now).collect::<Vec<_>>().join(gap)
}

/// The row that has a key in the table.
fn row_of(key: &str) -> Option<&'static Row> {
    rows().find(|row| row.keys.contains(&key))
}

/// The key that does now what this one does by the table.
fn in_place_of(bindings: &Bindings, key: &str) -> Option<String> {
    let keys = in_force(bindings, row_of(key)?);
    let same = keys.iter().find(|now| *now == key);
    same.or(keys.first()).cloned()
}

/// Why a key isn't bound.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refused {
    /// No key is spelt so, but perhaps so.
    NoKey(Option<&'static str>),
    /// Lists and lines need it, or counts do.
    Fixed,
    /// A letter follows the action, so only a character can be bound to it.
    NeedsCharacter,
    /// No action is called so.
    NoAction,
    /// It is an action in lists.
    OfLists,
    /// What is wrong with the line.
    Line(String),
}

/// Binds a key to an action by its name, to a line that begins with `:`, or to nothing for `none`; `check` says what is wrong with a line.
///
/// # Errors
/// [`Refused`] says why not.
pub fn bind(
    bindings: &mut Bindings,
    key: &str,
    to: &str,
    check: impl FnOnce(&str) -> Result<(), String>,
) -> Result<Chord, Refused> {
    let chord = spelt(key)?;
    let line = to.strip_prefix(':');
    let bound = match (to, rows().find(|row| row.name() == to)) {
        _ if line.is_some() => {
            let line = line.unwrap_or_default();
            check(line).map_err(Refused::Line)?;
            Bound::Line(line.to_owned())
        }
        (NOTHING, _) => Bound::Nothing,
        (_, None) => return Err(Refused::NoAction),
        (_, Some(row)) if row.is_of_lists() => return Err(Refused::OfLists),
        (_, Some(row)) if row.takes_letter() && (chord.first.is_some() || character(&chord.key).is_none()) => {
            return Err(Refused::NeedsCharacter);
        }
        (_, Some(_)) => Bound::Action(to.to_owned()),
    };
    let usual = usual(&chord).map_or(Bound::Nothing, |row| Bound::Action(row.name()));
    match (bound != usual, is_fixed(&chord)) {
        (true, true) => return Err(Refused::Fixed),
        (true, false) => _ = bindings.keys.insert(chord.clone(), bound),
        (false, _) => {}
    }
    Ok(chord)
}

/// Binds a key in the lists whose entries can be deleted, or takes it from there for `none`.
///
/// # Errors
/// [`Refused`] says why not.
pub fn bind_in_lists(bindings: &mut Bindings, key: &str, to: &str) -> Result<Chord, Refused> {
    let chord = spelt(key)?;
    if chord.first.is_some() || is_fixed(&chord) {
        return Err(Refused::Fixed);
    }
    let deletes = to != NOTHING;
    if deletes && !rows().any(|row| row.is_of_lists() && row.name() == to) {
        return Err(Refused::NoAction);
    }
    if deletes != rows().any(|row| row.is_of_lists() && has(row, &chord)) {
        bindings.in_lists.insert(chord.clone(), deletes);
    }
    Ok(chord)
}

/// What a key is bound to that is to do nothing.
pub const NOTHING: &str = "none";

/// The names of all actions, for lists where these are wanted.
pub fn names(in_lists: bool) -> Vec<String> {
    let own = rows().filter(|row| row.is_of_lists() == in_lists).map(Row::name);
    own.chain([NOTHING.to_owned()]).collect()
}

fn spelt(key: &str) -> Result<Chord, Refused> {
    let near = || suggest(key, NAMES.iter().map(|(name, _)| *name));
    match chord(key) {
        Some(chord) if unknown_name(key).is_none() && !key.chars().any(char::is_control) => Ok(chord),
        _ => Err(Refused::NoKey(near())),
    }
}

/// Whether lists and lines need a key, or counts begin with it.
fn is_fixed(chord: &Chord) -> bool {
    let begins = chord.first.map_or_else(|| chord.key.clone(), String::from);
    let is_digit = begins.len() == 1 && matches!(begins.as_bytes()[0], b'1'..=b'9');
    is_digit
        || (chord.first.is_some() && begins == "0")
        || NOT_SENT.contains(&chord.key.as_str())
        || matches!(chord.key.as_str(), "Esc" | "Enter")
}

/// What terminals send as Tab, Enter and Esc.
const NOT_SENT: [&str; 3] = ["^i", "^m", "^["];

/// Keys of which one is the beginning of the other, so that it never comes to that: the beginning first.
pub fn clashes(bindings: &Bindings) -> Vec<[Chord; 2]> {
    let clash = |pair: Chord| {
        let alone = Chord { first: None, key: pair.first?.to_string() };
        let is_one = match does(bindings, &alone)? {
            Does::Action(_) => true,
            Does::Letter(_) => character(&pair.key).is_some_and(char::is_alphanumeric),
        };
        is_one.then_some([alone, pair])
    };
    pairs(bindings).into_iter().filter_map(clash).collect()
}

/// Whether a key leaves the viewer, or begins a command, which can.
pub fn has_way_out(bindings: &Bindings) -> bool {
    let leaves = |row: &Row| matches!(row.action, Action::Quit | Action::Interrupt | Action::Walk(Walk::Command));
    rows().any(|row| leaves(row) && !in_force(bindings, row).is_empty())
}
