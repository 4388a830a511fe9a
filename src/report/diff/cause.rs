//! Why a quantity differs: which of its operands explain it, back to where the difference comes from.
//!
//! The formula of a quantity is evaluated with A's operands, and again with one operand at a time taken from B. How far the value
//! moves is the operand's effect. What the operands don't explain is the quantity's own: its rounding, or another way of computing
//! it. The largest of these is the cause.

use super::Changed;
use super::align::{Alignment, Item, Spot, computed};
use super::before::Before;
use super::kinds::Kinds;
use super::operands::{Pair, Substitution};
use super::tolerance::distance;
use crate::log::scope::Operand;
use crate::log::{Name, RayKind, Step, Value, What};
use crate::report::evaluate::evaluate;
use crate::report::provenance;
use crate::report::side_by_side::Run;
use serde::Serialize;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::rc::Rc;

/// What explains that something differs.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Attribution {
    pub why: Why,
    /// What it comes from; `None` where it comes from nothing else.
    pub from: Option<Spot>,
    /// The operands that differ, the largest effect first.
    pub operands: Vec<Contribution>,
    /// How far the values are apart for other reasons than the operands.
    pub own: f64,
    /// The object or light that is of another kind, if that is why.
    pub kind: Option<Changed>,
}

/// What kind of cause something has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Why {
    /// Its operands differ, and this has the largest effect.
    Operands,
    /// The quantity itself: its rounding, or there is no formula that tells.
    Itself,
    /// The two logs compute it by different formulas.
    OtherFormula,
    /// It is an input, which no step of the logs computed.
    Input,
    /// What was decided, or computed, before it.
    Before,
    /// Nothing before it differs.
    First,
    /// A test that only one log has: the other's tracer didn't need it.
    NotNeeded,
    /// A test with an object that the other scene doesn't have.
    NoSuchObject,
    /// The object, or the light, is of another kind in the other scene.
    OtherKind,
}

/// An operand that a difference comes from.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Contribution {
    pub spot: Spot,
    /// How far the value moves when only this is taken from B: the largest component.
    pub effect: f64,
}

/// Two aligned logs, and why they differ.
pub(super) struct Causes<'a> {
    pub a: Run<'a>,
    pub b: Run<'a>,
    alignment: Rc<Alignment>,
    before: Before<'a>,
    kinds: Rc<Kinds>,
    known: RefCell<HashMap<Spot, Rc<Attribution>>>,
    /// Where ways back end.
    origins: RefCell<HashMap<Spot, Spot>>,
}

