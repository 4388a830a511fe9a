//! How expressions are written: one walk over them, and a notation for each format.

use super::expression::{Expression, Leaf};
use super::language::Language;
use super::{Style, decided};
use crate::log::formula::{Formula, Operator, QUANTILE, Unary};
use crate::log::{Log, Tree, Value};
use decided::{Comparison, Relation};
use std::f64::consts::TAU;

/// How numbers are written.
#[derive(Clone, Copy)]
pub struct Numbers {
    /// The language, with its decimal mark.
    pub language: Language,
    /// Their decimals.
    pub style: Style,
}

impl Numbers {
    /// A number or triple in plain text.
    pub fn value(self, value: &Value) -> String {
        self.language.value(value, self.style)
    }
}

/// The signs of a format, and where it needs parentheses.
pub trait Notation {
    /// Whether all stands in one line, so that parentheses say how far a root, a power and a fraction reach.
    const IS_LINEAR: bool = false;
    /// 2π
    const TWO_PI: &str = "2π";
    /// What represents terms that are left out.
    const ELIDED: &str = "…";

    /// What comes between the numbers of a triple.
    fn separator(language: Language) -> String {
        language.texts().separator.to_owned()
    }

    /// A number or triple.
    fn value(numbers: Numbers, value: &Value) -> String;

    /// A symbol such as `T2_A`, `|D|`, `cosφ_1`, `−N·H′`.
    fn symbol(symbol: &str) -> String;

    /// The text of a value that this event computed.
    fn linked(text: String, _event: Option<usize>) -> String {
        text
    }

    /// Parentheses around a text.
    fn grouped(inner: &str) -> String {
        format!("({inner})")
    }

    /// The text of what is squared, raised to a power or, in one line, stands under a root or a fraction bar.
    fn base(style: Style, expression: &Expression, text: String) -> String;

    /// An operation on one operand that isn't a function's.
    fn unary(unary: Unary, inner: &str) -> String;

    /// The name of a function, such as `cos`.
    fn function(name: &str) -> String {
        name.to_owned()
    }

    /// An operation on two operands that isn't a function's.
    fn binary(operator: Operator, left: &str, right: &str) -> String;

    /// The sign of a relation.
    fn relation(relation: Relation) -> String {
        relation.sign().to_owned()
    }

    /// A formula within a sentence.
    fn within_text(formula: String) -> String {
        formula
    }
}

/// An expression in a N::
pub fn written<N: Notation>(numbers: Numbers, expression: &Expression) -> String {
    let of = |inner: &Expression| written::<N>(numbers, inner);
    let base = |inner: &Expression| N::base(numbers.style, inner, of(inner));
    // Behind an operator a minus sign needs parentheses.
    let operand = |inner: &Expression| match of(inner) {
        text if inner.begins_negative() => N::grouped(&text),
        text => text,
    };
    match expression {
        Formula::Number(TAU) => N::TWO_PI.to_owned(),
        Formula::Number(x) => N::value(numbers, &Value::Number(*x)),
        Formula::Leaf(leaf) => match leaf {
            Leaf::Symbol(symbol) => N::symbol(symbol),
            Leaf::Value(value, event) => N::linked(N::value(numbers, value), *event),
            Leaf::Precise(x, digits, event) => {
                let numbers = Numbers { style: numbers.style.at_least(*digits), ..numbers };
                N::linked(N::value(numbers, &Value::Number(*x)), *event)
            }
            Leaf::Elided => N::ELIDED.to_owned(),
        },
        Formula::Triple(parts) => N::grouped(&parts.each_ref().map(of).join(&N::separator(numbers.language))),
        Formula::Unary(unary, inner) => match unary {
            Unary::Grouped => N::grouped(&of(inner)),
            Unary::Negated => N::unary(*unary, &operand(inner)),
            Unary::Squared | Unary::Positive | Unary::Degrees => N::unary(*unary, &base(inner)),
            Unary::Root if N::IS_LINEAR => N::unary(*unary, &base(inner)),
            Unary::Root => N::unary(*unary, &of(inner.ungrouped())),
            Unary::Function(function) => N::function(function.word()) + &N::grouped(&of(inner)),
            Unary::ExtremeComponent(extreme) => N::function(extreme.word()) + &N::grouped(&of(inner)),
            _ => N::unary(*unary, &of(inner)),
        },
        Formula::Binary(operator, left, right) => {
            let call = |name| {
                let operands = [left, right].map(|inner| of(inner)).join(&N::separator(numbers.language));
                N::function(name) + &N::grouped(&operands)
            };
            let [left, right] = match operator {
                Operator::Extreme(extreme) => return call(extreme.word()),
                Operator::Quantile => return call(QUANTILE),
                Operator::Over | Operator::ComponentsOver if N::IS_LINEAR => [of(left), base(right)],
                Operator::Power if N::IS_LINEAR => [base(left), base(right)],
                Operator::Over => [of(left.ungrouped()), of(right.ungrouped())],
                Operator::Power => [base(left), of(right.ungrouped())],
                _ => [of(left), operand(right)],
            };
            N::binary(*operator, &left, &right)
        }
    }
}

