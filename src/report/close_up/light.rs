//! The points of an area light that a hit asks, with the weights of their shadow rays (Ramos, section 1.5).
//!
//! A rectangle and a disk are seen from their front, in the coordinates x_F and y_F of the log; a sphere is seen from the hit, points on its
//! far side are hollow. What a shadow ray brings is in the table.

use super::hit::{lights, number, shade, unit, value, vector};
use super::sheet::{Ink, Piece, Plane, Point, Sheet};
use super::{CloseUp, CloseUpError, Subject};
use crate::log::{Asking, Decision, Log, Name, Tree, Value, What};
use crate::report::contributions;
use crate::report::evaluate::term_of_light;
use crate::report::words;
use glam::DVec3;
use std::f64::consts::TAU;

/// The size of the sheet, the middle and the radius of the light.
const SIZE: [f64; 2] = [360.0, 360.0];
const MIDDLE: Point = [180.0, 180.0];
const RADIUS: f64 = 145.0;

/// The radius of the point of a shadow ray of mean weight.
const DOT: f64 = 6.0;

/// The most other area lights that the note names.
const MOST_NAMED: usize = 4;

/// A point of the light that was asked.
struct Asked {
    node: usize,
    split: u32,
    /// What part of the light's intensity it has.
    weight: f64,
    /// What its shadow ray lets through; `None` where none was sent.
    passed: Option<[f64; 3]>,
}

/// The points of an area light that a ray's hit asks: of the one that the path's shadow ray goes to (`C S2`, or `C S2.3` for the same light),
/// else of the first.
///
/// # Errors
/// No ray with the path, or no area light.
pub fn light(subject: &Subject) -> Result<CloseUp, CloseUpError> {
    let Subject { log, tree, language, style, path } = *subject;
    let texts = &language.texts().close_up;
    let (path_of_ray, chosen) = path.map_or((None, None), split_path);
    let of_its_ray = Subject { path: path_of_ray, ..*subject };
    let (ray, (shade, area_lights)) =
        of_its_ray.first("an area light (`rectangle`, `disk` or `sphere`)", |ray| area_lights(log, tree, ray))?;
    let path_of = |light: u32| format!("{} S{}", tree.path(ray), light + 1);
    let Some(number_of_light) = area_lights.iter().copied().find(|light| chosen.is_none_or(|chosen| chosen == *light))
    else {
        let known: Vec<_> = area_lights.iter().map(|light| path_of(*light)).collect();
        return Err(CloseUpError::NoRay { path: path.unwrap_or_default().to_owned(), known: known.join(", ") });
    };
    let points = points_of(log, tree, shade, number_of_light);
    let local = contributions::local(log, tree, shade).map(|(_, name)| name);
    let mean = 1.0 / points.len() as f64;
    let mut pieces = outline(log, tree, points[0].node);
    let mut rows = Vec::new();
    for point in &points {
        let is_lit = point.passed.is_some_and(|passed| passed != [0.0; 3]);
        let ink = match point.passed {
            None => Ink::Gray,
            Some(_) if is_lit => Ink::Light,
            Some(_) => Ink::Blocked,
        };
        let place = place(log, tree, point.node);
        if let Some((at, is_far)) = place {
            let radius = DOT * (point.weight / mean).max(0.0).sqrt();
            pieces.push(Piece::Dot { at, radius: radius.min(4.0 * DOT), ink, filled: is_lit && !is_far });
            pieces.push(Piece::Text { at: [at[0], at[1] - DOT - 8.0], text: point.split.max(1).to_string(), ink });
        }
        let adds = local.map(|name| term_of_light(log, tree, point.node, name)).filter(|_| is_lit);
        let triple = |triple: Option<[f64; 3]>| {
            triple.map_or("–".to_owned(), |triple| language.value(&Value::Triple(triple), style))
        };
        let position = vector(log, tree, point.node, Name::LightPositionOnArea).map(|position| position.to_array());
        rows.push(vec![
            point.split.max(1).to_string(),
            triple(position),
            language.number(point.weight, style),
            triple(point.passed),
            triple(adds.or(Some([0.0; 3]))),
        ]);
    }
    let total: f64 = points.iter().map(|point| point.weight).sum();
    let name_of = |light: u32| words::plain(log.header.light(light));
    let name = name_of(number_of_light);
    let others = area_lights.iter().filter(|light| **light != number_of_light).take(MOST_NAMED);
    let others = others.map(|light| (texts.another_light)(&path_of(*light), &name_of(*light)));
    let note = [texts.light_note.to_owned()].into_iter().chain(others).collect::<Vec<_>>().join(" ");
    Ok(CloseUp {
        title: (texts.light)(&name, &tree.path(ray)),
        note,
        columns: texts.light_columns.map(str::to_owned).to_vec(),
        rows,
        sheets: vec![Sheet::new((texts.weights)(&language.number(total, style)), SIZE, MIDDLE, pieces)],
    })
}

/// The path of a ray, and the light of the shadow ray behind it if the path ends with one.
fn split_path(path: &str) -> (Option<&str>, Option<u32>) {
    let (ray, last) = path.rsplit_once(' ').unwrap_or(("", path));
    let number = last.strip_prefix('S').map(|light| light.split_once('.').map_or(light, |(light, _)| light));
    match number.and_then(|number| number.parse::<u32>().ok()).and_then(|number| number.checked_sub(1)) {
        Some(light) => (Some(ray), Some(light)),
        None => (Some(path), None),
    }
}

