//! The terms of breakpoints as they are typed: `hit`, `kind shadow`, `object sphere`, `light lamp`, `depth 2`, `T2_A ~ 0`,
//! `ray.direction.y < -0.5`, `|ray.direction| > 1`, `N·L is nan`. An error says what was expected, or what may have been meant.

use super::condition::{Class, Condition, Operator, Quantity, Test};
use super::kind;
use crate::files::suggest;
use crate::log::{Log, Name, Value, What};
use crate::report::language::viewer::Breakpoints;
use crate::report::words::plain;
use crate::tui::model::quantity::{self, Part};

/// The operators, those that begin like another one before it.
const OPERATORS: &[(&str, Operator)] = &[
    ("<=", Operator::AtMost),
    (">=", Operator::AtLeast),
    ("!=", Operator::Unequal),
    ("==", Operator::Equal),
    ("≤", Operator::AtMost),
    ("≥", Operator::AtLeast),
    ("≠", Operator::Unequal),
    ("≈", Operator::Near),
    ("<", Operator::Below),
    (">", Operator::Above),
    ("=", Operator::Equal),
    ("~", Operator::Near),
];

/// The word before what a value is, and the one that negates it.
const IS: &str = "is";
const NOT: &str = "not";

/// What a value may be that isn't compared.
const CLASSES: [&str; 3] = ["nan", "infinite", "finite"];

/// The tests of a quantity that are no comparisons.
pub fn tests(key: &str) -> impl Iterator<Item = String> {
    CLASSES.into_iter().flat_map(move |class| [format!("{key} {IS} {class}"), format!("{key} {IS} {NOT} {class}")])
}

/// Whether a term begins with a word behind which a name goes on to its end.
pub fn named_by(text: &str) -> bool {
    let first = text.split_whitespace().next().unwrap_or_default();
    ["object", "light"].iter().any(|word| first.eq_ignore_ascii_case(word))
}

