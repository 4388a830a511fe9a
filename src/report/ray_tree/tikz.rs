//! The ray tree as a picture of LaTeX's TikZ.

use super::layout::{Spot, spots};
use super::{End, Figure};
use crate::log::RayKind;
use crate::report::escape::{self, line};
use std::fmt::Write;

/// The width of a character and the distance of levels, in centimetres.
const CHARACTER: f64 = 0.19;
const LEVEL: f64 = 1.6;

/// The figure; the colours of the kinds are those of the document.
pub fn tikz(figure: &Figure) -> String {
    let (spots, _) = spots(figure);
    let mut out = String::new();
    line!(out, "\\begin{{tikzpicture}}[every node/.style={{font=\\small}}]");
    for (number, spot) in spots.iter().enumerate() {
        let style = match spot.branch.map(|branch| branch.end) {
            None => "draw, rounded corners, fill=camera, text=white",
            Some(End::Object(_)) => "draw, rounded corners=6pt, fill=black!5",
            Some(End::Light(_)) => "fill=shadow!20, rounded corners=6pt",
            Some(_) => "text=black!60",
        };
        let (x, y) = place(spot);
        line!(out, "\\node[{style}] (n{number}) at ({x:.2},{y:.2}) {{{}}};", escape::latex(&spot.text));
    }
    for (number, spot) in spots.iter().enumerate() {
        let Some(branch) = spot.branch else { continue };
        let color = match branch.kind {
            _ if branch.is_blocked() => "blocked, dashed",
            RayKind::Camera => "camera",
            RayKind::Reflected => "reflected",
            RayKind::Transmitted => "transmitted",
            RayKind::Shadow { .. } => "shadow",
        };
        let mark = if branch.is_blocked() { " $\\times$" } else { "" };
        line!(
            out,
            "\\draw[{color}, line width={:.1}pt] (n{}) -- node[pos=0.68, fill=white, inner sep=1pt] {{{}{mark}}} (n{number});",
            0.5 + 3.5 * branch.width(),
            spot.parent,
            escape::latex(&branch.label)
        );
    }
    line!(out, "\\end{{tikzpicture}}");
    out
}

fn place(spot: &Spot) -> (f64, f64) {
    (spot.x * CHARACTER, -(spot.level as f64) * LEVEL)
}
