//! The schematic as SVG.

use super::Plan;
use crate::log::RayKind;
use crate::report::escape::line;
use crate::report::ray_group::RayGroup;
use crate::report::svg;
use std::fmt::Write;

/// The figure as an element of a page.
pub fn svg_of(plan: &Plan, title: &str) -> String {
    let mut out = svg::begin(plan.size, 0, title);
    for outline in &plan.outlines {
        line!(out, "<polyline points=\"{}\" fill=\"none\" stroke=\"#c4cbd6\"/>", svg::points(outline, 1));
    }
    for ray in &plan.rays {
        let ([x1, y1], [x2, y2]) = (ray.from, ray.to);
        let color = RayGroup::of(ray.kind, ray.is_blocked).hex();
        let dashes = match ray.kind {
            _ if ray.is_blocked => " stroke-dasharray=\"5 4\"",
            RayKind::Shadow { .. } => " stroke-width=\"1.2\"",
            _ => " stroke-width=\"2.2\"",
        };
        line!(out, "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"#{color}\"{dashes}/>");
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
        let (color, weight) = match label.ray {
            Some((kind, is_blocked)) => (RayGroup::of(kind, is_blocked).hex(), " font-weight=\"bold\""),
            None => ("1b1f27", ""),
        };
        out += &svg::label(label.at, &format!("fill=\"#{color}\"{weight}"), 4, &label.text);
    }
    line!(out, "</svg>");
    out
}
