//! Checker patterns: which colour a surface shows where, on every shape, and that a border between two layers of cubes
//! doesn't mix their colours.

use crate::support::scene_of;
use glam::DVec3;
use raywalk::log::{Decision, Name, What};
use raywalk::probe::Silent;
use raywalk::record::{self, Arithmetic};
use raywalk::scene::Scene;
use raywalk::trace::query::Query;

/// The colours are their own ambient light, so that the colour of a hit is that of the pattern.
const HEAD: &str = r#"{
  "format": "raywalk-scene/1",
  "camera": {"position": [0, 0, 9], "direction": [0, 0, -1]},
  "ambient": [1, 1, 1],
  "materials": {"checker": {"ambient": [1, 1, 1], "pattern": {"checker": {"a": [1, 0, 0], "b": [0, 1, 0], "size": SIZE}}}},
  "objects": [{"name": "it", "material": "checker", "shape": SHAPE}]
}"#;

const EVEN: DVec3 = DVec3::new(1.0, 0.0, 0.0);
const ODD: DVec3 = DVec3::new(0.0, 1.0, 0.0);

#[track_caller]
fn checkered(shape: &str, size: f64) -> Scene {
    scene_of(HEAD.replace("SIZE", &size.to_string()).replace("SHAPE", shape).as_bytes(), "checkered")
}

fn color(scene: &Scene, origin: DVec3, direction: DVec3) -> DVec3 {
    match record::ray(scene, origin, direction, Arithmetic::F64).events.last().map(|event| &event.what) {
        Some(What::Result { color }) => DVec3::from(*color),
        _ => panic!("a log ends with the result"),
    }
}

/// Rays from all around at points in and about the unit cube; each hit must have the colour that `is_odd` says of its cell
/// and normal. Both colours occur.
#[track_caller]
fn shows(shape: &str, size: f64, is_odd: impl Fn(DVec3, DVec3) -> bool) {
    let scene = checkered(shape, size);
    let mut seen = [0, 0];
    for k in 0..2000 {
        let (around, up) = (f64::from(k) * 2.399_963, f64::from(k % 20) / 10.0 - 0.95);
        let across = (1.0 - up * up).sqrt();
        let direction = DVec3::new(across * libm::cos(around), up, across * libm::sin(around));
        // Not at the edge of a cell, where the last bit decides: queries and rays of a log normalise in their own ways.
        let aim = DVec3::new(f64::from(k % 7), f64::from(k % 11), f64::from(k % 13)) / 13.0 + 0.001;
        let origin = aim - direction * 5.0;
        let query = Query::new(origin, direction);
        let Some(hit) = query.nearest(&scene) else { continue };
        let is_odd = is_odd((hit.point / size).floor(), hit.normal);
        let expected = if is_odd { ODD } else { EVEN };
        assert_eq!(color(&scene, origin, direction), expected, "{:?} {:?}", hit.point, hit.normal);
        seen[usize::from(is_odd)] += 1;
    }
    assert!(seen[0] > 20 && seen[1] > 20, "{shape}: {seen:?}");
}

fn is_odd(sum: f64) -> bool {
    sum.rem_euclid(2.0) == 1.0
}

/// All three axes count.
fn cubes(cell: DVec3, _: DVec3) -> bool {
    is_odd(cell.x + cell.y + cell.z)
}

/// The axis nearest to the normal doesn't.
fn squares(cell: DVec3, normal: DVec3) -> bool {
    let [x, y, z] = normal.abs().to_array();
    if x >= y && x >= z {
        is_odd(cell.y + cell.z)
    } else if y >= z {
        is_odd(cell.x + cell.z)
    } else {
        is_odd(cell.x + cell.y)
    }
}

