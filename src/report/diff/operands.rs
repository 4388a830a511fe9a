//! A formula whose operands are taken from the one log or the other.

use super::align::Alignment;
use super::tolerance::Tolerance;
use crate::log::formula::{self, Formula};
use crate::log::scope::Operand;
use crate::log::{Name, Value};
use crate::report::evaluate::{evaluate_with, operand};
use crate::report::side_by_side::Run;
use std::cell::RefCell;

/// The formula of a quantity, with its operands in both logs.
pub(super) struct Substitution<'a> {
    a: Run<'a>,
    event: usize,
    formula: &'static Formula,
    pub pairs: Vec<Pair>,
}

/// An operand of a formula, in both logs.
pub(super) struct Pair {
    pub symbol: &'static str,
    /// The nodes in A of the lights for which it stands under a Σ; `None` for what stands in none.
    lights: Vec<Option<usize>>,
    pub a: Option<Operand>,
    pub b: Option<Operand>,
}

impl Pair {
    fn differs(&self) -> bool {
        match (self.a, self.b) {
            (Some(a), Some(b)) => Tolerance::default().tells_apart(&a.value, &b.value),
            (a, b) => a.is_some() != b.is_some(),
        }
    }
}

impl<'a> Substitution<'a> {
    /// That of the quantity that A notes at one event and B at another; `None` if it has no formula in either.
    pub fn of(
        a: Run<'a>,
        b: Run,
        alignment: &Alignment,
        (event, our_name): (usize, Name),
        (their_event, their_name): (usize, Name),
    ) -> Option<Substitution<'a>> {
        let formula = formula_of(our_name).or_else(|| formula_of(their_name))?;
        let mut pairs: Vec<Pair> = Vec::new();
        for (symbol, light) in asked(a, event, formula) {
            let ours = operand(&a.log.events, a.tree, event, symbol, light);
            let theirs = match light {
                None => operand(&b.log.events, b.tree, their_event, symbol, None),
                Some(light) => alignment.nodes[light]
                    .and_then(|light| operand(&b.log.events, b.tree, their_event, symbol, Some(light))),
            };
            let is_same = |pair: &&mut Pair| pair.symbol == symbol && pair.a == ours && pair.b == theirs;
            match pairs.iter_mut().find(is_same) {
                // What belongs to no single light is the same for all.
                Some(pair) => pair.lights.push(light),
                None => pairs.push(Pair { symbol, lights: vec![light], a: ours, b: theirs }),
            }
        }
        Some(Substitution { a, event, formula, pairs })
    }

    /// The operands that differ, by their numbers.
    pub fn differing(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.pairs.len()).filter(|number| self.pairs[*number].differs())
    }

    /// The value of the formula with the operands of A, but for those that are taken from B.
    pub fn value(&self, is_of_b: impl Fn(usize) -> bool) -> Option<Value> {
        let operands = |symbol: &'static str, light: Option<usize>| {
            let number = self.pairs.iter().position(|pair| pair.symbol == symbol && pair.lights.contains(&light))?;
            let pair = &self.pairs[number];
            if is_of_b(number) { pair.b } else { pair.a }.map(|operand| operand.value)
        };
        evaluate_with(self.a.tree, self.event, self.formula, &operands).ok()
    }
}

/// What a formula asks for when it is evaluated in A: each symbol, under a Σ for each light.
fn asked(a: Run, event: usize, formula: &Formula) -> Vec<(&'static str, Option<usize>)> {
    let asked = RefCell::new(Vec::new());
    let operands = |symbol: &'static str, light: Option<usize>| {
        asked.borrow_mut().push((symbol, light));
        operand(&a.log.events, a.tree, event, symbol, light).map(|operand| operand.value)
    };
    // What it comes to is found out later; where it can't be evaluated, there are the operands up to there.
    let _ = evaluate_with(a.tree, event, formula, &operands);
    let mut asked = asked.into_inner();
    let mut seen = std::collections::HashSet::new();
    asked.retain(|known| seen.insert(*known));
    asked
}

/// The formula of a quantity; for what was computed with more digits and has none, the plain one of the same quantity.
fn formula_of(name: Name) -> Option<&'static Formula> {
    formula::of(name).or_else(|| formula::of(Name::find(name.key(), "")?))
}
