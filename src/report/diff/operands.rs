//! A formula whose operands are taken from the one log or the other.

use super::align::Alignment;
use super::tolerance::{Tolerance, distance};
use crate::log::formula::{self, Formula};
use crate::log::scope::{self, Operand};
use crate::log::{Name, Value};
use crate::report::evaluate::{evaluate_with, operand};
use crate::report::side_by_side::Run;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};

/// The formula of a quantity, with its operands in both logs.
pub(super) struct Substitution<'a> {
    a: Run<'a>,
    event: usize,
    formula: &'static Formula,
    pub pairs: Vec<Pair>,
    /// Which of them stands for a symbol, under a Σ for the node of a light.
    numbers: HashMap<(&'static str, Option<usize>), usize>,
}

/// An operand of a formula, in both logs.
pub(super) struct Pair {
    pub symbol: &'static str,
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

    /// How far the two are apart in proportion; what only one log has, farthest.
    fn apart(&self) -> f64 {
        self.a.zip(self.b).map_or(f64::INFINITY, |(a, b)| distance(&a.value, &b.value).relative)
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
        let (mut pairs, mut numbers) = (Vec::new(), HashMap::new());
        let mut known = HashMap::new();
        for (symbol, light) in asked(a, event, formula) {
            let ours = operand(&a.log.events, a.tree, event, symbol, light);
            let theirs = match light {
                None => operand(&b.log.events, b.tree, their_event, symbol, None),
                Some(light) => alignment.nodes[light]
                    .and_then(|light| operand(&b.log.events, b.tree, their_event, symbol, Some(light))),
            };
            // What belongs to no single light is the same for all.
            let sources = (symbol, ours.map(|operand| operand.event), theirs.map(|operand| operand.event));
            let number = *known.entry(sources).or_insert(pairs.len());
            if number == pairs.len() {
                pairs.push(Pair { symbol, a: ours, b: theirs });
            }
            numbers.insert((symbol, light), number);
        }
        Some(Substitution { a, event, formula, pairs, numbers })
    }

    /// The operands that differ, by their numbers; of very many, as under the Σ of a large area light, those that are farthest apart, so
    /// that the time doesn't grow with the square of their number.
    pub fn differing(&self) -> Vec<usize> {
        const MOST: usize = 200;
        // Further sums of a node go over the same operands.
        let most = MOST / (1 + scope::sums_before(&self.a.log.events, self.a.tree, self.event));
        let mut differing: Vec<usize> = (0..self.pairs.len()).filter(|number| self.pairs[*number].differs()).collect();
        if differing.len() > most {
            differing.sort_by(|x, y| self.pairs[*y].apart().total_cmp(&self.pairs[*x].apart()));
            differing.truncate(most);
        }
        differing
    }

    /// The value of the formula with the operands of A, but for those that are taken from B.
    pub fn value(&self, is_of_b: impl Fn(usize) -> bool) -> Option<Value> {
        let operands = |symbol: &'static str, light: Option<usize>| {
            let number = *self.numbers.get(&(symbol, light))?;
            let pair = &self.pairs[number];
            if is_of_b(number) { pair.b } else { pair.a }.map(|operand| operand.value)
        };
        evaluate_with(self.a.log, self.a.tree, self.event, self.formula, &operands).ok()
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
    let _ = evaluate_with(a.log, a.tree, event, formula, &operands);
    let mut asked = asked.into_inner();
    let mut seen = HashSet::new();
    asked.retain(|known| seen.insert(*known));
    asked
}

/// The formula of a quantity; for what was computed with more digits and has none, the plain one of the same quantity.
fn formula_of(name: Name) -> Option<&'static Formula> {
    formula::of(name).or_else(|| formula::of(Name::find(name.key(), "")?))
}
