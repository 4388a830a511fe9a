//! A formula ready to be written in any format: with its symbols, or with the numbers put in.

use super::provenance::Operand;
mod floor;
mod several;

use super::{Style, evaluate, forms, number};
use crate::log::formula::{Extreme, Formula, Function, Operator, Several};
use crate::log::{Log, Tree, Value, What, round_half_away, scope};

/// A formula with symbols or numbers.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// A number that the formula itself has.
    Number(f64),
    /// The symbol of a quantity.
    Symbol(&'static str),
    /// The value of a quantity, and the event that computed it, if one did and it is known.
    Value(Value, Option<usize>),
    /// A number with this many decimals, which are more than others have, and the event that computed it.
    Precise(f64, u32, Option<usize>),
    /// `−a`
    Negated(Box<Expression>),
    /// `√a`
    Root(Box<Expression>),
    /// `a²`
    Squared(Box<Expression>),
    /// `a⁺`
    Positive(Box<Expression>),
    /// `|a|`
    Length(Box<Expression>),
    /// `⌊a⌋`
    Floor(Box<Expression>),
    /// `(a)`
    Grouped(Box<Expression>),
    /// `Σ(a)`
    OverLights(Box<Expression>),
    /// `Σ_s(a)`
    Over(Several, Box<Expression>),
    /// `a°`
    Degrees(Box<Expression>),
    /// `cos(a)`
    Function(Function, Box<Expression>),
    /// `(a, b, c)`
    Triple(Box<[Expression; 3]>),
    /// Terms that are left out of a long sum.
    Elided,
    /// `min(a, b)`
    Extreme(Extreme, Box<Expression>, Box<Expression>),
    /// `student(p, ν)`
    Quantile(Box<Expression>, Box<Expression>),
    /// `min(a)`
    ExtremeComponent(Extreme, Box<Expression>),
    /// Two operands.
    Binary(Operator, Box<Expression>, Box<Expression>),
}

impl Expression {
    /// The formula with its symbols.
    pub fn symbolic(formula: &Formula) -> Expression {
        let of = |inner: &Formula| Box::new(Expression::symbolic(inner));
        match formula {
            Formula::Number(x) => Expression::Number(*x),
            Formula::Symbol(symbol) => Expression::Symbol(symbol),
            Formula::Negated(inner) => Expression::Negated(of(inner)),
            Formula::Root(inner) => Expression::Root(of(inner)),
            Formula::Squared(inner) => Expression::Squared(of(inner)),
            Formula::Positive(inner) => Expression::Positive(of(inner)),
            Formula::Length(inner) => Expression::Length(of(inner)),
            Formula::Floor(inner) => Expression::Floor(of(inner)),
            Formula::Grouped(inner) => Expression::Grouped(of(inner)),
            Formula::OverLights(inner) => Expression::OverLights(of(inner)),
            Formula::Over(several, inner) => Expression::Over(*several, of(inner)),
            Formula::Degrees(inner) => Expression::Degrees(of(inner)),
            Formula::Function(function, inner) => Expression::Function(*function, of(inner)),
            Formula::Triple(parts) => {
                let [x, y, z] = &**parts;
                Expression::Triple(Box::new([x, y, z].map(Expression::symbolic)))
            }
            Formula::Extreme(extreme, first, second) => Expression::Extreme(*extreme, of(first), of(second)),
            Formula::Quantile(probability, freedom) => Expression::Quantile(of(probability), of(freedom)),
            Formula::ExtremeComponent(extreme, inner) => Expression::ExtremeComponent(*extreme, of(inner)),
            Formula::Binary(operator, left, right) => Expression::Binary(*operator, of(left), of(right)),
        }
    }

    /// Whether its text begins with a minus sign, so that behind an operator it needs parentheses.
    pub fn begins_negative(&self) -> bool {
        match self {
            Expression::Number(x) | Expression::Value(Value::Number(x), _) | Expression::Precise(x, ..) => *x < 0.0,
            Expression::Negated(_) => true,
            Expression::Symbol(symbol) => symbol.starts_with('−'),
            Expression::Binary(operator, left, _) => *operator != Operator::Power && left.begins_negative(),
            _ => false,
        }
    }

