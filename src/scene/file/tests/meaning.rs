//! Numbers that cannot be meant.

use super::*;
use crate::scene::file::{check_scene, schema, validate};

#[test]
fn all_problems_are_reported_at_once() {
    let text = textbook_with("\"radius\": 3", "\"radius\": -1").replace("[321, 241]", "[0, 0]");
    let error = error_of(text.as_bytes());
    let paths: Vec<String> = error.problems().iter().map(|problem| problem.path.to_string()).collect();
    assert_eq!(paths, ["camera.resolution[0]", "camera.resolution[1]", "objects[1].shape.sphere.radius"]);
}

#[test]
fn numbers_that_no_file_can_hold() {
    let mut scene = loads(TEXTBOOK).scene;
    scene.ambient[1] = f64::NAN;
    scene.camera.position[2] = f64::INFINITY;
    let messages: Vec<String> = validate::validate(&scene)
        .errors
        .iter()
        .map(|finding| format!("{}: {}", finding.path, finding.message))
        .collect();
    assert_eq!(messages, ["camera.position[2]: must be finite, found inf", "ambient[1]: must be finite, found NaN"]);
}

#[test]
fn names_are_needed_when_no_file_was_read() {
    let mut scene = loads(TEXTBOOK).scene;
    scene.objects[0].name = Default::default();
    scene.format = schema::FORMAT.to_string();
    assert_eq!(validate::validate(&scene).errors[0].message, "a name must not be empty");
}

#[test]
fn a_scene_changed_by_options_is_checked_without_lines() {
    let mut scene = loads(TEXTBOOK).scene;
    scene.camera.resolution = [0, 1];
    let error = check_scene(&scene, "t").unwrap_err().to_string();
    assert_eq!(error, "t: camera.resolution[0]: the width must be from 1 to 65535 pixels, found 0");
}

#[test]
fn a_direction_of_no_length() {
    refuses_value(
        textbook_with("[-12, 4, 1]", "[0, 0, 0]"),
        "camera.direction: must not be the zero vector, found [0, 0, 0]",
    );
    refuses_value(
        textbook_with("[-12, 4, 1]", "[0, 1e-200, 0]"),
        "camera.direction: must have a length of at least 1e-150, found [0, 1e-200, 0]",
    );
    refuses_value(
        textbook_with("\"direction\": [-12, 4, 1]", "\"look_at\": [16, 2, 7]"),
        "camera.look_at: must not be the camera's position, found [16, 2, 7]",
    );
}

#[test]
fn up_along_the_view() {
    refuses_value(
        textbook_with("[0, 0, 1]", "[-24, 8, 2]"),
        "camera.up: must not be parallel to the direction of view [-12, 4, 1], found [-24, 8, 2]",
    );
}

#[test]
fn the_default_up_along_the_view_points_at_the_camera() {
    let text = scene_of("").replace("[0, 0, -1]", "[0, -1, 0]");
    refuses(text, "1:41: camera.up: must not be parallel to the direction of view [0, -1, 0], found [0, 1, 0]");
}

#[test]
fn field_of_view() {
    for fov in ["0", "180", "-45"] {
        refuses_value(
            textbook_with("45", fov),
            &format!("camera.vertical_fov: must be between 0 and 180, both excluded, found {fov}"),
        );
    }
}

