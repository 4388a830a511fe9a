//! What must be so for a breakpoint to stop.

use super::kind;
use crate::log::event::field::Id;
use crate::log::{Event, Name, RayKind, Step, Value, What};
use crate::report::Style;
use crate::report::side_by_side::Run;
use crate::tui::model::quantity::{self, Part};

/// What an event must be.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// Of this kind (see [`kind::WORDS`]).
    Kind(&'static str),
    /// About one of the objects with these numbers: a node of it, or a decision that names it.
    Object(Vec<u32>),
    /// About one of the lights with these numbers: its node, a shadow ray to it, or a decision that names it.
    Light(Vec<u32>),
    /// The beginning of a ray on such a level of the ray tree; a shadow ray has its surface's.
    Depth(Operator, u32),
    /// A quantity, perhaps with a certain value.
    Quantity(Quantity),
    /// All of these: one of them happens, and the others hold where it does.
    All(Vec<Condition>),
    /// One of these.
    Any(Vec<Condition>),
}

/// A quantity that must have a certain value.
#[derive(Clone, Debug, PartialEq)]
pub struct Quantity {
    /// The quantity by any of its formulas, or all of a symbol.
    pub names: Vec<Name>,
    /// Which number of it is compared.
    pub part: Part,
    /// What it must be; without it every value stops.
    pub test: Option<Test>,
}

/// What a value must be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Test {
    /// As another number compares.
    Compared(Operator, f64),
    /// Of a class of numbers, or not.
    Is {
        /// Which class.
        class: Class,
        /// Whether it must not be.
        is_negated: bool,
    },
}

