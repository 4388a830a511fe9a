//! What differs between two logs, where first, and why.
//!
//! Logs are compared a pixel at a time, so that a region takes the memory of its largest pixel. `align` says which step of one log is
//! which of the other, `tolerance` which values count as different, `cause` where a difference comes from; `text` and `json` show it.

mod align;
mod before;
mod cause;
mod changed;
mod headers;
mod json;
mod kinds;
mod operands;
mod rows;
mod summary;
mod text;
mod tolerance;

pub use align::{Item, Spot};
pub use cause::Why;
pub use headers::{HeaderDifference, Numbering, header_differences};
pub use json::Json;
pub use rows::{Row, Rows};
pub use summary::{Pixel, Summary};
pub use text::Text;
pub use tolerance::{Distance, Tolerance, distance};

use super::language::Language;
use super::side_by_side::Run;
use super::{Style, computation, words};
use crate::log::{Header, Name, Step, Value, What};
use cause::{Causes, Contribution};
use serde::Serialize;
use std::rc::Rc;

/// What differs in a pixel, or between two rays.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// How many values both logs have, inputs among them.
    pub values: usize,
    /// What differs, in the order of the computation.
    pub differences: Vec<Difference>,
    /// The inputs of the scene that differ, as the scene calls them.
    pub changed: Vec<Changed>,
    /// More about the first difference; about a test that only one log has only where nothing else differs.
    pub first: Option<First>,
    /// From where the difference of the colour comes, up to the colour: always along the largest effect. Empty if the colour is the
    /// same.
    pub way: Vec<Entry>,
}

/// An input of the scene that isn't the same in both logs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Changed {
    /// What it is, such as `lights.F.position`, or `lights.F` where the light is of another kind.
    pub input: String,
    /// What it is in A.
    pub a: String,
    /// What it is in B.
    pub b: String,
}

/// Something in the logs.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// The path of its ray, such as `C R S1`.
    pub path: String,
    /// The node in which it is, such as `test sphere`; empty for the ray's own.
    pub node: String,
    /// What it is.
    pub what: Statement,
}

/// What two logs say in one place.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// A value.
    Value {
        /// The quantity; `None` for the result and for how much light a surface lets pass.
        name: Option<Name>,
        /// Whether it is an input, which no step computed.
        is_input: bool,
        /// Its value in A.
        a: Value,
        /// Its value in B.
        b: Value,
        /// How far they are apart.
        distance: Distance,
    },
    /// A decision, as a sentence.
    Decision {
        /// That of A.
        a: String,
        /// That of B.
        b: String,
    },
    /// What only one log has.
    Only {
        /// Which log.
        side: Side,
        /// What it is, such as `test sphere` or `sphere.t = 10.718`.
        what: String,
        /// How many values it holds.
        values: usize,
    },
}

/// One of the two logs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Side {
    /// The first.
    A,
    /// The second.
    B,
}

/// A difference and its cause.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// What differs.
    pub entry: Entry,
    /// Why.
    pub why: Why,
    /// What it comes from directly, the largest effect first: each with how far the value moves when only this is taken from B.
    pub from: Vec<(Entry, f64)>,
    /// How far the values are apart for other reasons.
    pub own: f64,
    /// Where that comes from in the end; `None` if it is the difference itself.
    pub origin: Option<Entry>,
    /// The object or light that is of another kind, if it comes from that in the end.
    pub kind: Option<Changed>,
}

/// The first difference in full.
#[derive(Clone, Debug, PartialEq)]
pub struct First {
    /// How A and B compute it, with the numbers put in; `None` for what isn't computed.
    pub computations: Option<[String; 2]>,
    /// The way back to where it comes from; the difference itself is the first.
    pub way: Vec<Entry>,
    /// Why the last of them differs.
    pub why: Why,
    /// The object or light that is of another kind, if that is why.
    pub kind: Option<Changed>,
}

/// A format of comparisons, which is written piece by piece.
pub trait Format {
    /// What the logs are, and what their headers say differently.
    fn begin(&mut self, a: &Header, b: &Header, differences: &[HeaderDifference]) -> String;

    /// A pixel that both logs have; nothing if it is the same in both.
    fn pixel(&mut self, pixel: Pixel, found: &Comparison) -> String;

    /// A pixel that only one log has.
    fn alone(&mut self, pixel: Pixel, side: Side) -> String;

    /// The counts.
    fn end(&self, summary: &Summary) -> String;
}

