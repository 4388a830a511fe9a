//! `:eval`: an expression over the quantities of the log, with the values that hold at the current step.
//!
//! Its grammar and its arithmetic are those of the formulas of the log.

use super::model::Model;
use super::model::quantity::{self, Part};
use super::text::ascii;
use crate::files::suggest;
use crate::log::formula::{self, Expected, Formula, Wrong};
use crate::log::{Name, Value};
use crate::report::evaluate;
use crate::report::expression::{Expression, Leaf};
use crate::report::notation::{Numbers, Plain, written};
use crate::report::words::plain;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A number or a name that was typed.
#[derive(Clone)]
struct Typed {
    /// Where, in bytes.
    at: usize,
    what: What,
}

#[derive(Clone)]
enum What {
    Constant(f64),
    Quantity { names: Vec<Name>, part: Part },
}

/// The value of a leaf.
type Valued = (usize, Value, bool);

/// Says what an expression comes to here, with the numbers put in.
pub(super) fn answer(model: &mut Model, text: &str) -> Result<(), String> {
    let said = evaluated(model, text)?;
    model.say(&said);
    Ok(())
}

fn evaluated(model: &Model, text: &str) -> Result<String, String> {
    let (valued, value) = computed(model, text)?;
    let (result, with_numbers) = (model.value(&value), in_numbers(model, &valued));
    let is_single = matches!(valued, Formula::Leaf(_));
    let middle = if is_single || !has_names(&valued) { String::new() } else { format!(" = {with_numbers}") };
    Ok(format!("{}{middle} = {result}", plain(text.trim())))
}

/// The formula that somebody typed with the values that hold here, and what it comes to.
fn computed(model: &Model, text: &str) -> Result<(Formula<Valued>, Value), String> {
    let text = text.trim();
    let name = |rest: &str, at: usize| named(model, rest).map(|(what, length)| (Typed { at, what }, length));
    let number = |x: f64, at: usize| Typed { at, what: What::Constant(x) };
    let typed = formula::parse_typed(text, &name, &number, model.language.has_decimal_comma())
        .map_err(|wrong| unreadable(model, text, wrong))?;
    let valued = valued(model, text, &typed)?;
    let value = value_of(model, &valued).ok_or_else(|| impossible(model, text, &valued))?;
    Ok((valued, value))
}

/// What people may type for quantities, the longest first: symbols, symbols in ASCII, keys.
static WORDS: LazyLock<Vec<(String, Vec<Name>)>> = LazyLock::new(|| {
    let mut words: BTreeMap<String, Vec<Name>> = BTreeMap::new();
    for name in Name::all() {
        let in_ascii = Some(ascii(name.symbol())).filter(|text| !text.contains('?') && text != name.symbol());
        for word in [name.symbol().to_owned(), name.key().to_owned()].into_iter().chain(in_ascii) {
            words.entry(word).or_default().push(name);
        }
    }
    let mut words: Vec<_> = words.into_iter().collect();
    words.sort_by_key(|(word, _)| std::cmp::Reverse(word.len()));
    words
});

/// The name that a text begins with, and its length in bytes: the longest that has a value here, so that `N·L` is a product where
/// it isn't computed yet; else the longest.
fn named(model: &Model, text: &str) -> Option<(What, usize)> {
    if let Some(sign) = ["pi", "π"].into_iter().find(|sign| begins_with(text, sign)) {
        return Some((What::Constant(std::f64::consts::PI), sign.len()));
    }
    let begun = || WORDS.iter().filter(|(word, _)| begins_with(text, word));
    let (word, names) = begun().find(|(_, names)| model.here(names).is_some()).or_else(|| begun().next())?;
    let part = text[word.len()..].strip_prefix('.').and_then(|rest| quantity::component(rest.get(..1)?));
    let (part, length) = match part {
        Some(index) => (Part::Component(index), word.len() + 2),
        None => (Part::Whole, word.len()),
    };
    Some((What::Quantity { names: names.clone(), part }, length))
}

/// Whether a text begins with a word that ends there; behind it may be a component.
fn begins_with(text: &str, word: &str) -> bool {
    let Some(rest) = text.strip_prefix(word) else { return false };
    let mut next = rest.chars();
    let is_word = word.ends_with(is_of_name);
    match next.next() {
        Some('.') if is_word => {
            let letter =
                next.next().is_some_and(|letter| quantity::component(letter.encode_utf8(&mut [0; 4])).is_some());
            letter && next.next().is_none_or(|behind| !is_of_name(behind) && behind != '.')
        }
        Some(next) => !(is_word && is_of_name(next)),
        None => true,
    }
}

