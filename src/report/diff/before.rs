//! What precedes a difference and may be why it is there, for what no formula explains: decisions, and steps that only one log
//! has.

use super::align::{Alignment, Item, Spot};
use super::kinds::Kinds;
use super::tolerance::Tolerance;
use crate::log::{Decision, Step, Value, What};
use crate::report::side_by_side::Run;
use std::collections::HashMap;
use std::rc::Rc;

/// The items of two aligned logs, in their order.
pub(super) struct Before<'a> {
    a: Run<'a>,
    b: Run<'a>,
    alignment: Rc<Alignment>,
    kinds: Rc<Kinds>,
    places: HashMap<Spot, usize>,
    /// When each of them is in both logs.
    times: Vec<[Time; 2]>,
    /// The places of decisions that differ, all and by the ray of A that they belong to.
    decisions: Vec<usize>,
    decisions_of_rays: HashMap<usize, Vec<usize>>,
    /// Those of steps that only one log has.
    nodes_alone: Vec<usize>,
    /// Those of values that differ.
    values: Vec<usize>,
    /// By the nodes of A, the decisions and the values in them that differ.
    decisions_here: HashMap<usize, Vec<usize>>,
    values_here: HashMap<usize, Vec<usize>>,
}

/// When an item is in a log: how many items that were compared are before it there.
#[derive(Clone, Copy, Debug, Default)]
struct Time {
    count: usize,
    /// Whether the log has it. If not, it would be behind the last item before it that both have.
    is_there: bool,
}

