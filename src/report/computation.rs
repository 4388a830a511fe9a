//! One computed value as the source text writes it: symbol, formula, the numbers put in, the result.

use super::Style;
use super::expression;
use super::language::Language;
use super::notation::{Numbers, Plain, written};
use crate::log::formula;
use crate::log::{Log, Name, Tree, What};

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

/// The computation of the quantity that `event` notes, with the numbers of a language; `None` for other events.
pub fn computation(language: Language, log: &Log, tree: &Tree, event: usize, style: Style) -> Option<Computation> {
    let What::Note { name, value } = log.events[event].what else { return None };
    let result = language.value(&value, style);
    let formula = formula_of(name).map(str::to_owned);
    let substituted =
        formula::of(name).and_then(|formula| expression::substituted(log, tree, event, formula, style, &[]));
    let substituted = substituted
        .map(|expression| written::<Plain>(Numbers { language, style }, &expression))
        .filter(|text| *text != result);
    Some(Computation { symbol: name.symbol().to_owned(), formula, substituted, result })
}

/// The text of a quantity's formula, unless it only repeats the symbol or there is none.
pub fn formula_of(name: Name) -> Option<&'static str> {
    name.formula().filter(|text| without_spaces(text) != name.symbol())
}

fn without_spaces(text: &str) -> String {
    text.chars().filter(|c| *c != ' ').collect()
}
