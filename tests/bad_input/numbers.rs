//! The rows b29 to b43: numbers that a scene must not hold.

use crate::run::{answer, raywalk};
use crate::scenes::{TEXTBOOK, error_of, folder_with, refuses, refuses_value, textbook_with};
use std::fs;

#[test]
fn b29_zero_width() {
    refuses(
        textbook_with("[321, 241]", "[0, 241]"),
        "9:20: camera.resolution[0]: the width must be from 1 to 65535 pixels, found 0",
    );
}

#[test]
fn b30_negative_width() {
    refuses(
        textbook_with("[321, 241]", "[-5, 241]"),
        "9:20: camera.resolution[0]: expected a whole number from 1 to 65535, found -5",
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
        "camera.resolution[0]: expected a whole number from 1 to 65535, found 4294967296",
    );
}

#[test]
fn b33_fractional_width() {
    refuses_value(
        textbook_with("[321, 241]", "[10.5, 241]"),
        "camera.resolution[0]: expected a whole number from 1 to 65535, found 10.5",
    );
}

#[test]
fn b34_negative_radius() {
    refuses(
        textbook_with("\"radius\": 3", "\"radius\": -1"),
        "34:77: objects[1].shape.sphere.radius: must be positive, found -1",
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
        "33:59: objects[0].shape.plane.coefficients: must not be the zero vector, found [0, 0, 0]",
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
        "sampling.stochastic.n: expected a whole number from 1 to 1048576, found 1000000000000",
    );
}

/// The scene with this many copies of its first object.
fn copies(count: usize) -> String {
    let object = TEXTBOOK.lines().find(|line| line.contains("\"plane\"")).expect("an object");
    textbook_with(object, &vec![object; count].join("\n"))
}

#[test]
fn b42_many_objects() {
    let some = error_of(copies(20_000));
    assert!(some.trim_end().ends_with("error: and 19979 more problems, not shown"), "{some}");
    // Of a million, reading stops before they fill the memory.
    refuses_value(copies(1_000_000), "objects: names must be unique, found more than 65536 that are taken");
}

#[test]
fn b43_no_objects() {
    let objects = TEXTBOOK.split_once("\"objects\": [").and_then(|(_, rest)| rest.split_once("\n  ]"));
    let folder = folder_with(textbook_with(objects.expect("objects").0, ""));
    let render = ["render", "t.json", "--size", "2x2", "-q", "-o", "a.ppm"];
    let rendered = answer(&mut raywalk(folder.path(), &render)).ends_with(0);
    assert!(rendered.message.contains("objects: no objects: only the background will be seen"), "{}", rendered.message);
    let picture = fs::read(folder.path().join("a.ppm")).expect("a picture");
    assert_eq!(picture, [b"P6\n2 2\n255\n".as_slice(), &[200, 200, 255].repeat(4)].concat());
}
