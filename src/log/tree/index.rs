//! The contents of nodes that hold much: a search there takes as many steps as the number has digits, and not as many as there are events.

use super::Tree;
use super::children::{self, Child};
use super::memo::Memo;
use crate::log::event::{Decision, Event, Step, What};
use crate::log::events::Events;
use crate::log::formula::Several;
use crate::log::name::Name;
use crate::log::value::Value;
use std::collections::HashMap;
use std::hash::Hash;
use std::mem::{self, Discriminant};
use std::sync::LazyLock;

/// A node with no more events of its own is gone through.
const FEW: usize = 64;

/// One whose tests have no more of them is, too, for the nearest test.
const FEW_OF_TESTS: usize = 256;

/// Where the symbols and the nearest tests of those nodes are that hold much.
#[derive(Clone, Debug, Default)]
pub(in crate::log) struct Index {
    symbols: HashMap<usize, Symbols>,
    /// `None` where no object is the nearest.
    nearest: HashMap<usize, Option<Nearest>>,
    /// The nodes inside, in order.
    children: HashMap<(usize, Child), Vec<u32>>,
    /// By the numbers of objects, the events by which a test hits them.
    hits: HashMap<u32, Vec<u32>>,
    /// What nodes deep in the tree see around them.
    pub(in crate::log) memo: Memo,
}

/// The events of a node by symbol, in order.
#[derive(Clone, Debug, Default)]
struct Symbols {
    noted: HashMap<&'static str, Vec<u32>>,
    given: HashMap<&'static str, Vec<u32>>,
    names: HashMap<Name, Vec<u32>>,
    marks: HashMap<Discriminant<Decision>, Vec<u32>>,
    /// The quantities that are a sum over samples, cells, surfaces or lights.
    sums: Vec<u32>,
    /// Where the largest number so far grows, and to what.
    sizes: Vec<(u32, f64)>,
}

impl Index {
    /// That of these events.
    pub(in crate::log) fn of(events: &Events, tree: &Tree) -> Index {
        let mut index = Index { memo: Memo::of(tree), ..Index::default() };
        for (event, what) in events.iter().map(|event| &event.what).enumerate() {
            if *what == What::Mark(Decision::Hit)
                && let Some(Step::Test { object, .. }) = tree.nodes()[tree.owner(event)].step
            {
                index.hits.entry(object).or_default().push(event as u32);
            }
        }
        for (node, count) in children::counts(tree).into_iter().enumerate() {
            if count as usize > FEW {
                let kinds = Child::inside(events, tree, node);
                index.children.extend(kinds.map(|(kind, children)| ((node, kind), children)));
            }
        }
        let mut of_tests = vec![0; tree.nodes().len()];
        for (child, node) in tree.nodes().iter().enumerate().skip(1) {
            let is_test = matches!(node.step, Some(Step::Test { .. }));
            let size = 1 + if is_test { tree.own_events(child).len() } else { 0 };
            of_tests[node.parent] += size;
            // What is tested in a moving object's frame counts for the ray around it.
            if matches!(tree.nodes()[node.parent].step, Some(Step::Motion { .. })) {
                of_tests[tree.nodes()[node.parent].parent] += size;
            }
        }
        for (node, of_tests) in of_tests.into_iter().enumerate() {
            let own = tree.own_events(node).len();
            if own > FEW {
                index.symbols.insert(node, Symbols::of(events, tree, node));
            }
            if own > FEW || of_tests > FEW_OF_TESTS {
                index.nearest.insert(node, Nearest::of(events, tree, node, usize::MAX));
            }
        }
        index
    }

    /// The latest of a node's own events before one that notes a symbol; outside `None` where the node is to be gone through.
    pub(in crate::log) fn noted(&self, node: usize, before: usize, symbol: &str) -> Option<Option<usize>> {
        self.symbols.get(&node).map(|symbols| last(&symbols.noted, before, &symbol))
    }

    /// The same with those that have it among their inputs.
    pub(in crate::log) fn has(&self, node: usize, before: usize, symbol: &str) -> Option<Option<usize>> {
        let of_node = self.symbols.get(&node)?;
        Some(last(&of_node.noted, before, &symbol).max(last(&of_node.given, before, &symbol)))
    }

