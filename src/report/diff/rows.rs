//! Two aligned logs row by row, the same and the different, for walking through both at once.

use super::align::{self, Alignment, Item, Spot};
use super::cause::Causes;
use super::{Comparing, Text, Tolerance, before, decision, only, quantity, telling_apart};
use crate::log::{Decision, Step, Value, What};
use crate::report::language::Language;
use crate::report::side_by_side::Run;
use crate::report::{Style, words};
use std::rc::Rc;

/// Two logs beside each other. A node that both have, and each item in it, has a row.
pub struct Rows<'a> {
    comparing: Comparing<'a>,
    rows: Vec<Row>,
}

/// A row of two logs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// How many nodes are around it.
    pub level: usize,
    /// What is in it.
    place: Place,
    /// Whether the two logs differ in it.
    pub differs: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Place {
    /// A node of A, which B has too.
    Node(usize),
    Item(Spot),
}

impl<'a> Rows<'a> {
    /// Those of two logs whose objects and lights have the same numbers.
    pub fn of(a: Run<'a>, b: Run<'a>, tolerance: Tolerance) -> Rows<'a> {
        let alignment = Rc::new(align::align(a, b));
        let comparing = Comparing { causes: Causes::of(a, b, alignment.clone()), tolerance };
        let rows = rows(a, &alignment, |spot| comparing.differs(spot));
        Rows { comparing, rows }
    }

    /// The rows, from the top.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// What a row is a node of, if it is that of a node.
    pub fn step(&self, row: &Row) -> Option<Step> {
        let (a, b) = (self.comparing.causes.a, self.comparing.causes.b);
        match row.place {
            Place::Node(node) | Place::Item(Spot::OnlyA(Item::Node(node))) => a.tree.nodes()[node].step,
            Place::Item(Spot::OnlyB(Item::Node(node))) => b.tree.nodes()[node].step,
            Place::Item(_) => None,
        }
    }

    /// What A and B say in a row; `None` for the log that has nothing there.
    pub fn cells(&self, row: &Row) -> [Option<String>; 2] {
        let (a, b) = (self.comparing.causes.a, self.comparing.causes.b);
        match row.place {
            Place::Node(node) => {
                let theirs = self
                    .comparing
                    .causes
                    .partner(node)
                    .map(|node| words::title(Language::English, b.log, b.tree, node));
                [Some(words::title(Language::English, a.log, a.tree, node)), theirs]
            }
            Place::Item(spot @ Spot::Both(ours, theirs)) => match before::values_of(a, b, spot) {
                Some((value_a, value_b)) => {
                    let style = self.style(row, &value_a, &value_b);
                    [Some(named(a, ours, &value_a, style)), Some(named(b, theirs, &value_b, style))]
                }
                None => [Some(decision(a, ours)), Some(decision(b, theirs))],
            },
            Place::Item(Spot::OnlyA(item)) => [Some(alone(a, item)), None],
            Place::Item(Spot::OnlyB(item)) => [None, Some(alone(b, item))],
        }
    }

    /// How both logs compute what is in a row, and where a difference comes from; a line each.
    pub fn explanation(&self, row: &Row) -> Vec<String> {
        let Place::Item(spot) = row.place else { return Vec::new() };
        if row.differs {
            let (a, b) = (self.comparing.causes.a, self.comparing.causes.b);
            let text = Text::new(self.comparing.tolerance.digits, false).between(&a.log.header, &b.log.header);
            return text.explanation(&self.comparing.first(spot));
        }
        let computations = self.comparing.computations(spot);
        computations.map_or_else(Vec::new, |[a, b]| vec![format!("A: {a}"), format!("B: {b}")])
    }

    fn style(&self, row: &Row, a: &Value, b: &Value) -> Style {
        let digits = self.comparing.tolerance.digits;
        if row.differs {
            telling_apart(a, b, digits)
        } else {
            digits.map_or(Style::default(), |digits| Style::default().with(digits))
        }
    }
}

/// The items in their order, each node before the first item in it.
fn rows(a: Run, alignment: &Alignment, differs: impl Fn(Spot) -> bool) -> Vec<Row> {
    let nodes = a.tree.nodes();
    let mut rows = Vec::new();
    let shared = (0..nodes.len()).filter(|node| alignment.nodes[*node].is_some());
    let mut shared = shared.peekable();
    for (spot, home) in alignment.spots.iter().zip(&alignment.homes) {
        // Nodes before the one in which the item is, and that one, have begun.
        while let Some(node) = shared.next_if(|node| node <= home) {
            rows.push(Row { level: nodes[node].level, place: Place::Node(node), differs: false });
        }
        rows.push(Row { level: nodes[*home].level + 1, place: Place::Item(*spot), differs: differs(*spot) });
    }
    rows
}

fn named(run: Run, item: Item, value: &Value, style: Style) -> String {
    let shown = Language::English.value(value, style.within(&run.log.header));
    match quantity(run, item) {
        Some(name) => format!("{} = {shown}", name.symbol()),
        None => match item {
            Item::Event(event) if is_filter(run, event) => decision(run, item),
            _ => format!("result: {shown}"),
        },
    }
}

fn alone(run: Run, item: Item) -> String {
    let value = quantity(run, item).and_then(|_| before::value(run, item));
    value.map_or_else(|| only(run, item).0, |value| named(run, item, &value, Style::default()))
}

fn is_filter(run: Run, event: usize) -> bool {
    matches!(run.log.events[event].what, What::Mark(Decision::Attenuated { .. }))
}
