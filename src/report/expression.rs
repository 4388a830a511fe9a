//! A formula ready to be written in any format: with its symbols, or with the numbers put in.

mod floor;
mod several;

use super::provenance::Operand;
use super::{Style, evaluate, forms, number};
use crate::log::formula::{Formula, Operator, Unary};
use crate::log::scope::{self, Element};
use crate::log::{Log, Name, Tree, Value, What, round_half_away};
use std::collections::HashMap;

/// A formula with symbols or numbers.
pub type Expression = Formula<Leaf>;

/// What represents a quantity.
#[derive(Clone, Debug, PartialEq)]
pub enum Leaf {
    /// Its symbol.
    Symbol(&'static str),
    /// Its value, and the event that computed it, if one did and it is known.
    Value(Value, Option<usize>),
    /// A number with this many decimals, which are more than others have, and the event that computed it.
    Precise(f64, u32, Option<usize>),
    /// Terms that are left out of a long sum.
    Elided,
}

impl Expression {
    /// The formula with its symbols.
    pub fn symbolic(formula: &Formula) -> Expression {
        formula.map(&|symbol| Leaf::Symbol(symbol))
    }

    /// A value, and the event that computed it, if that is known.
    pub fn value(value: Value, computed: Option<usize>) -> Expression {
        Formula::Leaf(Leaf::Value(value, computed))
    }

    /// Whether its text begins with a minus sign, so that behind an operator it needs parentheses.
    pub fn begins_negative(&self) -> bool {
        match self {
            Formula::Number(x) | Formula::Leaf(Leaf::Value(Value::Number(x), _) | Leaf::Precise(x, ..)) => *x < 0.0,
            Formula::Leaf(Leaf::Symbol(symbol)) => symbol.starts_with('−'),
            Formula::Unary(Unary::Negated, _) => true,
            Formula::Binary(Operator::Power | Operator::Extreme(_) | Operator::Quantile, ..) => false,
            Formula::Binary(_, left, _) => left.begins_negative(),
            _ => false,
        }
    }

    /// Whether it is a number written with a power of ten, `5.000·10⁻⁵`: as a divisor, under a root and under a power it needs parentheses.
    pub fn has_power_of_ten(&self, style: Style) -> bool {
        match self {
            Formula::Number(x) | Formula::Leaf(Leaf::Value(Value::Number(x), _)) => number::has_power_of_ten(*x, style),
            Formula::Leaf(Leaf::Precise(x, digits, _)) => number::has_power_of_ten(*x, style.at_least(*digits)),
            _ => false,
        }
    }

