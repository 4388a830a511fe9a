//! The tree of calls (Ramos, figure 9): the ray tree without its shadow rays, and with the calls that return black at once because
//! they lie too deep.

use super::{Branch, End};
use crate::log::{Decision, Log, RayKind, Step, Term, Tree, What};
use crate::report::language::Language;
use crate::report::pseudocode;

/// The calls that trace these rays.
pub fn calls(log: &Log, tree: &Tree, branches: Vec<Branch>) -> Vec<Branch> {
    let is_call = |branch: &Branch| !matches!(branch.kind, RayKind::Shadow { .. });
    branches.into_iter().filter(is_call).map(|branch| call(log, tree, branch)).collect()
}

fn call(log: &Log, tree: &Tree, branch: Branch) -> Branch {
    let depth = match tree.nodes()[branch.node].step {
        Some(Step::Ray { depth, .. }) => depth,
        _ => 0,
    };
    let call = pseudocode::call(Language::English, &log.header, &branch.path, depth);
    let too_deep =
        if pseudocode::calls_too_deep(&log.header) { too_deep(log, tree, &branch, depth) } else { Vec::new() };
    let children = calls(log, tree, branch.children).into_iter().chain(too_deep).collect();
    Branch { call: Some(call), children, ..branch }
}

/// The calls from the end of a ray that the depth limit stops.
fn too_deep(log: &Log, tree: &Tree, branch: &Branch, depth: u32) -> Vec<Branch> {
    let limits = tree.own_events(branch.node).filter_map(|event| match log.events[event].what {
        What::Mark(Decision::DepthLimit { what: Term::Reflected }) => Some(RayKind::Reflected),
        What::Mark(Decision::DepthLimit { what: Term::Transmitted }) => Some(RayKind::Transmitted),
        _ => None,
    });
    let leaf = |kind: RayKind| {
        let path = format!("{} {}", branch.path, kind.letter());
        Branch {
            node: branch.node,
            label: kind.letter().to_owned(),
            kind,
            end: End::TooDeep,
            call: Some(pseudocode::call(Language::English, &log.header, &path, depth + 1)),
            path,
            share: 0.0,
            color: [0.0; 3],
            children: Vec::new(),
        }
    };
    limits.map(leaf).collect()
}
