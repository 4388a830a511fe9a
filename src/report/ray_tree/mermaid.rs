//! The ray tree for Mermaid, which many places draw where they show Markdown.

use super::layout::{self, Spot, name_of};
use super::{Branch, End, Figure};
use crate::report::escape::{self, line};
use std::fmt::Write;

/// The figure as a Mermaid flowchart.
pub fn mermaid(figure: &Figure) -> String {
    let mut out = String::new();
    line!(out, "flowchart TD");
    line!(out, "  eye([\"{}\"])", escape::mermaid(figure.language.texts().figure.eye));
    let mut styles = Vec::new();
    for (number, spot) in layout::spots(figure).0.iter().enumerate() {
        if let Some(branch) = spot.branch {
            let style = write_branch(&mut out, branch, spot, number);
            styles.push(style);
        }
    }
    for (number, style) in styles.iter().enumerate() {
        line!(out, "  linkStyle {number} {style}");
    }
    line!(out, "  classDef leaf fill:none,stroke:none");
    out
}

/// Writes a ray and its end; gives the style of its line.
fn write_branch(out: &mut String, branch: &Branch, spot: &Spot, number: usize) -> String {
    let (name, parent, label) = (name_of(number), name_of(spot.parent), escape::mermaid(&spot.text));
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
    format!("stroke:#{},stroke-width:{:.1}px{dashes}", branch.group().hex(), 1.0 + 5.0 * branch.width())
}
