//! What is read, with which defaults, and that printing it and reading it again changes nothing.

use super::*;
use crate::geometry::shape::SphereMethod;
use crate::scene::file::parse;
use crate::scene::file::schema::*;

/// Every key of the format, with values that are not the defaults.
const EVERYTHING: &str = r#"{
  "format": "raywalk-scene/1",
  "name": "everything",
  "camera": {"position": [0, -0.0, 1e-300], "look_at": [0, 0.1, -5], "up": [0, 1, 1], "vertical_fov": 60.5,
             "resolution": [640, 480], "lens": {"radius": 0.1, "focus_distance": 5}, "shutter": [0, 0.5]},
  "ambient": [1, 2, 3], "background": [4, 5, 6],
  "lights": [
    {"name": "a", "point": {"position": [1, 2, 3]}, "attenuation": [1, 0.5, 0.25]},
    {"name": "b", "directional": {"direction": [0, -1, 0]}, "color": [300, 300, 300]},
    {"name": "c", "rectangle": {"corner": [0, 0, 0], "edge_u": [1, 0, 0], "edge_v": [0, 1, 0]},
     "profile": {"cosine_power": 2}, "samples": 16},
    {"name": "d", "disk": {"center": [0, 0, 0], "normal": [0, 1, 0], "radius": 2}, "profile": "uniform",
     "samples": {"min": 4, "max": 16}},
    {"name": "e", "sphere": {"center": [0, 0, 0], "radius": 2}, "samples": 4, "by": "solid_angle"},
    {"sphere": {"center": [0, 0, 0], "radius": 2}}
  ],
  "materials": {
    "z": {"ambient": [1, 1, 1], "diffuse": [1, 1, 1], "specular": [1, 1, 1], "transmission": [1, 1, 1], "shininess": 0,
          "transmission_exponent": 3, "ior": 1.5, "weights": {"local": [1, 0.5, 2], "reflected": 0.5},
          "gloss_exponent": 10, "translucency_exponent": 20, "samples": 16,
          "pattern": {"checker": {"a": [1, 1, 1], "b": [0, 0, 0], "size": 2}}},
    "a": {}
  },
  "objects": [
    {"name": "1", "shape": {"plane": {"coefficients": [0, 1, 0, 0]}}, "material": "z"},
    {"name": "2", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1, "inward": true}}, "material": "a",
     "motion": {"translation": [1, 0, 0], "rotation": {"axis": [0, 1, 0], "point": [0, 0, 0], "degrees": 90}}},
    {"name": "3", "shape": {"ellipsoid": {"center": [0, 0, 0], "radii": [1, 2, 3], "rotation": [[0, -1, 0], [1, 0, 0], [0, 0, 1]]}}},
    {"name": "4", "shape": {"triangle": {"vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "normals": [[0, 0, 1], [0, 0, 1], [0, 0, 1]]}}},
    {"name": "5", "shape": {"polygon": {"vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}}, "motion": {}},
    {"name": "6", "shape": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}},
    {"name": "7", "shape": {"cylinder": {"base": [0, 0, 0], "apex": [0, 1, 0], "radius": 1, "caps": true}}},
    {"name": "8", "shape": {"cone": {"base": [0, 0, 0], "base_radius": 1, "apex": [0, 1, 0], "apex_radius": 0, "inward": true}}},
    {"name": "9", "shape": {"disk": {"center": [0, 0, 0], "normal": [0, 0, 2], "radius": 1}}},
    {"shape": {"mesh": {"path": "meshes/cow.obj"}}}
  ],
  "tracing": {"algorithm": "whitted", "max_depth": 3, "specular": "reflection_vector", "sphere_method": "geometric",
              "cutoff": 0.01, "two_sided": false},
  "sampling": {"statistical": {"confidence": 0.95, "tolerance": 0.01, "min": 4, "max": 64}},
  "frames": {"count": 10, "duration": 1},
  "output": {"white": 255, "transfer": "srgb", "exposure": -1}
}"#;

#[track_caller]
fn survives_printing(text: &str) {
    let scene = loads(text).scene;
    let printed = scene.to_json();
    assert_eq!(loads(&printed).scene, scene, "{printed}");
    assert_eq!(loads(&printed).scene.to_json(), printed);
}

#[test]
fn the_textbook_scene() {
    let Loaded { scene, warnings, .. } = loads(TEXTBOOK);
    assert_eq!(warnings, []);
    assert_eq!(scene.camera.aim, Aim::Direction([-12.0, 4.0, 1.0]));
    assert_eq!(scene.materials.index_of("ball"), Some(1));
    assert_eq!(scene.tracing.sphere_method, Some(SphereMethod::Geometric));
}

#[test]
fn printing_and_reading_again() {
    survives_printing(TEXTBOOK);
    survives_printing(EVERYTHING);
}

#[test]
fn every_sampling() {
    for sampling in [
        r#"{"none": {}}"#,
        r#"{"regular": {"n": 3}}"#,
        r#"{"shared": {"n": 2}}"#,
        r#"{"adaptive": {"threshold": 0.1, "depth": 3}}"#,
        r#"{"stochastic": {"n": 16}}"#,
        r#"{"random": {"n": 16}}"#,
        r#"{"sobol": {"n": 16}}"#,
    ] {
        survives_printing(&textbook_with("{\"none\": {}}", sampling));
    }
}

#[test]
fn defaults() {
    let scene = parse(scene_of("").as_bytes(), "scenes/small.json").unwrap();
    assert_eq!(scene.name, "small");
    assert_eq!(scene.camera.up, [0.0, 1.0, 0.0]);
    assert_eq!(scene.camera.vertical_fov, 45.0);
    assert_eq!(scene.camera.resolution, [320, 240]);
    assert_eq!(scene.sampling, Sampling::Center {});
    assert_eq!(scene.tracing.max_depth, 4);
    assert!(scene.tracing.two_sided);
    assert_eq!(scene.output.white, 1.0);
}

#[test]
fn defaults_of_lights_and_materials() {
    let scene = loads(EVERYTHING).scene;
    assert_eq!(scene.lights[0].color, [1.0; 3]);
    assert_eq!(scene.lights[1].attenuation, [1.0, 0.0, 0.0]);
    assert_eq!(scene.lights[2].profile, Some(Profile::CosinePower(2.0)));
    assert_eq!(scene.materials.get("a"), Some(&Material::default()));
    assert_eq!(scene.materials.get("z").unwrap().weights.transmitted, Weight::Scalar(0.0));
}

#[test]
fn names_are_filled_in() {
    let scene = loads(EVERYTHING).scene;
    assert_eq!(scene.objects[9].name, "object-10");
    assert_eq!(scene.lights[5].name, "light-6");
}

#[test]
fn names_that_are_filled_in_make_way() {
    let sphere = r#""shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}"#;
    let scene = loads(&scene_of(&format!(r#"{{{sphere}}}, {{"name": "object-1", {sphere}}}"#))).scene;
    assert_eq!(scene.objects[0].name, "object-1'");
}

#[test]
fn standard_input_has_a_name() {
    assert_eq!(parse(scene_of("").as_bytes(), "<stdin>").unwrap().name, "stdin");
}

#[test]
fn materials_keep_the_order_of_the_file() {
    let scene = loads(EVERYTHING).scene;
    let names: Vec<&str> = scene.materials.iter().map(|(name, _)| name).collect();
    assert_eq!(names, ["z", "a"]);
}

#[test]
fn look_at_gives_the_direction() {
    assert_eq!(loads(EVERYTHING).scene.camera.direction(), [0.0, 0.1, -5.0]);
}

#[test]
fn numbers_keep_their_bits() {
    let scene = loads(EVERYTHING).scene;
    let again = loads(&scene.to_json()).scene;
    assert_eq!(again.camera.position.map(f64::to_bits), scene.camera.position.map(f64::to_bits));
}

#[test]
fn printed_scenes_are_short() {
    let printed = loads(TEXTBOOK).scene.to_json();
    assert!(printed.contains("\n  \"ambient\": [180, 160, 190],\n"), "{printed}");
    assert!(printed.lines().all(|line| line.len() <= 102), "{printed}");
}

#[test]
fn colours_and_coefficients_may_exceed_one() {
    loads(&textbook_with("[220, 200, 255]", "[2200, 0, 1e6]"));
    loads(&textbook_with("\"ambient\": [0.2", "\"ambient\": [20"));
}
