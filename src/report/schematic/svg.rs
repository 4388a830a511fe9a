//! The schematic as SVG.

use super::Plan;
use crate::log::RayKind;
use crate::report::escape::{self, line};
use crate::report::ray_tree::color_of;
use std::fmt::Write;

/// The figure as an element of a page.
pub fn svg_of(plan: &Plan, title: &str) -> String {
    let [width, height] = plan.size;
    let mut out = String::new();
    line!(
        out,
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width:.0} {height:.0}\" width=\"{width:.0}\" \
         height=\"{height:.0}\" font-family=\"Helvetica, Arial, sans-serif\" font-size=\"12\" text-anchor=\"middle\" role=\"img\">"
    );
    line!(out, "<title>{}</title>", escape::xml(title));
    line!(out, "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>");
    for outline in &plan.outlines {
        let points: Vec<_> = outline.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        line!(out, "<polyline points=\"{}\" fill=\"none\" stroke=\"#c4cbd6\"/>", points.join(" "));
    }
    for ray in &plan.rays {
        let ([x1, y1], [x2, y2]) = (ray.from, ray.to);
        let color = color_of(ray.kind, ray.is_blocked);
        let dashes = match ray.kind {
            _ if ray.is_blocked => " stroke-dasharray=\"5 4\"",
            RayKind::Shadow { .. } => " stroke-width=\"1.2\"",
            _ => " stroke-width=\"2.2\"",
        };
        line!(out, "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"{color}\"{dashes}/>");
    }
    for [x, y] in &plan.points {
        line!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.2\" fill=\"#1b1f27\"/>");
    }
    for [x, y] in &plan.lights {
        line!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\" fill=\"#ffd34d\" stroke=\"#c98a00\"/>");
    }
    if let Some([x, y]) = plan.eye {
        line!(
            out,
            "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\" fill=\"#ffffff\" stroke=\"#3b4252\" stroke-width=\"2\"/>"
        );
        line!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"2\" fill=\"#3b4252\"/>");
    }
    for label in &plan.labels {
        let [x, y] = label.at;
        let (color, weight) = match label.ray {
            Some((kind, is_blocked)) => (color_of(kind, is_blocked), " font-weight=\"bold\""),
            None => ("#1b1f27", ""),
        };
        line!(
            out,
            "<text x=\"{x:.1}\" y=\"{:.1}\" fill=\"{color}\"{weight} paint-order=\"stroke\" stroke=\"#ffffff\" \
             stroke-width=\"4\">{}</text>",
            y + 4.0,
            escape::xml(&label.text)
        );
    }
    line!(out, "</svg>");
    out
}