#[test]
fn lens_and_shutter() {
    let with = |keys: &str| textbook_with("\"vertical_fov\": 45", keys);
    refuses_value(
        with(r#""lens": {"radius": -1, "focus_distance": 1}"#),
        "camera.lens.radius: must be 0 or more, found -1",
    );
    refuses_value(
        with(r#""lens": {"radius": 1, "focus_distance": 0}"#),
        "camera.lens.focus_distance: must be positive, found 0",
    );
    refuses_value(with(r#""shutter": [1, 0.5]"#), "camera.shutter: must open before it closes, found [1, 0.5]");
}

#[test]
fn materials_are_looked_up() {
    refuses(
        textbook_with("\"ball\"}]", "\"bal\"}]"),
        "16:104: objects[1].material: no material is named `bal`, did you mean `ball`?",
    );
    refuses_value(
        scene_of(r#"{"shape": {"box": {"min": [0, 0, 0], "max": [1, 1, 1]}}, "material": "m"}"#),
        "objects[0].material: no material is named `m`, the scene has no materials",
    );
}

#[test]
fn unused_materials() {
    warns(
        &textbook_with(", \"material\": \"wall\"", ""),
        "warning: scenes/t.json:10:5: materials.wall: no object has this material",
    );
}

#[test]
fn indices_of_refraction_that_are_quotients() {
    let air = |weights: &str| {
        let air = format!("\"air\": {{\"ior\": 0.667, \"weights\": {weights}}}");
        textbook_with("\"materials\": {", &format!("\"materials\": {{{air},"))
    };
    let doubt = "materials.air.ior: should be the index of the medium itself, 1 or more, and not its quotient";
    warns(&air(r#"{"transmitted": 0.9}"#), doubt);
    let opaque = loads(&air(r#"{"reflected": 0.9}"#)).warnings;
    assert!(opaque.iter().all(|warning| !warning.report(Severity::Warning, false).contains(".ior:")), "{opaque:?}");
}

#[test]
fn negative_colours() {
    refuses_value(textbook_with("[180, 160, 190]", "[180, -1, 190]"), "ambient[1]: must be 0 or more, found -1");
    refuses_value(textbook_with("[220, 200, 255]", "[-1, 0, 0]"), "lights[0].color[0]: must be 0 or more, found -1");
    refuses_value(
        textbook_with("\"local\": 1", "\"local\": -1"),
        "materials.wall.weights.local: must be 0 or more, found -1",
    );
}

#[test]
fn attenuation() {
    let with =
        |factors: &str| textbook_with("\"color\": [220", &format!("\"attenuation\": {factors}, \"color\": [220"));
    refuses_value(with("[0, -1, 0]"), "lights[0].attenuation[1]: must be 0 or more, found -1");
    refuses_value(
        with("[0, 0, 0]"),
        "lights[0].attenuation: must not be zero throughout, found [0, 0, 0] (no attenuation is [1, 0, 0])",
    );
}

#[test]
fn area_lights() {
    let with = |kind: &str| textbook_with("\"point\": {\"position\": [9, 12, 16]}", kind);
    refuses_value(
        with(r#""rectangle": {"corner": [0, 0, 0], "edge_u": [1, 0, 0], "edge_v": [-2, 0, 0]}"#),
        "lights[0].rectangle: the edges must not be parallel",
    );
    refuses_value(
        with(r#""disk": {"center": [0, 0, 0], "normal": [0, 0, 0], "radius": 1}"#),
        "lights[0].disk.normal: must not be the zero vector, found [0, 0, 0]",
    );
    refuses_value(
        with(r#""sphere": {"center": [0, 0, 0], "radius": 1}, "samples": 0"#),
        "lights[0].samples: must be from 1 to 1048576, found 0",
    );
    let sphere =
        |samples: &str| with(&format!(r#""sphere": {{"center": [0, 0, 0], "radius": 1}}, "samples": {samples}"#));
    refuses_value(sphere(r#"{"min": 5, "max": 4}"#), "lights[0].samples.max: must be `min`, 5, or more, found 4");
    refuses_value(sphere(r#"{"min": 0, "max": 4}"#), "lights[0].samples.min: must be from 1 to 1048576, found 0");
    refuses_value(
        sphere(r#"{"min": 4, "max": 9999999}"#),
        "lights[0].samples.max: must be from 1 to 1048576, found 9999999",
    );
    refuses_value(
        with(r#""rectangle": {"corner": [0, 0, 0], "edge_u": [1, 0, 0], "edge_v": [0.1, 2, 0]}, "by": "solid_angle""#),
        "lights[0].by: `solid_angle` is for rectangles with perpendicular edges, found a parallelogram (`area` takes any)",
    );
}

#[test]
fn ellipsoids() {
    refuses_value(
        shape(r#"{"ellipsoid": {"center": [0, 0, 0], "radii": [1, 0, 1]}}"#),
        "objects[0].shape.ellipsoid.radii[1]: must be positive, found 0",
    );
    let rotation = "objects[0].shape.ellipsoid.rotation: must be a proper rotation (rows of length 1, perpendicular, right-handed), found another matrix";
    for rows in ["[[1, 0, 0], [0, 1, 0], [0, 0, -1]]", "[[1, 0, 0], [0, 1, 0], [0, 0, 1.001]]"] {
        let text = format!(r#"{{"ellipsoid": {{"center": [0, 0, 0], "radii": [1, 1, 1], "rotation": {rows}}}}}"#);
        refuses_value(shape(&text), rotation);
    }
}

#[test]
fn triangles() {
    for last in ["[0.3, 0.3, 0.3]", "[0.1, 0.1, 0.1]"] {
        let text = format!(r#"{{"triangle": {{"vertices": [[0.1, 0.1, 0.1], [0.2, 0.2, 0.2], {last}]}}}}"#);
        refuses_value(
            shape(&text),
            "objects[0].shape.triangle.vertices: must not lie on one line, found a triangle without area",
        );
    }
    loads(&shape(r#"{"triangle": {"vertices": [[0, 0, 0], [1e6, 0, 0], [1, 1e-6, 0]]}}"#));
}

#[test]
fn polygons() {
    let polygon = |vertices: &str| shape(&format!(r#"{{"polygon": {{"vertices": {vertices}}}}}"#));
    refuses_value(polygon("[[0, 0, 0], [1, 0, 0]]"), "objects[0].shape.polygon.vertices: must be 3 or more, found 2");
    for vertices in ["[[1, 1, 1], [1, 1, 1], [1, 1, 1]]", "[[0, 0, 0], [1, 1, 0], [1, 0, 0], [0, 1, 0]]"] {
        refuses_value(
            polygon(vertices),
            "objects[0].shape.polygon.vertices: must span an area, found a polygon without",
        );
    }
    warns(&polygon("[[0, 0, 0], [1, 0, 0], [1, 1, 0.5], [0, 1, 0]]"), "should lie in one plane");
    refuses_value(
        shape(r#"{"polygon": {"vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 0]], "normals": [[0, 0, 1]]}}"#),
        "objects[0].shape.polygon.normals: must be one for each of the 3 vertices, found 1",
    );
}

#[test]
fn boxes() {
    refuses_value(
        shape(r#"{"box": {"min": [0, 3, 0], "max": [1, 2, 1]}}"#),
        "objects[0].shape.box.max[1]: must be greater than min[1], 3, found 2",
    );
}

#[test]
fn cylinders_and_cones() {
    refuses_value(
        shape(r#"{"cylinder": {"base": [1, 1, 1], "apex": [1, 1, 1], "radius": 1}}"#),
        "objects[0].shape.cylinder.apex: must not be the base, found [1, 1, 1]",
    );
    refuses_value(
        shape(r#"{"cylinder": {"base": [0, 0, 0], "apex": [0, 3e-319, 0], "radius": 1}}"#),
        "objects[0].shape.cylinder.apex: must be at least 1e-150 from the base, found 3e-319",
    );
    refuses_value(
        shape(r#"{"cone": {"base": [0, 0, 0], "base_radius": 2, "apex": [0, 1e-60, 0], "apex_radius": 0}}"#),
        "objects[0].shape.cone: its radius must change by at most 1e50 a unit of its axis, found 2e60",
    );
    refuses_value(
        shape(r#"{"cone": {"base": [0, 0, 0], "base_radius": 0, "apex": [0, 1, 0], "apex_radius": 0}}"#),
        "objects[0].shape.cone: `base_radius` and `apex_radius` must not both be 0",
    );
    refuses_value(
        shape(r#"{"cone": {"base": [0, 0, 0], "base_radius": -1, "apex": [0, 1, 0], "apex_radius": 0}}"#),
        "objects[0].shape.cone.base_radius: must be 0 or more, found -1",
    );
}

#[test]
fn meshes() {
    refuses_value(
        shape(r#"{"mesh": {"path": "../../../../etc/passwd"}}"#),
        "objects[0].shape.mesh.path: must stay inside the scene's folder, found `../../../../etc/passwd`",
    );
    refuses_value(
        shape(r#"{"mesh": {"path": "/dev/zero"}}"#),
        "objects[0].shape.mesh.path: must be relative to the scene file, found the absolute path `/dev/zero`",
    );
}

#[test]
fn motions() {
    let sphere = r#"{"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "motion": {"rotation": {"axis": [0, 0, 0], "point": [0, 0, 0], "degrees": 1}}}"#;
    refuses_value(scene_of(sphere), "objects[0].motion.rotation.axis: must not be the zero vector, found [0, 0, 0]");
    let sphere =
        r#"{"shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "motion": {"translation": [0, 3e60, 0]}}"#;
    let late = scene_of(sphere).replacen("\"camera\": {", "\"camera\": {\"shutter\": [-1e50, 0], ", 1);
    refuses_value(
        late,
        "objects[0].motion.translation: must lead at most 1e100 away while the shutter is open, found 3e110",
    );
}

#[test]
fn samplings() {
    let with = |sampling: &str| textbook_with("{\"none\": {}}", sampling);
    refuses_value(with(r#"{"regular": {"n": 0}}"#), "sampling.regular.n: must be from 1 to 1024, found 0");
    refuses_value(
        with(r#"{"adaptive": {"threshold": 0.1, "depth": 11}}"#),
        "sampling.adaptive.depth: must be from 0 to 10, found 11",
    );
    let statistical = r#"{"statistical": {"confidence": 1, "tolerance": 0, "min": 16, "max": 8}}"#;
    refuses_value(
        with(statistical),
        "sampling.statistical.confidence: must be between 0 and 1, both excluded, found 1",
    );
    refuses_value(with(statistical), "sampling.statistical.tolerance: must be positive, found 0");
    refuses_value(with(statistical), "sampling.statistical.max: must be `min`, 16, or more, found 8");
    let guided = r#"{"guided": {"tolerance": -1, "min": 0, "max": 1}}"#;
    refuses_value(with(guided), "sampling.guided.tolerance: must be positive, found -1");
    refuses_value(with(guided), "sampling.guided.min: must be from 1 to 1048576, found 0");
    refuses_value(with(guided), "sampling.guided.max: must be from 2 to 1048576, found 1");
}

#[test]
fn frames_and_output() {
    refuses_value(
        textbook_with("\"output\"", "\"frames\": {\"count\": 0, \"duration\": 1}, \"output\""),
        "frames.count: must be from 1 to 1000000, found 0",
    );
    refuses_value(textbook_with("\"white\": 255", "\"white\": 0"), "output.white: must be positive, found 0");
    refuses_value(
        textbook_with("\"white\": 255", "\"exposure\": 1e9"),
        "output.exposure: must be from -100 to 100, found 1000000000",
    );
}
