//! The parser of formula texts, and of what people type.

use super::typed::{self, Call};
use super::wrong::{Expected, Wrong};
use super::{Extreme, Formula, Function, NameReader, Operator, QUANTILE, Several, Unary};
use crate::log::name::Name;
use std::sync::LazyLock;

/// What comes between the terms of a sum.
const SUMS: &[(&str, Operator)] = &[("+", Operator::Plus), ("−", Operator::Minus)];

/// What comes between the factors of a product.
const PRODUCTS: &[(&str, Operator)] = &[
    ("·", Operator::Times),
    ("∘", Operator::Channelwise),
    ("×", Operator::Cross),
    ("/", Operator::Over),
    ("⊘", Operator::ComponentsOver),
];

/// What comes behind its operand.
const POSTFIXES: [(&str, Unary); 3] = [("²", Unary::Squared), ("⁺", Unary::Positive), ("°", Unary::Degrees)];

/// What comes around its operand.
const BRACKETS: [(&str, &str, Unary); 2] = [("|", "|", Unary::Length), ("⌊", "⌋", Unary::Floor)];

/// How the leaves of a text are read, and what else is in it.
pub(super) struct Dialect<'d, Leaf> {
    /// What a name at the beginning of a text stands for, and its length in bytes.
    pub name: &'d NameReader<'d, Leaf>,
    /// A number at this place of the text.
    pub number: &'d dyn Fn(f64, usize) -> Formula<Leaf>,
    /// Whether people type it: with signs in ASCII and more functions, but without sums over something.
    pub is_typed: bool,
    /// Whether a comma between two digits is a decimal one.
    pub has_decimal_commas: bool,
}

pub(super) struct Parser<'t, 'd, Leaf> {
    whole: &'t str,
    rest: &'t str,
    dialect: &'d Dialect<'d, Leaf>,
    /// How many more operations there may be: a formula is walked by recursion.
    room: usize,
}

/// The most operations of a text that is typed. The formulas of the table are far shorter.
const MOST_OPERATIONS: usize = 250;

/// The longest symbol of the table that a text begins with.
pub(super) fn symbol(text: &str) -> Option<&'static str> {
    static LONGEST_FIRST: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
        let mut symbols: Vec<_> = Name::all().map(Name::symbol).collect();
        symbols.sort_by_key(|symbol| std::cmp::Reverse(symbol.len()));
        symbols
    });
    LONGEST_FIRST.iter().copied().find(|symbol| text.starts_with(symbol))
}

impl<'t, 'd, Leaf: Clone> Parser<'t, 'd, Leaf> {
    pub(super) fn new(text: &'t str, dialect: &'d Dialect<'d, Leaf>) -> Parser<'t, 'd, Leaf> {
        Parser { whole: text, rest: text, dialect, room: MOST_OPERATIONS }
    }

    /// The formula up to the end of the text.
    pub(super) fn whole(mut self) -> Result<Formula<Leaf>, Wrong> {
        let formula = self.sum()?;
        if self.peek().is_empty() { Ok(formula) } else { Err(self.wrong(Expected::End)) }
    }

    fn sum(&mut self) -> Result<Formula<Leaf>, Wrong> {
        self.spend(1)?;
        let typed = if self.dialect.is_typed { typed::SUMS } else { &[] };
        self.left_to_right(&[SUMS, typed], Parser::product)
    }

    fn product(&mut self) -> Result<Formula<Leaf>, Wrong> {
        let typed = if self.dialect.is_typed { typed::PRODUCTS } else { &[] };
        self.left_to_right(&[PRODUCTS, typed], Parser::power)
    }

    /// Operands with some operators between them.
    fn left_to_right(
        &mut self,
        operators: &[&[(&str, Operator)]],
        operand: fn(&mut Self) -> Result<Formula<Leaf>, Wrong>,
    ) -> Result<Formula<Leaf>, Wrong> {
        let mut left = operand(self)?;
        while let Some((_, operator)) = operators.iter().copied().flatten().find(|(sign, _)| self.eat(sign)) {
            self.spend(1)?;
            left = Formula::binary(*operator, left, operand(self)?);
        }
        Ok(left)
    }

    fn power(&mut self) -> Result<Formula<Leaf>, Wrong> {
        self.spend(1)?;
        let base = self.prefix()?;
        if self.eat("^") { Ok(Formula::binary(Operator::Power, base, self.power()?)) } else { Ok(base) }
    }

    fn prefix(&mut self) -> Result<Formula<Leaf>, Wrong> {
        if self.name_ahead().is_some() {
            // Symbols first: the quantity `−N·H′` begins with a sign.
            self.postfix()
        } else if self.eat("−") || (self.dialect.is_typed && self.eat("-")) {
            Ok(Formula::unary(Unary::Negated, self.power()?))
        } else if self.eat("√") {
            Ok(Formula::unary(Unary::Root, self.postfix()?))
        } else {
            self.postfix()
        }
    }

    fn postfix(&mut self) -> Result<Formula<Leaf>, Wrong> {
        let mut inner = self.atom()?;
        loop {
            if self.dialect.is_typed
                && let Some((exponent, length)) = typed::raised(self.peek())
            {
                let at = self.at();
                self.rest = &self.rest[length..];
                inner = Formula::binary(Operator::Power, inner, (self.dialect.number)(exponent, at));
            } else if let Some((_, unary)) = POSTFIXES.iter().find(|(sign, _)| self.eat(sign)) {
                inner = Formula::unary(*unary, inner);
            } else {
                return Ok(inner);
            }
            self.spend(1)?;
        }
    }