impl<'a> Before<'a> {
    pub fn of(a: Run<'a>, b: Run<'a>, alignment: Rc<Alignment>, kinds: Rc<Kinds>) -> Before<'a> {
        let places = alignment.spots.iter().enumerate().map(|(place, spot)| (*spot, place)).collect();
        let times = times(a, b, &alignment);
        let mut before = Before {
            a,
            b,
            alignment,
            kinds,
            places,
            times,
            decisions: Vec::new(),
            decisions_of_rays: HashMap::new(),
            nodes_alone: Vec::new(),
            values: Vec::new(),
            decisions_here: HashMap::new(),
            values_here: HashMap::new(),
        };
        for place in 0..before.alignment.spots.len() {
            let home = before.alignment.homes[place];
            if before.decides_otherwise(place) {
                before.decisions.push(place);
                before.decisions_of_rays.entry(before.ray_around(home)).or_default().push(place);
                before.decisions_here.entry(home).or_default().push(place);
            }
            if before.is_node_alone(place) {
                before.nodes_alone.push(place);
            }
            if before.value_differs(place) {
                before.values.push(place);
                before.values_here.entry(home).or_default().push(place);
            }
        }
        before
    }

    /// What this may come from: for a step that only one log has, what is decided otherwise in its node; else, and for a decision,
    /// the last value before it in its node that differs; else what differs last before it in its ray: decisions, then steps that
    /// only one log has, then values.
    pub fn of_spot(&self, spot: Spot) -> Option<Spot> {
        let place = *self.places.get(&spot)?;
        let home = self.alignment.homes[place];
        let is_decision = self.decides_otherwise(place);
        let is_step_alone = !matches!(spot, Spot::Both(..)) && !is_decision;
        let decided_here = self
            .decisions_here
            .get(&home)
            .and_then(|places| places.iter().copied().find(|other| self.may_cause(*other, place)));
        let found = decided_here.filter(|_| is_step_alone).or_else(|| {
            let value_here = self.values_here.get(&home).and_then(|values| self.last_of(values, place));
            let decided = || self.decided_before(place);
            // What only one log has follows from a decision, and not the decision from it.
            let may_follow = !is_step_alone && !is_decision;
            let alone = || may_follow.then(|| self.last_of(&self.nodes_alone, place)).flatten();
            let value = || self.last_of(&self.values, place);
            value_here.or_else(decided).or_else(alone).or_else(value)
        });
        found.map(|place| self.alignment.spots[place])
    }

    /// The last decision before this in its ray that differs.
    pub fn decision_before(&self, spot: Spot) -> Option<Spot> {
        let place = *self.places.get(&spot)?;
        self.decided_before(place).map(|place| self.alignment.spots[place])
    }

    /// The last decision before a place that differs: of its ray itself, or else of the rays that this one sent out.
    fn decided_before(&self, place: usize) -> Option<usize> {
        let ray = self.ray_around(self.alignment.homes[place]);
        let own = self.decisions_of_rays.get(&ray).and_then(|decisions| self.last_of(decisions, place));
        own.or_else(|| self.last_of(&self.decisions, place))
    }

    /// The node in A in which this is, or would be.
    pub fn home(&self, spot: Spot) -> Option<usize> {
        self.places.get(&spot).map(|place| self.alignment.homes[*place])
    }

    /// Whether the alignment has this: a step that only one log has, for one.
    pub fn has(&self, spot: Spot) -> bool {
        self.places.contains_key(&spot)
    }

    /// Whether what is at one place comes before what is at another, in a log that has the first: there the second follows, or would if the
    /// log had it. A test that misses in A has no further steps; those of B come from that miss, which is the next that A has instead.
    fn may_cause(&self, cause: usize, effect: usize) -> bool {
        let is_before = |(cause, effect): (&Time, &Time)| match effect.is_there {
            true => cause.count < effect.count,
            false => cause.count <= effect.count,
        };
        let logs = self.times[cause].iter().zip(&self.times[effect]);
        logs.filter(|(cause, _)| cause.is_there).any(is_before)
    }

    /// The last of some places, which are in their order, that is before a place in its ray and may be its cause.
    fn last_of(&self, places: &[usize], place: usize) -> Option<usize> {
        let ray = self.ray_around(self.alignment.homes[place]);
        let within = ray..self.a.tree.nodes()[ray].subtree_end;
        let before = places[..places.partition_point(|other| *other < place)].iter().rev().copied();
        // The order is that of A's tree: what belongs to a ray is contiguous.
        let mut of_ray = before.take_while(|other| within.contains(&self.alignment.homes[*other]));
        of_ray.find(|other| self.may_cause(*other, place))
    }

    /// The node in A of the ray that a node belongs to; the root if it belongs to none.
    fn ray_around(&self, node: usize) -> usize {
        self.a.tree.around(node).find(|node| self.a.tree.ray(*node).is_some()).unwrap_or(0)
    }

    /// Whether a decision differs here, or is in one log only. Not every kind of shape asks on which side a ray begins: between two kinds
    /// that only one asks decides nothing.
    fn decides_otherwise(&self, place: usize) -> bool {
        let is_of_other_kind = self.kinds.has(self.alignment.homes[place]);
        let is_decision = |run: Run, item: Item| match item {
            Item::Event(event) => match run.log.events[event].what {
                What::Mark(Decision::Outside | Decision::Inside) => !is_of_other_kind,
                What::Mark(_) => true,
                _ => false,
            },
            Item::Input(..) | Item::Node(_) => false,
        };
        match self.alignment.spots[place] {
            Spot::Both(Item::Event(a), Item::Event(b)) => differ_as_decisions(self.a, a, self.b, b),
            Spot::Both(..) => false,
            Spot::OnlyA(item) => is_decision(self.a, item),
            Spot::OnlyB(item) => is_decision(self.b, item),
        }
    }

    /// Whether a ray or another part of the computation is in one log only.
    fn is_node_alone(&self, place: usize) -> bool {
        let spot = self.alignment.spots[place];
        matches!(spot, Spot::OnlyA(Item::Node(_)) | Spot::OnlyB(Item::Node(_))) && !self.is_test_alone(spot)
    }

    /// Whether this is a test that only one log has. It decides nothing by itself: which tests a tracer needs depends on its
    /// arithmetic, and on what it was asked to log.
    pub fn is_test_alone(&self, spot: Spot) -> bool {
        self.tested_alone(spot).is_some()
    }

    /// Whether the object of such a test is in one of the scenes only.
    pub fn is_of_one_scene(&self, spot: Spot) -> bool {
        let (ours, theirs) = (&self.a.log.header, &self.b.log.header);
        match (spot, self.tested_alone(spot)) {
            (Spot::OnlyA(_), Some(object)) => theirs.only_elsewhere.iter().any(|name| name == ours.object(object)),
            // What only B has is numbered behind what A has.
            (Spot::OnlyB(_), Some(object)) => object as usize >= ours.objects.len(),
            _ => false,
        }
    }

    fn tested_alone(&self, spot: Spot) -> Option<u32> {
        let step = match spot {
            Spot::OnlyA(Item::Node(node)) => self.a.tree.nodes()[node].step,
            Spot::OnlyB(Item::Node(node)) => self.b.tree.nodes()[node].step,
            _ => None,
        };
        match step {
            Some(Step::Test { object, .. } | Step::Motion { object }) => Some(object),
            _ => None,
        }
    }

    fn value_differs(&self, place: usize) -> bool {
        values_of(self.a, self.b, self.alignment.spots[place])
            .is_some_and(|(ours, theirs)| Tolerance::default().tells_apart(&ours, &theirs))
    }
}

