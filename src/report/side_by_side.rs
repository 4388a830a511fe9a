//! The values of one node in several arithmetics, beside each other.
//!
//! Two runs are aligned as everywhere: by the way of the nodes from the root (which holds the path of the ray), the key of the
//! quantity, and which occurrence of it in its node it is. Where a run decides otherwise it may never come to a node, or to a
//! quantity in it; that is said and not hidden.

use crate::log::tree::Way;
use crate::log::{Decision, Digits, Log, Name, Step, Tree, Value, What};

/// A run in one arithmetic.
#[derive(Clone, Copy, Debug)]
pub struct Run<'a> {
    /// Its log.
    pub log: &'a Log,
    /// Its nodes.
    pub tree: &'a Tree,
}

/// A quantity of the node in every run.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which quantity; none for the colour of the pixel.
    pub name: Option<Name>,
    /// The event that notes it in the first run that comes to it, if that is the first of all.
    pub event: Option<usize>,
    /// Its value in each run; `None` where the run doesn't come to it.
    pub values: Vec<Option<Value>>,
    /// How many digits of it can be trusted, where some run knows.
    pub digits: Option<Digits>,
}

/// What the runs say of a node.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// A row a quantity, in the order of the first run; those that only others have follow.
    pub rows: Vec<Row>,
    /// For each run, whether it comes to the node.
    pub reaches: Vec<bool>,
    /// For each run, whether it decides in the node as the first does.
    pub agrees: Vec<bool>,
}

/// The values of a node of the first run, and of those in its place in the others.
pub fn table(runs: &[Run], node: usize) -> Table {
    let Some(first) = runs.first() else { return Table { rows: Vec::new(), reaches: Vec::new(), agrees: Vec::new() } };
    let way = Way::to(first.tree, node);
    let places: Vec<_> = runs.iter().map(|run| way.end_in(run.tree).ok()).collect();
    let mut rows: Vec<Row> = Vec::new();
    for (number, (run, place)) in runs.iter().zip(&places).enumerate() {
        let Some(place) = *place else { continue };
        let mut seen: Vec<Option<Name>> = Vec::new();
        for event in run.tree.own_events(place) {
            let (name, value) = match run.log.events[event].what {
                What::Note { name, value } => (Some(name), value),
                What::Result { color } => (None, Value::Triple(color)),
                _ => continue,
            };
            let quantity = name.map(Name::quantity);
            let occurrence = seen.iter().filter(|earlier| **earlier == quantity).count();
            seen.push(quantity);
            let same = rows.iter_mut().filter(|row| row.name.map(Name::quantity) == quantity).nth(occurrence);
            let digits = run.log.events[event].digits.as_deref().copied();
            match same {
                Some(row) => {
                    row.values[number] = Some(value);
                    row.digits = row.digits.or(digits);
                }
                None => {
                    let mut values = vec![None; runs.len()];
                    values[number] = Some(value);
                    rows.push(Row { name, event: (number == 0).then_some(event), values, digits });
                }
            }
        }
    }
    let own = decisions(first, node);
    let agrees = runs.iter().zip(&places).map(|(run, place)| place.is_some_and(|place| decisions(run, place) == own));
    Table { rows, agrees: agrees.collect(), reaches: places.iter().map(Option::is_some).collect() }
}

/// What a node decides, and which nodes are in it besides intersection tests, which may come in another order.
fn decisions(run: &Run, node: usize) -> (Vec<Decision>, Vec<Step>) {
    let marks = run.tree.own_events(node).filter_map(|event| match run.log.events[event].what {
        // The factor of a filter is a number, and its object says enough.
        What::Mark(Decision::Attenuated { object, .. }) => Some(Decision::Attenuated { object, factor: [0.0; 3] }),
        What::Mark(decision) => Some(decision),
        _ => None,
    });
    let steps = run.tree.children(node).filter_map(|child| run.tree.nodes()[child].step);
    (marks.collect(), steps.filter(|step| !matches!(step, Step::Test { .. } | Step::Motion { .. })).collect())
}