    /// Whether it is a number written with a power of ten, `5.000·10⁻⁵`: as a divisor, under a root and under a power it needs parentheses.
    pub fn has_power_of_ten(&self, style: Style) -> bool {
        match self {
            Expression::Number(x) | Expression::Value(Value::Number(x), _) => number::has_power_of_ten(*x, style),
            Expression::Precise(x, digits, _) => number::has_power_of_ten(*x, style.at_least(*digits)),
            _ => false,
        }
    }

    /// Without the parentheses around it, where the format has another sign for what they do.
    pub fn ungrouped(&self) -> &Expression {
        match self {
            Expression::Grouped(inner) => inner.ungrouped(),
            other => other,
        }
    }
}

/// The formula of an event with the numbers put in; `links` are the operands of the event where it should be known what computed them.
pub fn substituted(
    log: &Log,
    tree: &Tree,
    event: usize,
    formula: &Formula,
    style: Style,
    links: &[Operand],
) -> Option<Expression> {
    if !explains(log, tree, event, style) {
        return None;
    }
    let is_doubled = matches!(log.events[event].what, What::Note { name, .. } if name.is_doubled());
    let whole = Substitution { log, tree, event, light: None, style, links, is_doubled }.part(formula).shown()?;
    // The whole right side needs no parentheses.
    Some(match (whole, formula) {
        (Expression::Grouped(inner), Formula::Binary(..)) => *inner,
        (whole, _) => whole,
    })
}

/// The same with the numbers as they are with twice the digits.
pub fn substituted_doubled(
    log: &Log,
    tree: &Tree,
    event: usize,
    formula: &Formula,
    style: Style,
) -> Option<Expression> {
    Substitution { log, tree, event, light: None, style, links: &[], is_doubled: true }.part(formula).shown()
}

/// Whether the operands that the log holds give the value of an event by this formula, but for what rounding and the
/// digits that are shown hide. Those of a log that another program wrote may be absent, or others of the same symbol. The book
/// prints what doesn't follow from its formulas, and its own arithmetic is shown as it is.
fn explains(log: &Log, tree: &Tree, event: usize, style: Style) -> bool {
    let What::Note { name, value } = log.events[event].what else { return true };
    match evaluate::evaluate(log, tree, event, name) {
        Some(Ok(computed)) => {
            log.header.arithmetic == "printed" || forms::is_near(log, &computed, &value, style.digits)
        }
        _ => false,
    }
}

/// Puts numbers into the formula of one event.
#[derive(Clone, Copy)]
struct Substitution<'a> {
    log: &'a Log,
    tree: &'a Tree,
    event: usize,
    /// The light whose part of a sum is written.
    light: Option<usize>,
    style: Style,
    links: &'a [Operand],
    /// Whether operands are taken with twice the digits, as the tracer took them: what the log has of them may have lost theirs.
    is_doubled: bool,
}

/// A part of a formula with its numbers.
enum Part {
    There(Expression),
    /// An absent factor: it changes nothing.
    One,
    /// An absent term: what it multiplies is left out.
    Zero,
}

impl Part {
    fn shown(self) -> Option<Expression> {
        match self {
            Part::There(expression) => Some(expression),
            Part::One => None,
            Part::Zero => Some(Expression::Number(0.0)),
        }
    }

    /// What an operator can be put to.
    fn operand(self) -> Option<Box<Expression>> {
        match self {
            Part::There(expression) => Some(Box::new(expression)),
            Part::One | Part::Zero => None,
        }
    }
}

