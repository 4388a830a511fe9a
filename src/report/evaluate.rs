//! A second opinion on every formula: evaluates the formula texts on the values that a log holds.
//!
//! It shares the grammar and the scope rules with the program, and no arithmetic: the operations are here once more, in the
//! order in which a reader takes them, from left to right. So a log can be checked against its formulas (the tests do that for
//! every name, bit for bit), and it can be asked what a quantity would be if one of its operands were another (`diff`).

mod amount;
mod doubled;
mod functions;
mod statistics;
mod wide;

use crate::log::formula::{self, Extreme, Formula, Operator, Several, Unary};
use crate::log::scope::{self, Operand};
use crate::log::{Events, Log, Name, Tree, Value, round_half_away};
use amount::Amount;

/// The value of the formula of the quantity `name` that `event` notes, before any rounding; `None` for what has no
/// formula.
///
/// # Errors
/// Which operand the log doesn't hold, or what can't be computed.
pub fn evaluate(log: &Log, tree: &Tree, event: usize, name: Name) -> Option<Result<Value, String>> {
    evaluate_within(log, tree, event, name).map(|result| result.map(|within| within.value))
}

/// What a formula comes to, and how far from there the logged value may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Within {
    /// The value.
    pub value: Value,
    /// By how much the logged value may differ, per component: 0 unless the tracer took twice the digits to its operands, too.
    pub bound: Value,
}

impl Within {
    /// Whether a logged value is what the formula gives: to the last bit, or within the bound.
    pub fn allows(&self, logged: &Value) -> bool {
        let (ours, bounds, theirs) = (self.value.components(), self.bound.components(), logged.components());
        self.value.same_bits(logged)
            || (ours.len() == theirs.len()
                && (0..ours.len()).all(|k| (ours[k] - theirs[k]).abs() <= bounds[k] && bounds[k] > 0.0))
    }
}

/// The same with the bound within which the formula gives the value. Quantities that were computed with twice the digits
/// ([`Name::is_doubled`]) are evaluated so, too.
///
/// # Errors
/// As those of [`evaluate`].
pub fn evaluate_within(log: &Log, tree: &Tree, event: usize, name: Name) -> Option<Result<Within, String>> {
    let (events, formula) = (&log.events, formula::of(name)?);
    if name.is_doubled() {
        return Some(doubled::evaluate(events, tree, event, formula));
    }
    if matches!(formula, Formula::Unary(Unary::Over(_), _)) && !scope::is_added_up(events, tree, event) {
        return Some(Err(too_many_sums()));
    }
    let logged = |symbol, light| operand(events, tree, event, symbol, light).map(|operand| operand.value);
    let result = match formula {
        Formula::Unary(Unary::Over(several), _) if several.is_statistic() => {
            statistics::of_samples(*several, events, tree, event)
        }
        Formula::Unary(Unary::Over(Several::Surfaces), _) => {
            Ok(Value::Triple(scope::transmittance(events, tree, event)))
        }
        _ => evaluate_with(log, tree, event, formula, &logged),
    };
    let bound = match formula {
        Formula::Binary(Operator::Quantile, probability, _) => {
            match evaluate_with(log, tree, event, probability, &logged) {
                Ok(Value::Number(probability)) => statistics::error_of_quantile(probability),
                _ => 0.0,
            }
        }
        _ => 0.0,
    };
    Some(result.map(|value| Within { value, bound: value.map(|x| x.abs() * bound) }))
}

/// The value of a formula at `event`, evaluated with twice the digits as the tracer does where f64 loses too many, and rounded once.
///
/// # Errors
/// As those of [`evaluate`].
pub fn doubled_value(events: &Events, tree: &Tree, event: usize, formula: &Formula) -> Result<Value, String> {
    doubled::evaluate(events, tree, event, formula).map(|within| within.value)
}

/// An operand of such a formula, evaluated and rounded so.
///
/// # Errors
/// As those of [`evaluate`].
pub fn doubled_operand(events: &Events, tree: &Tree, event: usize, symbol: &'static str) -> Result<Value, String> {
    doubled_value(events, tree, event, &Formula::Leaf(symbol))
}

/// The colour of the pixel of a log as the last of its computations has it: the mean of its samples, or what its one ray brought.
pub fn result(events: &Events, tree: &Tree, pixel: usize) -> Option<Value> {
    scope::color_of_pixel(events, tree, pixel)
}

/// What a symbol in the formula of the quantity that `event` notes stands for; under a Σ, in the part of the light whose node
/// is `light`.
pub fn operand(events: &Events, tree: &Tree, event: usize, symbol: &str, light: Option<usize>) -> Option<Operand> {
    match light {
        Some(light) => scope::operand_of_light(events, tree, light, symbol),
        None => scope::operand(events, tree, event, symbol),
    }
}

