//! One computed value as the source text writes it: symbol, formula, the numbers put in, the result.

use super::Style;
use super::expression::{self, Expression};
use super::language::Language;
use crate::log::formula::{self, Extreme, Operator, QUANTILE};
use crate::log::{Log, Name, Tree, What};
use std::f64::consts::TAU;

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
    computation_in(Language::English, log, tree, event, style)
}

/// The computation with the numbers of a language.
pub fn computation_in(language: Language, log: &Log, tree: &Tree, event: usize, style: Style) -> Option<Computation> {
    let What::Note { name, value } = log.events[event].what else { return None };
    let result = language.value(&value, style);
    let formula = formula_of(name).map(str::to_owned);
    let substituted =
        formula::of(name).and_then(|formula| expression::substituted(log, tree, event, formula, style, &[]));
    let substituted = substituted.map(|expression| text(language, &expression, style)).filter(|text| *text != result);
    Some(Computation { symbol: name.symbol().to_owned(), formula, substituted, result })
}

/// The text of a quantity's formula, unless it only repeats the symbol or there is none.
pub fn formula_of(name: Name) -> Option<&'static str> {
    name.formula().filter(|text| without_spaces(text) != name.symbol())
}

fn without_spaces(text: &str) -> String {
    text.chars().filter(|c| *c != ' ').collect()
}

/// An expression in one line of plain text.
pub(super) fn text(language: Language, expression: &Expression, style: Style) -> String {
    let shown = |inner: &Expression| text(language, inner, style);
    let behind_operator = |inner: &Expression| {
        if inner.begins_negative() { format!("({})", shown(inner)) } else { shown(inner) }
    };
    // Under a root, a power or a fraction bar a number with a power of ten is a product.
    let as_one = |inner: &Expression| {
        if inner.begins_negative() || inner.has_power_of_ten(style) {
            format!("({})", shown(inner))
        } else {
            shown(inner)
        }
    };
    match expression {
        Expression::Number(TAU) => "2π".to_owned(),
        Expression::Number(x) => language.number(*x, style),
        Expression::Symbol(symbol) => (*symbol).to_owned(),
        Expression::Value(value, _) => language.value(value, style),
        Expression::Precise(x, digits, _) => language.number(*x, style.at_least(*digits)),
        Expression::Negated(inner) => format!("−{}", behind_operator(inner)),
        Expression::Root(inner) => format!("√{}", as_one(inner)),
        Expression::Squared(inner) => format!("{}²", as_one(inner)),
        Expression::Positive(inner) => format!("{}⁺", as_one(inner)),
        Expression::Length(inner) => format!("|{}|", shown(inner)),
        Expression::Floor(inner) => format!("⌊{}⌋", shown(inner)),
        Expression::Grouped(inner) => format!("({})", shown(inner)),
        Expression::OverLights(inner) => format!("Σ({})", shown(inner)),
        Expression::Over(several, inner) => format!("{}({})", several.sign(), shown(inner)),
        Expression::Degrees(inner) => format!("{}°", as_one(inner)),
        Expression::Function(function, inner) => format!("{}({})", function.word(), shown(inner)),
        Expression::Triple(parts) => {
            format!("({})", parts.each_ref().map(shown).join(language.texts().separator))
        }
        Expression::Elided => "…".to_owned(),
        Expression::Extreme(extreme, first, second) => {
            format!("{}({}{}{})", word(*extreme), shown(first), language.texts().separator, shown(second))
        }
        Expression::Quantile(probability, freedom) => {
            format!("{QUANTILE}({}{}{})", shown(probability), language.texts().separator, shown(freedom))
        }
        Expression::ExtremeComponent(extreme, inner) => format!("{}({})", word(*extreme), shown(inner)),
        Expression::Binary(operator, left, right) => {
            let left = if *operator == Operator::Power { as_one(left) } else { shown(left) };
            let right = match operator {
                Operator::Over | Operator::ComponentsOver | Operator::Power => as_one(right),
                _ => behind_operator(right),
            };
            format!("{left}{}{right}", infix(*operator))
        }
    }
}

/// What an extreme is called.
pub fn word(extreme: Extreme) -> &'static str {
    match extreme {
        Extreme::Min => "min",
        Extreme::Max => "max",
    }
}

/// What is between two operands.
pub fn infix(operator: Operator) -> &'static str {
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
