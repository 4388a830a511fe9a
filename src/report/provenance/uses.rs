//! The steps that take a value.

use super::{each_symbol, gives, handed, notes, operands};
use crate::log::formula;
use crate::log::scope;
use crate::log::{Decision, Event, Log, Name, Step, Tree, What};
use std::ops::Range;

/// The later steps that take the value which `event` notes, in order, at most `most`.
///
/// Only some events can: a value is seen in the rest of its own node, where no later one of its symbol hides it; from an
/// intersection test also in the rest of the ray that hits there; from a light also in the sum of its surface; and what a node
/// passes on, in the node around it. Each is gone through once, and a node whose inputs hide the value is skipped whole, so
/// that a log of a million events takes milliseconds.
pub fn uses(log: &Log, tree: &Tree, event: usize, most: usize) -> Vec<usize> {
    let Some((name, _)) = log.events.get(event).and_then(Event::noted) else { return Vec::new() };
    let seeker = Seeker::new(log, tree, event, name);
    let mut found = seeker.in_own_node();
    found.extend(seeker.in_ray_around_test());
    found.extend(seeker.in_sum_over_lights());
    found.extend(seeker.where_handed_on());
    found.sort_unstable();
    found.dedup();
    found.truncate(most);
    found
}

/// Which names have formulas with this one's symbol: outside a Σ, or under one.
fn takers(taken: Name, under_sum: bool) -> Vec<bool> {
    let takes = |name: Name| {
        let mut takes = false;
        if let Some(formula) = formula::of(name) {
            each_symbol(formula, false, &mut |symbol, is_under_sum| {
                takes |= symbol == taken.symbol() && is_under_sum == under_sum;
            });
        }
        takes
    };
    Name::all().map(takes).collect()
}

struct Seeker<'a> {
    log: &'a Log,
    tree: &'a Tree,
    event: usize,
    symbol: &'static str,
    /// By name, whether its formula has the symbol.
    plain: Vec<bool>,
    /// By name, whether its formula has the symbol under a Σ.
    summed: Vec<bool>,
}

