//! One spelling for everything, and messages that help where another was used.

use super::*;

#[test]
fn a_word_is_no_key() {
    refuses_value(
        textbook_with("\"recursive\"", "{\"recursive\": null}"),
        "tracing.algorithm.recursive: expected the word alone, as a string, found it as a key",
    );
}

#[test]
fn a_key_is_no_word() {
    refuses_value(
        textbook_with("{\"none\": {}}", "\"none\""),
        "sampling: expected an object, `{\"none\": …}`, found the word alone",
    );
}

#[test]
fn an_unknown_word() {
    refuses(
        textbook_with("\"recursive\"", "\"recursiv\""),
        "17:28: tracing.algorithm: unknown word `recursiv`, did you mean `recursive`? expected `recursive`, `whitted` or `foley`",
    );
}

#[test]
fn one_shape_an_object() {
    refuses_value(
        textbook_with("\"radius\": 3}", "\"radius\": 3}, \"plane\": {\"coefficients\": [1, 0, 0, 0]}"),
        "objects[1].shape: expected an object with exactly one key, found a second one, `plane`",
    );
    refuses_value(
        textbook_with("{\"plane\": {\"coefficients\": [1, 0, 0, -4]}}", "{}"),
        "objects[0].shape: expected an object with exactly one key, found none",
    );
}

#[test]
fn a_shape_is_an_object() {
    let expected = "objects[0].shape: expected one of `plane`, `sphere`, `ellipsoid`, `triangle`, `polygon`, `box`, `cylinder`, `cone`, `disk`, `mesh`, found 5";
    refuses_value(shape("5"), expected);
}

#[test]
fn a_missing_key() {
    refuses_value(
        textbook_with(", \"radius\": 3", ""),
        "objects[1].shape.sphere: the key `radius` is missing, expected it here",
    );
}

#[test]
fn a_missing_camera() {
    refuses("{\"format\": \"raywalk-scene/1\"}", "1:1: the key `camera` is missing, expected it here");
}

#[test]
fn another_version_is_named_before_its_unknown_keys() {
    refuses(
        "{\"stuff\": 1, \"format\": \"raywalk-scene/2\"}",
        "1:24: format: this program reads `raywalk-scene/1`, found `raywalk-scene/2`",
    );
    refuses_value(
        textbook_with("raywalk-scene/1", "raywalk-scene/2"),
        "format: this program reads `raywalk-scene/1`, found `raywalk-scene/2`",
    );
}