/// Compares the logs of a pixel or ray. Their objects and lights must have the same numbers, see [`Numbering`].
pub fn compare(a: Run, b: Run, tolerance: &Tolerance) -> Comparison {
    let alignment = Rc::new(align::align(a, b));
    let comparing = Comparing { causes: Causes::of(a, b, alignment.clone()), tolerance: *tolerance };
    let spots: Vec<Spot> = alignment.spots.iter().copied().filter(|spot| comparing.differs(*spot)).collect();
    let values = alignment.spots.iter().filter(|spot| before::values_of(a, b, **spot).is_some()).count();
    // A test that the other tracer didn't need is reported first only where nothing else differs.
    let first = spots.iter().find(|spot| !comparing.causes.is_test_alone(**spot)).or(spots.first());
    Comparison {
        values,
        changed: changed::changed(a, b, &alignment, tolerance),
        differences: spots.iter().map(|spot| comparing.difference(*spot)).collect(),
        first: first.map(|spot| comparing.first(*spot)),
        way: comparing.way_to_the_color(&spots),
    }
}

/// What of B isn't as it is in A.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Differing {
    /// The events of B that differ, or that A doesn't have.
    pub events: Vec<usize>,
    /// How many values, decisions and nodes differ, those that only A has too.
    pub count: usize,
    /// What the first is called, and where it is.
    pub first: Option<String>,
}

/// What differs between two logs, in short. Their objects and lights must have the same numbers, see [`Numbering`].
pub fn differing(a: Run, b: Run) -> Differing {
    let alignment = Rc::new(align::align(a, b));
    let comparing = Comparing { causes: Causes::of(a, b, alignment.clone()), tolerance: Tolerance::default() };
    let spots: Vec<Spot> = alignment.spots.iter().copied().filter(|spot| comparing.differs(*spot)).collect();
    let event = |spot: &Spot| match spot {
        Spot::Both(_, Item::Event(event) | Item::Input(event, _))
        | Spot::OnlyB(Item::Event(event) | Item::Input(event, _)) => Some(*event),
        Spot::OnlyB(Item::Node(node)) => Some(b.tree.nodes()[*node].events.start),
        Spot::Both(_, Item::Node(_)) | Spot::OnlyA(_) => None,
    };
    let first = spots.first().map(|spot| match *spot {
        Spot::Both(..) => text::label_with_path(&comparing.entry(*spot)),
        Spot::OnlyA(item) => place(a, item),
        Spot::OnlyB(item) => place(b, item),
    });
    Differing { events: spots.iter().filter_map(event).collect(), count: spots.len(), first }
}

/// Where something is that only one log has, in words of no language: its path, and the key of a value.
fn place(run: Run, item: Item) -> String {
    let (node, name) = match item {
        Item::Node(node) => (node, None),
        Item::Event(event) | Item::Input(event, _) => {
            (run.tree.owner(event), run.log.events[event].noted().map(|(name, _)| name.key()))
        }
    };
    let path = run.tree.path(node);
    name.map_or(path.clone(), |key| format!("{key} ({path})"))
}

struct Comparing<'a> {
    causes: Causes<'a>,
    tolerance: Tolerance,
}

