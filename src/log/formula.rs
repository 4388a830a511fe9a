//! The grammar of the formula texts: one parser, so that every view and every check reads them alike.
//!
//! ```text
//! sum      = product { ("+" | "−") product }
//! product  = power { ("·" | "∘" | "×" | "/" | "⊘") power }
//! power    = prefix [ "^" power ]
//! prefix   = "−" power | "√" postfix | postfix
//! postfix  = atom { "²" | "⁺" | "°" }
//! atom     = number [ "π" ] | symbol | "(" sum ")" | "(" sum "," sum "," sum ")" | "|" sum "|" | "⌊" sum "⌋"
//!          | ("Σ" | "Σ_s" | "Σ_c" | "Π" | "se_s" | "df_s") "(" sum ")" | ("min" | "max") "(" sum [ "," sum ] ")"
//!          | "student" "(" sum "," sum ")"
//!          | ("cos" | "sin" | "tan" | "exp" | "expm1" | "ln1p" | "ceil") "(" sum ")"
//! ```
//!
//! `·` is the product of two numbers, the scaling of a triple, or the dot product of two triples; `∘` multiplies colours
//! channel by channel; `×` is the cross product; `⊘` divides component by component, and a quotient that isn't finite
//! counts as the largest number of its sign (0⊘0 as 0); `min` and `max` of two triples go component by component, of one
//! triple they are its least and its greatest component; `x⁺` is the number between 0 and 1 that is nearest to x; `|v|` is a
//! length, and `|v|²` is v · v, without a root; `⌊x⌋` is the greatest whole number that isn't above x, of a triple component
//! by component. `Σ` adds over the lights of a surface point, one after the other, to the sum
//! before it; a term of which the log holds no part is zero, but `att` and `τ` that are absent count as 1 (a light that doesn't fade, a
//! shadow ray that nothing crosses). `Σ_s` adds over the samples of a pixel so far, and `Σ_c` over its accepted
//! cells, with twice the digits: the quotient that such a sum is in is rounded once. In them `I` is the colour that a sample brought.
//! `Π` multiplies, channel by channel, what the surfaces let through that a shadow ray crosses, in its order; it is zero where one lets
//! nothing through, and no channel of it is above 10¹⁵⁰. `se_s` is the standard error of the mean of the samples so far, per channel, and `df_s` its degrees of freedom: samples that
//! are a power of two, 2ᵏ, make 2^(k−1) pairs, in each of as many equal parts of the pixel one; with the differences δ of the pairs these are √Σδ²/2ᵏ and
//! max((Σδ²)²/Σδ⁴, 1). The parts are ⌈(k−1)/2⌉ times halved down and ⌊(k−1)/2⌋ times across, or the other way
//! round, whichever has the greater error, and the first where both have the same; where both have none or there are no pairs, all samples count
//! as one: √(Σ(I − mean)²/(n − 1)/n) and n − 1. In both the sums are those of quotients by the greatest |δ| or |I − mean|, in the order of the
//! second samples of the pairs or of all samples, by which the root is multiplied again. The place of a sample is
//! ((i_s + ξ_x)/c_s, (a_s + ξ_y·c_s)/n_s) of its inputs, or (s_x, s_y) where these are inputs, not rounded.
//! `student(p, ν)` is the t for which a variable of Student's distribution with ν degrees of freedom lies between −t and t with probability p,
//! to 10⁻⁹ of its value. `x°` is an angle in degrees; `cos(x°)` and `sin(x°)` are exact at quarters of a turn. `expm1(x)` is eˣ − 1 and `ln1p(x)` the
//! logarithm of 1 + x, with their digits near 0; `ceil` rounds up. The names of functions, with the parenthesis behind them, are tried first. A symbol is the longest one of the table of names that the text
//! goes on with, so `N·L` is the quantity and `N · L` its formula. Operations are done from left to right: evaluated so, a
//! formula gives the logged value to the last bit, but for `student`; docs/log.md says what other programs may compute otherwise.

mod words;

pub use words::{Function, QUANTILE, Several};

use super::name::Name;
use std::sync::LazyLock;