/// A class of numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// No number: of a triple one component at least.
    Nan,
    /// Infinite: of a triple one component at least.
    Infinite,
    /// Finite: of a triple all components.
    Finite,
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

    /// Whether it stops at an event of a log; `style` says how many decimals are shown.
    pub fn stops_at(&self, run: Run, at: usize, style: Style) -> bool {
        match self {
            Condition::All(parts) => {
                // A place such as a depth only says where the values and the decisions beside it count.
                let has_moments = self.is_moment();
                let mut stopping = parts.iter().filter(|part| !has_moments || part.is_moment());
                stopping.any(|part| part.stops_at(run, at, style)) && self.holds(run, at, style)
            }
            Condition::Any(parts) => parts.iter().any(|part| part.stops_at(run, at, style)),
            single => run.log.events.get(at).is_some_and(|event| single.is_event(event, style)),
        }
    }

    /// Whether an event is so by itself.
    fn is_event(&self, event: &Event, style: Style) -> bool {
        match self {
            Condition::Kind(word) => kind::of(&event.what).contains(word),
            Condition::Object(numbers) => {
                names(&event.what, |id| matches!(id, Id::Object(object) if numbers.contains(object)))
            }
            Condition::Light(numbers) => {
                names(&event.what, |id| matches!(id, Id::Light(light) if numbers.contains(light)))
            }
            Condition::Depth(operator, depth) => match event.what {
                What::Enter { step: Step::Ray { depth: own, .. }, .. } => {
                    operator.holds(own.into(), (*depth).into(), style)
                }
                _ => false,
            },
            Condition::Quantity(quantity) => match &event.what {
                What::Note { name, value } => quantity.names.contains(name) && quantity.holds(value, style),
                _ => false,
            },
            Condition::All(_) | Condition::Any(_) => false,
        }
    }

    /// Whether it is so where an event happens: the event itself, the nodes around it, the latest value that is seen there.
    fn holds(&self, run: Run, at: usize, style: Style) -> bool {
        match self {
            Condition::All(parts) => return parts.iter().all(|part| part.holds(run, at, style)),
            Condition::Any(parts) => return parts.iter().any(|part| part.holds(run, at, style)),
            _ => {}
        }
        let Some(event) = run.log.events.get(at) else { return false };
        self.is_event(event, style) || self.is_around(run, at, style)
    }

    fn is_around(&self, run: Run, at: usize, style: Style) -> bool {
        let steps = || run.tree.around(run.tree.owner(at)).filter_map(|node| run.tree.nodes()[node].step);
        let ray = || steps().find(|step| matches!(step, Step::Ray { .. }));
        match self {
            Condition::Kind(word) if RayKind::WORDS.contains(word) => {
                ray().is_some_and(|ray| kind::of_step(&ray).contains(word))
            }
            Condition::Kind(word) => kind::is_node(word) && steps().any(|step| kind::of_step(&step).contains(word)),
            Condition::Object(numbers) => steps().find_map(object).is_some_and(|object| numbers.contains(&object)),
            Condition::Light(numbers) => steps().find_map(light).is_some_and(|light| numbers.contains(&light)),
            Condition::Depth(operator, depth) => match ray() {
                Some(Step::Ray { depth: own, .. }) => operator.holds(own.into(), (*depth).into(), style),
                _ => false,
            },
            Condition::Quantity(quantity) => {
                let events = &run.log.events;
                let is_noted = matches!(events[at].what, What::Note { name, .. } if quantity.names.contains(&name));
                // Its own value is the latest.
                let latest = || quantity::latest(events, run.tree, at, &quantity.names);
                !is_noted && latest().is_some_and(|latest| quantity.holds(&latest.value, style))
            }
            Condition::All(_) | Condition::Any(_) => false,
        }
    }

    /// Whether it is about a value or a decision, not about a place.
    fn is_moment(&self) -> bool {
        match self {
            Condition::Kind(word) => !kind::is_node(word),
            Condition::Quantity(_) => true,
            Condition::Object(_) | Condition::Light(_) | Condition::Depth(..) => false,
            Condition::All(parts) | Condition::Any(parts) => parts.iter().any(Condition::is_moment),
        }
    }

    /// Whether it has several terms.
    pub fn is_compound(&self) -> bool {
        matches!(self, Condition::All(_) | Condition::Any(_))
    }

    /// Whether that an event is so would tell its value or what was decided; that it computes a quantity doesn't.
    pub fn tells(&self, what: &What) -> bool {
        let tests = matches!(self, Condition::Quantity(Quantity { test: Some(_), .. }));
        matches!(what, What::Mark(_)) || tests || (self.is_compound() && self.may_tell())
    }

    /// Whether there may be events of which it would tell that.
    pub fn may_tell(&self) -> bool {
        match self {
            Condition::Kind(word) => !kind::is_open(word),
            Condition::Object(_) => true,
            Condition::Light(_) | Condition::Depth(..) => false,
            Condition::Quantity(quantity) => quantity.test.is_some(),
            Condition::All(parts) | Condition::Any(parts) => parts.iter().any(Condition::may_tell),
        }
    }
}

/// The object that a node is about.
fn object(step: Step) -> Option<u32> {
    let mut found = None;
    What::Enter { parent: 0, step }.each_id(&mut |id| match id {
        Id::Object(object) => found = found.or(Some(*object)),
        Id::Light(_) => {}
    });
    found
}

/// The light that a node is about.
fn light(step: Step) -> Option<u32> {
    let mut found = None;
    What::Enter { parent: 0, step }.each_id(&mut |id| match id {
        Id::Light(light) => found = found.or(Some(*light)),
        Id::Object(_) => {}
    });
    found
}

impl Quantity {
    fn holds(&self, value: &Value, style: Style) -> bool {
        let Some(test) = self.test else { return true };
        match (test, self.part) {
            (Test::Compared(operator, limit), part) => {
                part.of(value).is_some_and(|number| operator.holds(number, limit, style))
            }
            (Test::Is { class, is_negated }, Part::Whole) => class.has(value.components()) != is_negated,
            (Test::Is { class, is_negated }, part) => {
                part.of(value).is_some_and(|number| class.has(&[number]) != is_negated)
            }
        }
    }
}

impl Class {
    fn has(self, numbers: &[f64]) -> bool {
        match self {
            Class::Nan => numbers.iter().any(|x| x.is_nan()),
            Class::Infinite => numbers.iter().any(|x| x.is_infinite()),
            Class::Finite => numbers.iter().all(|x| x.is_finite()),
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