    /// Without the parentheses around it, where the format has another sign for what they do.
    pub fn ungrouped(&self) -> &Expression {
        match self {
            Formula::Unary(Unary::Grouped, inner) => inner.ungrouped(),
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
    // The first of those that are alike counts.
    let links = &links.iter().rev().map(|link| ((link.symbol, link.event), link.computed)).collect();
    let whole = Substitution { log, tree, event, light: None, element: None, style, links, is_doubled }
        .part(formula)
        .shown()?;
    // The whole right side needs no parentheses.
    Some(match (whole, formula) {
        (Formula::Unary(Unary::Grouped, inner), Formula::Binary(..)) => *inner,
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
    Substitution { log, tree, event, light: None, element: None, style, links: &HashMap::new(), is_doubled: true }
        .part(formula)
        .shown()
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
    /// The sample or the cell whose part of a sum is written.
    element: Option<Element>,
    style: Style,
    /// What computed an operand, by its symbol and its event.
    links: &'a HashMap<(&'static str, usize), Option<usize>>,
    /// Whether operands are taken with twice the digits, as the tracer took them: what the log has of them may have lost theirs.
    is_doubled: bool,
}

/// A part of a formula with its numbers.
type Part = super::part::Part<Expression>;

impl Part {
    /// With the zero that an absent term is.
    fn shown(self) -> Option<Expression> {
        match self {
            Part::Zero => Some(Formula::Number(0.0)),
            part => part.there(),
        }
    }
}

impl Substitution<'_> {
    fn part(&self, formula: &Formula) -> Part {
        match formula {
            Formula::Number(x) => Part::There(Formula::Number(*x)),
            Formula::Leaf(symbol) => self.symbol(symbol),
            Formula::Triple(parts) => match parts.each_ref().map(|part| self.part(part).shown()) {
                [Some(x), Some(y), Some(z)] => Part::There(Formula::Triple(Box::new([x, y, z]))),
                _ => Part::Zero,
            },
            Formula::Unary(unary, inner) => self.unary(*unary, inner),
            Formula::Binary(operator, left, right) => self.binary(*operator, left, right),
        }
    }

    fn unary(&self, unary: Unary, inner: &Formula) -> Part {
        let around =
            |inner: Option<Expression>| inner.map_or(Part::Zero, |inner| Part::There(Formula::unary(unary, inner)));
        match unary {
            Unary::Negated | Unary::Root | Unary::Squared => around(self.part(inner).there()),
            Unary::Length | Unary::Degrees | Unary::Function(_) | Unary::ExtremeComponent(_) => {
                around(self.part(inner).shown())
            }
            Unary::Grouped => match (self.part(inner), inner) {
                // A number needs no parentheses of its own.
                (part, Formula::Leaf(_) | Formula::Unary(Unary::Positive, _)) => part,
                (part @ Part::There(Formula::Unary(Unary::Grouped, _)), _) => part,
                (Part::There(inside), _) => Part::There(Formula::unary(Unary::Grouped, inside)),
                (absent, _) => absent,
            },
            Unary::Floor => self.floor(inner),
            Unary::Positive => self.positive(inner),
            Unary::OverLights => self.over_lights(inner),
            Unary::Over(several) => self.over(several, inner),
        }
    }

    fn symbol(&self, symbol: &'static str) -> Part {
        if let Some(element) = self.element {
            let value = scope::operand_of_element(&self.log.events, self.tree, element, symbol);
            return value.map_or(Part::Zero, |value| Part::There(Expression::value(value, None)));
        }
        let operand = match self.light {
            Some(light) => scope::operand_of_light(&self.log.events, self.tree, light, symbol),
            None => scope::operand(&self.log.events, self.tree, self.event, symbol),
        };
        match operand {
            Some(operand) => {
                if self.is_doubled
                    && let Ok(value) = evaluate::doubled_operand(&self.log.events, self.tree, self.event, symbol)
                {
                    return Part::There(Expression::value(value, None));
                }
                let computed = self.links.get(&(symbol, operand.event)).copied().flatten();
                Part::There(Expression::value(operand.value, computed))
            }
            None if scope::is_one_when_absent(symbol) => Part::One,
            None => Part::Zero,
        }
    }

    /// `x⁺` as the number that it is.
    fn positive(&self, inner: &Formula) -> Part {
        let part = self.part(inner);
        let Part::There(Formula::Leaf(Leaf::Value(Value::Number(x), _))) = part else { return part };
        let is_above_one = number::number(x, self.style).parse::<f64>().is_ok_and(|shown| shown > 1.0);
        match x {
            x if x <= 0.0 => Part::Zero,
            // Only rounding takes a cosine past 1.
            _ if is_above_one => Part::There(Formula::Number(1.0)),
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
        let Formula::Unary(Unary::Grouped, inner) = base else { return false };
        let Formula::Unary(Unary::Positive, cosine) = &**inner else { return false };
        matches!(self.part(cosine), Part::There(_))
    }

    fn over_lights(&self, inner: &Formula) -> Part {
        let lights = scope::lights(&self.log.events, self.tree, self.event).filter(|light| !self.is_dark(*light));
        let parts = lights.filter_map(|light| Substitution { light: Some(light), ..*self }.part(inner).there());
        parts.reduce(|sum, part| Formula::binary(Operator::Plus, sum, part)).map_or(Part::Zero, Part::There)
    }

    fn is_dark(&self, light: usize) -> bool {
        let passed = scope::operand_of_light(&self.log.events, self.tree, light, Name::ShadowTransmittance.symbol());
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
            (Operator::Extreme(_) | Operator::Quantile, left, right) => match (left.shown(), right.shown()) {
                (Some(left), Some(right)) => Part::There(Formula::binary(operator, left, right)),
                _ => Part::Zero,
            },
            // 0⁰ is 1, and no term that is absent.
            (Operator::Power, Part::Zero, Part::There(Formula::Leaf(Leaf::Value(Value::Number(0.0), _))))
                if is_cosine_below_zero =>
            {
                Part::There(Formula::Number(1.0))
            }
            (operator, Part::There(left), Part::There(right)) => Part::There(Formula::binary(operator, left, right)),
            (operator, left, right) => Part::without(operator, left, right).unwrap_or(Part::Zero),
        }
    }
}

/// A dot product whose products were rounded before they were added, as the sum that it then is: `(0.533 + 0.036 + 0.219)`.
fn rounded_products(a: [f64; 3], b: [f64; 3], digits: u32) -> Part {
    let [x, y, z] = [0, 1, 2].map(|i| Expression::value(Value::Number(round_half_away(a[i] * b[i], digits)), None));
    let sum = |left, right| Formula::binary(Operator::Plus, left, right);
    Part::There(Formula::unary(Unary::Grouped, sum(sum(x, y), z)))
}