/// A formula as a tree.
#[derive(Clone, PartialEq, Debug)]
pub enum Formula {
    /// A number.
    Number(f64),
    /// The symbol of a quantity.
    Symbol(&'static str),
    /// `−a`
    Negated(Box<Formula>),
    /// `√a`
    Root(Box<Formula>),
    /// `a²`
    Squared(Box<Formula>),
    /// `a⁺`
    Positive(Box<Formula>),
    /// `|a|`
    Length(Box<Formula>),
    /// `⌊a⌋`
    Floor(Box<Formula>),
    /// `(a)`, kept because it is written.
    Grouped(Box<Formula>),
    /// `Σ(a)`
    OverLights(Box<Formula>),
    /// `Σ_s(a)`, `Σ_c(a)` or `Π(a)`
    Over(Several, Box<Formula>),
    /// `student(p, ν)`
    Quantile(Box<Formula>, Box<Formula>),
    /// `a°`
    Degrees(Box<Formula>),
    /// `cos(a)`
    Function(Function, Box<Formula>),
    /// `(a, b, c)`
    Triple(Box<[Formula; 3]>),
    /// `min(a, b)` or `max(a, b)`
    Extreme(Extreme, Box<Formula>, Box<Formula>),
    /// `min(a)` or `max(a)`: the extreme component of a triple.
    ExtremeComponent(Extreme, Box<Formula>),
    /// Two operands.
    Binary(Operator, Box<Formula>, Box<Formula>),
}

/// Which of several numbers.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Extreme {
    /// The least.
    Min,
    /// The greatest.
    Max,
}

/// An operator between two operands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Operator {
    /// `+`
    Plus,
    /// `−`
    Minus,
    /// `·`
    Times,
    /// `∘`
    Channelwise,
    /// `×`
    Cross,
    /// `/`
    Over,
    /// `⊘`
    ComponentsOver,
    /// `^`
    Power,
}

/// The formula of a name, parsed; `None` for what is given.
pub fn of(name: Name) -> Option<&'static Formula> {
    static PARSED: LazyLock<Vec<Option<Formula>>> = LazyLock::new(|| {
        // The texts are part of the program, and a test parses each of them.
        Name::all().map(|name| name.formula().and_then(|text| parse(text).ok())).collect()
    });
    PARSED[name as usize].as_ref()
}

/// Reads a formula text; the error says what was expected where.
pub fn parse(text: &str) -> Result<Formula, String> {
    let mut parser = Parser { rest: text };
    let formula = parser.sum()?;
    match parser.peek() {
        "" => Ok(formula),
        rest => Err(format!("expected the end of the formula, found `{rest}`")),
    }
}

struct Parser<'t> {
    rest: &'t str,
}

impl<'t> Parser<'t> {
    fn sum(&mut self) -> Result<Formula, String> {
        let mut left = self.product()?;
        loop {
            let operator = if self.eat("+") {
                Operator::Plus
            } else if self.eat("−") {
                Operator::Minus
            } else {
                return Ok(left);
            };
            left = binary(operator, left, self.product()?);
        }
    }

    fn product(&mut self) -> Result<Formula, String> {
        let mut left = self.power()?;
        loop {
            let operator = if self.eat("·") {
                Operator::Times
            } else if self.eat("∘") {
                Operator::Channelwise
            } else if self.eat("×") {
                Operator::Cross
            } else if self.eat("/") {
                Operator::Over
            } else if self.eat("⊘") {
                Operator::ComponentsOver
            } else {
                return Ok(left);
            };
            left = binary(operator, left, self.power()?);
        }
    }

    fn power(&mut self) -> Result<Formula, String> {
        let base = self.prefix()?;
        if self.eat("^") { Ok(binary(Operator::Power, base, self.power()?)) } else { Ok(base) }
    }

    fn prefix(&mut self) -> Result<Formula, String> {
        if self.symbol_ahead().is_some() {
            // Symbols first: the quantity `−N·H′` begins with a sign.
            self.postfix()
        } else if self.eat("−") {
            Ok(Formula::Negated(Box::new(self.power()?)))
        } else if self.eat("√") {
            Ok(Formula::Root(Box::new(self.postfix()?)))
        } else {
            self.postfix()
        }
    }

    fn postfix(&mut self) -> Result<Formula, String> {
        let mut inner = self.atom()?;
        loop {
            if self.eat("²") {
                inner = Formula::Squared(Box::new(inner));
            } else if self.eat("⁺") {
                inner = Formula::Positive(Box::new(inner));
            } else if self.eat("°") {
                inner = Formula::Degrees(Box::new(inner));
            } else {
                return Ok(inner);
            }
        }
    }