impl Comparing<'_> {
    fn differs(&self, spot: Spot) -> bool {
        let (a, b) = (self.causes.a, self.causes.b);
        match (before::values_of(a, b, spot), spot) {
            (Some((ours, theirs)), _) => self.tolerance.tells_apart(&ours, &theirs),
            (None, Spot::Both(Item::Event(ours), Item::Event(theirs))) => {
                before::differ_as_decisions(a, ours, b, theirs)
            }
            (None, Spot::Both(..)) => false,
            (None, Spot::OnlyA(_) | Spot::OnlyB(_)) => !self.tolerance.is_of_common,
        }
    }

    fn difference(&self, spot: Spot) -> Difference {
        let attribution = self.causes.attribution(spot);
        let from = match (&attribution.operands[..], attribution.from) {
            ([], Some(from)) => vec![(self.entry(from), 0.0)],
            (operands, _) => {
                operands.iter().map(|Contribution { spot, effect }| (self.entry(*spot), *effect)).collect()
            }
        };
        let last = self.causes.origin(spot);
        let origin = Some(last).filter(|last| *last != spot).map(|last| self.entry(last));
        let kind = self.causes.attribution(last).kind.clone();
        Difference { entry: self.entry(spot), why: attribution.why, from, own: attribution.own, origin, kind }
    }

    fn first(&self, spot: Spot) -> First {
        let way = self.causes.way_back(spot);
        let last = way.last().map(|last| self.causes.attribution(*last));
        let why = last.as_ref().map_or(Why::First, |last| last.why);
        let kind = last.and_then(|last| last.kind.clone());
        First {
            computations: self.computations(spot),
            way: way.into_iter().map(|spot| self.entry(spot)).collect(),
            why,
            kind,
        }
    }

    fn way_to_the_color(&self, differing: &[Spot]) -> Vec<Entry> {
        let is_result = |spot: &&Spot| match spot {
            Spot::Both(Item::Event(a), _) => matches!(self.causes.a.log.events[*a].what, What::Result { .. }),
            _ => false,
        };
        let Some(result) = differing.iter().rev().find(is_result) else { return Vec::new() };
        let way = self.causes.way_back(*result);
        way.into_iter().rev().map(|spot| self.entry(spot)).collect()
    }

    /// How both logs compute a quantity, with as many digits as tell the two apart.
    fn computations(&self, spot: Spot) -> Option<[String; 2]> {
        let Spot::Both(Item::Event(ours), Item::Event(theirs)) = spot else { return None };
        let (value_a, value_b) = before::values_of(self.causes.a, self.causes.b, spot)?;
        let attribution = self.causes.attribution(spot);
        let operands = attribution.operands.iter();
        let operands = operands.filter_map(|operand| before::values_of(self.causes.a, self.causes.b, operand.spot));
        let values: Vec<_> = operands.chain([(value_a, value_b)]).collect();
        // The numbers put in must tell what the result is from.
        let digits = values.iter().map(|(a, b)| telling_apart(a, b, self.tolerance.digits).digits).max();
        let style = digits.map_or(Style::default(), |digits| Style::default().with(digits));
        let line = |run: Run, event| {
            let style = style.within(&run.log.header);
            computation(Language::English, run.log, run.tree, event, style).map(|computation| computation.line())
        };
        Some([line(self.causes.a, ours)?, line(self.causes.b, theirs)?])
    }

    fn entry(&self, spot: Spot) -> Entry {
        let (a, b) = (self.causes.a, self.causes.b);
        match spot {
            Spot::Both(ours, theirs) => {
                let what = match before::values_of(a, b, spot) {
                    Some((value_a, value_b)) => Statement::Value {
                        name: quantity(a, ours),
                        is_input: matches!((ours, theirs), (Item::Input(..), Item::Input(..))),
                        a: value_a,
                        b: value_b,
                        distance: distance(&value_a, &value_b),
                    },
                    None => Statement::Decision { a: decision(a, ours), b: decision(b, theirs) },
                };
                entry_in(a, ours, what)
            }
            Spot::OnlyA(item) => entry_in(a, item, alone(a, Side::A, item)),
            Spot::OnlyB(item) => entry_in(b, item, alone(b, Side::B, item)),
        }
    }
}

/// The style with the fewest decimals, at least those that are asked for, or else 3, that show two values differently.
pub fn telling_apart(a: &Value, b: &Value, digits: Option<u32>) -> Style {
    super::number::telling(a, b, digits.map_or(Style::default(), |digits| Style::default().with(digits)))
}

fn entry_in(run: Run, item: Item, what: Statement) -> Entry {
    let nodes = run.tree.nodes();
    let node = match item {
        // A node is in the one around it; a ray says its own path.
        Item::Node(node) if !matches!(nodes[node].step, Some(Step::Ray { .. })) => nodes[node].parent,
        item => item.owner(run),
    };
    let title = match nodes[node].step {
        None | Some(Step::Ray { .. } | Step::Sample { .. }) => String::new(),
        Some(_) => words::title(Language::English, run.log, run.tree, node),
    };
    Entry { path: run.tree.shown_path(node), node: title, what }
}

fn quantity(run: Run, item: Item) -> Option<Name> {
    match item {
        Item::Event(event) => run.log.events[event].noted().map(|(name, _)| name),
        Item::Input(event, number) => Some(run.log.given(event)[number].0),
        Item::Node(_) => None,
    }
}

/// A decision as a sentence; nothing for what is none.
fn decision(run: Run, item: Item) -> String {
    let Item::Event(event) = item else { return String::new() };
    let decision = run.log.events[event].decision();
    decision.map_or_else(String::new, |decision| {
        words::decision(Language::English, &run.log.header, &decision, Style::default())
    })
}

fn alone(run: Run, side: Side, item: Item) -> Statement {
    let (what, values) = only(run, item);
    Statement::Only { side, what, values }
}

/// What only one log has, in a few words, and how many values it holds.
fn only(run: Run, item: Item) -> (String, usize) {
    let is_value = |event: &usize| matches!(run.log.events[*event].what, What::Note { .. });
    match (item, quantity(run, item), before::value(run, item)) {
        (Item::Node(node), ..) => {
            let events = run.tree.nodes()[node].events.clone();
            (words::title(Language::English, run.log, run.tree, node), events.filter(is_value).count())
        }
        (_, Some(name), Some(value)) => {
            (format!("{} = {}", name.key(), Language::English.value(&value, Style::default())), 1)
        }
        (Item::Event(event), ..) if matches!(run.log.events[event].what, What::Result { .. }) => {
            ("result".to_owned(), 1)
        }
        _ => (decision(run, item), 0),
    }
}
