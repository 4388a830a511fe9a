//! One ray onto each shape: the walk as text and every noted value to its last bit, pinned.
//!
//! The scenes have ambient light only, so that a walk is about the shape.

use crate::support::{scene_of, snapshots};
use glam::DVec3;
use raywalk::log::{Log, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::language::Language;
use raywalk::report::{Style, text};
use std::fmt::Write;

/// The ray goes slightly aslant, so that no component is simple.
const ORIGIN: DVec3 = DVec3::new(0.25, 0.5, 4.0);
const DIRECTION: DVec3 = DVec3::new(-0.125, -0.25, -4.0);

const PLAIN: &str = r#""ambient": [0.5, 0.25, 1]"#;

#[track_caller]
fn walks(name: &str, shape: &str) {
    walks_on(name, shape, PLAIN, ORIGIN);
}

#[track_caller]
fn walks_on(name: &str, shape: &str, material: &str, origin: DVec3) {
    let scene = format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 9], "direction": [0, 0, -1]}}, "ambient": [1, 1, 1],
           "materials": {{"it": {{{material}}}}}, "objects": [{{"name": "{name}", "material": "it", "shape": {shape}}}]}}"#
    );
    let log = record::ray(&scene_of(scene.as_bytes(), name), origin, DIRECTION, Arithmetic::F64);
    let is_hit =
        log.events.iter().any(|event| matches!(event.what, What::Note { name, .. } if name.key() == "hit.normal"));
    assert!(is_hit, "the ray misses the {name}");
    let walk = format!("{}\n{}", text::text(Language::English, &log, Style::default()), exact_values(&log));
    snapshots().bind(|| insta::assert_snapshot!(format!("shape_{}", name.replace(' ', "_")), walk));
}

/// Every value of the test and the surface, as it is in the log.
fn exact_values(log: &Log) -> String {
    let mut lines = String::new();
    for event in &log.events {
        let What::Note { name, value } = event.what else { continue };
        if name.key().starts_with("combine.") {
            break;
        }
        let value = match value {
            Value::Number(x) => format!("{x:?}"),
            Value::Triple(triple) => format!("{triple:?}"),
        };
        let form = if name.form().is_empty() { String::new() } else { format!(" ({})", name.form()) };
        writeln!(lines, "{}{form}: {value}", name.key()).expect("a string can be written to");
    }
    lines
}

#[test]
fn plane() {
    walks("plane", r#"{"plane": {"coefficients": [0.5, 0.25, 2, 1]}}"#);
}

#[test]
fn sphere() {
    walks("sphere", r#"{"sphere": {"center": [0.25, 0.125, 0], "radius": 1.5}}"#);
}

#[test]
fn ellipsoid() {
    let shape = r#"{"ellipsoid": {"center": [0.25, 0.125, 0], "radii": [1.5, 1, 0.5],
                    "rotation": [[0.8, -0.6, 0], [0.6, 0.8, 0], [0, 0, 1]]}}"#;
    walks("ellipsoid", shape);
}

#[test]
fn triangle() {
    walks("triangle", r#"{"triangle": {"vertices": [[-1, -1, 0], [2, -1, 0.5], [0, 2, 0.25]]}}"#);
}

#[test]
fn smooth_triangle() {
    let shape = r#"{"triangle": {"vertices": [[-1, -1, 0], [2, -1, 0.5], [0, 2, 0.25]],
                    "normals": [[-1, -1, 2], [1, -1, 2], [0, 1, 2]]}}"#;
    walks("smooth triangle", shape);
}

#[test]
fn polygon() {
    // Concave, met from behind.
    walks("polygon", r#"{"polygon": {"vertices": [[-1, -1, 0], [-1, 2, 0], [2, 2, 0], [0.5, 0.5, 0], [2, -1, 0]]}}"#);
}

#[test]
fn cuboid() {
    walks("box", r#"{"box": {"min": [-1, -1, -1], "max": [1, 1, 0.5]}}"#);
}

#[test]
fn cylinder() {
    walks("cylinder", r#"{"cylinder": {"base": [-2, 0, 0], "apex": [2, 1, 0], "radius": 0.75}}"#);
}

#[test]
fn cap() {
    let shape = r#"{"cylinder": {"base": [0, 0, -1], "apex": [0.25, 0, 1], "radius": 0.75, "caps": true}}"#;
    walks("cap of a cylinder", shape);
}

#[test]
fn cone() {
    walks("cone", r#"{"cone": {"base": [-2, 0, 0], "base_radius": 1, "apex": [2, 1, 0], "apex_radius": 0.25}}"#);
}

#[test]
fn disk() {
    walks("disk", r#"{"disk": {"center": [0.25, 0.125, 0], "normal": [0.5, 0.25, 2], "radius": 1.5}}"#);
}

#[test]
fn mesh() {
    // The middle of the knot is empty.
    walks_on("mesh", r#"{"mesh": {"path": "knot.obj"}}"#, PLAIN, DVec3::new(1.5, 0.5, 4.0));
}

#[test]
fn checker() {
    let material =
        r#""ambient": [0.5, 0.25, 1], "pattern": {"checker": {"a": [1, 1, 1], "b": [0.5, 0.5, 0.25], "size": 0.4}}"#;
    walks_on("checkered sphere", r#"{"sphere": {"center": [0.25, 0.125, 0], "radius": 1.5}}"#, material, ORIGIN);
    walks_on("checkered plane", r#"{"plane": {"coefficients": [0.5, 0.25, 2, 1]}}"#, material, ORIGIN);
}
