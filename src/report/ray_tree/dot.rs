//! The ray tree for Graphviz.

use super::{Branch, End, Figure, color};
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
    let mut number = 0;
    for branch in figure.branches {
        write_branch(&mut out, figure, branch, "eye", &mut number);
    }
    line!(out, "}}");
    out
}

fn write_branch(out: &mut String, figure: &Figure, branch: &Branch, parent: &str, number: &mut usize) {
    *number += 1;
    let name = format!("n{number}");
    let label = escape::dot(&figure.end(branch));
    let shape = match branch.end {
        End::Object(_) => "",
        End::Background | End::TooDeep | End::Unknown => ", shape=plaintext, fontcolor=\"#667788\"",
        End::Light(_) | End::Blocked { .. } => ", shape=plaintext",
    };
    let tip = escape::dot(&figure.description(branch));
    line!(out, "  {name} [label=\"{label}\"{shape}, tooltip=\"{tip}\"];");
    let blocked = if branch.is_blocked() { ", style=dashed, arrowhead=tee" } else { "" };
    let mark = if branch.is_blocked() { " ✗" } else { "" };
    let (width, color) = (1.0 + 5.0 * branch.width(), color(branch));
    line!(
        out,
        "  {parent} -> {name} [label=\" {}{mark}\", color=\"{color}\", fontcolor=\"{color}\", penwidth={width:.2}{blocked}, \
         tooltip=\"{tip}\"];",
        escape::dot(&branch.label)
    );
    for child in &branch.children {
        write_branch(out, figure, child, &name, number);
    }
}