    /// The same with those that note one quantity.
    pub(in crate::log) fn names(&self, node: usize, before: usize, name: Name) -> Option<Option<usize>> {
        self.symbols.get(&node).map(|symbols| last(&symbols.names, before, &name))
    }

    /// The same with the decisions of a kind.
    pub(in crate::log) fn marked(
        &self,
        node: usize,
        before: usize,
        kind: Discriminant<Decision>,
    ) -> Option<Option<usize>> {
        self.symbols.get(&node).map(|symbols| last(&symbols.marks, before, &kind))
    }

    /// How many sums a node has noted before an event; `None` where they can't be many.
    pub(in crate::log) fn sums(&self, node: usize, before: usize) -> Option<usize> {
        let sums = &self.symbols.get(&node)?.sums;
        Some(sums.partition_point(|event| (*event as usize) < before))
    }

    /// The first of a node's own events from one on that notes a quantity; outside `None` where the node is to be gone through.
    pub(in crate::log) fn first_name(&self, node: usize, from: usize, name: Name) -> Option<Option<usize>> {
        let symbols = self.symbols.get(&node)?;
        let first = symbols.names.get(&name).and_then(|list| {
            list.get(list.partition_point(|event| (*event as usize) < from)).map(|event| *event as usize)
        });
        Some(first)
    }

    /// The latest event before one by which a test hits an object.
    pub(in crate::log) fn hit(&self, before: usize, object: u32) -> Option<usize> {
        last(&self.hits, before, &object)
    }

    /// The nodes of a kind directly inside a node that holds many.
    pub(in crate::log) fn children(&self, node: usize, kind: Child) -> Option<&[u32]> {
        self.children.get(&(node, kind)).map(Vec::as_slice)
    }

    /// The largest number in a node before an event; outside `None` where the node is to be gone through.
    pub(in crate::log) fn size(&self, node: usize, before: usize) -> Option<f64> {
        let sizes = &self.symbols.get(&node)?.sizes;
        let count = sizes.partition_point(|(event, _)| (*event as usize) < before);
        Some(count.checked_sub(1).map_or(0.0, |at| sizes[at].1))
    }

    /// The tests of the nearest object in a node; outside `None` where the node is to be gone through.
    pub(in crate::log) fn nearest(&self, node: usize) -> Option<Option<&Nearest>> {
        self.nearest.get(&node).map(Option::as_ref)
    }
}

impl Symbols {
    fn of(events: &Events, tree: &Tree, node: usize) -> Symbols {
        let mut symbols = Symbols::default();
        for event in tree.own_events(node) {
            match &events[event].what {
                What::Note { name, .. } => {
                    symbols.noted.entry(name.symbol()).or_default().push(event as u32);
                    symbols.names.entry(*name).or_default().push(event as u32);
                    if adds_up(*name) {
                        symbols.sums.push(event as u32);
                    }
                }
                What::Mark(decision) => {
                    symbols.marks.entry(mem::discriminant(decision)).or_default().push(event as u32);
                }
                _ => {}
            }
            for (name, _) in events.given(&events[event]) {
                symbols.given.entry(name.symbol()).or_default().push(event as u32);
            }
            let largest = symbols.sizes.last().map_or(0.0, |(_, size)| *size);
            let size = size_of(events, event, largest);
            if size > largest {
                symbols.sizes.push((event as u32, size));
            }
        }
        symbols
    }
}

fn last<K: Eq + Hash>(lists: &HashMap<K, Vec<u32>>, before: usize, key: &K) -> Option<usize> {
    let list = lists.get(key)?;
    let count = list.partition_point(|event| (*event as usize) < before);
    count.checked_sub(1).map(|at| list[at] as usize)
}

/// The tests, directly inside a node or in a moving object's frame there, that may have found the nearest object.
#[derive(Clone, Debug)]
pub(in crate::log) struct Nearest {
    /// The event that says which object it is.
    event: usize,
    /// From the nearest on. With each is the event after which none of those up to it counts any more, because marks say that their
    /// triangles only lie in the same place.
    tests: Vec<(usize, usize)>,
}

