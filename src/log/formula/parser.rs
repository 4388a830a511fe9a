//! The parser of formula texts.

use super::{Extreme, Formula, Function, Operator, QUANTILE, Several, Unary};
use crate::log::name::Name;
use std::sync::LazyLock;

/// What comes between the terms of a sum.
const SUMS: [(&str, Operator); 2] = [("+", Operator::Plus), ("−", Operator::Minus)];

/// What comes between the factors of a product.
const PRODUCTS: [(&str, Operator); 5] = [
    ("·", Operator::Times),
    ("∘", Operator::Channelwise),
    ("×", Operator::Cross),
    ("/", Operator::Over),
    ("⊘", Operator::ComponentsOver),
];

/// What comes behind its operand.
const POSTFIXES: [(&str, Unary); 3] = [("²", Unary::Squared), ("⁺", Unary::Positive), ("°", Unary::Degrees)];

/// What comes around its operand.
const BRACKETS: [(&str, &str, Unary); 3] =
    [("Σ(", ")", Unary::OverLights), ("|", "|", Unary::Length), ("⌊", "⌋", Unary::Floor)];

pub(super) struct Parser<'t> {
    rest: &'t str,
}

impl<'t> Parser<'t> {
    pub(super) fn new(text: &'t str) -> Parser<'t> {
        Parser { rest: text }
    }

    /// The formula up to the end of the text.
    pub(super) fn whole(mut self) -> Result<Formula, String> {
        let formula = self.sum()?;
        match self.peek() {
            "" => Ok(formula),
            rest => Err(format!("expected the end of the formula, found `{rest}`")),
        }
    }

    fn sum(&mut self) -> Result<Formula, String> {
        self.left_to_right(&SUMS, Parser::product)
    }

    fn product(&mut self) -> Result<Formula, String> {
        self.left_to_right(&PRODUCTS, Parser::power)
    }

    /// Operands with some operators between them.
    fn left_to_right(
        &mut self,
        operators: &[(&str, Operator)],
        operand: fn(&mut Self) -> Result<Formula, String>,
    ) -> Result<Formula, String> {
        let mut left = operand(self)?;
        while let Some((_, operator)) = operators.iter().find(|(sign, _)| self.eat(sign)) {
            left = Formula::binary(*operator, left, operand(self)?);
        }
        Ok(left)
    }

    fn power(&mut self) -> Result<Formula, String> {
        let base = self.prefix()?;
        if self.eat("^") { Ok(Formula::binary(Operator::Power, base, self.power()?)) } else { Ok(base) }
    }

    fn prefix(&mut self) -> Result<Formula, String> {
        if self.symbol_ahead().is_some() {
            // Symbols first: the quantity `−N·H′` begins with a sign.
            self.postfix()
        } else if self.eat("−") {
            Ok(Formula::unary(Unary::Negated, self.power()?))
        } else if self.eat("√") {
            Ok(Formula::unary(Unary::Root, self.postfix()?))
        } else {
            self.postfix()
        }
    }

    fn postfix(&mut self) -> Result<Formula, String> {
        let mut inner = self.atom()?;
        while let Some((_, unary)) = POSTFIXES.iter().find(|(sign, _)| self.eat(sign)) {
            inner = Formula::unary(*unary, inner);
        }
        Ok(inner)
    }

    fn atom(&mut self) -> Result<Formula, String> {
        // Before symbols, as a word may begin with the letter of one.
        if let Some(several) = Several::ALL.into_iter().find(|several| self.eat_call(several.word())) {
            return self.around(Unary::Over(several), ")");
        }
        if let Some(function) = Function::ALL.into_iter().find(|function| self.eat_call(function.word())) {
            return self.around(Unary::Function(function), ")");
        }
        if self.eat_call(QUANTILE) {
            let probability = self.sum()?;
            self.require(",")?;
            return Ok(Formula::binary(Operator::Quantile, probability, self.until(")")?));
        }
        if let Some(symbol) = self.symbol_ahead() {
            self.rest = &self.rest[symbol.len()..];
            return Ok(Formula::Leaf(symbol));
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

    /// Eats a word with the parenthesis behind it.
    fn eat_call(&mut self, word: &str) -> bool {
        match self.peek().strip_prefix(word).and_then(|rest| rest.strip_prefix('(')) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn until(&mut self, close: &str) -> Result<Formula, String> {
        let inner = self.sum()?;
        self.require(close)?;
        Ok(inner)
    }

    fn around(&mut self, unary: Unary, close: &str) -> Result<Formula, String> {
        Ok(Formula::unary(unary, self.until(close)?))
    }

    /// What follows `(`: a part in parentheses, or a triple.
    fn group(&mut self) -> Result<Formula, String> {
        let first = self.sum()?;
        if !self.eat(",") {
            self.require(")")?;
            return Ok(Formula::unary(Unary::Grouped, first));
        }
        let second = self.sum()?;
        self.require(",")?;
        Ok(Formula::Triple(Box::new([first, second, self.until(")")?])))
    }

    /// What follows `min(` or `max(`.
    fn extreme(&mut self, extreme: Extreme) -> Result<Formula, String> {
        let first = self.sum()?;
        if self.eat(",") {
            return Ok(Formula::binary(Operator::Extreme(extreme), first, self.until(")")?));
        }
        self.require(")")?;
        Ok(Formula::unary(Unary::ExtremeComponent(extreme), first))
    }

    fn number(&mut self) -> Result<Formula, String> {
        let digits = self.peek();
        let end = digits.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(digits.len());
        let number: f64 =
            digits[..end].parse().map_err(|_| format!("expected a number or a symbol, found `{digits}`"))?;
        self.rest = &digits[end..];
        Ok(Formula::Number(if self.eat("π") { number * std::f64::consts::PI } else { number }))
    }

    /// The longest symbol that the text goes on with.
    fn symbol_ahead(&mut self) -> Option<&'static str> {
        static LONGEST_FIRST: LazyLock<Vec<&'static str>> = LazyLock::new(|| {
            let mut symbols: Vec<_> = Name::all().map(Name::symbol).collect();
            symbols.sort_by_key(|symbol| std::cmp::Reverse(symbol.len()));
            symbols
        });
        let rest = self.peek();
        LONGEST_FIRST.iter().copied().find(|symbol| rest.starts_with(symbol))
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

    fn require(&mut self, token: &str) -> Result<(), String> {
        if self.eat(token) { Ok(()) } else { Err(format!("expected `{token}`, found `{}`", self.rest)) }
    }
}
