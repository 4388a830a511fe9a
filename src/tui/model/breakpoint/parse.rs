//! Conditions of several terms: `N·L < 0.2 and depth >= 2`, `(hit or miss) and object sphere`. `and` binds tighter than `or`.

use super::condition::Condition;
use super::term;
use crate::log::{Log, Name};
use crate::report::language::viewer::Breakpoints;
use crate::report::words::plain;

/// The most parentheses inside each other.
const DEEPEST: usize = 32;

/// The most terms, and the most characters of a condition. Whether a name goes on behind an `and` is asked of every later one.
const MOST_TERMS: usize = 64;
const LONGEST: usize = 4096;

/// What joins two terms.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Joint {
    And,
    Or,
}

/// A term as it is typed, and what joins it to the one before.
struct Piece<'t> {
    joint: Joint,
    /// Where it begins and ends in the text.
    begin: usize,
    end: usize,
    text: &'t str,
}

/// The condition that a text stands for, in a log that has these objects, lights and quantities.
pub fn parse(text: &str, log: &Log, texts: &Breakpoints) -> Result<Condition, String> {
    if text.len() > LONGEST {
        return Err((texts.too_long)(MOST_TERMS, LONGEST));
    }
    nested(text, log, texts, DEEPEST)
}

fn nested(text: &str, log: &Log, texts: &Breakpoints, room: usize) -> Result<Condition, String> {
    let text = text.trim();
    let pieces = pieces(text);
    if pieces.len() > MOST_TERMS {
        return Err((texts.too_long)(MOST_TERMS, LONGEST));
    }
    let mut alternatives = Vec::new();
    let mut all = Vec::new();
    let mut at = 0;
    while at < pieces.len() {
        if at > 0 && pieces[at].joint == Joint::Or {
            alternatives.push(joined(std::mem::take(&mut all), Condition::All));
        }
        // A name may have such a word in it: the longest that is one counts.
        let longest = (at + 1..pieces.len()).rev().find_map(|last| {
            let whole = &text[pieces[at].begin..pieces[last].end];
            let named = term::named_by(whole).then(|| term::parse(whole, log, texts).ok())??;
            Some((named, last))
        });
        let (condition, last) = match longest {
            Some(found) => found,
            None => (one(pieces[at].text, log, texts, room, pieces.len() > 1)?, at),
        };
        all.push(condition);
        at = last + 1;
    }
    alternatives.push(joined(all, Condition::All));
    Ok(joined(alternatives, Condition::Any))
}

/// A term, or what is in parentheses.
fn one(text: &str, log: &Log, texts: &Breakpoints, room: usize, is_joined: bool) -> Result<Condition, String> {
    match text.strip_prefix('(').map(|rest| (rest, rest.strip_suffix(')'))) {
        Some(_) if room == 0 => Err(texts.too_nested.to_owned()),
        Some((_, Some(inside))) => nested(inside, log, texts, room - 1),
        Some((rest, None)) => Err((texts.not_closed)(&plain(rest))),
        None if text.is_empty() && is_joined => Err(texts.nothing_joined.to_owned()),
        None => term::parse(text, log, texts),
    }
}

/// Several conditions as one; one is itself.
fn joined(mut conditions: Vec<Condition>, several: fn(Vec<Condition>) -> Condition) -> Condition {
    match conditions.len() {
        1 => conditions.remove(0),
        _ => several(conditions),
    }
}

/// The terms between `and` and `or`, but for those in quotes and parentheses.
fn pieces(text: &str) -> Vec<Piece<'_>> {
    let mut pieces = Vec::new();
    let (mut depth, mut is_quoted) = (0_usize, false);
    let (mut begin, mut joint) = (0, Joint::And);
    let mut is_after_gap = true;
    for (at, character) in text.char_indices() {
        match character {
            '"' => is_quoted = !is_quoted,
            '(' if !is_quoted => depth += 1,
            ')' if !is_quoted => depth = depth.saturating_sub(1),
            _ if is_quoted || depth > 0 || !is_after_gap || at < begin => {}
            _ => {
                if let Some((next, length)) = joint_at(&text[at..]) {
                    pieces.push(piece(text, joint, begin, at));
                    (joint, begin) = (next, at + length);
                }
            }
        }
        is_after_gap = character.is_whitespace() || character == ')' || character == '"';
    }
    pieces.push(piece(text, joint, begin, text.len()));
    pieces
}

fn piece(text: &str, joint: Joint, begin: usize, end: usize) -> Piece<'_> {
    Piece { joint, begin, end, text: text[begin..end].trim() }
}

/// The joint that a text begins with, and how long it is; behind it something else begins.
fn joint_at(text: &str) -> Option<(Joint, usize)> {
    let joints = [("and", Joint::And), ("or", Joint::Or)];
    joints.into_iter().find_map(|(word, joint)| {
        let (begin, rest) = text.split_at_checked(word.len())?;
        let is_word = rest.chars().next().is_none_or(|next| next.is_whitespace() || next == '(' || next == '"');
        (begin.eq_ignore_ascii_case(word) && is_word).then_some((joint, word.len()))
    })
}

/// How a typed condition may go on: its last term by a word, behind a quantity a test that is no comparison.
pub fn completions(log: &Log, text: &str) -> Vec<String> {
    let last = pieces(text).pop().map_or(0, |piece| piece.begin);
    let begins_at = text[last..].find(|c: char| !c.is_whitespace() && c != '(').map_or(text.len(), |at| last + at);
    let (before, term) = text.split_at(begins_at);
    let tests = term.split_once(char::is_whitespace).filter(|(key, _)| Name::with_key(key).is_some());
    let tests = tests.into_iter().flat_map(|(key, _)| term::tests(key));
    let words = term::words(log).into_iter().chain(tests);
    words.filter(|word| word.starts_with(term)).map(|word| format!("{before}{word}")).collect()
}
