//! The ray tree as a picture of LaTeX's TikZ.

use super::layout::{LETTER_AT, Spot, spots};
use super::{End, Figure};
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
    // The letters lie over all lines.
    for is_letter in [false, true] {
        for (number, spot) in spots.iter().enumerate() {
            write_ray(&mut out, spot, number, is_letter);
        }
    }
    line!(out, "\\end{{tikzpicture}}");
    out
}

/// The line of a ray, or the letter on it.
fn write_ray(out: &mut String, spot: &Spot, number: usize, is_letter: bool) {
    let Some(branch) = spot.branch else { return };
    let color = branch.group().word();
    let (from, dashes) = (spot.parent, if branch.is_blocked() { ", dashed" } else { "" });
    if is_letter {
        let mark = if branch.is_blocked() { " $\\times$" } else { "" };
        let letter =
            format!("node[pos={LETTER_AT}, fill=white, inner sep=1pt] {{{}{mark}}}", escape::latex(&branch.label));
        line!(out, "\\path[{color}] (n{from}) -- {letter} (n{number});");
    } else {
        let width = 0.5 + 3.5 * branch.width();
        line!(out, "\\draw[{color}{dashes}, line width={width:.1}pt] (n{from}) -- (n{number});");
    }
}

fn place(spot: &Spot) -> (f64, f64) {
    (spot.x * CHARACTER, -(spot.level as f64) * LEVEL)
}
