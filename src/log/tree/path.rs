//! The way of a ray from the eye.

use super::{Node, Tree};
use crate::log::event::{RayKind, Step};
use std::iter;

/// Nodes no deeper than this are gone up one by one.
const FEW_LEVELS: usize = 64;

/// The most steps of a path that is shown as a whole: those of a sample, of the deepest recursion that a scene may ask for (256), and of
/// a shadow ray. Only logs from elsewhere have longer ones.
const LONGEST_SHOWN: u32 = 260;

/// So many of the first steps and of the last ones of a longer path are shown.
const SHOWN: u32 = 8;

/// What is known of a deep node.
#[derive(Clone, Copy, Debug)]
pub(super) struct Deep {
    node: u32,
    /// The node itself or the nearest one around it that is a step of the path; 0 if there is none.
    step: u32,
    /// How many steps the path has.
    length: u32,
    /// The node of the last of the first steps, if there are this many.
    head: u32,
}

impl Tree {
    /// The way of a node's ray from the eye, such as `C R S1`, or `3 C R S1` in the third sample; empty outside every ray.
    pub fn path(&self, node: usize) -> String {
        self.joined(self.steps_up(node).collect())
    }

    /// The same for people: of a path that nobody would read to its end, the first and the last steps, and how many are between them.
    pub fn shown_path(&self, node: usize) -> String {
        match self.deep(node) {
            Some(Deep { step, length, head, .. }) if length > LONGEST_SHOWN => {
                let last = self.steps_up(step as usize).take(SHOWN as usize).collect();
                format!("{} …{}… {}", self.path(head as usize), length - 2 * SHOWN, self.joined(last))
            }
            _ => self.path(node),
        }
    }

    /// How many steps its path has.
    pub fn steps_to(&self, node: usize) -> usize {
        self.deep(node).map_or_else(|| self.steps_up(node).count(), |deep| deep.length as usize)
    }

    /// The step of a path before this one: the ray or the sample around a ray.
    pub fn step_before(&self, node: usize) -> Option<usize> {
        self.step_around(self.nodes[node].parent)
    }

    /// The path of these nodes, of which the last comes first.
    fn joined(&self, nodes: Vec<usize>) -> String {
        let mut path = String::new();
        nodes.iter().rev().filter_map(|node| self.nodes[*node].step).for_each(|step| add_step(&mut path, step));
        path
    }

    /// The steps of a node's path, from the last one up.
    fn steps_up(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        iter::successors(self.step_around(node), |step| self.step_around(self.nodes[*step].parent))
    }

    /// The node itself or the nearest one around it that is a step of the path.
    fn step_around(&self, mut node: usize) -> Option<usize> {
        loop {
            if let Some(deep) = self.deep(node) {
                return Some(deep.step as usize).filter(|step| *step != 0);
            }
            match self.nodes[node].step {
                None | Some(Step::Pixel(_)) => return None,
                Some(step) if is_step(step) => return Some(node),
                _ => node = self.nodes[node].parent,
            }
        }
    }

    fn deep(&self, node: usize) -> Option<Deep> {
        if self.nodes[node].level <= FEW_LEVELS {
            return None;
        }
        find(self.deep.get_or_init(|| self.all_deep()), node)
    }

    /// All deep nodes, in order.
    fn all_deep(&self) -> Vec<Deep> {
        let mut found: Vec<Deep> = Vec::new();
        for (node, Node { step, parent, level, .. }) in self.nodes.iter().enumerate() {
            if *level <= FEW_LEVELS {
                continue;
            }
            let around = find(&found, *parent).unwrap_or_else(|| self.beginning(*parent));
            let mut deep = Deep { node: node as u32, ..around };
            if step.is_some_and(is_step) {
                deep.step = node as u32;
                deep.length += 1;
                if deep.length == SHOWN {
                    deep.head = deep.step;
                }
            }
            found.push(deep);
        }
        found
    }

    /// What a node that isn't deep passes on to those in it.
    fn beginning(&self, node: usize) -> Deep {
        let steps: Vec<usize> = self.steps_up(node).collect();
        let head = steps.len().checked_sub(SHOWN as usize).map_or(0, |at| steps[at]);
        let step = steps.first().copied().unwrap_or(0);
        Deep { node: node as u32, step: step as u32, length: steps.len() as u32, head: head as u32 }
    }
}

fn find(deep: &[Deep], node: usize) -> Option<Deep> {
    let at = deep.binary_search_by_key(&(node as u32), |deep| deep.node).ok()?;
    Some(deep[at])
}

fn is_step(step: Step) -> bool {
    matches!(step, Step::Sample { .. } | Step::Ray { .. })
}

/// The path of a node inside a node with this path: samples add their number, rays their letter, a
/// shadow ray also its light's number from 1: `3 C R S1`. Of several rays of a kind from one place each has its number after a
/// dot: `C R.12 S1.4` is the fourth shadow ray to the first light from the twelfth zone of a blurred reflection. A pixel of one sample has no sample node and no number.
pub fn path_of_child(path: &str, step: Step) -> String {
    let mut path = path.to_owned();
    add_step(&mut path, step);
    path
}

/// Makes the path of a node that of a node inside it.
pub(in crate::log) fn add_step(path: &mut String, step: Step) {
    let part = match step {
        Step::Pixel(_) => {
            path.clear();
            return;
        }
        Step::Sample { number } => number.to_string(),
        Step::Ray { kind, split, .. } => {
            let light = if let RayKind::Shadow { light } = kind { (light + 1).to_string() } else { String::new() };
            let split = if split == 0 { String::new() } else { format!(".{split}") };
            format!("{}{light}{split}", kind.letter())
        }
        _ => return,
    };
    if !path.is_empty() {
        path.push(' ');
    }
    path.push_str(&part);
}