impl<'a> Causes<'a> {
    pub fn of(a: Run<'a>, b: Run<'a>, alignment: Rc<Alignment>) -> Causes<'a> {
        let kinds = Rc::new(Kinds::of(a, b, &alignment));
        let before = Before::of(a, b, alignment.clone(), kinds.clone());
        Causes { a, b, alignment, before, kinds, known: RefCell::default(), origins: RefCell::default() }
    }

    /// Whether this is a test that only one log has.
    pub fn is_test_alone(&self, spot: Spot) -> bool {
        self.before.is_test_alone(spot)
    }

    /// The node of B in the place of a node of A.
    pub fn partner(&self, node: usize) -> Option<usize> {
        self.alignment.nodes[node]
    }

    /// Why this differs.
    pub fn attribution(&self, spot: Spot) -> Rc<Attribution> {
        if let Some(known) = self.known.borrow().get(&spot) {
            return known.clone();
        }
        let found = Rc::new(self.explain(spot));
        self.known.borrow_mut().insert(spot, found.clone());
        found
    }

    /// The way from this back to where its difference comes from, always along the largest effect; this itself is the first.
    pub fn way_back(&self, spot: Spot) -> Vec<Spot> {
        let mut way = vec![spot];
        let mut seen = HashSet::from([spot]);
        while let Some(next) = way.last().and_then(|last| self.attribution(*last).from) {
            if !seen.insert(next) {
                break;
            }
            way.push(next);
        }
        way
    }

    /// The last place of that way. Each part of a way is gone only once, however many lead into it.
    pub fn origin(&self, spot: Spot) -> Spot {
        let mut origins = self.origins.borrow_mut();
        let (mut way, mut places, mut at) = (Vec::new(), HashMap::new(), spot);
        let origin = loop {
            if let Some(known) = origins.get(&at) {
                break *known;
            }
            if let Some(entry) = places.insert(at, way.len()) {
                // In a circle a way ends just before it would come to a place again.
                let circle: Vec<Spot> = way.split_off(entry);
                let before = circle.iter().cycle().skip(circle.len() - 1);
                origins.extend(circle.iter().copied().zip(before.copied()));
                break origins.get(&at).copied().unwrap_or(at);
            }
            way.push(at);
            match self.attribution(at).from {
                Some(next) => at = next,
                None => break at,
            }
        };
        origins.extend(way.into_iter().map(|place| (place, origin)));
        origins.get(&spot).copied().unwrap_or(origin)
    }

    fn explain(&self, spot: Spot) -> Attribution {
        if let Some(kind) = self.before.home(spot).and_then(|home| self.kinds.cause_of(self.a, self.b, home, spot)) {
            return Attribution { kind: Some(kind.clone()), ..bare(Why::OtherKind) };
        }
        match spot {
            Spot::Both(Item::Event(a), Item::Event(b)) => {
                match (&self.a.log.events[a].what, &self.b.log.events[b].what) {
                    (What::Note { name: ours, value: our_value }, What::Note { name: theirs, value: their_value }) => {
                        self.of_quantity(spot, (a, *ours, *our_value), (b, *theirs, *their_value))
                    }
                    (What::Result { .. }, What::Result { .. }) => self.of_result(spot),
                    _ => self.by_what_was_before(spot, Why::First),
                }
            }
            Spot::Both(ours, theirs) => {
                // What only one log computed comes from there.
                let part = |run, item| computed(run, item).map(Item::Event);
                let of_a = part(self.a, ours).and_then(|ours| self.part_of_a(ours));
                match of_a.or_else(|| part(self.b, theirs).and_then(|theirs| self.part_of_b(theirs))) {
                    Some(from) => Attribution { from: Some(from), ..bare(Why::Before) },
                    None => bare(Why::Input),
                }
            }
            Spot::OnlyA(_) | Spot::OnlyB(_) if self.before.is_test_alone(spot) => {
                bare(if self.before.is_of_one_scene(spot) { Why::NoSuchObject } else { Why::NotNeeded })
            }
            Spot::OnlyA(Item::Input(..)) | Spot::OnlyB(Item::Input(..)) => self.by_what_was_before(spot, Why::Input),
            Spot::OnlyA(_) | Spot::OnlyB(_) => self.by_what_was_before(spot, Why::First),
        }
    }

    fn by_what_was_before(&self, spot: Spot, otherwise: Why) -> Attribution {
        match self.before.of_spot(spot) {
            Some(from) => Attribution { from: Some(from), ..bare(Why::Before) },
            None => bare(otherwise),
        }
    }

    fn of_quantity(&self, spot: Spot, ours: (usize, Name, Value), theirs: (usize, Name, Value)) -> Attribution {
        let ((a, our_name, our_value), (b, their_name, their_value)) = (ours, theirs);
        let substitution = Substitution::of(self.a, self.b, &self.alignment, (a, our_name), (b, their_name));
        let Some(substitution) = substitution else { return self.by_what_was_before(spot, Why::Itself) };
        let with_ours = substitution.value(|_| false);
        let with_theirs = substitution.value(|_| true);
        let computed_there = evaluate(self.b.log, self.b.tree, b, their_name);
        let computed_there = computed_there.and_then(Result::ok).or(with_theirs);
        let contribution = |number: usize| {
            let moved = substitution.value(|other| other == number);
            let place = self.spot_of(spot, (a, b), &substitution.pairs[number]).or_else(|| self.before.of_spot(spot));
            place.map(|spot| Contribution { spot, effect: apart(with_ours, moved) })
        };
        let operands = by_effect(substitution.differing().into_iter().filter_map(contribution).collect());
        let own = match (with_ours, computed_there) {
            (Some(ours), Some(theirs)) => apart(Some(minus(our_value, ours)), Some(minus(their_value, theirs))),
            _ => 0.0,
        };
        let by_formula = match (with_theirs, computed_there) {
            (Some(_), Some(_)) => apart(with_theirs, computed_there),
            // A formula that can't be evaluated on the operands of the other log is another one.
            _ if our_name != their_name => f64::INFINITY,
            _ => 0.0,
        };
        // Where no single operand moves the value, several do together.
        let largest = operands.first().filter(|largest| largest.effect >= own.max(by_formula));
        match largest.map(|largest| largest.spot) {
            from @ Some(_) => Attribution { from, operands, own, ..bare(Why::Operands) },
            None if by_formula > own => {
                let from = self.before.of_spot(spot).or_else(|| operands.first().map(|operand| operand.spot));
                Attribution { from, operands, own: by_formula, ..bare(Why::OtherFormula) }
            }
            None => Attribution { operands, own, ..bare(Why::Itself) },
        }
    }

    /// The colour of a pixel comes from its ray, or from that of its samples whose colours differ most.
    fn of_result(&self, spot: Spot) -> Attribution {
        let rays = (0..self.alignment.nodes.len()).filter_map(|ours| Some((ours, self.alignment.nodes[ours]?)));
        let colors = rays.filter(|(ours, _)| is_camera_ray(self.a.tree.nodes()[*ours].step));
        let colors = colors.filter_map(|(ours, theirs)| {
            let (a, our_color) = color_of(self.a, ours)?;
            let (b, their_color) = color_of(self.b, theirs)?;
            let effect = apart(Some(our_color), Some(their_color));
            Some(Contribution { spot: Spot::Both(Item::Event(a), Item::Event(b)), effect })
        });
        let operands = by_effect(colors.filter(|color| color.effect != 0.0).collect());
        match operands.first().map(|first| first.spot) {
            from @ Some(_) => Attribution { from, operands, ..bare(Why::Operands) },
            None => self.by_what_was_before(spot, Why::Itself),
        }
    }

    /// Where an operand of the quantity in this place, at these events, comes from; `None` where that isn't known.
    fn spot_of(&self, spot: Spot, (a, b): (usize, usize), pair: &Pair) -> Option<Spot> {
        let ours = pair.a.map(|operand| source(self.a, a, &operand, pair.symbol));
        let theirs = pair.b.map(|operand| source(self.b, b, &operand, pair.symbol));
        match (ours, theirs) {
            (Some(ours), Some(theirs)) if self.before.has(Spot::Both(ours, theirs)) => Some(Spot::Both(ours, theirs)),
            // From different places: from a part that only one log has, or another quantity of the same part, or chosen by a decision.
            (Some(ours), Some(theirs)) => {
                let part = self.part_of_a(ours).or_else(|| self.part_of_b(theirs));
                let is_of_same_part = self.partner(ours.owner(self.a)) == Some(theirs.owner(self.b));
                let instead = || Some(Spot::OnlyA(ours)).filter(|spot| is_of_same_part && self.before.has(*spot));
                part.or_else(instead).or_else(|| self.before.decision_before(spot))
            }
            (Some(ours), None) => {
                self.part_of_a(ours).or(Some(Spot::OnlyA(ours)).filter(|spot| self.before.has(*spot)))
            }
            (None, Some(theirs)) => {
                self.part_of_b(theirs).or(Some(Spot::OnlyB(theirs)).filter(|spot| self.before.has(*spot)))
            }
            (None, None) => None,
        }
    }

    /// The outermost node with this that only A has.
    fn part_of_a(&self, item: Item) -> Option<Spot> {
        let node = outermost(self.a, item, |node| self.alignment.nodes[node].is_some());
        node.map(|node| Spot::OnlyA(Item::Node(node)))
    }

    /// The outermost node with this that only B has.
    fn part_of_b(&self, item: Item) -> Option<Spot> {
        let node = outermost(self.b, item, |node| self.alignment.is_shared[node]);
        node.map(|node| Spot::OnlyB(Item::Node(node)))
    }
}

