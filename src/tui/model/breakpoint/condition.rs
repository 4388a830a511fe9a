//! What must be so for a breakpoint to stop.

use super::kind;
use crate::log::event::field::Id;
use crate::log::{Event, Name, Step, Value, What};
use crate::report::Style;

/// What an event must be.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// Of this kind (see [`kind::WORDS`]).
    Kind(&'static str),
    /// About one of the objects with these numbers: a node of it, or a decision that names it.
    Object(Vec<u32>),
    /// About one of the lights with these numbers: its node, a shadow ray to it, or a decision that names it.
    Light(Vec<u32>),
    /// The beginning of a ray on this level of the ray tree; a shadow ray has its surface's.
    Depth(u32),
    /// A quantity, perhaps with a certain value.
    Quantity(Quantity),
}

/// A quantity that must have a certain value.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The quantity by any of its formulas, or all of a symbol.
    pub names: Vec<Name>,
    /// Which number of it is compared.
    pub part: Part,
    /// With what; without it every value stops.
    pub test: Option<(Operator, f64)>,
}

/// A number of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The number itself.
    Whole,
    /// A component of a triple.
    Component(usize),
    /// The length of a triple, the magnitude of a number.
    Length,
}

/// How two numbers compare.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Operator {
    Below,
    AtMost,
    Above,
    AtLeast,
    Equal,
    Unequal,
    /// Equal as far as it is shown: they differ by at most half a unit of the last decimal that is shown, or by 10⁻⁹ if
    /// that is more.
    Near,
}

impl Condition {
    /// Every value of the quantity with this key.
    pub fn of_quantity(key: &str) -> Condition {
        let names = Name::all().filter(|name| name.key() == key).collect();
        Condition::Quantity(Quantity { names, part: Part::Whole, test: None })
    }

    /// Whether an event is so; `style` says how many decimals are shown.
    pub fn holds(&self, event: &Event, style: Style) -> bool {
        match self {
            Condition::Kind(word) => kind::of(&event.what).contains(word),
            Condition::Object(numbers) => {
                names(&event.what, |id| matches!(id, Id::Object(object) if numbers.contains(object)))
            }
            Condition::Light(numbers) => {
                names(&event.what, |id| matches!(id, Id::Light(light) if numbers.contains(light)))
            }
            Condition::Depth(depth) => match event.what {
                What::Enter { step: Step::Ray { depth: own, .. }, .. } => own == *depth,
                _ => false,
            },
            Condition::Quantity(quantity) => match &event.what {
                What::Note { name, value } => quantity.names.contains(name) && quantity.holds(value, style),
                _ => false,
            },
        }
    }

    /// Whether that an event is so would tell its value or what was decided; that it computes a quantity doesn't.
    pub fn tells(&self, what: &What) -> bool {
        let tests = matches!(self, Condition::Quantity(Quantity { test: Some(_), .. }));
        matches!(what, What::Mark(_)) || tests
    }

    /// Whether there may be events of which it would tell that.
    pub fn may_tell(&self) -> bool {
        match self {
            Condition::Kind(word) => !kind::is_open(word),
            Condition::Object(_) => true,
            Condition::Light(_) | Condition::Depth(_) => false,
            Condition::Quantity(quantity) => quantity.test.is_some(),
        }
    }
}

impl Quantity {
    fn holds(&self, value: &Value, style: Style) -> bool {
        let Some((operator, limit)) = self.test else { return true };
        self.part.of(value).is_some_and(|number| operator.holds(number, limit, style))
    }
}

impl Part {
    /// This number of a value, if it has it.
    pub fn of(self, value: &Value) -> Option<f64> {
        match (self, value) {
            (Part::Whole, Value::Number(number)) => Some(*number),
            (Part::Component(index), Value::Triple(triple)) => Some(triple[index]),
            (Part::Length, Value::Number(number)) => Some(number.abs()),
            (Part::Length, Value::Triple([x, y, z])) => Some((x * x + y * y + z * z).sqrt()),
            _ => None,
        }
    }
}

impl Operator {
    fn holds(self, number: f64, limit: f64, style: Style) -> bool {
        match self {
            Operator::Below => number < limit,
            Operator::AtMost => number <= limit,
            Operator::Above => number > limit,
            Operator::AtLeast => number >= limit,
            Operator::Equal => number == limit,
            Operator::Unequal => number != limit,
            Operator::Near => (number - limit).abs() <= tolerance(style),
        }
    }
}

/// How near is near.
fn tolerance(style: Style) -> f64 {
    let unit = (0..style.digits).fold(1.0, |unit, _| unit / 10.0);
    f64::max(1e-9, unit / 2.0)
}

/// Whether it names such an object or light.
fn names(what: &What, is_it: impl Fn(&Id) -> bool) -> bool {
    let mut found = false;
    what.clone().each_id(&mut |id| found |= is_it(&id));
    found
}
