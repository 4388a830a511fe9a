//! Breakpoints as they are typed: `hit`, `kind shadow`, `object sphere`, `light lamp`, `depth 2`, `T2_A ~ 0`,
//! `ray.direction.y < -0.5`, `|ray.direction| > 1`. An error says what was expected, or what may have been meant.

use super::condition::{Condition, Operator, Part, Quantity};
use super::kind;
use crate::log::{Log, Name, Value, What};
use crate::report::words::plain;
use crate::tui::suggest::nearest;
use crate::tui::view::ascii;

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

/// The condition that a text stands for, in a log that has these objects, lights and quantities.
pub fn parse(text: &str, log: &Log) -> Result<Condition, String> {
    let text = text.trim();
    if let Some(kind) = kind::find(text) {
        return Ok(Condition::Kind(kind));
    }
    let (first, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    let rest = rest.trim();
    let begins_name = !rest.is_empty() && operator(rest).is_none_or(|(before, ..)| !before.is_empty());
    match first.to_lowercase().as_str() {
        "" => Err("expected a breakpoint: hit, shadow, object NAME, light NAME, depth 2 or T2_A < 0".to_owned()),
        "kind" => kind_of(rest),
        "object" if begins_name || rest.is_empty() => named("object", &log.header.objects, rest).map(Condition::Object),
        "light" if begins_name => named("light", &log.header.lights, rest).map(Condition::Light),
        "depth"
            if operator(rest).is_none_or(|(before, operator, _)| before.is_empty() && operator == Operator::Equal) =>
        {
            depth(rest)
        }
        _ => quantity(text, log).map(Condition::Quantity),
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

fn kind_of(word: &str) -> Result<Condition, String> {
    kind::find(word).map(Condition::Kind).ok_or_else(|| match nearest(word, kind::WORDS.iter().copied()) {
        Some(near) => format!("no kind of event is called `{}`; did you mean `{near}`?", plain(word)),
        None => "expected a kind of event such as shadow, hit, occluded or total-internal-reflection".to_owned(),
    })
}

/// The numbers of the objects or lights with a name.
fn named(what: &str, names: &[String], name: &str) -> Result<Vec<u32>, String> {
    let name = name.trim_matches('"');
    let numbers = |is: &dyn Fn(&str) -> bool| -> Vec<u32> {
        (0..).zip(names).filter(|(_, known)| is(known)).map(|(number, _)| number).collect()
    };
    let exact = numbers(&|known| known == name);
    let found = if exact.is_empty() { numbers(&|known| known.eq_ignore_ascii_case(name)) } else { exact };
    if !found.is_empty() {
        return Ok(found);
    }
    let all = names.iter().map(String::as_str);
    Err(match nearest(name, all.clone()) {
        Some(near) => format!("there is no {what} `{}`; did you mean `{}`?", plain(name), plain(near)),
        None if names.is_empty() => format!("there is no {what} in this log"),
        None => {
            const SOME: usize = 5;
            let some: Vec<_> = all.take(SOME).map(plain).collect();
            let more = names.len().saturating_sub(SOME);
            let more = if more == 0 { String::new() } else { format!(" and {more} more") };
            format!("there is no {what} `{}`, but {}{more}", plain(name), some.join(", "))
        }
    })
}

fn depth(text: &str) -> Result<Condition, String> {
    let number = text.trim_start_matches('=').trim();
    let depth = number.parse().map_err(|_| "expected a level of the ray tree, such as depth 2".to_owned())?;
    Ok(Condition::Depth(depth))
}

fn quantity(text: &str, log: &Log) -> Result<Quantity, String> {
    let (operand, test) = match operator(text) {
        None => (text, None),
        Some((before, operator, after)) => (before, Some((operator, number(after)?))),
    };
    let (names, part) = operand_of(operand)?;
    let value = log.events.iter().find_map(|event| match &event.what {
        What::Note { name, value } if names.contains(name) => Some(value),
        _ => None,
    });
    if let Some(value) = value.filter(|value| test.is_some() && part.of(value).is_none()) {
        return Err(match value {
            Value::Number(_) => format!("{} is a number and has no components", names[0].symbol()),
            Value::Triple(_) => {
                let key = names[0].key();
                format!("{key} has three numbers: compare {key}.x, .y or .z (.r, .g or .b), or the length |{key}|")
            }
        });
    }
    Ok(Quantity { names, part, test })
}

/// The text before the first operator, that, and the text after it.
fn operator(text: &str) -> Option<(&str, Operator, &str)> {
    text.char_indices().find_map(|(at, _)| {
        let (sign, operator) = OPERATORS.iter().find(|(sign, _)| text[at..].starts_with(sign))?;
        Some((text[..at].trim(), *operator, text[at + sign.len()..].trim()))
    })
}

fn number(text: &str) -> Result<f64, String> {
    let number = text.replace('−', "-").parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| format!("expected a number such as 0 or -1.5e-3, not `{}`", plain(text)))
}

/// The quantities that a text names, and which number of them.
fn operand_of(text: &str) -> Result<(Vec<Name>, Part), String> {
    let whole = called(text);
    if !whole.is_empty() {
        return Ok((whole, Part::Whole));
    }
    if let Some(inner) = text.strip_prefix('|').and_then(|text| text.strip_suffix('|')) {
        return operand_of(inner.trim()).map(|(names, _)| (names, Part::Length));
    }
    if let Some((before, letter)) = text.rsplit_once('.')
        && let Some(component) = ["xr", "yg", "zb"].iter().position(|both| letter.len() == 1 && both.contains(letter))
    {
        let names = called(before);
        if !names.is_empty() {
            return Ok((names, Part::Component(component)));
        }
    }
    let known = Name::all().flat_map(|name| [name.key(), name.symbol()]).chain(kind::WORDS.iter().copied());
    // A kind of event has no value to compare.
    let known = known.filter(|word| *word != text);
    Err(match nearest(text, known) {
        Some(near) => format!("nothing is called `{}`; did you mean `{near}`?", plain(text)),
        None => format!(
            "nothing is called `{}`: expected a kind of event (hit), object NAME, light NAME, depth 2 or a quantity (T2_A < 0)",
            plain(text)
        ),
    })
}

/// The quantities with this key or symbol; symbols also as they are written in ASCII.
fn called(text: &str) -> Vec<Name> {
    let bare: String = text.chars().filter(|c| *c != ' ').collect();
    let is_called = |name: &Name| name.key() == bare || name.symbol() == bare || ascii(name.symbol()) == bare;
    Name::all().filter(is_called).collect()
}
