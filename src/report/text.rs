//! The walk as plain text: every node, every value with its formula and the numbers put in.

use super::computation;
use super::language::Language;
use super::tag::tag;
use super::{Style, digits, notation, words};
use crate::log::{Input, Log, Tree, Value, What};
use std::fmt::Write;

/// The whole log as text.
pub fn text(language: Language, log: &Log, style: Style) -> String {
    let header = &log.header;
    let mut out = String::new();
    let subject = words::subject_in_frame(language, header);
    let algorithm = format!("{}, {} {}", header.tracing.algorithm, language.texts().depth, header.tracing.max_depth);
    let sampling = words::sampling(language, header).map_or(String::new(), |sampling| format!(" · {sampling}"));
    let scene = words::plain(&header.scene.name);
    // Writing to a String can't fail.
    let _ = writeln!(out, "{scene} · {subject} · {} · {algorithm}{sampling}", words::arithmetic(header));
    let tree = Tree::of(&log.events);
    for event in 0..log.events.len() {
        if let Some(line) = line(language, log, &tree, event, style) {
            let _ = writeln!(out, "{line}");
        }
    }
    out
}

/// The line of an event, indented; `None` for events that need none.
fn line(language: Language, log: &Log, tree: &Tree, event: usize, style: Style) -> Option<String> {
    let node = tree.owner(event);
    let level = tree.nodes()[node].level;
    let happening = &log.events[event];
    let body = match &happening.what {
        What::Enter { .. } => {
            let given = given(language, log.given(event), style);
            let title = words::title(language, log, tree, node);
            let title = if given.is_empty() { title } else { format!("{title}: {given}") };
            return Some(format!("{}{title}", indent(level.saturating_sub(1))));
        }
        What::Note { name, .. } => {
            let source = [Some(name.key().to_owned()), tag(log, tree, event)];
            let source = source.into_iter().flatten().collect::<Vec<_>>().join(" ");
            let line = computation(language, log, tree, event, style)?.line();
            let body = format!("{line}{}   [{source}]", digits::marker(language, log, tree, event));
            let given = given(language, log.given(event), style);
            if given.is_empty() { body } else { format!("{} {given}\n{}{body}", language.texts().given, indent(level)) }
        }
        What::Mark(decision) => {
            let lost = words::lost(language, log.given(event), style);
            let numbers = notation::line(language, log, tree, event, style);
            let numbers = numbers.map_or(String::new(), |numbers| format!(" ({numbers})"));
            format!(
                "→ {}{numbers}{lost}{}",
                words::decision(language, &log.header, decision, style),
                digits::marker(language, log, tree, event)
            )
        }
        What::Leave => return None,
        What::Result { color } => {
            let color = language.value(&Value::Triple(*color), style);
            return Some(format!("{}: {color}{}", language.texts().result, digits::marker(language, log, tree, event)));
        }
    };
    Some(format!("{}{body}", indent(level)))
}

/// Lines are indented by this many levels at most. Deeper lines begin with the number of their level, so that a deep log isn't mostly spaces.
const MOST_INDENT: usize = 32;

/// What precedes a line of a level.
pub(super) fn indent(level: usize) -> String {
    let space = "  ".repeat(level.min(MOST_INDENT));
    if level > MOST_INDENT { format!("{space}({level}) ") } else { space }
}

/// The inputs of an event: `r = 3, S_c = (17, 9, 8)`.
pub fn given(language: Language, inputs: &[Input], style: Style) -> String {
    let inputs = inputs.iter().map(|(name, value)| format!("{} = {}", name.symbol(), language.value(value, style)));
    inputs.collect::<Vec<_>>().join(", ")
}