fn bare(why: Why) -> Attribution {
    Attribution { why, from: None, operands: Vec::new(), own: 0.0, kind: None }
}

fn by_effect(mut contributions: Vec<Contribution>) -> Vec<Contribution> {
    // Stable: of equal effects that of the formula's first operand stays first.
    contributions.sort_by(|x, y| y.effect.total_cmp(&x.effect));
    contributions
}

/// The largest difference of a component; 0 where one of the values can't be had.
fn apart(a: Option<Value>, b: Option<Value>) -> f64 {
    let apart = a.zip(b).map_or(0.0, |(a, b)| distance(&a, &b).absolute);
    if apart.is_nan() { 0.0 } else { apart }
}

fn minus(value: Value, other: Value) -> Value {
    match (value, other) {
        (Value::Number(a), Value::Number(b)) => Value::Number(a - b),
        (Value::Triple(a), Value::Triple(b)) => Value::Triple([0, 1, 2].map(|i| a[i] - b[i])),
        _ => value,
    }
}

/// What has the value of an operand of the quantity at `event`: the step that computed it, or an input.
fn source(run: Run, event: usize, operand: &Operand, symbol: &str) -> Item {
    let holder = &run.log.events[operand.event];
    let is_noted = matches!(holder.what, What::Note { name, .. } if name.symbol() == symbol);
    if operand.event < event && is_noted {
        return Item::Event(operand.event);
    }
    match run.log.given(operand.event).iter().rposition(|(name, _)| name.symbol() == symbol) {
        Some(number) => {
            let input = Item::Input(operand.event, number);
            computed(run, input).map_or(input, Item::Event)
        }
        None => Item::Event(operand.event),
    }
}

/// The outermost node around a item that isn't shared, if there is one.
fn outermost(run: Run, item: Item, is_shared: impl Fn(usize) -> bool) -> Option<usize> {
    run.tree.around(item.owner(run)).take_while(|node| !is_shared(*node)).last()
}

fn is_camera_ray(step: Option<Step>) -> bool {
    matches!(step, Some(Step::Ray { kind: RayKind::Camera, .. }))
}

/// The event with the colour of a ray that met something, and the colour.
fn color_of(run: Run, ray: usize) -> Option<(usize, Value)> {
    let event = provenance::color_of_ray(run.log, run.tree, ray)?;
    run.log.events[event].noted().map(|(_, value)| (event, value))
}