    fn atom(&mut self) -> Result<Formula<Leaf>, Wrong> {
        // Before symbols, as a word may begin with the letter of one.
        if !self.dialect.is_typed {
            if let Some(several) = Several::ALL.into_iter().find(|several| self.eat_call(several.word())) {
                return self.around(Unary::Over(several), ")");
            }
            if self.eat("Σ(") {
                return self.around(Unary::OverLights, ")");
            }
        } else if let Some((_, call)) = typed::CALLS.iter().find(|(word, _)| self.eat_call(word)) {
            return self.call(*call);
        }
        if let Some(function) = Function::ALL.into_iter().find(|function| self.eat_call(function.word())) {
            return self.around(Unary::Function(function), ")");
        }
        if self.eat_call(QUANTILE) {
            let probability = self.sum()?;
            self.require(",")?;
            return Ok(Formula::binary(Operator::Quantile, probability, self.until(")")?));
        }
        if let Some((leaf, length)) = self.name_ahead() {
            self.rest = &self.rest[length..];
            return Ok(Formula::Leaf(leaf));
        }
        if let Some(extreme) = [Extreme::Min, Extreme::Max].into_iter().find(|extreme| self.eat_call(extreme.word())) {
            return self.extreme(extreme);
        }
        if self.eat("(") {
            return self.group();
        }
        match BRACKETS.iter().find(|(open, ..)| self.eat(open)) {
            Some((_, close, unary)) => self.around(*unary, close),
            None => self.number(),
        }
    }

    /// Eats a word with the parenthesis behind it; what is typed may have a blank between them.
    fn eat_call(&mut self, word: &str) -> bool {
        let is_typed = self.dialect.is_typed;
        let rest = self.peek().strip_prefix(word);
        match rest.and_then(|rest| if is_typed { rest.trim_start() } else { rest }.strip_prefix('(')) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn until(&mut self, close: &'static str) -> Result<Formula<Leaf>, Wrong> {
        let inner = self.sum()?;
        self.require(close)?;
        Ok(inner)
    }

    fn around(&mut self, unary: Unary, close: &'static str) -> Result<Formula<Leaf>, Wrong> {
        Ok(Formula::unary(unary, self.until(close)?))
    }

    /// What follows `(`: a part in parentheses, or a triple.
    fn group(&mut self) -> Result<Formula<Leaf>, Wrong> {
        let first = self.sum()?;
        if !self.eat_separator() {
            self.require(")")?;
            return Ok(Formula::unary(Unary::Grouped, first));
        }
        let second = self.sum()?;
        self.require(",")?;
        Ok(Formula::Triple(Box::new([first, second, self.until(")")?])))
    }

    /// What follows `min(` or `max(`.
    fn extreme(&mut self, extreme: Extreme) -> Result<Formula<Leaf>, Wrong> {
        let first = self.sum()?;
        if self.eat_separator() {
            return Ok(Formula::binary(Operator::Extreme(extreme), first, self.until(")")?));
        }
        self.require(")")?;
        Ok(Formula::unary(Unary::ExtremeComponent(extreme), first))
    }

    /// What follows the parenthesis of a function that only what is typed has.
    fn call(&mut self, call: Call) -> Result<Formula<Leaf>, Wrong> {
        let mut operands = vec![self.sum()?];
        while operands.len() < call.operands() {
            self.require(",")?;
            operands.push(self.sum()?);
        }
        self.require(")")?;
        // Some take an operand twice.
        self.spend(operands.iter().map(Formula::size).sum())?;
        call.formula(operands).ok_or_else(|| self.wrong(Expected::Operand))
    }

    fn number(&mut self) -> Result<Formula<Leaf>, Wrong> {
        let (digits, at) = (self.peek(), self.at());
        let (number, length) = match self.dialect.is_typed {
            true => typed::number(digits, self.dialect.has_decimal_commas),
            false => {
                let end = digits.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(digits.len());
                digits[..end].parse().ok().map(|number: f64| (number, end))
            }
        }
        .ok_or_else(|| self.wrong(Expected::Operand))?;
        self.rest = &digits[length..];
        let has_pi = self.eat("π");
        Ok((self.dialect.number)(if has_pi { number * std::f64::consts::PI } else { number }, at))
    }

    /// The name that the text goes on with.
    fn name_ahead(&mut self) -> Option<(Leaf, usize)> {
        let rest = self.peek();
        (self.dialect.name)(rest, self.at())
    }

    fn at(&self) -> usize {
        self.whole.len() - self.rest.len()
    }

    fn wrong(&self, expected: Expected) -> Wrong {
        Wrong { at: self.at(), expected }
    }

    fn spend(&mut self, operations: usize) -> Result<(), Wrong> {
        self.room = self.room.checked_sub(operations).ok_or_else(|| self.wrong(Expected::Less))?;
        Ok(())
    }

    fn peek(&mut self) -> &'t str {
        self.rest = self.rest.trim_start();
        self.rest
    }

    fn eat(&mut self, token: &str) -> bool {
        match self.peek().strip_prefix(token) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn eat_separator(&mut self) -> bool {
        self.eat(",") || (self.dialect.is_typed && self.eat(";"))
    }

    fn require(&mut self, token: &'static str) -> Result<(), Wrong> {
        let is_there = if token == "," { self.eat_separator() } else { self.eat(token) };
        if is_there { Ok(()) } else { Err(self.wrong(Expected::Sign(token))) }
    }
}
