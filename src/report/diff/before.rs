//! What stands before a difference and may be why it is there, for what no formula explains: decisions, and steps that only one log
//! has.

use super::align::{Alignment, Spot, Thing};
use super::tolerance::Tolerance;
use crate::log::{Decision, Step, Value, What};
use crate::report::side_by_side::Run;
use std::collections::HashMap;

/// The things of two aligned logs, in their order.
pub(super) struct Before<'a> {
    a: Run<'a>,
    b: Run<'a>,
    alignment: &'a Alignment,
    places: HashMap<Spot, usize>,
    /// By the nodes of A, the decisions in them that differ.
    decisions: HashMap<usize, Vec<usize>>,
}

impl<'a> Before<'a> {
    pub fn of(a: Run<'a>, b: Run<'a>, alignment: &'a Alignment) -> Before<'a> {
        let places = alignment.spots.iter().enumerate().map(|(place, spot)| (*spot, place)).collect();
        let mut before = Before { a, b, alignment, places, decisions: HashMap::new() };
        for place in 0..alignment.spots.len() {
            if before.decides_otherwise(place) {
                before.decisions.entry(alignment.homes[place]).or_default().push(place);
            }
        }
        before
    }

    /// What this may come from: for a step that only one log has, what is decided otherwise in its node; else, and for a decision,
    /// the last value before it in its node that differs; else what differs last before it in its ray, decisions first.
    pub fn of_spot(&self, spot: Spot) -> Option<Spot> {
        let place = *self.places.get(&spot)?;
        let home = self.alignment.homes[place];
        let here = self.decisions.get(&home);
        let decided_here = here.and_then(|places| places.iter().find(|other| **other != place).copied());
        let is_step_alone = !matches!(spot, Spot::Both(..)) && !self.decides_otherwise(place);
        let found = decided_here.filter(|_| is_step_alone).or_else(|| {
            let ray = self.ray_around(home);
            let within = self.a.tree.nodes()[ray].subtree_end;
            // The order is that of A's tree: what belongs to a ray stands together.
            let earlier = (0..place).rev().take_while(|other| (ray..within).contains(&self.alignment.homes[*other]));
            let earlier: Vec<usize> = earlier.collect();
            let value_here =
                earlier.iter().find(|other| self.alignment.homes[**other] == home && self.value_differs(**other));
            let decided = || earlier.iter().find(|other| self.decides_otherwise(**other));
            let value = || earlier.iter().find(|other| self.value_differs(**other));
            value_here.or_else(decided).or_else(value).copied()
        });
        found.map(|place| self.alignment.spots[place])
    }

    /// The node in A of the ray in which a node stands; the root if it stands in none.
    fn ray_around(&self, node: usize) -> usize {
        let nodes = self.a.tree.nodes();
        let is_ray = |node: usize| matches!(nodes[node].step, Some(Step::Ray { .. }));
        let mut around = std::iter::successors(Some(node), |node| Some(nodes[*node].parent));
        around.find(|node| *node == 0 || is_ray(*node)).unwrap_or(0)
    }

    /// Whether a decision differs here, or a ray or another part of the computation is in one log only. A test that only one log has
    /// decides nothing by itself.
    fn decides_otherwise(&self, place: usize) -> bool {
        match self.alignment.spots[place] {
            Spot::Both(Thing::Event(a), Thing::Event(b)) => differ_as_decisions(self.a, a, self.b, b),
            Spot::Both(..) => false,
            Spot::OnlyA(thing) => decides(self.a, thing),
            Spot::OnlyB(thing) => decides(self.b, thing),
        }
    }

    fn value_differs(&self, place: usize) -> bool {
        values_of(self.a, self.b, self.alignment.spots[place])
            .is_some_and(|(ours, theirs)| Tolerance::default().tells_apart(&ours, &theirs))
    }
}

fn decides(run: Run, thing: Thing) -> bool {
    match thing {
        Thing::Event(event) => matches!(run.log.events[event].what, What::Mark(_)),
        Thing::Input(..) => false,
        Thing::Node(node) => !matches!(run.tree.nodes()[node].step, Some(Step::Test { .. } | Step::Motion { .. })),
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

/// The value of a thing, if it has one.
pub(super) fn value(run: Run, thing: Thing) -> Option<Value> {
    match thing {
        Thing::Event(event) => match run.log.events[event].what {
            What::Note { value, .. } => Some(value),
            What::Result { color } => Some(Value::Triple(color)),
            What::Mark(Decision::Attenuated { factor, .. }) => Some(Value::Triple(factor)),
            _ => None,
        },
        Thing::Input(event, number) => Some(run.log.events[event].given[number].1),
        Thing::Node(_) => None,
    }
}
