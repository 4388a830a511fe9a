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
//!          | ("cos" | "sin" | "tan" | "exp" | "expm1" | "ln" | "ln1p" | "ceil" | "asin" | "acos" | "atan" | "deg") "(" sum ")"
//! ```
//!
//! Where people type a formula it may also have `-` and `*`, `x` and `o` with blanks around them (for `×` and `∘`), `;` for `,`, numbers such as `1e-3`,
//! raised exponents, and `dot(a, b)`, `cross(a, b)`, `length(a)`, `abs(a)`, `unit(a)`, `clamp(a, least, most)`, `sqrt(a)`, `rad(a)`; no sums over something.
//!
//! `·` is the product of two numbers, the scaling of a triple, or the dot product of two triples; `∘` multiplies colours
//! channel by channel; `×` is the cross product; `⊘` divides component by component, and a quotient that isn't finite
//! counts as the largest number of its sign (0⊘0 as 0); `min` and `max` of two triples go component by component, of one
//! triple they are its least and its greatest component; `x⁺` is the number between 0 and 1 that is nearest to x; `|v|` is a
//! length, and `|v|²` is v · v, without a root; `⌊x⌋` is the greatest whole number that isn't above x, of a triple component
//! by component. `Σ` adds over the lights of a surface point, one after the other, to the sum
//! before it; a term of which the log holds no part is zero, but `att` and `τ` that are absent count as 1 (a light that doesn't fade, a
//! shadow ray that nothing crosses). `Σ_s` adds over the samples of a pixel so far, and `Σ_c` over its accepted
//! cells, with twice the digits: the quotient that such a sum is in is rounded once. In them `I` is the colour of a sample.
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
//! logarithm of 1 + x, with their digits near 0; `ceil` rounds up; `deg` is an angle in degrees. The names of functions, with the parenthesis behind them, are tried first. A symbol is the longest one of the table of names that the text
//! goes on with, so `N·L` is the quantity and `N · L` its formula. Operations are done from left to right: evaluated so, a
//! formula gives the logged value to the last bit, but for `student`; docs/log.md says what other programs may compute otherwise.

mod parser;
mod typed;
mod words;
mod wrong;

pub use words::{Function, QUANTILE, Several};
pub use wrong::{Expected, Wrong};

use super::name::Name;
use crate::log::words::words;
use parser::{Dialect, Parser};
use std::sync::LazyLock;

/// A formula as a tree. Its leaves are symbols, unless something else was put in for them.
#[derive(Clone, PartialEq, Debug)]
pub enum Formula<Leaf = &'static str> {
    /// A number.
    Number(f64),
    /// The symbol of a quantity, or what represents it.
    Leaf(Leaf),
    /// `(a, b, c)`
    Triple(Box<[Formula<Leaf>; 3]>),
    /// One operand.
    Unary(Unary, Box<Formula<Leaf>>),
    /// Two operands.
    Binary(Operator, Box<Formula<Leaf>>, Box<Formula<Leaf>>),
}

/// What is done to one operand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unary {
    /// `−a`
    Negated,
    /// `√a`
    Root,
    /// `a²`
    Squared,
    /// `a⁺`
    Positive,
    /// `|a|`
    Length,
    /// `⌊a⌋`
    Floor,
    /// `(a)`, kept because it is written.
    Grouped,
    /// `Σ(a)`
    OverLights,
    /// `Σ_s(a)`, `Σ_c(a)` or `Π(a)`
    Over(Several),
    /// `a°`
    Degrees,
    /// `cos(a)`
    Function(Function),
    /// `min(a)` or `max(a)`: the extreme component of a triple.
    ExtremeComponent(Extreme),
}

words! {
    /// Which of several numbers.
    pub Extreme {
        /// The least.
        Min = "min",
        /// The greatest.
        Max = "max",
    }
}

/// What is done to two operands.
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
    /// `min(a, b)` or `max(a, b)`
    Extreme(Extreme),
    /// `student(p, ν)`
    Quantile,
}

impl<Leaf> Formula<Leaf> {
    /// A formula of one operand.
    pub fn unary(unary: Unary, inner: Formula<Leaf>) -> Formula<Leaf> {
        Formula::Unary(unary, Box::new(inner))
    }

    /// A formula of two operands.
    pub fn binary(operator: Operator, left: Formula<Leaf>, right: Formula<Leaf>) -> Formula<Leaf> {
        Formula::Binary(operator, Box::new(left), Box::new(right))
    }

    /// How many operations and leaves it has.
    pub fn size(&self) -> usize {
        match self {
            Formula::Number(_) | Formula::Leaf(_) => 1,
            Formula::Triple(parts) => 1 + parts.iter().map(Formula::size).sum::<usize>(),
            Formula::Unary(_, inner) => 1 + inner.size(),
            Formula::Binary(_, left, right) => 1 + left.size() + right.size(),
        }
    }

    /// The same with other leaves.
    pub fn map<Other>(&self, leaf: &impl Fn(&Leaf) -> Other) -> Formula<Other> {
        match self {
            Formula::Number(x) => Formula::Number(*x),
            Formula::Leaf(own) => Formula::Leaf(leaf(own)),
            Formula::Triple(parts) => Formula::Triple(Box::new(parts.each_ref().map(|part| part.map(leaf)))),
            Formula::Unary(unary, inner) => Formula::unary(*unary, inner.map(leaf)),
            Formula::Binary(operator, left, right) => Formula::binary(*operator, left.map(leaf), right.map(leaf)),
        }
    }
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
    let name = |text: &str, _: usize| parser::symbol(text).map(|symbol| (symbol, symbol.len()));
    let number = |number, _| Formula::Number(number);
    let dialect = Dialect { name: &name, number: &number, is_typed: false, has_decimal_commas: false };
    Parser::new(text, &dialect).whole().map_err(|wrong| wrong.in_words(text))
}

/// Gives the leaf that a text begins with, which is at this place of the whole in bytes, and its length in bytes.
pub type NameReader<'a, Leaf> = dyn Fn(&str, usize) -> Option<(Leaf, usize)> + 'a;

/// Reads a formula that somebody typed. `name` gives the leaf that a text begins with, at this place of the whole in bytes, and its length; `number` that of
/// a number. In a language with decimal commas a comma between digits is one, unless that makes no sense.
///
/// # Errors
/// What was expected, and where.
pub fn parse_typed<Leaf: Clone>(
    text: &str,
    name: &NameReader<'_, Leaf>,
    number: &dyn Fn(f64, usize) -> Leaf,
    has_decimal_commas: bool,
) -> Result<Formula<Leaf>, Wrong> {
    let number = |x, at| Formula::Leaf(number(x, at));
    let read = |has_decimal_commas| {
        let dialect = Dialect { name, number: &number, is_typed: true, has_decimal_commas };
        Parser::new(text, &dialect).whole()
    };
    let plainly = read(false);
    if has_decimal_commas { read(true).or(plainly) } else { plainly }
}

/// The names of the functions that people can type.
pub fn typed_functions() -> impl Iterator<Item = &'static str> {
    let extremes = Extreme::ALL.map(Extreme::word);
    let calls = typed::CALLS.iter().map(|(word, _)| *word);
    Function::ALL.into_iter().map(Function::word).chain(calls).chain(extremes).chain([QUANTILE])
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;

    fn symbol(text: &'static str) -> Formula {
        Formula::Leaf(text)
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
        assert_eq!(parse("N · L").unwrap(), Formula::binary(Operator::Times, symbol("N"), symbol("L")));
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
