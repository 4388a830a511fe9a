//! The ray tree for Graphviz.

use super::layout::{self, Spot, name_of};
use super::{Branch, End, Figure};
use crate::report::escape::{self, line};
use std::fmt::Write;

/// The figure in the language of Graphviz, for `dot`.
pub fn dot(figure: &Figure) -> String {
    let texts = &figure.language.texts().figure;
    let mut out = String::new();
    line!(out, "digraph rays {{");
    line!(out, "  label=\"{}\\n{}\";", escape::dot(&figure.title()), escape::dot(texts.width));
    line!(out, "  labelloc=b; fontname=\"Helvetica\"; fontsize=11; ranksep=0.5; nodesep=0.2;");
    line!(out, "  node [fontname=\"Helvetica\", fontsize=11, shape=ellipse, margin=\"0.06,0.03\"];");
    line!(out, "  edge [fontname=\"Helvetica\", fontsize=11, arrowsize=0.6];");
    line!(out, "  eye [label=\"{}\", shape=house, orientation=180];", escape::dot(texts.eye));
    for (number, spot) in layout::spots(figure).0.iter().enumerate() {
        if let Some(branch) = spot.branch {
            write_branch(&mut out, figure, branch, spot, number);
        }
    }
    line!(out, "}}");
    out
}

fn write_branch(out: &mut String, figure: &Figure, branch: &Branch, spot: &Spot, number: usize) {
    let (name, parent) = (name_of(number), name_of(spot.parent));
    let label = escape::dot(&spot.text);
    let shape = match branch.end {
        End::Object(_) => "",
        End::Background | End::TooDeep | End::Unknown => ", shape=plaintext, fontcolor=\"#667788\"",
        End::Light(_) | End::Blocked { .. } => ", shape=plaintext",
    };
    let tip = escape::dot(&figure.description(branch));
    line!(out, "  {name} [label=\"{label}\"{shape}, tooltip=\"{tip}\"];");
    let blocked = if branch.is_blocked() { ", style=dashed, arrowhead=tee" } else { "" };
    let mark = if branch.is_blocked() { " ✗" } else { "" };
    let (width, color) = (1.0 + 5.0 * branch.width(), branch.group().hex());
    line!(
        out,
        "  {parent} -> {name} [label=\" {}{mark}\", color=\"#{color}\", fontcolor=\"#{color}\", penwidth={width:.2}{blocked}, \
         tooltip=\"{tip}\"];",
        escape::dot(&branch.label)
    );
}