/// The comparisons by which the decision of an event was taken; nothing where there are none.
pub fn comparisons<N: Notation>(numbers: Numbers, log: &Log, tree: &Tree, event: usize) -> Option<String> {
    let line = |comparison: &Comparison| {
        let text = |expression: &Expression| written::<N>(Numbers { style: comparison.style, ..numbers }, expression);
        let relation = N::relation(comparison.relation);
        let sides = |[left, right]: [String; 2]| N::within_text(format!("{left} {relation} {right}"));
        let [symbols, values] = [comparison.symbolic.each_ref().map(text), comparison.numbers(&text)].map(sides);
        let digits = numbers.language.texts().twice_the_digits;
        let doubled = if comparison.is_doubled { format!(" ({digits})") } else { String::new() };
        format!("{symbols}: {values}{doubled}")
    };
    let lines: Vec<_> = decided::comparisons(log, tree, event, numbers.style).iter().map(line).collect();
    (!lines.is_empty()).then(|| lines.join("; "))
}

/// The same in one line of plain text.
pub fn line(language: Language, log: &Log, tree: &Tree, event: usize, style: Style) -> Option<String> {
    comparisons::<Plain>(Numbers { language, style }, log, tree, event)
}

/// Plain text in one line.
pub struct Plain;

impl Notation for Plain {
    const IS_LINEAR: bool = true;

    fn value(numbers: Numbers, value: &Value) -> String {
        numbers.value(value)
    }

    fn symbol(symbol: &str) -> String {
        symbol.to_owned()
    }

    /// A number with a power of ten is a product.
    fn base(style: Style, expression: &Expression, text: String) -> String {
        let is_one = !expression.begins_negative() && !expression.has_power_of_ten(style);
        if is_one { text } else { Self::grouped(&text) }
    }

    fn unary(unary: Unary, inner: &str) -> String {
        match unary {
            Unary::Negated => format!("−{inner}"),
            Unary::Root => format!("√{inner}"),
            Unary::Squared => format!("{inner}²"),
            Unary::Positive => format!("{inner}⁺"),
            Unary::Degrees => format!("{inner}°"),
            Unary::Length => format!("|{inner}|"),
            Unary::Floor => format!("⌊{inner}⌋"),
            Unary::OverLights => format!("Σ({inner})"),
            Unary::Over(several) => format!("{}({inner})", several.word()),
            Unary::Grouped | Unary::Function(_) | Unary::ExtremeComponent(_) => Self::grouped(inner),
        }
    }

    fn binary(operator: Operator, left: &str, right: &str) -> String {
        match operator {
            Operator::Plus | Operator::Minus => format!("{left} {} {right}", infix(operator)),
            _ => format!("{left}{}{right}", infix(operator)),
        }
    }
}

/// What comes between two operands.
pub fn infix(operator: Operator) -> &'static str {
    match operator {
        Operator::Plus => "+",
        Operator::Minus => "−",
        Operator::Times => "·",
        Operator::Channelwise => "∘",
        Operator::Cross => "×",
        Operator::Over => "/",
        Operator::ComponentsOver => "⊘",
        Operator::Power => "^",
        Operator::Extreme(_) | Operator::Quantile => ", ",
    }
}