    fn atom(&mut self) -> Result<Formula, String> {
        // Before symbols, as a word may begin with the letter of one.
        for several in Several::ALL {
            if self.eat_call(several.sign()) {
                return Ok(Formula::Over(several, Box::new(self.until_closed()?)));
            }
        }
        for function in Function::ALL {
            if self.eat_call(function.word()) {
                return Ok(Formula::Function(function, Box::new(self.until_closed()?)));
            }
        }
        if self.eat_call(QUANTILE) {
            let probability = self.sum()?;
            self.require(",")?;
            return Ok(Formula::Quantile(Box::new(probability), Box::new(self.until_closed()?)));
        }
        if let Some(symbol) = self.symbol_ahead() {
            self.rest = &self.rest[symbol.len()..];
            return Ok(Formula::Symbol(symbol));
        }
        if self.eat("Σ(") {
            let inner = self.sum()?;
            self.require(")")?;
            return Ok(Formula::OverLights(Box::new(inner)));
        }
        for (word, extreme) in [("min(", Extreme::Min), ("max(", Extreme::Max)] {
            if self.eat(word) {
                return self.extreme(extreme);
            }
        }
        if self.eat("(") {
            return self.group();
        }
        if self.eat("|") {
            let inner = self.sum()?;
            self.require("|")?;
            return Ok(Formula::Length(Box::new(inner)));
        }
        if self.eat("⌊") {
            let inner = self.sum()?;
            self.require("⌋")?;
            return Ok(Formula::Floor(Box::new(inner)));
        }
        self.number()
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

    fn until_closed(&mut self) -> Result<Formula, String> {
        let inner = self.sum()?;
        self.require(")")?;
        Ok(inner)
    }

    /// What follows `(`: a part in parentheses, or a triple.
    fn group(&mut self) -> Result<Formula, String> {
        let first = self.sum()?;
        if !self.eat(",") {
            self.require(")")?;
            return Ok(Formula::Grouped(Box::new(first)));
        }
        let second = self.sum()?;
        self.require(",")?;
        Ok(Formula::Triple(Box::new([first, second, self.until_closed()?])))
    }

    /// What follows `min(` or `max(`.
    fn extreme(&mut self, extreme: Extreme) -> Result<Formula, String> {
        let first = Box::new(self.sum()?);
        if self.eat(",") {
            let second = Box::new(self.sum()?);
            self.require(")")?;
            return Ok(Formula::Extreme(extreme, first, second));
        }
        self.require(")")?;
        Ok(Formula::ExtremeComponent(extreme, first))
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

fn binary(operator: Operator, left: Formula, right: Formula) -> Formula {
    Formula::Binary(operator, Box::new(left), Box::new(right))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn symbol(text: &'static str) -> Formula {
        Formula::Symbol(text)
    }

    #[test]
    fn every_formula_of_the_table_parses() {
        for name in Name::all() {
            if let Some(text) = name.formula() {
                assert!(parse(text).is_ok(), "{name:?}: {text}: {:?}", parse(text));
                assert!(of(name).is_some());
            }
        }
    }

    #[test]
    fn the_longest_symbol_wins() {
        assert_eq!(parse("N·L").unwrap(), symbol("N·L"));
        assert_eq!(parse("N · L").unwrap(), binary(Operator::Times, symbol("N"), symbol("L")));
        assert_eq!(parse("−N·H′").unwrap(), symbol("−N·H′"));
    }

    #[test]
    fn sums_and_quotients_group_to_the_left() {
        let minus_then_plus = parse("r² − L2oc + T_A²").unwrap();
        let Formula::Binary(Operator::Plus, left, _) = minus_then_plus else { panic!("a sum") };
        assert!(matches!(*left, Formula::Binary(Operator::Minus, ..)));
    }

    #[test]
    fn what_is_wrong_is_said() {
        assert_eq!(parse("r +").unwrap_err(), "expected a number or a symbol, found ``");
        assert_eq!(parse("(r").unwrap_err(), "expected `)`, found ``");
        assert_eq!(parse("r )").unwrap_err(), "expected the end of the formula, found `)`");
    }
}