#[test]
fn curved_shapes_are_cut_out_of_cubes() {
    shows(r#"{"sphere": {"center": [0.4, 0.5, 0.6], "radius": 0.8}}"#, 0.3, cubes);
    shows(r#"{"sphere": {"center": [0.4, 0.5, 0.6], "radius": 0.8, "inward": true}}"#, 0.3, cubes);
    shows(r#"{"ellipsoid": {"center": [0.4, 0.5, 0.6], "radii": [0.9, 0.6, 0.4]}}"#, 0.3, cubes);
    shows(r#"{"cylinder": {"base": [0.5, -1, 0.5], "apex": [0.5, 2, 0.5], "radius": 0.7}}"#, 0.3, cubes);
    let cone = r#"{"cone": {"base": [0.5, -1, 0.5], "base_radius": 0.9, "apex": [0.5, 2, 0.4], "apex_radius": 0.1}}"#;
    shows(cone, 0.3, cubes);
}

#[test]
fn flat_shapes_show_squares() {
    shows(r#"{"plane": {"coefficients": [0, 1, 0, -0.6]}}"#, 0.3, squares);
    shows(r#"{"plane": {"coefficients": [-3, 1, 2, 0.1]}}"#, 0.3, squares);
    shows(r#"{"triangle": {"vertices": [[-2, -1, 0.3], [3, -1, 0.6], [0.5, 3, 0.9]]}}"#, 0.3, squares);
    shows(r#"{"polygon": {"vertices": [[0.6, -1, -1], [0.6, 2, -1], [0.6, 2, 2], [0.6, -1, 2]]}}"#, 0.3, squares);
    shows(r#"{"disk": {"center": [0.5, 0.5, 0.6], "normal": [0.2, 0.1, -2], "radius": 2}}"#, 0.3, squares);
    shows(r#"{"box": {"min": [0, 0, 0], "max": [0.9, 1.2, 0.6]}}"#, 0.3, squares);
    shows(r#"{"mesh": {"path": "knot.obj"}}"#, 0.1, squares);
}

#[test]
fn caps_are_flat() {
    let along_z = |cell: DVec3, normal: DVec3| {
        let is_cap = normal.z.abs() == 1.0;
        if is_cap { squares(cell, normal) } else { cubes(cell, normal) }
    };
    let ends = r#""base": [0.5, 0.5, 0], "apex": [0.5, 0.5, 0.9]"#;
    shows(&format!(r#"{{"cylinder": {{{ends}, "radius": 0.7, "caps": true}}}}"#), 0.3, along_z);
    let radii = r#""base_radius": 0.8, "apex_radius": 0.6"#;
    shows(&format!(r#"{{"cone": {{{ends}, {radii}, "caps": true}}}}"#), 0.3, along_z);
}

#[test]
fn a_shape_that_lies_between_two_layers_has_whole_squares() {
    // Hits lie a rounding above or below the plane. Within one square all have one colour all the same.
    for (height, size) in [(0.0, 1.0), (0.7, 0.1), (1.0 / 3.0, 1.0 / 3.0), (-12.3, 4.1)] {
        let scene = checkered(&format!(r#"{{"plane": {{"coefficients": [0, 1, 0, {}]}}}}"#, -height), size);
        let in_square = |k: i32| (f64::from(k) / 50.0 + 0.01) * size;
        for (x, z) in (0..49).flat_map(|x| (0..49).map(move |z| (in_square(x), in_square(z)))) {
            let eye = DVec3::new(0.3, height + 3.3, 5.1) * size;
            assert_eq!(color(&scene, eye, DVec3::new(x, height, z) - eye), EVEN, "{x} {z} at {height}");
            assert_eq!(color(&scene, eye, DVec3::new(x - size, height, z) - eye), ODD, "{x} {z} at {height}");
        }
    }
}

#[test]
fn far_from_the_origin_the_pattern_ends() {
    let scene = checkered(r#"{"plane": {"coefficients": [0, 1, 0, 0]}}"#, 1e-300);
    let log = record::ray(&scene, DVec3::new(0.0, 5.0, 0.0), DVec3::new(1e9, -5.0, 0.0), Arithmetic::F64);
    let is_undefined = |what: &What| *what == What::Mark(Decision::Undefined { quantity: Name::PatternCell });
    assert!(log.events.iter().any(|event| is_undefined(&event.what)));
    assert_eq!(log.events.last().map(|event| event.what.clone()), Some(What::Result { color: EVEN.to_array() }));
}

#[test]
fn diffuse_light_has_the_pattern_and_highlights_have_not() {
    let text = r#"{
      "format": "raywalk-scene/1",
      "camera": {"position": [0.5, 0.5, 4], "direction": [0, 0, -1], "resolution": [5, 5]},
      "lights": [{"point": {"position": [0.5, 0.5, 4]}}],
      "materials": {"it": {"diffuse": [0.5, 0.25, 1], "specular": SPECULAR, "shininess": 3,
                    "pattern": {"checker": {"a": [0.5, 0, 0.25], "b": [0, 1, 0], "size": 1}}}},
      "objects": [{"shape": {"plane": {"coefficients": [0, 0, 1, 0]}}, "material": "it"}]
    }"#;
    let middle = |specular: &str| {
        raywalk::sampling::pixel(&scene_of(text.replace("SPECULAR", specular).as_bytes(), "it"), [2, 2], &mut Silent)
    };
    assert_eq!(middle("[0, 0, 0]"), DVec3::new(0.25, 0.0, 0.25));
    assert_eq!(middle("[0.5, 0.5, 0.5]"), DVec3::new(0.75, 0.5, 0.75));
}