impl Nearest {
    /// Those of a node, if an event before this one says which object is the nearest.
    pub(in crate::log) fn of(events: &Events, tree: &Tree, node: usize, before: usize) -> Option<Nearest> {
        let (event, nearest) = tree.own_events_before(node, before).find_map(|event| match events[event].what {
            What::Mark(Decision::Nearest { object }) => Some((event, object)),
            _ => None,
        })?;
        let mut behind: HashMap<u32, usize> = HashMap::new();
        for event in tree.own_events(node) {
            if let What::Mark(Decision::Coincident { object, triangle: Some(triangle) }) = events[event].what
                && object == nearest
            {
                behind.entry(triangle).or_insert(event);
            }
        }
        let triangle_of = |child: usize| match tree.nodes()[child].step {
            Some(Step::Test { object, triangle }) if object == nearest => Some(triangle),
            _ => None,
        };
        let is_hit = |child: usize| tree.own_events(child).any(|event| events[event].what == What::Mark(Decision::Hit));
        // The tests with a moving object are in a node around them.
        let is_moving = |child: &usize| tree.nodes()[*child].step == Some(Step::Motion { object: nearest });
        let moving = tree.children(node).filter(is_moving).flat_map(|motion| tree.children(motion));
        let tests = tree.children(node).chain(moving).filter_map(|child| Some((child, triangle_of(child)?)));
        let found = tests.filter(|(child, triangle)| triangle.is_none() || is_hit(*child));
        // Everything but a mesh has one test, so that its distance doesn't matter.
        let distance = |child: usize, triangle: Option<u32>| match triangle {
            Some(_) => distance(events, tree, child).unwrap_or(f64::INFINITY),
            None => f64::INFINITY,
        };
        let mut found: Vec<_> = found.map(|(child, triangle)| (distance(child, triangle), triangle, child)).collect();
        found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let mut latest = 0;
        let tests = found.into_iter().map(|(_, triangle, child)| {
            let until = triangle.and_then(|triangle| behind.get(&triangle)).copied().unwrap_or(usize::MAX);
            latest = until.max(latest);
            (child, latest)
        });
        Some(Nearest { event, tests: tests.collect() })
    }

    /// The test that found the nearest object, as far as the events before one tell.
    pub(in crate::log) fn before(&self, before: usize) -> Option<usize> {
        let out = self.tests.partition_point(|(_, until)| *until < before);
        self.tests.get(out).filter(|_| self.event < before).map(|(test, _)| *test)
    }
}

/// How far along the ray a test found its object.
fn distance(events: &Events, tree: &Tree, test: usize) -> Option<f64> {
    let symbol = Name::PlaneT.symbol();
    let found = tree
        .own_events(test)
        .rev()
        .find_map(|event| noted(&events[event], symbol).or_else(|| given_at(events, event, symbol)));
    match found? {
        Value::Number(distance) => Some(distance),
        Value::Triple(_) => None,
    }
}

/// Whether the formula of a quantity goes over samples, cells, surfaces or lights.
pub(in crate::log) fn adds_up(name: Name) -> bool {
    static ADDING: LazyLock<Vec<bool>> = LazyLock::new(|| {
        let signs = || Several::ALL.map(Several::word).into_iter().chain(["Σ"]);
        let adds_up = |name: Name| name.formula().is_some_and(|formula| signs().any(|sign| formula.contains(sign)));
        Name::all().map(adds_up).collect()
    });
    ADDING[name as usize]
}

/// The largest of a number and those that an event notes or has among its inputs.
pub(in crate::log) fn size_of(events: &Events, event: usize, size: f64) -> f64 {
    let noted = events[event].noted().map(|(_, value)| value);
    let values = noted.into_iter().chain(events.given(&events[event]).iter().map(|(_, value)| *value));
    values.fold(size, |size, value| value.components().iter().fold(size, |size: f64, x| size.max(x.abs())))
}

pub(in crate::log) fn noted(event: &Event, symbol: &str) -> Option<Value> {
    match event.what {
        What::Note { name, value } if name.symbol() == symbol => Some(value),
        _ => None,
    }
}

pub(in crate::log) fn given_at(events: &Events, event: usize, symbol: &str) -> Option<Value> {
    events.given(&events[event]).iter().rev().find(|(name, _)| name.symbol() == symbol).map(|(_, value)| *value)
}
