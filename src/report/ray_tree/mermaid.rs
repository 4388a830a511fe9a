//! The ray tree for Mermaid, which many places draw where they show Markdown.

use super::{Branch, End, Figure, color};
use crate::report::escape::{self, line};
use std::fmt::Write;

/// The figure as a Mermaid flowchart.
pub fn mermaid(figure: &Figure) -> String {
    let mut out = String::new();
    line!(out, "flowchart TD");
    line!(out, "  eye([\"{}\"])", escape::mermaid(figure.language.texts().figure.eye));
    let mut styles = Vec::new();
    for branch in figure.branches {
        write_branch(&mut out, figure, branch, "eye", &mut styles);
    }
    for (number, style) in styles.iter().enumerate() {
        line!(out, "  linkStyle {number} {style}");
    }
    line!(out, "  classDef leaf fill:none,stroke:none");
    out
}

fn write_branch(out: &mut String, figure: &Figure, branch: &Branch, parent: &str, styles: &mut Vec<String>) {
    let name = format!("n{}", styles.len() + 1);
    let label = escape::mermaid(&figure.end(branch));
    let node = match branch.end {
        End::Object(_) => format!("{name}([\"{label}\"])"),
        _ => format!("{name}[\"{label}\"]:::leaf"),
    };
    let ray = escape::mermaid(&branch.label);
    if branch.is_blocked() {
        line!(out, "  {parent} -. \"{ray} ✗\" .-x {node}");
    } else {
        line!(out, "  {parent} -- \"{ray}\" --> {node}");
    }
    let dashes = if branch.is_blocked() { ",stroke-dasharray:4 3" } else { "" };
    styles.push(format!("stroke:{},stroke-width:{:.1}px{dashes}", color(branch), 1.0 + 5.0 * branch.width()));
    for child in &branch.children {
        write_branch(out, figure, child, &name, styles);
    }
}
