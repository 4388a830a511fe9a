//! The ray tree in one line a ray: what it hits, whether light gets through, what colour it brings.

use super::language::Language;
use super::{Style, text, words};
use crate::log::{Decision, Log, Name, RayKind, Step, Tree, Value, What};
use std::fmt::Write;

/// The ray tree of a log, indented by level.
pub fn outline(log: &Log, style: Style) -> String {
    let tree = Tree::of(&log.events);
    let mut out = String::new();
    for (index, node) in tree.nodes().iter().enumerate() {
        let Some(Step::Ray { kind, .. }) = node.step else { continue };
        let path = tree.shown_path(index);
        let level = tree.steps_to(index).saturating_sub(1);
        // Writing to a String can't fail.
        let _ = writeln!(out, "{}{path}: {}", text::indent(level), fate(log, &tree, index, kind, style));
    }
    if let Some(What::Result { color }) = log.events.last().map(|event| &event.what) {
        let _ = writeln!(out, "result: {}", Language::English.value(&Value::Triple(*color), style));
    }
    out
}

/// What became of a ray.
fn fate(log: &Log, tree: &Tree, node: usize, kind: RayKind, style: Style) -> String {
    let mut words = Vec::new();
    for event in tree.own_events(node) {
        match &log.events[event].what {
            What::Mark(Decision::Nearest { object }) => words.push(words::plain(log.header.object(*object))),
            What::Mark(decision) => words.push(words::decision(Language::English, &log.header, decision, style)),
            _ => {}
        }
    }
    if words.is_empty() && matches!(kind, RayKind::Shadow { .. }) {
        words.push("free".to_owned());
    }
    let combined = tree.children(node).filter(|child| tree.nodes()[*child].step == Some(Step::Combine)).last();
    let color = combined.and_then(|combine| {
        let noted = tree.own_events(combine).filter_map(|event| log.events[event].noted());
        noted.into_iter().find(|(name, _)| *name == Name::CombineColor)
    });
    words.extend(color.map(|(_, value)| Language::English.value(&value, style)));
    words.join(", ")
}