/// The condition that a term stands for.
pub fn parse(text: &str, log: &Log, texts: &Breakpoints) -> Result<Condition, String> {
    let text = text.trim();
    if let Some(kind) = kind::find(text) {
        return Ok(Condition::Kind(kind));
    }
    let (first, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let rest = rest.trim();
    let is_depth = |before: &str| before.eq_ignore_ascii_case("depth");
    if let Some((_, sign, level)) = operator(text).filter(|(before, ..)| is_depth(before)) {
        return depth(sign, level, texts);
    }
    let begins_name = !rest.is_empty() && operator(rest).is_none_or(|(before, ..)| !before.is_empty());
    match first.to_lowercase().as_str() {
        "" => Err(texts.expected.to_owned()),
        "kind" => kind_of(rest, texts),
        "object" if begins_name || rest.is_empty() => {
            let unknown = Unknown { none: texts.no_objects, like: texts.object_like, others: texts.other_objects };
            named(&log.header.objects, rest, &unknown).map(Condition::Object)
        }
        "light" if begins_name => {
            let unknown = Unknown { none: texts.no_lights, like: texts.light_like, others: texts.other_lights };
            named(&log.header.lights, rest, &unknown).map(Condition::Light)
        }
        "depth" if operator(rest).is_none() => depth(Operator::Equal, rest, texts),
        _ => quantity(text, log, texts).map(Condition::Quantity),
    }
}

/// The words that a breakpoint may begin with: for completion.
pub fn words(log: &Log) -> Vec<String> {
    let mut words: Vec<String> = ["kind ", "depth "].map(str::to_owned).to_vec();
    words.extend(kind::WORDS.iter().map(|word| (*word).to_owned()));
    words.extend(kind::WORDS.iter().map(|word| format!("kind {word}")));
    words.extend(log.header.objects.iter().map(|name| format!("object {name}")));
    words.extend(log.header.lights.iter().map(|name| format!("light {name}")));
    words.extend(Name::all().map(|name| name.key().to_owned()));
    words
}

fn kind_of(word: &str, texts: &Breakpoints) -> Result<Condition, String> {
    kind::find(word).map(Condition::Kind).ok_or_else(|| match suggest(word, kind::WORDS.iter().copied()) {
        Some(near) => (texts.kind_like)(&plain(word), near),
        None => texts.expected_kind.to_owned(),
    })
}

/// What to say where a log has no object, or no light, of a name.
struct Unknown {
    none: &'static str,
    like: fn(&str, &str) -> String,
    others: fn(&str, &str, usize) -> String,
}

/// The numbers of the objects or lights with a name.
fn named(names: &[String], name: &str, unknown: &Unknown) -> Result<Vec<u32>, String> {
    // Quotes may be part of the name.
    let name = if names.iter().any(|known| known == name) { name } else { name.trim_matches('"') };
    let numbers = |is: &dyn Fn(&str) -> bool| -> Vec<u32> {
        (0..).zip(names).filter(|(_, known)| is(known)).map(|(number, _)| number).collect()
    };
    let exact = numbers(&|known| known == name);
    let found = if exact.is_empty() { numbers(&|known| known.eq_ignore_ascii_case(name)) } else { exact };
    if !found.is_empty() {
        return Ok(found);
    }
    let all = names.iter().map(String::as_str);
    Err(match suggest(name, all.clone()) {
        Some(near) => (unknown.like)(&plain(name), &plain(near)),
        None if names.is_empty() => unknown.none.to_owned(),
        None => {
            const SOME: usize = 5;
            let some: Vec<_> = all.take(SOME).map(plain).collect();
            (unknown.others)(&plain(name), &some.join(", "), names.len().saturating_sub(SOME))
        }
    })
}

fn depth(operator: Operator, text: &str, texts: &Breakpoints) -> Result<Condition, String> {
    let depth = text.parse().map_err(|_| texts.expected_depth.to_owned())?;
    Ok(Condition::Depth(operator, depth))
}

fn quantity(text: &str, log: &Log, texts: &Breakpoints) -> Result<Quantity, String> {
    let (operand, test) = match (operator(text), class(text)) {
        (Some((before, operator, after)), _) => (before, Some(Test::Compared(operator, number(after, texts)?))),
        (None, Some((before, class))) => (before, Some(class_of(class, texts)?)),
        (None, None) => (text, None),
    };
    let (names, part) = operand_of(operand, texts)?;
    let value = log.events.iter().find_map(|event| match &event.what {
        What::Note { name, value } if names.contains(name) => Some(value),
        _ => None,
    });
    let is_compared = matches!(test, Some(Test::Compared(..))) || part != Part::Whole;
    if let Some(value) = value.filter(|value| is_compared && test.is_some() && part.of(value).is_none()) {
        return Err(match value {
            Value::Number(_) => (texts.no_components)(names[0].symbol()),
            Value::Triple(_) => (texts.three_numbers)(names[0].key()),
        });
    }
    Ok(Quantity { names, part, test })
}

/// The text before the word `is`, and the text behind it.
fn class(text: &str) -> Option<(&str, &str)> {
    let mut words = text.char_indices().filter(|(_, character)| character.is_whitespace());
    words.find_map(|(at, _)| {
        let (before, rest) = (&text[..at], text[at..].trim_start());
        let (word, class) = rest.split_once(char::is_whitespace).unwrap_or((rest, ""));
        word.eq_ignore_ascii_case(IS).then(|| (before.trim(), class.trim()))
    })
}

/// What a value must be by the words behind `is`.
fn class_of(text: &str, texts: &Breakpoints) -> Result<Test, String> {
    let text = text.to_lowercase();
    let mut words: Vec<&str> = text.split_whitespace().collect();
    let is_negated = words.first() == Some(&NOT);
    if is_negated {
        words.remove(0);
    }
    let class = match words[..] {
        ["nan"] => Class::Nan,
        ["infinite" | "inf"] => Class::Infinite,
        ["finite"] => Class::Finite,
        _ => return Err((texts.expected_class)(&plain(&text), suggest(&words.join(" "), CLASSES).unwrap_or_default())),
    };
    Ok(Test::Is { class, is_negated })
}

/// The text before the first operator, that, and the text after it.
fn operator(text: &str) -> Option<(&str, Operator, &str)> {
    text.char_indices().find_map(|(at, _)| {
        let (sign, operator) = OPERATORS.iter().find(|(sign, _)| text[at..].starts_with(sign))?;
        Some((text[..at].trim(), *operator, text[at + sign.len()..].trim()))
    })
}

/// A number, with a decimal point or a decimal comma.
fn number(text: &str, texts: &Breakpoints) -> Result<f64, String> {
    let number = text.replace('−', "-").replace(',', ".").parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| (texts.expected_number)(&plain(text)))
}

/// The quantities that a text names, and which number of them.
fn operand_of(text: &str, texts: &Breakpoints) -> Result<(Vec<Name>, Part), String> {
    if let Some(found) = quantity::named(text) {
        return Ok(found);
    }
    let known = quantity::words().chain(kind::WORDS.iter().copied());
    // A kind of event has no value to compare.
    let known = known.filter(|word| *word != text);
    Err(match suggest(text, known) {
        Some(near) => (texts.name_like)(&plain(text), near),
        None => (texts.no_name)(&plain(text)),
    })
}
