//! One computed value as the source text writes it: symbol, formula, the numbers put in, the result.

use super::{Style, number};
use crate::log::formula::{self, Extreme, Formula, Operator};
use crate::log::{Log, Tree, Value, What, scope};

/// A computed value, ready to be shown as `symbol = formula = substituted = result`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Computation {
    /// The symbol of the quantity, such as `T2_A`.
    pub symbol: String,
    /// Its formula, such as `r² − L2oc + T_A²`, unless it only repeats the symbol or there is none.
    pub formula: Option<String>,
    /// The formula with the numbers put in, such as `9 − 178.024 + 13.244²`, unless it only repeats the result.
    pub substituted: Option<String>,
    /// The value, such as `6.380`.
    pub result: String,
}

impl Computation {
    /// The whole chain in one line.
    pub fn line(&self) -> String {
        let parts = [Some(&self.symbol), self.formula.as_ref(), self.substituted.as_ref(), Some(&self.result)];
        parts.into_iter().flatten().map(String::as_str).collect::<Vec<_>>().join(" = ")
    }
}

/// The computation of the quantity that `event` notes; `None` for other events.
pub fn computation(log: &Log, tree: &Tree, event: usize, style: Style) -> Option<Computation> {
    let What::Note { name, value } = log.events[event].what else { return None };
    let result = number::value(&value, style);
    let formula = name.formula().filter(|text| without_spaces(text) != name.symbol()).map(str::to_owned);
    let substitution = Substitution { log, tree, event, light: None, style };
    let substituted = formula::of(name).and_then(|formula| substitution.text(formula).shown());
    let substituted = substituted.filter(|text| *text != result);
    Some(Computation { symbol: name.symbol().to_owned(), formula, substituted, result })
}

fn without_spaces(text: &str) -> String {
    text.chars().filter(|c| *c != ' ').collect()
}

/// Puts numbers into the formula of one event.
#[derive(Clone, Copy)]
struct Substitution<'a> {
    log: &'a Log,
    tree: &'a Tree,
    event: usize,
    /// The light whose part of a sum is written.
    light: Option<usize>,
    style: Style,
}

/// A part of a formula with its numbers.
enum Part {
    /// Text; whether it begins with a minus sign.
    Text(String, bool),
    /// An absent factor: it changes nothing.
    One,
    /// An absent term: what it multiplies is left out.
    Zero,
}

impl Part {
    fn shown(self) -> Option<String> {
        match self {
            Part::Text(text, _) => Some(text),
            Part::One => None,
            Part::Zero => Some("0".to_owned()),
        }
    }

    /// The text of an operand that stands behind an operator.
    fn behind_operator(self) -> Option<String> {
        match self {
            Part::Text(text, true) => Some(format!("({text})")),
            Part::Text(text, false) => Some(text),
            _ => None,
        }
    }
}

