//! The catalogue of bad inputs, b29 to b43: numbers that a scene must not hold.

use super::*;

#[test]
fn b29_zero_width() {
    refuses(
        textbook_with("[321, 241]", "[0, 241]"),
        "5:49: camera.resolution[0]: the width must be from 1 to 65535 pixels, found 0",
    );
}

#[test]
fn b30_negative_width() {
    refuses(
        textbook_with("[321, 241]", "[-5, 241]"),
        "5:49: camera.resolution[0]: expected a whole number from 0 to 4294967295, found -5",
    );
}

#[test]
fn b31_huge_image() {
    refuses_value(
        textbook_with("[321, 241]", "[1000000, 1000000]"),
        "camera.resolution[1]: the height must be from 1 to 65535 pixels, found 1000000",
    );
    refuses_value(
        textbook_with("[321, 241]", "[60000, 60000]"),
        "camera.resolution: a picture must have at most 268435456 pixels, found 60000 × 60000 = 3600000000",
    );
}

#[test]
fn b32_overflowing_image() {
    refuses_value(
        textbook_with("[321, 241]", "[4294967295, 4294967295]"),
        "camera.resolution[0]: the width must be from 1 to 65535 pixels, found 4294967295",
    );
    refuses_value(
        textbook_with("[321, 241]", "[4294967296, 1]"),
        "camera.resolution[0]: expected a whole number from 0 to 4294967295, found 4294967296",
    );
}

#[test]
fn b33_fractional_width() {
    refuses_value(
        textbook_with("[321, 241]", "[10.5, 241]"),
        "camera.resolution[0]: expected a whole number from 0 to 4294967295, found 10.5",
    );
}

#[test]
fn b34_negative_radius() {
    refuses(
        textbook_with("\"radius\": 3", "\"radius\": -1"),
        "16:87: objects[1].shape.sphere.radius: must be positive, found -1",
    );
}

#[test]
fn b35_zero_radius() {
    refuses_value(
        textbook_with("\"radius\": 3", "\"radius\": -0.0"),
        "objects[1].shape.sphere.radius: must be positive, found -0",
    );
}

#[test]
fn b36_zero_normal() {
    refuses(
        textbook_with("[1, 0, 0, -4]", "[0, 0, 0, -4]"),
        "15:69: objects[0].shape.plane.coefficients: must not be the zero vector, found [0, 0, 0]",
    );
}

#[test]
fn b37_negative_exponent() {
    refuses_value(
        textbook_with("\"shininess\": 2,", "\"shininess\": -1,"),
        "materials.ball.shininess: must be 0 or more, found -1",
    );
}

#[test]
fn b38_zero_ior() {
    refuses_value(textbook_with("\"shininess\": 2,", "\"ior\": 0,"), "materials.ball.ior: must be positive, found 0");
}

#[test]
fn b39_negative_ior() {
    refuses_value(
        textbook_with("\"shininess\": 2,", "\"ior\": -1.5,"),
        "materials.ball.ior: must be positive, found -1.5",
    );
}

#[test]
fn b40_huge_depth() {
    refuses_value(
        textbook_with("\"max_depth\": 1", "\"max_depth\": 1000000000"),
        "tracing.max_depth: must be from 0 to 256, found 1000000000",
    );
}

#[test]
fn b41_huge_sample_count() {
    refuses_value(
        textbook_with("{\"none\": {}}", "{\"stochastic\": {\"n\": 1000000000000}}"),
        "sampling.stochastic.n: must be from 1 to 1048576, found 1000000000000",
    );
}

#[test]
fn b42_many_copies_of_an_object() {
    let object = r#"{"name": "it", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}}"#;
    let copies = vec![object; 20_000].join(",\n");
    let error = error_of(scene_of(&copies).as_bytes()).to_string();
    assert!(error.ends_with("and 19979 more problems, not shown"));
}

#[test]
fn b43_no_objects() {
    warns(&scene_of(""), "objects: no objects: only the background will be seen");
}