/// The value of a formula at `event` of a log, with the operands that `operands` has for a symbol and, under a Σ, the node of a light.
///
/// # Errors
/// As those of [`evaluate`].
pub fn evaluate_with(
    log: &Log,
    tree: &Tree,
    event: usize,
    formula: &Formula,
    operands: &Operands,
) -> Result<Value, String> {
    let (events, decimals_of_products) = (&log.events, log.header.decimals_of_products());
    match (Evaluator { events, tree, event, operands, light: None, decimals_of_products }).part(formula)? {
        Part::There(value) => Ok(value),
        absent => Err(format!("the formula comes to {absent:?}")),
    }
}

/// What the light in the node `light` adds to the local intensity `name`: the term under the Σ of its formula. A log holds the sum over
/// the lights and all that goes into it, but no light's own part. In f64 the parts add up to the sum but for roundings; in other
/// arithmetics the logged sum is rounded once more.
pub(super) fn term_of_light(log: &Log, tree: &Tree, light: usize, name: Name) -> [f64; 3] {
    let Some(Formula::Binary(Operator::Plus, _, lights)) = formula::of(name) else { return [0.0; 3] };
    let Formula::Unary(Unary::OverLights, term) = &**lights else { return [0.0; 3] };
    let operands = |symbol, _| scope::operand_of_light(&log.events, tree, light, symbol).map(|operand| operand.value);
    let decimals_of_products = log.header.decimals_of_products();
    let evaluator = Evaluator {
        events: &log.events,
        tree,
        event: light,
        operands: &operands,
        light: Some(light),
        decimals_of_products,
    };
    match evaluator.part(term) {
        Ok(Part::There(Value::Triple(color))) => color,
        Ok(Part::There(Value::Number(x))) => [x; 3],
        _ => [0.0; 3],
    }
}

/// Where the operands of a formula come from: by their symbol and, under a Σ, the node of a light.
pub type Operands<'a> = dyn Fn(&'static str, Option<usize>) -> Option<Value> + 'a;

#[derive(Clone, Copy)]
struct Evaluator<'a> {
    events: &'a Events,
    tree: &'a Tree,
    event: usize,
    operands: &'a Operands<'a>,
    /// The light whose term under Σ is evaluated.
    light: Option<usize>,
    /// To how many decimals the products of a dot product are rounded before they are added.
    decimals_of_products: Option<u32>,
}

/// What a part of a formula comes to.
type Part = super::part::Part<Value>;

impl Evaluator<'_> {
    fn part(&self, formula: &Formula) -> Result<Part, String> {
        match formula {
            Formula::Number(number) => Ok(Part::There(Value::Number(*number))),
            Formula::Leaf(symbol) => self.operand(symbol),
            Formula::Triple(parts) => {
                let [x, y, z] = [self.number(&parts[0])?, self.number(&parts[1])?, self.number(&parts[2])?];
                Ok(Part::There(Value::Triple([x, y, z])))
            }
            Formula::Unary(unary, inner) => self.unary(*unary, inner),
            Formula::Binary(Operator::Plus, left, right) => match &**right {
                Formula::Unary(Unary::OverLights, term) => self.over_lights(self.part(left)?, term),
                right => binary(Operator::Plus, self.part(left)?, self.part(right)?),
            },
            Formula::Binary(Operator::Quantile, probability, freedom) => {
                let probability = self.number(probability)?;
                map(self.part(freedom)?, |freedom| statistics::quantile(probability, freedom).unwrap_or(f64::NAN))
            }
            Formula::Binary(operator, left, right) => self.binary(*operator, self.part(left)?, self.part(right)?),
        }
    }

    fn unary(&self, unary: Unary, inner: &Formula) -> Result<Part, String> {
        let part = || self.part(inner);
        match (unary, inner) {
            // |v|² is v · v: on paper nobody takes a root to square it.
            (Unary::Squared, Formula::Unary(Unary::Length, vector)) => squared(self.part(vector)?),
            (Unary::Function(function), Formula::Unary(Unary::Degrees, angle)) => {
                map(self.part(angle)?, |degrees| functions::of_degrees(function, degrees))
            }
            (Unary::OverLights, term) => self.over_lights(Part::Zero, term),
            (Unary::Over(several), _) => Err(format!("{} stands in another formula", several.word())),
            (Unary::Grouped, _) => part(),
            (Unary::Negated, _) => map(part()?, |x| -x),
            (Unary::Positive, _) => map(part()?, |x| x.clamp(0.0, 1.0)),
            (Unary::Floor, _) => map(part()?, f64::floor),
            (Unary::Root, _) => map(part()?, f64::sqrt),
            (Unary::Squared, _) => squared(part()?),
            // Not the root of a square, which may overflow.
            (Unary::Length, _) => match part()? {
                Part::There(Value::Number(x)) => Ok(Part::There(Value::Number(x.abs()))),
                vector => map(squared(vector)?, f64::sqrt),
            },
            (Unary::Degrees, _) => map(part()?, f64::to_radians),
            (Unary::Function(function), _) => map(part()?, |x| functions::of(function, x)),
            (Unary::ExtremeComponent(which), _) => match part()? {
                Part::There(Value::Triple([x, y, z])) => {
                    Ok(Part::There(Value::Number(extreme(which, x, extreme(which, y, z)))))
                }
                part => Err(format!("{which:?}({part:?})")),
            },
        }
    }

    fn number(&self, formula: &Formula) -> Result<f64, String> {
        match self.part(formula)? {
            Part::There(Value::Number(x)) => Ok(x),
            Part::Zero => Ok(0.0),
            part => Err(format!("{part:?} is no number")),
        }
    }

    /// What is written as a product: that of two triples is a dot product, whose own products may be rounded.
    fn binary(&self, operator: Operator, left: Part, right: Part) -> Result<Part, String> {
        match (operator, left, right, self.decimals_of_products) {
            (Operator::Times, Part::There(Value::Triple(a)), Part::There(Value::Triple(b)), Some(digits)) => {
                let [x, y, z] = [0, 1, 2].map(|i| round_half_away(a[i] * b[i], digits));
                Ok(Part::There(Value::Number(x + y + z)))
            }
            _ => binary(operator, left, right),
        }
    }

    fn operand(&self, symbol: &'static str) -> Result<Part, String> {
        match (self.operands)(symbol, self.light) {
            Some(value) => Ok(Part::There(value)),
            None if scope::is_one_when_absent(symbol) => Ok(Part::One),
            None if self.light.is_some() => Ok(Part::Zero),
            None => Err(format!("the log holds no `{symbol}`")),
        }
    }

    /// Σ goes on with the sum before it, one light after the other.
    fn over_lights(&self, before: Part, term: &Formula) -> Result<Part, String> {
        if !scope::is_added_up(self.events, self.tree, self.event) {
            return Err(too_many_sums());
        }
        scope::lights(self.events, self.tree, self.event).try_fold(before, |sum, light| {
            let term = Evaluator { light: Some(light), ..*self }.part(term)?;
            binary(Operator::Plus, sum, term)
        })
    }
}

