//! Which rows of the tree are shown: those that a filter keeps, with the intersection tests or without.
//!
//! Most rows of a pixel are tests. Without them the tree is that of figure 7: rays, local models and weighted sums.

use super::model::Model;
use crate::log::{RayKind, Step, Tree};
use crate::report::Language;

/// Shows the rows of these nodes and those around them, or all; without the tests, if they are hidden.
pub(super) fn keep(model: &mut Model, nodes: Option<Vec<usize>>) {
    let tree = &model.tree;
    let nodes = match nodes {
        nodes if !model.guide.hides_tests => nodes,
        Some(nodes) => Some(nodes.into_iter().filter(|node| !tree.around(*node).any(|at| is_test(tree, at))).collect()),
        None => Some(without_tests(tree)),
    };
    model.fold.visible.keep(&model.tree, nodes);
    // One's own place isn't lost.
    model.fold.visible.show(&model.tree, model.cursor);
}

/// The nodes that aren't in a test, in order.
fn without_tests(tree: &Tree) -> Vec<usize> {
    let after = |node: usize| if is_test(tree, node) { tree.nodes()[node].subtree_end } else { node + 1 };
    let all = std::iter::successors(Some(0), |node| Some(after(*node)).filter(|next| *next < tree.nodes().len()));
    all.filter(|node| !is_test(tree, *node)).collect()
}

/// Whether a node is a test of an object, or of one that moves.
fn is_test(tree: &Tree, node: usize) -> bool {
    matches!(tree.nodes()[node].step, Some(Step::Test { .. } | Step::Motion { .. }))
}

/// The nodes that a kind of ray brings, if a text is the word for one: the rays and all that is traced for them.
pub(super) fn of_rays(model: &Model, text: &str) -> Option<Vec<usize>> {
    let is_called = |kind: RayKind| Language::ALL.into_iter().any(|language| text == word(language, kind));
    let kinds = [RayKind::Reflected, RayKind::Transmitted, RayKind::Shadow { light: 0 }];
    let wanted = kinds.into_iter().find(|kind| is_called(*kind))?;
    let is_alike = |kind: RayKind| std::mem::discriminant(&kind) == std::mem::discriminant(&wanted);
    let nodes = model.tree.nodes();
    let rays = (0..nodes.len()).filter(|node| model.tree.ray(*node).is_some_and(is_alike));
    let mut end = 0;
    let mut found = Vec::new();
    for ray in rays {
        // Rays within rays are there already.
        found.extend(ray.max(end)..nodes[ray].subtree_end);
        end = end.max(nodes[ray].subtree_end);
    }
    Some(found).filter(|found| !found.is_empty())
}

fn word(language: Language, kind: RayKind) -> &'static str {
    let texts = language.texts();
    match kind {
        RayKind::Reflected => texts.reflected,
        RayKind::Transmitted => texts.transmitted,
        RayKind::Shadow { .. } | RayKind::Camera => texts.viewer.status.shadow,
    }
}
