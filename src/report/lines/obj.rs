//! Wavefront OBJ.

use super::{far, grouped, name, number};
use crate::files::escape::escape_hidden;
use crate::log::Header;
use crate::report::escape::line;
use crate::report::segments::Segment;
use std::fmt::Write;

/// Rays, of one pixel or many, as `l` lines in groups by kind; those that hit nothing have a length that the file states.
pub fn obj(header: &Header, rays: &[Segment]) -> String {
    let far = far(rays);
    let mut out = String::new();
    line!(out, "# rays of {}, traced by raywalk {}", escape_hidden(&header.scene.name), escape_hidden(&header.version));
    line!(out, "# rays that meet nothing are drawn {} long", number(far));
    let mut vertices = 0;
    for (group, rays) in grouped(rays) {
        line!(out, "g {}", name(group));
        for ray in &rays {
            for [x, y, z] in [ray.from, ray.end(far)] {
                line!(out, "v {} {} {}", number(x), number(y), number(z));
            }
        }
        for _ in &rays {
            line!(out, "l {} {}", vertices + 1, vertices + 2);
            vertices += 2;
        }
    }
    out
}