fn too_many_sums() -> String {
    "its node has too many sums".to_owned()
}

fn map(part: Part, f: impl Fn(f64) -> f64) -> Result<Part, String> {
    Ok(match part {
        Part::There(value) => Part::There(value.map(f)),
        Part::Zero => Part::Zero,
        Part::One => return Err("an absent factor outside a product".to_owned()),
    })
}

fn squared(part: Part) -> Result<Part, String> {
    binary(Operator::Times, part, part)
}

fn binary(operator: Operator, left: Part, right: Part) -> Result<Part, String> {
    let result = match (left, right) {
        (Part::There(left), Part::There(right)) => operate(operator, left, right).map(Part::There),
        (left, right) => Part::without(operator, left, right),
    };
    result.ok_or_else(|| format!("{left:?} {operator:?} {right:?}"))
}

fn operate(operator: Operator, left: Value, right: Value) -> Option<Value> {
    use Value::{Number, Triple};
    let zipped = |a: [f64; 3], b: [f64; 3], f: &dyn Fn(f64, f64) -> f64| Triple([0, 1, 2].map(|i| f(a[i], b[i])));
    Some(match (operator, left, right) {
        (Operator::Channelwise, Triple(a), Triple(b)) => zipped(a, b, &|a, b| a * b),
        (Operator::Channelwise, Triple(a), Number(b)) | (Operator::Channelwise, Number(b), Triple(a)) => {
            Triple(a.map(|x| x * b))
        }
        (Operator::ComponentsOver, Triple(a), Triple(b)) => zipped(a, b, &|a, b| match a / b {
            quotient if quotient.is_nan() => 0.0,
            quotient if quotient.is_infinite() => f64::MAX.copysign(quotient),
            quotient => quotient,
        }),
        (Operator::Power, Number(a), Number(b)) => Number(libm::pow(a, b)),
        (Operator::Extreme(which), Number(a), Number(b)) => Number(extreme(which, a, b)),
        (Operator::Extreme(which), Triple(a), Triple(b)) => zipped(a, b, &|a, b| extreme(which, a, b)),
        _ => return Amount::from(left).with(operator, right.into()).map(Value::from),
    })
}

/// The extreme of two numbers; of two equal ones (0 and −0) the second.
fn extreme(extreme: Extreme, a: f64, b: f64) -> f64 {
    let takes_first = match extreme {
        Extreme::Min => a < b,
        Extreme::Max => a > b,
    };
    if takes_first { a } else { b }
}
