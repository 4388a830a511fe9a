//! The algorithms of the source text as lines (Ramos, section 1.1.1), and which line each step of a log belongs to.
//!
//! The lines follow the two pseudocodes, in English and with what they leave open filled in as the tracer does it. A tracer that
//! has one code path for all three runs them in its own order only where that can't be told from the log: it asks for the depth
//! before a bounce instead of after it.

mod place;

pub use place::{Place, place};

use super::language::Language;
use crate::log::{Header, Log, RayKind, Step, Tree};
use Place::*;

/// A line of an algorithm.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Line {
    /// How far it is indented.
    pub indent: u8,
    /// What it says.
    pub text: &'static str,
    /// The steps that belong to it.
    pub places: &'static [Place],
}

const fn line(indent: u8, text: &'static str, places: &'static [Place]) -> Line {
    Line { indent, text, places }
}

/// The first pseudocode.
const RECURSIVE: &[Line] = &[
    line(0, "picture()", &[]),
    line(1, "for each pixel", &[Pixel]),
    line(2, "for each sample: the ray from the eye through it", &[Sample, Aim]),
    line(2, "pixel = mean of TR(eye, direction, 0)", &[Mean]),
    line(0, "color TR(origin, direction, depth)", &[Call]),
    line(1, "if depth > max_depth return black", &[TooDeep]),
    line(1, "point = nearest_intersection(origin, direction)", &[Nearest, Surface]),
    line(1, "if there is none return background", &[Background]),
    line(1, "local = local_contribution(point)", &[Ambient, LocalSum]),
    line(2, "for each light: its direction, N · L", &[Light]),
    line(3, "shadow ray: how much light gets through", &[Shadow]),
    line(3, "diffuse, specular and transmitted terms", &[Terms]),
    line(1, "dir_r = reflection_direction()", &[Reflection]),
    line(1, "reflected = TR(point, dir_r, depth + 1)", &[Reflected]),
    line(1, "dir_t = transmission_direction()", &[Transmission, TotalReflection]),
    line(1, "transmitted = TR(point, dir_t, depth + 1)", &[Transmitted]),
    line(1, "return combine(local, W_l,", &[CombineLocal]),
    line(3, "reflected, W_r,", &[CombineReflected]),
    line(3, "transmitted, W_t)", &[CombineTransmitted, Return]),
];

/// The second pseudocode as printed: at the limit a hit has its ambient colour only.
const WHITTED: &[Line] = &[
    line(0, "procedure RT_picture", &[]),
    line(1, "for each line, for each pixel of it", &[Pixel]),
    line(2, "the ray from the eye through the pixel", &[Sample, Aim]),
    line(2, "pixel := RT_trace(ray, 1)", &[Mean]),
    line(0, "procedure RT_trace(ray, depth)", &[Call]),
    line(1, "the nearest intersection with an object", &[Nearest]),
    line(1, "if there is one", &[]),
    line(2, "the normal there", &[Surface]),
    line(2, "RT_trace := RT_shade(object, ray, point, normal, depth)", &[Return]),
    line(1, "else RT_trace := BACKGROUND", &[Background]),
    line(0, "procedure RT_shade(object, ray, point, normal, depth)", &[]),
    line(1, "color := ambient colour", &[Ambient]),
    line(1, "if depth < depth limit", &[TooDeep]),
    line(2, "for each light", &[Light]),
    line(3, "ray_s := from the point to the light", &[]),
    line(3, "if it stands in front of the surface", &[]),
    line(4, "how much light is blocked", &[Shadow]),
    line(4, "diffuse and specular terms, added to color", &[Terms, LocalSum]),
    line(2, "if the object reflects", &[]),
    line(3, "ray_r := direction of reflection", &[Reflection]),
    line(3, "color_r := RT_trace(ray_r, depth + 1)", &[Reflected]),
    line(3, "scale color_r, add it to color", &[CombineLocal, CombineReflected]),
    line(2, "if the object transmits", &[]),
    line(3, "ray_t := direction of refraction", &[Transmission]),
    line(3, "if there is no total reflection", &[TotalReflection]),
    line(4, "color_t := RT_trace(ray_t, depth + 1)", &[Transmitted]),
    line(4, "scale color_t, add it to color", &[CombineTransmitted]),
    line(1, "RT_shade := color", &[]),
];