/// Whether a character goes on with a name.
fn is_of_name(c: char) -> bool {
    c.is_alphabetic() || c.is_ascii_digit() || matches!(c, '_' | '′' | '\'')
}

/// The formula with the values that hold here, or what has none.
fn valued(model: &Model, text: &str, formula: &Formula<Typed>) -> Result<Formula<Valued>, String> {
    Ok(match formula {
        Formula::Number(x) => Formula::Number(*x),
        Formula::Leaf(Typed { at, what: What::Constant(x) }) => Formula::Leaf((*at, Value::Number(*x), false)),
        Formula::Leaf(Typed { at, what: What::Quantity { names, part } }) => {
            let value = looked_up(model, names, *part).map_err(|why| placed(model, text, *at, &why))?;
            Formula::Leaf((*at, value, true))
        }
        Formula::Triple(parts) => {
            let [x, y, z] = parts.each_ref().map(|part| valued(model, text, part));
            Formula::Triple(Box::new([x?, y?, z?]))
        }
        Formula::Unary(unary, inner) => Formula::unary(*unary, valued(model, text, inner)?),
        Formula::Binary(operator, left, right) => {
            Formula::binary(*operator, valued(model, text, left)?, valued(model, text, right)?)
        }
    })
}

fn looked_up(model: &Model, names: &[Name], part: Part) -> Result<Value, String> {
    let texts = &model.texts().eval;
    let first = *names.first().ok_or(texts.too_long)?;
    if model.understanding.quiz.is_some() {
        // A formula of names would tell what the quiz asks for.
        return Err(texts.only_numbers.to_owned());
    }
    let Some(found) = model.here(names) else {
        let node = model.tree.owner(model.event);
        let has_it =
            |event: &usize| quantity::value_at(&model.log.events, *event, |name| names.contains(&name)).is_some();
        let later = model.tree.own_events_from(node, model.event + 1).find(has_it);
        return Err(match later.filter(|_| model.told().is_none()) {
            Some(event) => (texts.not_yet)(first.symbol(), event + 1),
            None => (texts.not_known)(first.symbol(), &known(model).join(", ")),
        });
    };
    match part {
        Part::Whole => Ok(found.value),
        part => part
            .of(&found.value)
            .map(Value::Number)
            .ok_or_else(|| (model.texts().breakpoints.no_components)(first.symbol())),
    }
}

/// The symbols that have a value here, the latest first; some of them, if there are many.
fn known(model: &Model) -> Vec<&'static str> {
    const MOST: usize = 12;
    const MOST_EVENTS: usize = 64;
    let mut found: Vec<&'static str> = Vec::new();
    let mut before = model.event + 1;
    for node in model.tree.around(model.tree.owner(model.event)) {
        for event in model.tree.own_events_before(node, before).rev().take(MOST_EVENTS) {
            let happening = &model.log.events[event];
            let noted = happening.noted().filter(|_| !model.hides(event)).map(|(name, _)| name);
            let given = model.log.given(event).iter().map(|(name, _)| *name);
            for symbol in noted.into_iter().chain(given).map(Name::symbol) {
                if !found.contains(&symbol) && found.len() < MOST {
                    found.push(symbol);
                }
            }
        }
        before = model.tree.nodes()[node].events.start;
        if found.len() == MOST {
            break;
        }
    }
    found
}

/// What a formula comes to, if its operands are such that it can be computed.
fn value_of(model: &Model, formula: &Formula<Valued>) -> Option<Value> {
    let constant = with_leaves(formula, &|(_, value, _)| match value {
        Value::Number(x) => Formula::Number(*x),
        Value::Triple(xyz) => Formula::Triple(Box::new(xyz.map(Formula::Number))),
    });
    evaluate::evaluate_with(&model.log, &model.tree, model.event, &constant, &|_, _| None).ok()
}

/// A formula in numbers.
fn in_numbers(model: &Model, formula: &Formula<Valued>) -> String {
    let expression: Expression = with_leaves(formula, &|(_, value, is_name)| match value {
        Value::Number(x) if !is_name => Formula::Number(*x),
        value => Formula::Leaf(Leaf::Value(*value, None)),
    });
    written::<Plain>(Numbers { language: model.language, style: model.numbers }, &expression)
}

/// The same formula with something else in place of its leaves.
fn with_leaves<A, B>(formula: &Formula<A>, leaf: &impl Fn(&A) -> Formula<B>) -> Formula<B> {
    match formula {
        Formula::Number(x) => Formula::Number(*x),
        Formula::Leaf(own) => leaf(own),
        Formula::Triple(parts) => Formula::Triple(Box::new(parts.each_ref().map(|part| with_leaves(part, leaf)))),
        Formula::Unary(unary, inner) => Formula::unary(*unary, with_leaves(inner, leaf)),
        Formula::Binary(operator, left, right) => {
            Formula::binary(*operator, with_leaves(left, leaf), with_leaves(right, leaf))
        }
    }
}