impl<'a> Seeker<'a> {
    fn new(log: &'a Log, tree: &'a Tree, event: usize, name: Name) -> Seeker<'a> {
        Seeker { log, tree, event, symbol: name.symbol(), plain: takers(name, false), summed: takers(name, true) }
    }

    fn in_own_node(&self) -> Vec<usize> {
        let node = self.tree.owner(self.event);
        self.seen_in(node, self.event + 1..self.tree.nodes()[node].events.end)
    }

    /// From the nearest hit on, a ray sees the values of the test that found it.
    fn in_ray_around_test(&self) -> Vec<usize> {
        let test = self.tree.owner(self.event);
        let Some(ray) = self.ray_around_test(test) else { return Vec::new() };
        let is_last =
            self.tree.own_events(test).rfind(|at| notes(&self.log.events[*at], self.symbol)) == Some(self.event);
        let is_nearest = |at: &usize| matches!(self.log.events[*at].what, What::Mark(Decision::Nearest { .. }));
        let nearest = self.tree.own_events(ray).rfind(is_nearest);
        let Some(nearest) = nearest.filter(|_| is_last) else { return Vec::new() };
        let end = self.tree.nodes()[ray].events.end;
        let is_hidden = self.tree.own_events_before(ray, nearest).any(|at| self.redefines(at));
        if is_hidden || scope::nearest_test(&self.log.events, self.tree, ray, end) != Some(test) {
            return Vec::new();
        }
        self.seen_in(ray, nearest + 1..end)
    }

    fn ray_around_test(&self, test: usize) -> Option<usize> {
        let nodes = self.tree.nodes();
        if !matches!(nodes[test].step, Some(Step::Test { .. })) {
            return None;
        }
        let around = nodes[test].parent;
        Some(if matches!(nodes[around].step, Some(Step::Motion { .. })) { nodes[around].parent } else { around })
    }

    fn redefines(&self, at: usize) -> bool {
        notes(&self.log.events[at], self.symbol) || gives(self.log, at, self.symbol)
    }

    /// The steps among these events, which lie in `top` or inside it, that take the value from there.
    fn seen_in(&self, top: usize, events: Range<usize>) -> Vec<usize> {
        let mut found = Vec::new();
        // The nodes around the event at hand, `top` first, each with whether the value is hidden there.
        let mut open = vec![(top, false)];
        let mut at = events.start;
        while at < events.end {
            let owner = self.tree.owner(at);
            while open.last().is_some_and(|(node, _)| self.tree.nodes()[*node].events.end <= at) {
                open.pop();
            }
            if open.last().is_some_and(|(node, _)| *node != owner) {
                let is_hidden = open.last().is_some_and(|(_, is_hidden)| *is_hidden);
                open.push((owner, is_hidden));
            }
            let Some((_, is_hidden)) = open.last_mut() else { break };
            let happening = &self.log.events[at];
            let is_given_anew = gives(self.log, at, self.symbol);
            if let What::Note { name, .. } = happening.what {
                let takes = self.plain[name as usize] && !*is_hidden && !is_given_anew;
                if takes || self.summed[name as usize] && self.sums_it(at) {
                    found.push(at);
                }
            }
            *is_hidden |= self.redefines(at) || owner != top && self.finds_another(owner, at);
            match *is_hidden {
                true if owner == top => break,
                // Nothing inside sees it any more.
                true if matches!(happening.what, What::Enter { .. }) => at = self.tree.nodes()[owner].events.end,
                _ => at += 1,
            }
        }
        found
    }

    /// Whether a ray has met its nearest object, and the test there has a value of the symbol.
    fn finds_another(&self, ray: usize, at: usize) -> bool {
        if !matches!(self.log.events[at].what, What::Mark(Decision::Nearest { .. })) {
            return false;
        }
        let test = scope::nearest_test(&self.log.events, self.tree, ray, at + 1);
        test.is_some_and(|test| self.tree.own_events(test).any(|at| self.redefines(at)))
    }

    /// Whether the Σ in the formula of a local intensity takes the value, in the part of some light.
    fn sums_it(&self, sum: usize) -> bool {
        scope::lights(&self.log.events, self.tree, sum).any(|light| {
            let operand = scope::operand_of_light(&self.log.events, self.tree, light, self.symbol);
            operand.is_some_and(|operand| operand.event == self.event)
        })
    }

    fn in_sum_over_lights(&self) -> Option<usize> {
        let light = self.tree.owner(self.event);
        if !matches!(self.tree.nodes()[light].step, Some(Step::Light { .. })) {
            return None;
        }
        let shade = self.tree.nodes()[light].parent;
        let is_sum = |at: &usize| self.log.events[*at].noted().is_some_and(|(name, _)| self.summed[name as usize]);
        self.tree.own_events(shade).rfind(is_sum).filter(|sum| self.sums_it(*sum))
    }

    /// The steps that take it as an input: they are in the node around, in its weighted sum, or where a ray sets out.
    fn where_handed_on(&self) -> Vec<usize> {
        let nodes = self.tree.nodes();
        let node = self.tree.owner(self.event);
        let parent = nodes[node].parent;
        let holder = match nodes[node].step {
            Some(Step::Combine) => match nodes[nodes[parent].parent].step {
                Some(Step::Zone { .. }) => nodes[nodes[parent].parent].parent,
                _ => nodes[parent].parent,
            },
            Some(Step::Shade { .. } | Step::Motion { .. }) => parent,
            _ => node,
        };
        let inside = self.tree.children(holder).flat_map(|child| self.with_inner(child));
        let events = std::iter::once(holder).chain(inside).flat_map(|node| self.tree.own_events(node));
        let may_take = |at: &usize| {
            let mut inputs = self.log.given(*at).iter();
            *at > self.event && inputs.any(|(name, _)| handed::may_come_from(*name, self.symbol))
        };
        let later = events.filter(may_take);
        later.flat_map(|at| self.takers_of_input(at)).collect()
    }

    /// A node, and where it holds no ray of its own, what is in it: the lights of a surface with their shadow rays.
    fn with_inner(&self, node: usize) -> Vec<usize> {
        let nodes = self.tree.nodes();
        match nodes[node].step {
            Some(Step::Shade { .. } | Step::Zone { .. } | Step::Light { .. }) => {
                let inner = self.tree.children(node).flat_map(|child| self.with_inner(child));
                std::iter::once(node).chain(inner).collect()
            }
            _ => vec![node],
        }
    }

    /// The steps that take it from among the inputs of an event: that event, and those that see its inputs.
    fn takers_of_input(&self, at: usize) -> Vec<usize> {
        let (log, tree) = (self.log, self.tree);
        let is_it = |name: Name, value: &_| {
            handed::may_come_from(name, self.symbol) && handed::origin(log, tree, at, name, value) == Some(self.event)
        };
        let handed = log.given(at).iter().filter(|(name, value)| is_it(*name, value));
        let mut found: Vec<_> = handed.flat_map(|(name, _)| Seeker::new(log, tree, at, *name).in_own_node()).collect();
        if operands(log, tree, at).iter().any(|operand| operand.computed == Some(self.event)) {
            found.push(at);
        }
        found
    }
}
