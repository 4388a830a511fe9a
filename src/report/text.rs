//! The walk as plain text: every node, every value with its formula and the numbers put in.

use super::{Style, computation, digits, number, words};
use crate::log::{Event, Log, Name, Tree, Value, What};
use std::fmt::Write;

/// The whole log as text.
pub fn text(log: &Log, style: Style) -> String {
    let header = &log.header;
    let mut out = String::new();
    let subject: Vec<_> = words::frame(header).into_iter().chain([words::subject(header)]).collect();
    let subject = subject.join(", ");
    let algorithm = format!("{}, depth {}", header.tracing.algorithm, header.tracing.max_depth);
    let sampling = words::sampling(header).map_or(String::new(), |sampling| format!(" · {sampling}"));
    let scene = words::plain(&header.scene.name);
    // Writing to a String can't fail.
    let _ = writeln!(out, "{scene} · {subject} · {} · {algorithm}{sampling}", header.arithmetic);
    let tree = Tree::of(&log.events);
    for event in 0..log.events.len() {
        if let Some(line) = line(log, &tree, event, style) {
            let _ = writeln!(out, "{line}");
        }
    }
    out
}

/// The line of an event, indented; `None` for events that need none.
fn line(log: &Log, tree: &Tree, event: usize, style: Style) -> Option<String> {
    let node = tree.owner(event);
    let level = tree.nodes()[node].level;
    let happening = &log.events[event];
    let body = match &happening.what {
        What::Enter { .. } => {
            let given = given(happening, style);
            let title = words::title(log, tree, node);
            let title = if given.is_empty() { title } else { format!("{title}: {given}") };
            return Some(format!("{}{title}", "  ".repeat(level.saturating_sub(1))));
        }
        What::Note { name, .. } => {
            let line = computation(log, tree, event, style)?.line();
            let body = format!("{line}{}   [{}]", digits::marker(happening), source(*name));
            let given = given(happening, style);
            if given.is_empty() { body } else { format!("given {given}\n{}{body}", "  ".repeat(level)) }
        }
        What::Mark(decision) => {
            let lost = words::lost(happening, style).map_or(String::new(), |lost| format!("; {lost}"));
            format!("→ {}{lost}{}", words::decision(&log.header, decision, style), digits::marker(happening))
        }
        What::Leave => return None,
        What::Result { color } => {
            let color = number::value(&Value::Triple(*color), style);
            return Some(format!("result: {color}{}", digits::marker(happening)));
        }
    };
    Some(format!("{}{body}", "  ".repeat(level)))
}

/// The inputs of an event: `r = 3, S_c = (17, 9, 8)`.
pub fn given(event: &Event, style: Style) -> String {
    let inputs = event.given.iter().map(|(name, value)| format!("{} = {}", name.symbol(), number::value(value, style)));
    inputs.collect::<Vec<_>>().join(", ")
}

fn source(name: Name) -> String {
    format!("{} {}", name.key(), name.section())
}
