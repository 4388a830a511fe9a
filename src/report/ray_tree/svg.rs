//! The ray tree as SVG, by itself.

use super::layout::{LETTER_AT, Spot, spots};
use super::{End, Figure};
use crate::files::escape::width;
use crate::report::escape::{self, line};
use crate::report::ray_group::RayGroup;
use crate::report::svg::{begin, file, label};
use std::fmt::Write;

/// The width of a character, the distance of levels, the height of a node, in the units of the picture.
const CHARACTER: f64 = 7.2;
const LEVEL: f64 = 74.0;
const HALF_HEIGHT: f64 = 12.0;
const MARGIN: f64 = 14.0;
const LEGEND: f64 = 44.0;

/// The figure as a file of its own.
pub fn svg(figure: &Figure) -> String {
    file(&svg_of(figure))
}

/// The figure as an element of a page.
pub fn svg_of(figure: &Figure) -> String {
    let (spots, width) = spots(figure);
    let levels = spots.iter().map(|spot| spot.level).max().unwrap_or(0);
    let wide = (width * CHARACTER).max(560.0) + 2.0 * MARGIN;
    let shift = (wide - width * CHARACTER) / 2.0;
    // Where a fan of rays is wide, there is more room between the levels, so that they part.
    let widest = spots.iter().map(|spot| (spot.x - spots[spot.parent].x).abs()).fold(0.0, f64::max);
    let level = LEVEL + (widest * CHARACTER * 0.1).min(LEVEL);
    let tree_height = levels as f64 * level + 2.0 * HALF_HEIGHT + 2.0 * MARGIN;
    let height = tree_height + LEGEND;
    let mut out = begin([wide, height], 1, &figure.title());
    let place = |spot: &Spot| (spot.x * CHARACTER + shift, spot.level as f64 * level + HALF_HEIGHT + MARGIN);
    for spot in &spots {
        write_ray(&mut out, figure, spot, place(&spots[spot.parent]), place(spot));
    }
    for spot in &spots {
        write_label(&mut out, spot, place(&spots[spot.parent]), place(spot));
        write_node(&mut out, spot, place(spot));
    }
    write_legend(&mut out, figure, tree_height);
    line!(out, "</svg>");
    out
}

fn write_ray(out: &mut String, figure: &Figure, spot: &Spot, (x1, y1): (f64, f64), (x2, y2): (f64, f64)) {
    let Some(branch) = spot.branch else { return };
    let color = branch.group().hex();
    let (y1, y2) = (y1 + HALF_HEIGHT, y2 - HALF_HEIGHT);
    let width = 1.2 + 6.0 * branch.width();
    let dashes = if branch.is_blocked() { " stroke-dasharray=\"5 4\"" } else { "" };
    line!(
        out,
        "<line x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\" stroke=\"#{color}\" stroke-width=\"{width:.1}\" \
         stroke-linecap=\"round\"{dashes}><title>{}</title></line>",
        escape::xml(&figure.description(branch))
    );
}

/// The letter of a ray, over all lines, and the cross of a blocked one.
fn write_label(out: &mut String, spot: &Spot, (x1, y1): (f64, f64), (x2, y2): (f64, f64)) {
    let Some(branch) = spot.branch else { return };
    let color = branch.group().hex();
    let (y1, y2) = (y1 + HALF_HEIGHT, y2 - HALF_HEIGHT);
    // Nearer to the end, where the rays of one node have parted.
    let at = |part: f64| (x1 + (x2 - x1) * part, y1 + (y2 - y1) * part);
    if branch.is_blocked() {
        let (x, y) = at(0.9);
        let (left, right, top, bottom) = (x - 5.0, x + 5.0, y - 5.0, y + 5.0);
        line!(
            out,
            "<path d=\"M{left:.1} {top:.1}L{right:.1} {bottom:.1}M{left:.1} {bottom:.1}L{right:.1} {top:.1}\" \
             stroke=\"#{color}\" stroke-width=\"2.4\"/>"
        );
    }
    let (x, y) = at(LETTER_AT);
    *out += &label([x, y], &format!("fill=\"#{color}\" font-weight=\"bold\""), 4, &branch.label);
}

fn write_node(out: &mut String, spot: &Spot, (x, y): (f64, f64)) {
    let text = escape::xml(&spot.text);
    let half = (width(&spot.text) as f64 * CHARACTER / 2.0 + 7.0).max(HALF_HEIGHT);
    let (left, top, width, height) = (x - half, y - HALF_HEIGHT, 2.0 * half, 2.0 * HALF_HEIGHT);
    let body = |fill: &str, stroke: &str| {
        format!(
            "<rect x=\"{left:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height:.1}\" rx=\"{HALF_HEIGHT}\" \
             fill=\"{fill}\" stroke=\"{stroke}\" stroke-width=\"1.2\"/>"
        )
    };
    let (body, ink) = match spot.branch.map(|branch| branch.end) {
        None => (body("#3b4252", "#3b4252"), "#ffffff"),
        Some(End::Object(_)) => (body("#eef2f7", "#3b4252"), "#1b1f27"),
        Some(End::Background | End::TooDeep) => (body("#ffffff", "none"), "#66707f"),
        Some(End::Light(_)) => (body("#fff3cf", "none"), "#1b1f27"),
        Some(End::Blocked { .. }) => (body("#f3f3f3", "none"), "#8a8f98"),
        Some(End::Unknown) => (String::new(), "#66707f"),
    };
    line!(out, "{body}<text x=\"{x:.1}\" y=\"{:.1}\" fill=\"{ink}\">{text}</text>", y + 4.0);
}

fn write_legend(out: &mut String, figure: &Figure, top: f64) {
    let texts = &figure.language.texts().figure;
    // Shadow rays are no calls.
    let kinds = if figure.branches.iter().any(|branch| branch.call.is_some()) { 3 } else { RayGroup::ALL.len() };
    let mut x = MARGIN;
    for (kind, group) in texts.kinds.iter().zip(RayGroup::ALL).take(kinds) {
        let dashes = if group == RayGroup::Blocked { " stroke-dasharray=\"5 4\"" } else { "" };
        line!(
            out,
            "<line x1=\"{x:.1}\" y1=\"{y:.1}\" x2=\"{end:.1}\" y2=\"{y:.1}\" stroke=\"#{color}\" stroke-width=\"3\"{dashes}/>\
             <text x=\"{text:.1}\" y=\"{base:.1}\" text-anchor=\"start\" font-size=\"11\" fill=\"#3b4252\">{kind}</text>",
            y = top + 8.0,
            end = x + 20.0,
            text = x + 25.0,
            base = top + 12.0,
            color = group.hex(),
            kind = escape::xml(kind)
        );
        x += 34.0 + kind.chars().count() as f64 * 6.4;
    }
    line!(
        out,
        "<text x=\"{MARGIN:.1}\" y=\"{:.1}\" text-anchor=\"start\" font-size=\"11\" fill=\"#66707f\">{}</text>",
        top + 32.0,
        escape::xml(texts.width)
    );
}
