//! What each node came to, and how many rays lie inside it: gathered once, in one pass over the events.

use crate::log::{Decision, Event, Log, Name, Node, RayKind, Step, Term, Tree, What};
use std::ops::Range;

/// What the nodes of a tree came to.
#[derive(Clone, Debug)]
pub struct Facts {
    nodes: Vec<Fact>,
    /// How many of the nodes before each one are rays.
    rays_before: Vec<u32>,
}

/// What one node came to. Each field is the number of an event plus one; 0 is none.
#[derive(Clone, Copy, Debug, Default)]
struct Fact {
    value: u32,
    outcome: u32,
    limit: u32,
}

impl Facts {
    /// The facts of a log.
    pub fn of(log: &Log, tree: &Tree) -> Facts {
        let mut facts = Facts { nodes: vec![Fact::default(); tree.nodes().len()], rays_before: rays_before(tree) };
        for (index, event) in log.events.iter().enumerate() {
            facts.take(tree, index, event);
        }
        facts
    }

    /// The event with a node's value: the colour of a pixel, ray or surface, the distance of a test.
    pub fn value(&self, node: usize) -> Option<usize> {
        self.event(node, |fact| fact.value)
    }

    /// The event with a node's decision: a hit or miss, the nearest object, the background, what blocks the light.
    pub fn outcome(&self, node: usize) -> Option<usize> {
        self.event(node, |fact| fact.outcome)
    }

    /// The event that says why a bounce of this ray doesn't go on: a depth limit or a total internal reflection.
    pub fn limit(&self, node: usize) -> Option<usize> {
        self.event(node, |fact| fact.limit)
    }

    /// How many rays are among these nodes.
    pub fn rays(&self, nodes: Range<usize>) -> u32 {
        self.rays_before[nodes.end] - self.rays_before[nodes.start]
    }

    fn event(&self, node: usize, field: impl Fn(&Fact) -> u32) -> Option<usize> {
        (field(&self.nodes[node]) as usize).checked_sub(1)
    }

    fn take(&mut self, tree: &Tree, index: usize, event: &Event) {
        let owner = tree.owner(index);
        let fact = &mut self.nodes[owner];
        let number = index as u32 + 1;
        match event.what {
            What::Note { name, .. } if says_what_came(tree.nodes()[owner].step, name) => fact.value = number,
            What::Note { .. } => {}
            What::Result { .. } => fact.value = number,
            // Why no shadow ray goes to a light.
            What::Mark(Decision::Skipped { what: Term::Shadow, .. } | Decision::Free)
                if is_light(&tree.nodes()[owner]) =>
            {
                fact.outcome = number;
            }
            What::Mark(decision) => match decision {
                Decision::Outside | Decision::Inside | Decision::Skipped { .. } | Decision::LeakGuard { .. } => {}
                Decision::Coincident { .. } | Decision::Immersed { .. } | Decision::Bent { .. } => {}
                // The end of the ray says that nothing is in the way.
                Decision::Free => {}
                Decision::Asked { .. } => {}
                Decision::Subdivided { .. } | Decision::Accepted { .. } | Decision::MoreSamples { .. } => {}
                Decision::DepthLimit { .. } | Decision::TotalInternalReflection => fact.limit = number,
                Decision::Hit | Decision::Miss { .. } | Decision::Nearest { .. } | Decision::Background => {
                    fact.outcome = number
                }
                Decision::Occluded { .. } | Decision::Attenuated { .. } => fact.outcome = number,
                Decision::Undefined { .. } | Decision::Rejected { .. } => fact.outcome = number,
            },
            What::Leave => self.hand_up(tree, owner),
            What::Enter { .. } => {}
        }
    }

    /// What a node came to is also what the node around it came to, where that one has no value of its own.
    fn hand_up(&mut self, tree: &Tree, node: usize) {
        let inner = self.nodes[node];
        let parent = tree.nodes()[node].parent;
        let outer = &mut self.nodes[parent];
        match (tree.nodes()[parent].step, tree.nodes()[node].step) {
            (Some(Step::Ray { .. }), Some(Step::Combine)) => outer.value = inner.value,
            (Some(Step::Sample { .. } | Step::Zone { .. }), Some(Step::Ray { .. })) => outer.value = inner.value,
            (Some(Step::Motion { .. }), Some(Step::Test { .. })) => {
                outer.value = inner.value;
                outer.outcome = inner.outcome;
            }
            (Some(Step::Light { .. }), Some(Step::Ray { kind: RayKind::Shadow { .. }, .. })) => {
                outer.outcome = inner.outcome;
            }
            _ => {}
        }
    }
}

/// Whether a quantity is what such a node is there for.
fn says_what_came(step: Option<Step>, name: Name) -> bool {
    match step {
        // The distance; a disk and a polygon name more after it.
        Some(Step::Test { .. }) => name.key().ends_with(".t"),
        Some(Step::Shade { .. }) => name.is(Name::ShadeLocal),
        Some(Step::Combine) => name.is(Name::CombineColor),
        _ => false,
    }
}

fn rays_before(tree: &Tree) -> Vec<u32> {
    let mut count = 0;
    let mut before = Vec::with_capacity(tree.nodes().len() + 1);
    before.push(0);
    for node in tree.nodes() {
        count += u32::from(is_ray(node));
        before.push(count);
    }
    before
}

fn is_light(node: &Node) -> bool {
    matches!(node.step, Some(Step::Light { .. }))
}

fn is_ray(node: &Node) -> bool {
    matches!(node.step, Some(Step::Ray { .. }))
}
