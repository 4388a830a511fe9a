//! The Polygon File Format (PLY), as text.

use super::{far, grouped, name, number};
use crate::files::escape::escape_hidden;
use crate::log::Header;
use crate::report::escape::line;
use crate::report::ray_group::RayGroup;
use crate::report::segments::Segment;
use std::fmt::Write;

/// Rays, of one pixel or many, as edges between vertices that have the colour of their kind; those that hit nothing have a length
/// that the file states.
pub fn ply(header: &Header, rays: &[Segment]) -> String {
    let far = far(rays);
    let mut out = String::new();
    line!(out, "ply");
    line!(out, "format ascii 1.0");
    line!(
        out,
        "comment rays of {}, traced by raywalk {}",
        escape_hidden(&header.scene.name),
        escape_hidden(&header.version)
    );
    line!(out, "comment rays that meet nothing are drawn {} long", number(far));
    for (group, _) in grouped(rays) {
        line!(out, "comment color {}: {}", color(group), name(group));
    }
    line!(out, "element vertex {}", 2 * rays.len());
    ["x", "y", "z"].iter().for_each(|axis| line!(out, "property double {axis}"));
    ["red", "green", "blue"].iter().for_each(|channel| line!(out, "property uchar {channel}"));
    line!(out, "element edge {}", rays.len());
    line!(out, "property int vertex1");
    line!(out, "property int vertex2");
    line!(out, "end_header");
    for (group, rays) in grouped(rays) {
        let color = color(group);
        for [x, y, z] in rays.iter().flat_map(|ray| [ray.from, ray.end(far)]) {
            line!(out, "{} {} {} {color}", number(x), number(y), number(z));
        }
    }
    for ray in 0..rays.len() {
        line!(out, "{} {}", 2 * ray, 2 * ray + 1);
    }
    out
}

/// Red, green and blue, from 0 to 255.
fn color(group: RayGroup) -> String {
    let [_, red, green, blue] = u32::from_str_radix(group.hex(), 16).unwrap_or_default().to_be_bytes();
    format!("{red} {green} {blue}")
}
