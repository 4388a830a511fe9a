//! The schematic as a picture of LaTeX's TikZ.

use super::Plan;
use crate::report::escape::{self, line};
use crate::report::ray_group::RayGroup;
use std::fmt::Write;

/// Units of the plan in a centimetre.
const UNITS: f64 = 42.0;

/// The figure; the colours of the kinds are those of the document.
pub fn tikz(plan: &Plan) -> String {
    let at = |[x, y]: [f64; 2]| format!("({:.2},{:.2})", bounded(x), -bounded(y));
    let mut out = String::new();
    line!(out, "\\begin{{tikzpicture}}[every node/.style={{font=\\small, inner sep=1pt}}]");
    line!(out, "\\clip (0,0) rectangle {};", at(plan.size));
    for outline in &plan.outlines {
        let points: Vec<_> = outline.iter().map(|place| at(*place)).collect();
        line!(out, "\\draw[black!25] {};", points.join(" -- "));
    }
    for ray in &plan.rays {
        let color = RayGroup::of(ray.kind, ray.is_blocked).word();
        let style = if ray.is_blocked { "dashed" } else { "thick" };
        line!(out, "\\draw[{color}, {style}] {} -- {};", at(ray.from), at(ray.to));
    }
    for place in &plan.points {
        line!(out, "\\fill {} circle (2pt);", at(*place));
    }
    for place in &plan.lights {
        line!(out, "\\filldraw[draw=shadow, fill=yellow!60] {} circle (3pt);", at(*place));
    }
    if let Some(place) = plan.eye {
        line!(out, "\\filldraw[draw=camera, fill=white, thick] {} circle (3pt);", at(place));
    }
    for label in &plan.labels {
        let color = label.ray.map_or("black", |(kind, is_blocked)| RayGroup::of(kind, is_blocked).word());
        line!(
            out,
            "\\node[text={color}, fill=white, fill opacity=0.8, text opacity=1] at {} {{{}}};",
            at(label.at),
            escape::latex(&label.text)
        );
    }
    line!(out, "\\end{{tikzpicture}}");
    out
}

/// In centimetres; TeX knows no lengths of more than some metres, and what is far out is clipped anyhow.
fn bounded(x: f64) -> f64 {
    (x / UNITS).clamp(-100.0, 100.0)
}