impl Substitution<'_> {
    fn text(&self, formula: &Formula) -> Part {
        let plain = |text: String| Part::Text(text, false);
        match formula {
            Formula::Number(x) => plain(number::number(*x, self.style)),
            Formula::Symbol(symbol) => self.symbol(symbol),
            Formula::Negated(inner) => match self.text(inner).behind_operator() {
                Some(text) => Part::Text(format!("−{text}"), true),
                None => Part::Zero,
            },
            Formula::Root(inner) => self.wrapped(inner, "√", ""),
            Formula::Squared(inner) => self.wrapped(inner, "", "²"),
            Formula::Length(inner) => self.text(inner).shown().map_or(Part::Zero, |text| plain(format!("|{text}|"))),
            Formula::Floor(inner) => self.text(inner).shown().map_or(Part::Zero, |text| plain(format!("⌊{text}⌋"))),
            Formula::Positive(inner) => self.positive(inner),
            Formula::Grouped(inner) => match (self.text(inner), &**inner) {
                // A number needs no parentheses of its own.
                (text, Formula::Symbol(_) | Formula::Positive(_)) => text,
                (Part::Text(text, _), _) => plain(format!("({text})")),
                (absent, _) => absent,
            },
            Formula::Extreme(extreme, first, second) => match (self.text(first).shown(), self.text(second).shown()) {
                (Some(first), Some(second)) => plain(format!("{}({first}, {second})", word(*extreme))),
                _ => Part::Zero,
            },
            Formula::ExtremeComponent(extreme, inner) => {
                self.text(inner).shown().map_or(Part::Zero, |text| plain(format!("{}({text})", word(*extreme))))
            }
            Formula::OverLights(inner) => self.over_lights(inner),
            Formula::Binary(operator, left, right) => self.binary(*operator, left, right),
        }
    }

    fn symbol(&self, symbol: &str) -> Part {
        let operand = match self.light {
            Some(light) => scope::operand_of_light(&self.log.events, self.tree, light, symbol),
            None => scope::operand(&self.log.events, self.tree, self.event, symbol),
        };
        match operand {
            Some(operand) => {
                let text = number::value(&operand.value, self.style);
                let is_negative = text.starts_with('-');
                Part::Text(text, is_negative)
            }
            None if scope::is_one_when_absent(symbol) => Part::One,
            None => Part::Zero,
        }
    }

    fn wrapped(&self, inner: &Formula, before: &str, after: &str) -> Part {
        match self.text(inner).behind_operator() {
            Some(text) => Part::Text(format!("{before}{text}{after}"), false),
            None => Part::Zero,
        }
    }

    /// `x⁺` as the number that it is.
    fn positive(&self, inner: &Formula) -> Part {
        match self.text(inner) {
            Part::Text(text, true) if text.starts_with('-') => Part::Zero,
            Part::Text(text, _) if text == "0" => Part::Zero,
            // Only rounding takes a cosine past 1.
            Part::Text(text, _) if text.parse::<f64>().is_ok_and(|x| x > 1.0) => Part::Text("1".to_owned(), false),
            part => part,
        }
    }

    fn over_lights(&self, inner: &Formula) -> Part {
        let parts = scope::lights(self.tree, self.event)
            .filter(|light| !self.is_dark(*light))
            .filter_map(|light| Substitution { light: Some(light), ..*self }.text(inner).behind_operator());
        match parts.collect::<Vec<_>>() {
            parts if parts.is_empty() => Part::Zero,
            parts => Part::Text(parts.join(" + "), false),
        }
    }

    fn is_dark(&self, light: usize) -> bool {
        let passed = scope::operand_of_light(&self.log.events, self.tree, light, "τ");
        passed.is_some_and(|operand| operand.value == Value::Triple([0.0; 3]))
    }

    fn binary(&self, operator: Operator, left: &Formula, right: &Formula) -> Part {
        let (left, right) = (self.text(left), self.text(right));
        match operator {
            Operator::Plus | Operator::Minus => match (left, right) {
                (Part::Zero, right) if operator == Operator::Plus => right,
                (left, Part::Zero) => left,
                (left, right) => {
                    let sign = if operator == Operator::Plus { "+" } else { "−" };
                    joined(left, &format!(" {sign} "), right)
                }
            },
            _ => match (left, right) {
                (Part::Zero, _) | (_, Part::Zero) => Part::Zero,
                (Part::One, part) if operator != Operator::Over => part,
                (part, Part::One) => part,
                (left, right) => joined(left, infix(operator), right),
            },
        }
    }
}

fn word(extreme: Extreme) -> &'static str {
    match extreme {
        Extreme::Min => "min",
        Extreme::Max => "max",
    }
}

fn infix(operator: Operator) -> &'static str {
    match operator {
        Operator::Plus => " + ",
        Operator::Minus => " − ",
        Operator::Times => "·",
        Operator::Channelwise => "∘",
        Operator::Cross => "×",
        Operator::Over => "/",
        Operator::ComponentsOver => "⊘",
        Operator::Power => "^",
    }
}

fn joined(left: Part, infix: &str, right: Part) -> Part {
    let begins_negative = matches!(left, Part::Text(_, true));
    let needs_group = begins_negative && matches!(infix, "^");
    let left = if needs_group { left.behind_operator() } else { left.shown() };
    match (left, right.behind_operator()) {
        (Some(left), Some(right)) => Part::Text(format!("{left}{infix}{right}"), begins_negative && !needs_group),
        (Some(part), None) | (None, Some(part)) => Part::Text(part, false),
        (None, None) => Part::One,
    }
}