/// The local model of a ray's hit, and the area lights that it asks, each once; `None` if there are none.
fn area_lights(log: &Log, tree: &Tree, ray: usize) -> Option<(usize, Vec<u32>)> {
    let shade = shade(tree, ray)?;
    let nodes = lights(tree, shade);
    let are_areas = nodes.iter().filter(|(node, ..)| value(log, tree, *node, Name::LightCenter).is_some());
    let mut found: Vec<u32> = are_areas.map(|(_, light, _)| *light).collect();
    found.dedup();
    (!found.is_empty()).then_some((shade, found))
}

/// The points of a light that the local model of a ray's hit asks.
fn points_of(log: &Log, tree: &Tree, shade: usize, light: u32) -> Vec<Asked> {
    let nodes: Vec<_> = lights(tree, shade).into_iter().filter(|(_, of, _)| *of == light).collect();
    let count = nodes.len() as f64;
    // The weight of a rule's point is its part of the mean.
    let is_by_rule = |event: usize| matches!(log.events[event].what, What::Mark(Decision::Asked { light: of, why: Asking::Rule, .. }) if of == light);
    let whole = if tree.own_events(shade).any(is_by_rule) { 1.0 } else { count };
    let point = |(node, _, split): &(usize, u32, u32)| Asked {
        node: *node,
        split: *split,
        weight: [Name::LightWeight, Name::LightShare]
            .map(|name| number(log, tree, *node, name).unwrap_or(1.0))
            .into_iter()
            .product::<f64>()
            / whole,
        passed: passed(log, tree, *node),
    };
    nodes.iter().map(point).collect()
}

/// What a light's shadow ray lets through; `None` where none was sent.
fn passed(log: &Log, tree: &Tree, light: usize) -> Option<[f64; 3]> {
    let ray = tree.children(light).find(|child| tree.ray(*child).is_some());
    let is_free = |event: usize| log.events[event].decision() == Some(Decision::Free);
    let Some(ray) = ray else { return tree.own_events(light).any(is_free).then_some([1.0; 3]) };
    let is_blocked = |event: usize| matches!(log.events[event].what, What::Mark(Decision::Occluded { .. }));
    match vector(log, tree, light, Name::ShadowTransmittance) {
        Some(passed) => Some(passed.to_array()),
        None if tree.own_events(ray).any(is_blocked) => Some([0.0; 3]),
        None => Some([1.0; 3]),
    }
}

/// Where a point of the light is, and whether it lies on the far side of a sphere.
fn place(log: &Log, tree: &Tree, node: usize) -> Option<(Point, bool)> {
    if let Some(outward) = vector(log, tree, node, Name::LightOutward) {
        let plane = sphere(log, tree, node)?;
        let toward_viewer = plane.right.cross(plane.up);
        return Some((plane.place(outward), outward.dot(toward_viewer) < 0.0));
    }
    let [x, y] = [number(log, tree, node, Name::LightX)?, number(log, tree, node, Name::LightY)?];
    Some(([MIDDLE[0] + RADIUS * x, MIDDLE[1] - RADIUS * y], false))
}

/// The plane across the line from the centre of a sphere to the hit.
fn sphere(log: &Log, tree: &Tree, node: usize) -> Option<Plane> {
    let center = vector(log, tree, node, Name::LightCenter)?;
    let position = vector(log, tree, node, Name::LightPositionOnSphere)?;
    let hit = position - vector(log, tree, node, Name::LightVector)?;
    let toward_viewer = unit(hit - center)?;
    let (right, up) = toward_viewer.any_orthonormal_pair();
    let right = if right.cross(up).dot(toward_viewer) < 0.0 { -right } else { right };
    Some(Plane { origin: MIDDLE, right, up, unit: RADIUS })
}

/// The outline of the light: a circle, or a square for a rectangle of any sides.
fn outline(log: &Log, tree: &Tree, node: usize) -> Vec<Piece> {
    let is_round = [Name::LightRadius, Name::DiscX].iter().any(|name| value(log, tree, node, *name).is_some());
    let turn = |step: u32, steps: u32| {
        let angle = TAU * f64::from(step) / f64::from(steps);
        [libm::cos(angle), libm::sin(angle)]
    };
    let corners: Vec<[f64; 2]> = if is_round {
        (0..64).map(|step| turn(step, 64)).collect()
    } else {
        vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
    };
    let points = corners.iter().map(|[x, y]| [MIDDLE[0] + RADIUS * x, MIDDLE[1] - RADIUS * y]).collect();
    let mut pieces = vec![Piece::Path { points, ink: Ink::Light, is_area: true }];
    if !is_round || value(log, tree, node, Name::LightRadius).is_none() {
        let ends =
            [DVec3::X, DVec3::Y].map(|axis| [MIDDLE[0] + RADIUS * axis.x * 1.12, MIDDLE[1] - RADIUS * axis.y * 1.12]);
        for (at, name) in ends.into_iter().zip(["x_F", "y_F"]) {
            pieces.push(Piece::Text { at, text: name.to_owned(), ink: Ink::Black });
        }
    }
    pieces
}
