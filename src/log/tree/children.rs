//! The nodes inside those that hold many, by what they are.

use super::Tree;
use crate::log::event::{RayKind, Step, Term, What};
use crate::log::events::Events;
use crate::log::name::Name;

/// What is looked for among the nodes directly inside another one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Child {
    /// Whatever it is.
    Any,
    /// A sample.
    Sample,
    /// A weighted sum.
    Combine,
    /// A ray, or a zone around one, of a bounce of this kind.
    Bounce(Term),
    /// A shadow ray.
    Shadow,
    /// A node that notes a local intensity.
    Local,
}

impl Child {
    /// Whether a node is one.
    pub(in crate::log) fn is(self, events: &Events, tree: &Tree, node: usize) -> bool {
        match (self, tree.nodes()[node].step) {
            (Child::Any, _)
            | (Child::Sample, Some(Step::Sample { .. }))
            | (Child::Combine, Some(Step::Combine))
            | (Child::Bounce(Term::Reflected), Some(Step::Ray { kind: RayKind::Reflected, .. }))
            | (Child::Bounce(Term::Transmitted), Some(Step::Ray { kind: RayKind::Transmitted, .. }))
            | (Child::Shadow, Some(Step::Ray { kind: RayKind::Shadow { .. }, .. })) => true,
            (Child::Bounce(of), Some(Step::Zone { what, .. })) => of == what,
            (Child::Local, _) => {
                let symbol = Name::ShadeLocal.symbol();
                let is_local =
                    |at: usize| matches!(events[at].what, What::Note { name, .. } if name.symbol() == symbol);
                tree.own_events(node).any(is_local)
            }
            _ => false,
        }
    }

    fn all() -> impl Iterator<Item = Child> {
        let bounces = [Term::Reflected, Term::Transmitted].map(Child::Bounce);
        [Child::Any, Child::Sample, Child::Combine, Child::Shadow, Child::Local].into_iter().chain(bounces)
    }

    /// Those inside a node of each kind, in order.
    pub(super) fn inside(events: &Events, tree: &Tree, node: usize) -> impl Iterator<Item = (Child, Vec<u32>)> {
        let of_kind = move |kind: Child| tree.children(node).filter(move |child| kind.is(events, tree, *child));
        Child::all().map(move |kind| (kind, of_kind(kind).map(|child| child as u32).collect()))
    }
}

/// How many nodes are directly inside each node.
pub(super) fn counts(tree: &Tree) -> Vec<u32> {
    let mut counts = vec![0; tree.nodes().len()];
    tree.nodes().iter().skip(1).for_each(|node| counts[node.parent] += 1);
    counts
}