/// The second as in its source: at the limit only the bounces stop.
const FOLEY: &[Line] = &[
    line(0, "procedure RT_picture", &[]),
    line(1, "for each line, for each pixel of it", &[Pixel]),
    line(2, "the ray from the eye through the pixel", &[Sample, Aim]),
    line(2, "pixel := RT_trace(ray, 1)", &[Mean]),
    line(0, "procedure RT_trace(ray, depth)", &[Call]),
    line(1, "the nearest intersection with an object", &[Nearest]),
    line(1, "if there is one", &[]),
    line(2, "the normal there", &[Surface]),
    line(2, "RT_trace := RT_shade(object, ray, point, normal, depth)", &[Return]),
    line(1, "else RT_trace := BACKGROUND", &[Background]),
    line(0, "procedure RT_shade(object, ray, point, normal, depth)", &[]),
    line(1, "color := ambient colour", &[Ambient]),
    line(1, "for each light", &[Light]),
    line(2, "ray_s := from the point to the light", &[]),
    line(2, "if it stands in front of the surface", &[]),
    line(3, "how much light is blocked", &[Shadow]),
    line(3, "diffuse and specular terms, added to color", &[Terms, LocalSum]),
    line(1, "if depth < depth limit", &[TooDeep]),
    line(2, "if the object reflects", &[]),
    line(3, "ray_r := direction of reflection", &[Reflection]),
    line(3, "color_r := RT_trace(ray_r, depth + 1)", &[Reflected]),
    line(3, "scale color_r, add it to color", &[CombineLocal, CombineReflected]),
    line(2, "if the object transmits", &[]),
    line(3, "ray_t := direction of refraction", &[Transmission]),
    line(3, "if there is no total reflection", &[TotalReflection]),
    line(4, "color_t := RT_trace(ray_t, depth + 1)", &[Transmitted]),
    line(4, "scale color_t, add it to color", &[CombineTransmitted]),
    line(1, "RT_shade := color", &[]),
];

/// The lines of the algorithm in use.
pub fn lines(header: &Header) -> &'static [Line] {
    match header.tracing.algorithm.as_str() {
        "whitted" => WHITTED,
        "foley" => FOLEY,
        _ => RECURSIVE,
    }
}

/// The line of a place.
pub fn line_of(header: &Header, place: Place) -> usize {
    // Every place has a line in every algorithm; a test says so.
    lines(header).iter().position(|line| line.places.contains(&place)).unwrap_or(0)
}

/// The line that an event belongs to.
pub fn current_line(log: &Log, tree: &Tree, event: usize) -> usize {
    line_of(&log.header, place(log, tree, event))
}

/// A call of the tracer that isn't over: a ray on the way from the eye.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// Its node.
    pub node: usize,
    /// What is called, such as `TR(C R, 1)`.
    pub text: String,
    /// The line at which it is now: where it calls the next, or the current line.
    pub line: usize,
}

/// The call that traces the ray with this path, at this depth of the ray tree: `TR(C R, 1)`.
pub fn call(header: &Header, path: &str, depth: u32) -> String {
    let (procedure, first) = if calls_too_deep(header) { ("TR", 0) } else { ("RT_trace", 1) };
    format!("{procedure}({path}, {})", u64::from(depth) + first)
}

/// Whether the algorithm asks for the depth in the call, and not before it.
pub fn calls_too_deep(header: &Header) -> bool {
    header.tracing.algorithm == "recursive"
}

/// The calls around an event, the outermost first: the way through the tree of calls (figure 9). A shadow ray is the last.
pub fn stack(log: &Log, tree: &Tree, event: usize) -> Vec<Call> {
    stack_in(Language::English, log, tree, event)
}

/// The calls around an event in a language.
pub fn stack_in(language: Language, log: &Log, tree: &Tree, event: usize) -> Vec<Call> {
    let owner = tree.owner(event);
    let around = std::iter::successors(Some(owner), |at| Some(tree.nodes()[*at].parent).filter(|parent| parent != at));
    let calls = around.filter_map(|node| match tree.nodes()[node].step {
        Some(Step::Ray { kind, depth, .. }) => Some((node, kind, depth)),
        _ => None,
    });
    let mut stack: Vec<Call> = Vec::new();
    let mut inner: Option<RayKind> = None;
    for (node, kind, depth) in calls {
        let line = match inner {
            None => current_line(log, tree, event),
            Some(inner) => line_of(&log.header, place::of_call(inner)),
        };
        let path = tree.path(node);
        let text = match kind {
            RayKind::Shadow { .. } => (language.texts().viewer.panes.shadow_ray)(&path),
            _ => call(&log.header, &path, depth),
        };
        stack.push(Call { node, text, line });
        inner = Some(kind);
    }
    stack.reverse();
    stack
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_place_has_one_line_in_every_algorithm() {
        for lines in [RECURSIVE, WHITTED, FOLEY] {
            for place in Place::ALL {
                let count = lines.iter().filter(|line| line.places.contains(place)).count();
                assert_eq!(count, 1, "{place:?} in {}", lines[0].text);
            }
        }
    }
}