#[test]
fn type_tag_is_refused() {
    let error = error_of(shape(r#"{"type": "sphere", "radius": 1}"#).as_bytes()).to_string();
    assert!(error.contains("objects[0].shape.type: unknown word `type`, expected `plane`"), "{error}");
}

#[test]
fn direction_or_look_at() {
    refuses_value(
        textbook_with("\"direction\": [-12, 4, 1], ", ""),
        "camera: expected exactly one of `direction`, `look_at`, found none of them",
    );
    refuses_value(
        textbook_with("\"up\"", "\"look_at\": [0, 0, 0], \"up\""),
        "camera: expected exactly one of `direction`, `look_at`, found `direction` and `look_at`",
    );
}

#[test]
fn one_kind_a_light() {
    refuses_value(
        textbook_with("\"point\": {\"position\": [9, 12, 16]}, ", ""),
        "lights[0]: expected exactly one of `point`, `directional`, `rectangle`, `disk`, `sphere`, found none of them",
    );
    refuses_value(
        textbook_with("\"color\"", "\"directional\": {\"direction\": [0, 0, 1]}, \"color\""),
        "lights[0]: expected exactly one of `point`, `directional`, `rectangle`, `disk`, `sphere`, found `point` and `directional`",
    );
}

#[test]
fn only_area_lights_have_samples() {
    refuses_value(
        textbook_with("\"color\": [220", "\"samples\": 4, \"color\": [220"),
        "lights[0].samples: `samples` is for `rectangle`, `disk` and `sphere` lights, found it on a `point` light",
    );
    refuses_value(
        textbook_with("\"color\": [220", "\"samples\": {\"min\": 1, \"max\": 4}, \"color\": [220"),
        "lights[0].samples: `samples` is for `rectangle`, `disk` and `sphere` lights, found it on a `point` light",
    );
    let sphere = |samples: &str| {
        let kind = format!(r#""sphere": {{"center": [0, 0, 0], "radius": 1}}, "samples": {samples}"#);
        textbook_with("\"point\": {\"position\": [9, 12, 16]}", &kind)
    };
    refuses_value(sphere(r#"{"min": 1}"#), "lights[0].samples: the key `max` is missing, expected it here");
    refuses_value(
        sphere(r#"{"min": 1, "max": 4, "most": 5}"#),
        "lights[0].samples.most: unknown key `most`, expected `min` or `max`",
    );
    for (wrong, found) in
        [(r#""4""#, r#"the string "4""#), ("2.5", "2.5"), ("-4", "-4"), ("[1, 4]", "an array"), ("null", "null")]
    {
        let message = "expected a whole number from 1 to 1048576, or an object with `min` and `max`, found";
        refuses_value(sphere(wrong), &format!("lights[0].samples: {message} {found}"));
    }
}

#[test]
fn by_solid_angle_for_rectangles_and_spheres() {
    refuses_value(
        textbook_with("\"color\": [220", "\"by\": \"area\", \"color\": [220"),
        "lights[0].by: `by` is for `rectangle`, `disk` and `sphere` lights, found it on a `point` light",
    );
    let disk = r#""disk": {"center": [0, 0, 0], "normal": [0, 1, 0], "radius": 1}, "by": "solid_angle""#;
    refuses_value(
        textbook_with("\"point\": {\"position\": [9, 12, 16]}", disk),
        "lights[0].by: `solid_angle` is for `rectangle` and `sphere` lights, found it on a `disk` light, whose points can be spread by `area` alone",
    );
}

#[test]
fn a_weight_is_a_number_or_a_colour() {
    refuses_value(
        textbook_with("\"local\": 1", "\"local\": \"full\""),
        "materials.wall.weights.local: expected a number, or an array of 3 numbers, found the string \"full\"",
    );
    refuses_value(
        textbook_with("\"local\": 1", "\"local\": [1, 1]"),
        "materials.wall.weights.local: expected a number, or an array of 3 numbers, found 2 elements",
    );
    refuses_value(
        textbook_with("\"local\": 1", "\"local\": [1, 1, 1, 1]"),
        "materials.wall.weights.local: expected a number, or an array of 3 numbers, found 4 elements",
    );
}

#[test]
fn numbers_of_other_languages() {
    for number in [".5", "5.", "+1", "01", "0x10", "1_000", "2f"] {
        let message = format!(
            "objects[1].shape.sphere.radius: `{number}` is no number in JSON, expected one like 12, -0.5 or 1e3"
        );
        let text = textbook_with("\"radius\": 3", &format!("\"radius\": {number}"));
        let found = error_of(text.as_bytes()).to_string();
        assert!(found.contains(&message) || found.contains(&message.replace(".radius", "")), "{found}");
    }
}

#[test]
fn words_of_other_languages() {
    refuses_value(
        textbook_with("\"radius\": 3", "\"inward\": True, \"radius\": 3"),
        "objects[1].shape.sphere.inward: `True` is no value in JSON, expected `true` or `false`",
    );
    refuses_value(
        textbook_with("\"ball\"}]", "None}]"),
        "objects[1].material: `None` is no value in JSON, leave the key out instead",
    );
}

#[test]
fn quotes_of_other_languages() {
    refuses_value(
        textbook_with("\"textbook\"", "'textbook'"),
        "name: strings and keys need double quotes in JSON, found a single quote",
    );
    refuses(textbook_with("\"name\":", "name:"), "3:3: expected a key in double quotes, found `n`");
}

#[test]
fn missing_punctuation() {
    refuses(textbook_with("\"textbook\",", "\"textbook\""), "4:3: expected `,` or `}`, found `\"`");
}

#[test]
fn the_place_is_shown() {
    let text = textbook_with("\"radius\": 3", "\"radius\": -1");
    let report = error_of(text.as_bytes()).report(false);
    let lines: Vec<&str> = report.lines().collect();
    assert_eq!(lines[0], "error: t:16:87: objects[1].shape.sphere.radius: must be positive, found -1");
    let caret = lines[3].chars().position(|c| c == '^').unwrap();
    assert!(lines[2].chars().skip(caret).collect::<String>().starts_with("-1}}"), "{report}");
    assert!(lines[3].ends_with(" ^^"));
}
