//! How expressions are written: one walk over them, and a notation for each format.

use super::expression::{Expression, Leaf};
use super::language::Language;
use super::{Style, decided};
use crate::log::formula::{Formula, Operator, QUANTILE, Unary};
use crate::log::{Log, Tree, Value};
use decided::{Comparison, Relation};
use std::f64::consts::TAU;

/// The signs of a format, and where it needs parentheses.
pub trait Notation {
    /// Whether all stands in one line, so that parentheses say how far a root, a power and a fraction reach.
    const IS_LINEAR: bool = false;
    /// 2π
    const TWO_PI: &str = "2π";
    /// What stands for terms that are left out.
    const ELIDED: &str = "…";

    /// How numbers are shown.
    fn style(&self) -> Style;

    /// What stands between the numbers of a triple.
    fn separator(&self) -> String;

    /// A number or triple.
    fn value(&self, value: &Value, style: Style) -> String;

    /// A symbol such as `T2_A`, `|D|`, `cosφ_1`, `−N·H′`.
    fn symbol(&self, symbol: &str) -> String;

    /// The text of a value that this event computed.
    fn linked(&self, text: String, _event: Option<usize>) -> String {
        text
    }

    /// Parentheses around a text.
    fn grouped(&self, inner: &str) -> String {
        format!("({inner})")
    }

    /// The text of what is squared, raised to a power or, in one line, stands under a root or a fraction bar.
    fn base(&self, expression: &Expression, text: String) -> String;

    /// An operation on one operand that isn't a function's.
    fn unary(&self, unary: Unary, inner: &str) -> String;

    /// The name of a function, such as `cos`.
    fn function(&self, name: &str) -> String {
        name.to_owned()
    }

    /// An operation on two operands that isn't a function's.
    fn binary(&self, operator: Operator, left: &str, right: &str) -> String;

    /// The sign of a relation.
    fn relation(&self, relation: Relation) -> String {
        relation.sign().to_owned()
    }

    /// A formula within a sentence.
    fn within_text(&self, formula: String) -> String {
        formula
    }
}

/// An expression in a notation.
pub fn written<N: Notation>(notation: &N, expression: &Expression) -> String {
    let of = |inner: &Expression| written(notation, inner);
    let base = |inner: &Expression| notation.base(inner, of(inner));
    // Behind an operator a minus sign needs parentheses.
    let operand = |inner: &Expression| match of(inner) {
        text if inner.begins_negative() => notation.grouped(&text),
        text => text,
    };
    match expression {
        Formula::Number(TAU) => N::TWO_PI.to_owned(),
        Formula::Number(x) => notation.value(&Value::Number(*x), notation.style()),
        Formula::Leaf(leaf) => match leaf {
            Leaf::Symbol(symbol) => notation.symbol(symbol),
            Leaf::Value(value, event) => notation.linked(notation.value(value, notation.style()), *event),
            Leaf::Precise(x, digits, event) => {
                notation.linked(notation.value(&Value::Number(*x), notation.style().at_least(*digits)), *event)
            }
            Leaf::Elided => N::ELIDED.to_owned(),
        },
        Formula::Triple(parts) => notation.grouped(&parts.each_ref().map(of).join(&notation.separator())),
        Formula::Unary(unary, inner) => match unary {
            Unary::Grouped => notation.grouped(&of(inner)),
            Unary::Negated => notation.unary(*unary, &operand(inner)),
            Unary::Squared | Unary::Positive | Unary::Degrees => notation.unary(*unary, &base(inner)),
            Unary::Root if N::IS_LINEAR => notation.unary(*unary, &base(inner)),
            Unary::Root => notation.unary(*unary, &of(inner.ungrouped())),
            Unary::Function(function) => notation.function(function.word()) + &notation.grouped(&of(inner)),
            Unary::ExtremeComponent(extreme) => notation.function(extreme.word()) + &notation.grouped(&of(inner)),
            _ => notation.unary(*unary, &of(inner)),
        },
        Formula::Binary(operator, left, right) => {
            let call = |name| {
                let operands = [left, right].map(|inner| of(inner)).join(&notation.separator());
                notation.function(name) + &notation.grouped(&operands)
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
            notation.binary(*operator, &left, &right)
        }
    }
}

/// The comparisons by which the decision of an event was taken, in a notation for their styles; nothing where there are none.
pub fn comparisons<N: Notation>(
    log: &Log,
    tree: &Tree,
    event: usize,
    (language, style): (Language, Style),
    notation: impl Fn(Style) -> N,
) -> Option<String> {
    let line = |comparison: &Comparison| {
        let notation = notation(comparison.style);
        let text = |expression: &Expression| written(&notation, expression);
        let relation = notation.relation(comparison.relation);
        let sides = |[left, right]: [String; 2]| notation.within_text(format!("{left} {relation} {right}"));
        let [symbols, numbers] = [comparison.symbolic.each_ref().map(text), comparison.numbers(&text)].map(sides);
        let doubled =
            if comparison.is_doubled { format!(" ({})", language.texts().twice_the_digits) } else { String::new() };
        format!("{symbols}: {numbers}{doubled}")
    };
    let lines: Vec<_> = decided::comparisons(log, tree, event, style).iter().map(line).collect();
    (!lines.is_empty()).then(|| lines.join("; "))
}

/// Plain text in one line.
pub struct Plain {
    /// The language of its numbers.
    pub language: Language,
    /// How numbers are shown.
    pub style: Style,
}

impl Notation for Plain {
    const IS_LINEAR: bool = true;

    fn style(&self) -> Style {
        self.style
    }

    fn separator(&self) -> String {
        self.language.texts().separator.to_owned()
    }

    fn value(&self, value: &Value, style: Style) -> String {
        self.language.value(value, style)
    }

    fn symbol(&self, symbol: &str) -> String {
        symbol.to_owned()
    }

    /// A number with a power of ten is a product.
    fn base(&self, expression: &Expression, text: String) -> String {
        let is_one = !expression.begins_negative() && !expression.has_power_of_ten(self.style);
        if is_one { text } else { self.grouped(&text) }
    }

    fn unary(&self, unary: Unary, inner: &str) -> String {
        match unary {
            Unary::Negated => format!("−{inner}"),
            Unary::Root => format!("√{inner}"),
            Unary::Squared => format!("{inner}²"),
            Unary::Positive => format!("{inner}⁺"),
            Unary::Degrees => format!("{inner}°"),
            Unary::Length => format!("|{inner}|"),
            Unary::Floor => format!("⌊{inner}⌋"),
            Unary::OverLights => format!("Σ({inner})"),
            Unary::Over(several) => format!("{}({inner})", several.sign()),
            Unary::Grouped | Unary::Function(_) | Unary::ExtremeComponent(_) => self.grouped(inner),
        }
    }

    fn binary(&self, operator: Operator, left: &str, right: &str) -> String {
        match operator {
            Operator::Plus | Operator::Minus => format!("{left} {} {right}", infix(operator)),
            _ => format!("{left}{}{right}", infix(operator)),
        }
    }
}

/// What stands between two operands.
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
