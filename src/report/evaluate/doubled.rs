//! Formulas of what the tracer computed with twice the digits: sums over samples, and distances where f64 loses too many.
//!
//! The tracer keeps such a value's operands with all their digits, too, and rounds once. So an operand that the same test noted isn't
//! taken as logged, but by its own formula, and the ray's direction is a vector over its length: D, or that of the bounce. Inputs that were rounded before they were logged (a unit
//! axis, the rows of a map) may be off by their roundings, which the bound takes into account.

use super::Within;
use super::amount::Amount;
use super::wide::Wide;
use crate::log::formula::{self, Formula, Operator, Several, Unary};
use crate::log::scope::{self, Element};
use crate::log::{Events, Name, Step, Tree, Value, What};

/// How far the tracer's own arithmetic may be from the exact value, as a part of it: two units in the last place.
const OF_RESULT: f64 = 2.0 * f64::EPSILON;

/// How far a component of an input that was rounded before may be off, as a part of the input: four roundings.
const OF_INPUT: f64 = 4.0 * f64::EPSILON;

/// Inputs that were made of the scene's numbers.
const MADE: [Name; 9] = [
    Name::AxisDirection,
    Name::AxisLength,
    Name::ConeSlope,
    Name::EllipsoidRow1,
    Name::EllipsoidRow2,
    Name::EllipsoidRow3,
    Name::SphereRadiusSquared,
    Name::CylinderRadiusSquared,
    Name::EllipsoidRadiusSquared,
];

/// Evaluates the formula of a quantity that `event` notes.
pub(super) fn evaluate(events: &Events, tree: &Tree, event: usize, formula: &Formula) -> Result<Within, String> {
    let scope = Scope { events, tree, event, element: None };
    let value = scope.part(formula)?;
    // The mean of samples is exact but for its last rounding.
    let of_result = if is_sum(formula) { 0.0 } else { OF_RESULT };
    let bound = |x: Wide| if of_result == 0.0 { 0.0 } else { x.error + x.value().abs() * of_result };
    Ok(Within { value: value.map(Wide::value).into(), bound: value.map(bound).into() })
}

fn is_sum(formula: &Formula) -> bool {
    match formula {
        Formula::Unary(Unary::Over(_), _) => true,
        Formula::Binary(_, left, _) => is_sum(left),
        _ => false,
    }
}

/// A number or triple with twice the digits.
type Part = Amount<Wide>;

/// Where the symbols of a formula are looked up.
#[derive(Clone, Copy)]
struct Scope<'a> {
    events: &'a Events,
    tree: &'a Tree,
    /// The event that notes the quantity.
    event: usize,
    /// The sample or the cell whose term of a sum is evaluated.
    element: Option<Element>,
}

impl Scope<'_> {
    fn part(&self, formula: &Formula) -> Result<Part, String> {
        match formula {
            Formula::Number(x) => Ok(Part::Number(Wide::exact(*x))),
            Formula::Leaf(symbol) => self.operand(symbol),
            Formula::Unary(Unary::Over(several), inner) => self.over(*several, inner),
            Formula::Unary(unary, inner) => match (unary, &**inner) {
                (Unary::Squared, Formula::Unary(Unary::Length, vector)) => squared(self.part(vector)?),
                (Unary::Grouped, inner) => self.part(inner),
                (Unary::Negated, inner) => Ok(self.part(inner)?.map(|x| -x)),
                (Unary::Root, inner) => Ok(self.part(inner)?.map(Wide::sqrt)),
                (Unary::Squared, inner) => squared(self.part(inner)?),
                (Unary::Length, inner) => Ok(squared(self.part(inner)?)?.map(Wide::sqrt)),
                _ => Err(format!("{formula:?} isn't evaluated with twice the digits")),
            },
            Formula::Binary(operator, left, right) => binary(*operator, self.part(left)?, self.part(right)?),
            Formula::Triple(_) => Err(format!("{formula:?} isn't evaluated with twice the digits")),
        }
    }

    fn over(&self, several: Several, inner: &Formula) -> Result<Part, String> {
        if !scope::is_added_up(self.events, self.tree, self.event) {
            return Err(super::too_many_sums());
        }
        let elements = scope::elements(self.events, self.tree, self.event, several);
        elements.into_iter().try_fold(Part::Triple([Wide::ZERO; 3]), |sum, element| {
            let term = Scope { element: Some(element), ..*self }.part(inner)?;
            binary(Operator::Plus, sum, term)
        })
    }

    fn operand(&self, symbol: &'static str) -> Result<Part, String> {
        if let Some(element) = self.element {
            let value = scope::operand_of_element(self.events, self.tree, element, symbol);
            return value.map(exact).ok_or_else(|| format!("the log holds no `{symbol}`"));
        }
        let operand = scope::operand(self.events, self.tree, self.event, symbol)
            .ok_or_else(|| format!("the log holds no `{symbol}`"))?;
        let source = &self.events[operand.event];
        let owner = self.tree.owner(operand.event);
        if operand.event < self.event
            && let What::Note { name, .. } = source.what
            && name.symbol() == symbol
        {
            let is_in_this_test = owner == self.tree.owner(self.event)
                && matches!(self.tree.nodes()[owner].step, Some(Step::Test { .. }));
            let here = Scope { event: operand.event, ..*self };
            match formula::of(name) {
                Some(_) if name == Name::RayDirection => return here.operand(Name::RayVector.symbol()).and_then(unit),
                Some(formula) if is_in_this_test => return here.part(formula),
                _ => {}
            }
        }
        if symbol == Name::RayDirection.symbol() {
            return unit(exact(operand.value));
        }
        let given = self.events.given(source).iter().rev().find(|(name, _)| name.symbol() == symbol);
        let is_made = given.is_some_and(|(name, value)| MADE.contains(name) && value.same_bits(&operand.value));
        Ok(if is_made { made(operand.value) } else { exact(operand.value) })
    }
}

/// A vector over its length.
fn unit(vector: Part) -> Result<Part, String> {
    let length = squared(vector)?.map(Wide::sqrt);
    binary(Operator::Over, vector, length)
}

fn squared(part: Part) -> Result<Part, String> {
    binary(Operator::Times, part, part)
}

fn exact(value: Value) -> Part {
    Amount::from(value).map(Wide::exact)
}

fn made(value: Value) -> Part {
    let size = value.components().iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    Amount::from(value).map(|x| Wide::off(x, size * OF_INPUT))
}

fn binary(operator: Operator, left: Part, right: Part) -> Result<Part, String> {
    left.with(operator, right).ok_or_else(|| format!("{left:?} {operator:?} {right:?}"))
}