fn has_names(formula: &Formula<Valued>) -> bool {
    match formula {
        Formula::Number(_) => false,
        Formula::Leaf((_, _, is_name)) => *is_name,
        Formula::Triple(parts) => parts.iter().any(has_names),
        Formula::Unary(_, inner) => has_names(inner),
        Formula::Binary(_, left, right) => has_names(left) || has_names(right),
    }
}

/// Where a formula begins in the text, in bytes.
fn begins_at(formula: &Formula<Valued>) -> usize {
    match formula {
        Formula::Number(_) => 0,
        Formula::Leaf((at, ..)) => *at,
        Formula::Triple(parts) => begins_at(&parts[0]),
        Formula::Unary(_, inner) | Formula::Binary(_, inner, _) => begins_at(inner),
    }
}

/// What to say of the innermost operation that can't be done.
fn impossible(model: &Model, text: &str, formula: &Formula<Valued>) -> String {
    let parts: Vec<&Formula<Valued>> = match formula {
        Formula::Number(_) | Formula::Leaf(_) => Vec::new(),
        Formula::Triple(parts) => parts.iter().collect(),
        Formula::Unary(_, inner) => vec![inner],
        Formula::Binary(_, left, right) => vec![left, right],
    };
    match parts.into_iter().find(|part| value_of(model, part).is_none()) {
        Some(part) => impossible(model, text, part),
        None => {
            let why = (model.texts().eval.impossible)(&in_numbers(model, formula));
            placed(model, text, begins_at(formula), &why)
        }
    }
}

/// What to say of a text that is no expression.
fn unreadable(model: &Model, text: &str, wrong: Wrong) -> String {
    let texts = &model.texts().eval;
    let rest = text.get(wrong.at..).unwrap_or_default().trim_start();
    let found = if rest.is_empty() { String::new() } else { (texts.found)(&plain(rest)) };
    let why = match wrong.expected {
        Expected::Operand if rest.starts_with(char::is_alphabetic) => unknown(model, rest),
        Expected::Operand => (texts.expected_operand)(&found),
        Expected::Sign(sign) => (texts.expected_sign)(sign, &found),
        Expected::End => (texts.expected_end)(&found),
        Expected::Less => return texts.too_long.to_owned(),
    };
    placed(model, text, text.len() - rest.len(), &why)
}

/// What to say of a text that begins with an unknown name.
fn unknown(model: &Model, text: &str) -> String {
    let texts = &model.texts().eval;
    let end = text.find(|c: char| !is_of_name(c) && !matches!(c, '.' | '·')).unwrap_or(text.len());
    let (name, rest) = text.split_at(end);
    let is_called = rest.trim_start().starts_with('(');
    let near = match is_called {
        true => suggest(name, formula::typed_functions()),
        // What is known here is likelier.
        false => suggest(name, known(model)).or_else(|| suggest(name, quantity::words().chain(["pi"]))),
    };
    match near {
        Some(near) => (texts.name_like)(&plain(name), near),
        None if is_called => (texts.no_name)(&plain(name), &formula::typed_functions().collect::<Vec<_>>().join(", ")),
        None => (texts.no_name)(&plain(name), &known(model).join(", ")),
    }
}

/// What is wrong, with the column where it is.
fn placed(model: &Model, text: &str, at: usize, why: &str) -> String {
    let column = text.get(..at).map_or(0, |before| before.chars().count()) + 1;
    (model.texts().eval.at)(column, why)
}

/// How an expression may go on: with the symbols and keys of what is known here, and with functions.
pub(super) fn completions(model: &Model, text: &str) -> Vec<String> {
    let begin = text
        .rfind(|c: char| !is_of_name(c) && c != '.')
        .map_or(0, |at| at + text[at..].chars().next().map_or(1, char::len_utf8));
    let (before, word) = text.split_at(begin);
    if word.is_empty() {
        return Vec::new();
    }
    let is_known = |(_, names): &&(String, Vec<Name>)| model.here(names).is_some();
    let names = WORDS.iter().filter(|(name, _)| name.starts_with(word)).filter(is_known).map(|(name, _)| name.clone());
    let functions = formula::typed_functions().filter(|name| name.starts_with(word)).map(|name| format!("{name}("));
    let mut ways: Vec<_> = names.chain(functions).map(|way| format!("{before}{way}")).collect();
    ways.sort();
    ways.dedup();
    ways
}

#[cfg(test)]
mod tests;