impl Substitution<'_> {
    fn part(&self, formula: &Formula) -> Part {
        match formula {
            Formula::Number(x) => Part::There(Expression::Number(*x)),
            Formula::Symbol(symbol) => self.symbol(symbol),
            Formula::Negated(inner) => self.around(inner, Expression::Negated),
            Formula::Root(inner) => self.around(inner, Expression::Root),
            Formula::Squared(inner) => self.around(inner, Expression::Squared),
            Formula::Length(inner) => self.around_shown(inner, Expression::Length),
            Formula::Floor(inner) => self.floor(inner),
            Formula::Positive(inner) => self.positive(inner),
            Formula::Grouped(inner) => match (self.part(inner), &**inner) {
                // A number needs no parentheses of its own.
                (part, Formula::Symbol(_) | Formula::Positive(_)) => part,
                (part @ Part::There(Expression::Grouped(_)), _) => part,
                (Part::There(inside), _) => Part::There(Expression::Grouped(Box::new(inside))),
                (absent, _) => absent,
            },
            Formula::Extreme(extreme, first, second) => match (self.part(first).shown(), self.part(second).shown()) {
                (Some(first), Some(second)) => {
                    Part::There(Expression::Extreme(*extreme, Box::new(first), Box::new(second)))
                }
                _ => Part::Zero,
            },
            Formula::Quantile(probability, freedom) => {
                match (self.part(probability).shown(), self.part(freedom).shown()) {
                    (Some(p), Some(freedom)) => Part::There(Expression::Quantile(Box::new(p), Box::new(freedom))),
                    _ => Part::Zero,
                }
            }
            Formula::ExtremeComponent(extreme, inner) => {
                self.around_shown(inner, |inner| Expression::ExtremeComponent(*extreme, inner))
            }
            Formula::OverLights(inner) => self.over_lights(inner),
            Formula::Over(several, inner) => self.over(*several, inner),
            Formula::Degrees(inner) => self.around_shown(inner, Expression::Degrees),
            Formula::Function(function, inner) => {
                self.around_shown(inner, |inner| Expression::Function(*function, inner))
            }
            Formula::Triple(parts) => {
                let [x, y, z] = &**parts;
                match [x, y, z].map(|part| self.part(part).shown()) {
                    [Some(x), Some(y), Some(z)] => Part::There(Expression::Triple(Box::new([x, y, z]))),
                    _ => Part::Zero,
                }
            }
            Formula::Binary(operator, left, right) => self.binary(*operator, left, right),
        }
    }

    fn symbol(&self, symbol: &'static str) -> Part {
        let operand = match self.light {
            Some(light) => scope::operand_of_light(&self.log.events, self.tree, light, symbol),
            None => scope::operand(&self.log.events, self.tree, self.event, symbol),
        };
        match operand {
            Some(operand) => {
                if self.is_doubled
                    && let Ok(value) = evaluate::doubled_operand(&self.log.events, self.tree, self.event, symbol)
                {
                    return Part::There(Expression::Value(value, None));
                }
                let link = self.links.iter().find(|link| link.symbol == symbol && link.event == operand.event);
                Part::There(Expression::Value(operand.value, link.and_then(|link| link.computed)))
            }
            None if scope::is_one_when_absent(symbol) => Part::One,
            None => Part::Zero,
        }
    }

    fn around(&self, inner: &Formula, outer: impl FnOnce(Box<Expression>) -> Expression) -> Part {
        self.part(inner).operand().map_or(Part::Zero, |inner| Part::There(outer(inner)))
    }

    fn around_shown(&self, inner: &Formula, outer: impl FnOnce(Box<Expression>) -> Expression) -> Part {
        self.part(inner).shown().map_or(Part::Zero, |inner| Part::There(outer(Box::new(inner))))
    }

    /// `x⁺` as the number that it is.
    fn positive(&self, inner: &Formula) -> Part {
        let part = self.part(inner);
        let Part::There(Expression::Value(Value::Number(x), _)) = part else { return part };
        let is_above_one = number::number(x, self.style).parse::<f64>().is_ok_and(|shown| shown > 1.0);
        match x {
            x if x <= 0.0 => Part::Zero,
            // Only rounding takes a cosine past 1.
            _ if is_above_one => Part::There(Expression::Number(1.0)),
            _ => part,
        }
    }

    /// What a formula of a vector comes to.
    fn triple(&self, formula: &Formula) -> Option<[f64; 3]> {
        let operands = |symbol, light: Option<usize>| {
            let operand = evaluate::operand(&self.log.events, self.tree, self.event, symbol, light.or(self.light));
            operand.map(|operand| operand.value)
        };
        match evaluate::evaluate_with(self.log, self.tree, self.event, formula, &operands) {
            Ok(Value::Triple(triple)) => Some(triple),
            _ => None,
        }
    }

    /// Whether a base is the cosine `(x)⁺` of a quantity that the log holds, whatever it comes to.
    fn has_cosine(&self, base: &Formula) -> bool {
        let Formula::Grouped(inner) = base else { return false };
        let Formula::Positive(cosine) = &**inner else { return false };
        matches!(self.part(cosine), Part::There(_))
    }

    fn over_lights(&self, inner: &Formula) -> Part {
        let lights = scope::lights(&self.log.events, self.tree, self.event).filter(|light| !self.is_dark(*light));
        let parts = lights.filter_map(|light| Substitution { light: Some(light), ..*self }.part(inner).operand());
        let sum = parts.reduce(|sum, part| Box::new(Expression::Binary(Operator::Plus, sum, part)));
        sum.map_or(Part::Zero, |sum| Part::There(*sum))
    }

    fn is_dark(&self, light: usize) -> bool {
        let passed = scope::operand_of_light(&self.log.events, self.tree, light, "τ");
        passed.is_some_and(|operand| operand.value == Value::Triple([0.0; 3]))
    }

    fn binary(&self, operator: Operator, left: &Formula, right: &Formula) -> Part {
        if operator == Operator::Times
            && let Some(digits) = self.log.header.decimals_of_products()
            && let (Some(a), Some(b)) = (self.triple(left), self.triple(right))
        {
            return rounded_products(a, b, digits);
        }
        let is_cosine_below_zero = operator == Operator::Power && self.has_cosine(left);
        let (left, right) = (self.part(left), self.part(right));
        match (operator, left, right) {
            // 0⁰ is 1, and no term that is absent.
            (Operator::Power, Part::Zero, Part::There(Expression::Value(Value::Number(0.0), _)))
                if is_cosine_below_zero =>
            {
                Part::There(Expression::Number(1.0))
            }
            (Operator::Plus, Part::Zero, right) => right,
            (Operator::Plus | Operator::Minus, left, Part::Zero) => left,
            (Operator::Plus | Operator::Minus, left, right) => joined(operator, left, right),
            (_, Part::Zero, _) | (_, _, Part::Zero) => Part::Zero,
            (operator, Part::One, part) if operator != Operator::Over => part,
            (_, part, Part::One) => part,
            (operator, left, right) => joined(operator, left, right),
        }
    }
}

/// A dot product whose products were rounded before they were added, as the sum that it then is: `(0.533 + 0.036 + 0.219)`.
fn rounded_products(a: [f64; 3], b: [f64; 3], digits: u32) -> Part {
    let [x, y, z] = [0, 1, 2].map(|i| Expression::Value(Value::Number(round_half_away(a[i] * b[i], digits)), None));
    let sum = |left, right| Expression::Binary(Operator::Plus, Box::new(left), Box::new(right));
    Part::There(Expression::Grouped(Box::new(sum(sum(x, y), z))))
}

fn joined(operator: Operator, left: Part, right: Part) -> Part {
    match (left.shown(), right.operand()) {
        (Some(left), Some(right)) => Part::There(Expression::Binary(operator, Box::new(left), right)),
        (Some(part), None) => Part::There(part),
        (None, Some(part)) => Part::There(*part),
        (None, None) => Part::One,
    }
}