/// When each item that is compared is in both logs.
fn times(a: Run, b: Run, alignment: &Alignment) -> Vec<[Time; 2]> {
    let runs = [a, b];
    let mut times = vec![[Time::default(); 2]; alignment.spots.len()];
    let items: Vec<[Option<Item>; 2]> = alignment.spots.iter().map(|spot| items(*spot)).collect();
    let in_order = [0, 1].map(|log| {
        let mut places: Vec<usize> = (0..items.len()).filter(|place| items[*place][log].is_some()).collect();
        places.sort_by_key(|place| items[*place][log].map(|item| order(runs[log], item)));
        places
    });
    for (log, places) in in_order.iter().enumerate() {
        for (count, place) in places.iter().enumerate() {
            times[*place][log] = Time { count, is_there: true };
        }
    }
    for (log, places) in in_order.iter().enumerate() {
        let other = 1 - log;
        let mut behind = 0;
        for place in places {
            match times[*place][other] {
                Time { count, is_there: true } => behind = count + 1,
                Time { .. } => times[*place][other].count = behind,
            }
        }
    }
    times
}

/// The items of both logs in a place.
fn items(spot: Spot) -> [Option<Item>; 2] {
    match spot {
        Spot::Both(ours, theirs) => [Some(ours), Some(theirs)],
        Spot::OnlyA(item) => [Some(item), None],
        Spot::OnlyB(item) => [None, Some(item)],
    }
}

/// Where an item is in its log: the inputs of an event before what it says.
fn order(run: Run, item: Item) -> (usize, usize) {
    match item {
        Item::Event(event) => (event, usize::MAX),
        Item::Input(event, number) => (event, number),
        Item::Node(node) => (run.tree.nodes()[node].events.start, 0),
    }
}

/// Whether two events are different decisions. How much light a surface lets pass is a value.
pub(super) fn differ_as_decisions(a: Run, event_a: usize, b: Run, event_b: usize) -> bool {
    match (&a.log.events[event_a].what, &b.log.events[event_b].what) {
        (What::Mark(Decision::Attenuated { .. }), What::Mark(Decision::Attenuated { .. })) => false,
        (What::Mark(ours), What::Mark(theirs)) => ours != theirs,
        _ => false,
    }
}

/// The values of something that both logs have; `None` for decisions.
pub(super) fn values_of(a: Run, b: Run, spot: Spot) -> Option<(Value, Value)> {
    match spot {
        Spot::Both(ours, theirs) => Some((value(a, ours)?, value(b, theirs)?)),
        Spot::OnlyA(_) | Spot::OnlyB(_) => None,
    }
}

/// The value of an item, if it has one.
pub(super) fn value(run: Run, item: Item) -> Option<Value> {
    match item {
        Item::Event(event) => match &run.log.events[event].what {
            What::Mark(Decision::Attenuated { factor, .. }) => Some(Value::Triple(*factor)),
            what => what.value(),
        },
        Item::Input(event, number) => Some(run.log.given(event)[number].1),
        Item::Node(_) => None,
    }
}
