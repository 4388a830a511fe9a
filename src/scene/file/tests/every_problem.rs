//! All problems at once: mistakes of form don't hide one another, nor what is wrong about the numbers; and nothing is
//! reported that only follows from another mistake.

use super::*;

/// The problems of a text, path and message, without their places.
fn problems(text: &str) -> Vec<String> {
    let found = error_of(text.as_bytes()).to_string();
    found.lines().filter_map(|line| Some(line.split_once(": ")?.1.to_string())).collect()
}

#[track_caller]
fn finds(text: &str, expected: &[&str]) {
    let found = problems(text);
    let fits = found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| a.starts_with(b));
    assert!(fits, "expected {expected:#?}\nfound {found:#?}");
}

#[test]
fn form_and_meaning_together() {
    let text = textbook_with("[16, 2, 7]", "[16, 2]")
        .replace("\"background\"", "\"backgruond\"")
        .replace("[0.8, 0.6, 0.9]", "[0.8, -0.6, 0.9]")
        .replace("\"shininess\": 2,", "\"shininess\": \"2\",")
        .replace("\"ball\"}]", "\"bal\"}]")
        .replace("\"radius\": 3", "\"radius\": 0")
        .replace("\"recursive\"", "\"recursiv\"");
    finds(
        &text,
        &[
            "camera.position: expected an array of 3 elements, found 2 elements",
            "backgruond: unknown key `backgruond`, did you mean `background`?",
            "materials.wall.specular[1]: must be 0 or more, found -0.6",
            "materials.ball.shininess: expected a number, found the string \"2\"",
            "objects[1].shape.sphere.radius: must be positive, found 0",
            "objects[1].material: no material is named `bal`, did you mean `ball`?",
            "tracing.algorithm: unknown word `recursiv`, did you mean `recursive`?",
        ],
    );
}

#[test]
fn several_in_one_object() {
    let object = r#"{"nmae": "a", "shape": {"box": {"min": [0, 0], "max": [1, "1", 1]}}, "material": 5}"#;
    finds(
        &scene_of(object),
        &[
            "objects[0].nmae: unknown key `nmae`, did you mean `name`?",
            "objects[0].shape.box.min: expected an array of 3 elements",
            "objects[0].shape.box.max[1]: expected a number",
            "objects[0].material: expected a string, found 5",
        ],
    );
}

#[test]
fn every_missing_key() {
    finds(
        &scene_of(r#"{"shape": {"sphere": {}}}, {}, {"shape": {"disk": {"normal": [0, 1, 0]}}}"#),
        &[
            "objects[0].shape.sphere: the key `center` is missing",
            "objects[0].shape.sphere: the key `radius` is missing",
            "objects[1]: the key `shape` is missing",
            "objects[2].shape.disk: the key `center` is missing",
            "objects[2].shape.disk: the key `radius` is missing",
        ],
    );
    finds(r#"{"format": "raywalk-scene/1"}"#, &["the key `camera` is missing", "the key `objects` is missing"]);
}

#[test]
fn a_misspelt_key_is_not_missing_too() {
    finds(
        &shape(r#"{"sphere": {"centre": [0, 0, 0], "radius": -1}}"#),
        &[
            "objects[0].shape.sphere.centre: unknown key `centre`, did you mean `center`?",
            "objects[0].shape.sphere.radius: must be positive, found -1",
        ],
    );
    finds(&textbook_with("\"direction\"", "\"directon\""), &["camera.directon: unknown key `directon`, did you mean"]);
    finds(&textbook_with("\"point\"", "\"pont\""), &["lights[0].pont: unknown key `pont`, did you mean `point`?"]);
    finds(&textbook_with("\"materials\"", "\"material\""), &["material: unknown key `material`, did you mean"]);
}

#[test]
fn a_wrong_section_does_not_make_others_wrong() {
    finds(&textbook_with("\"materials\": {", "\"materials\": 5, \"x\": {"), &["materials: expected", "x: unknown key"]);
    finds(
        &textbook_with("\"direction\": [-12, 4, 1]", "\"direction\": true").replace("45", "200"),
        &["camera.direction: expected an array of 3", "camera.vertical_fov: must be between 0 and 180"],
    );
}

#[test]
fn a_mesh_of_mistakes_in_corners() {
    finds(
        &shape(r#"{"triangle": {"vertices": [[0, 0, 0], [1, 0], [0, 1, "0"]], "normals": [[0, 0, 0], [0, 0], 5]}}"#),
        &[
            "objects[0].shape.triangle.vertices[1]: expected an array of 3 elements",
            "objects[0].shape.triangle.vertices[2][2]: expected a number",
            "objects[0].shape.triangle.normals[1]: expected an array of 3 elements",
            "objects[0].shape.triangle.normals[2]: expected an array of 3 elements, found 5",
        ],
    );
}

#[test]
fn keys_that_stand_several_times() {
    finds(
        &textbook_with("\"radius\": 3", "\"radius\": 3, \"radius\": 4").replace("\"ball\": {", "\"wall\": {"),
        &[
            "materials.wall: the key `wall` occurs twice",
            "objects[1].shape.sphere.radius: the key `radius` occurs twice",
            "objects[1].material: no material is named `ball`",
        ],
    );
}

#[test]
fn where_it_is_no_json_the_rest_is_silence() {
    finds(
        &textbook_with("[16, 2, 7]", "[16, 2]").replace("\"radius\": 3", "\"radius\": NaN"),
        &[
            "camera.position: expected an array of 3 elements",
            "objects[1].shape.sphere.radius: `NaN` is no number in JSON",
        ],
    );
}

#[test]
fn no_more_than_twenty_are_shown_and_the_rest_is_counted() {
    let objects = vec![r#"{"shape": {"sphere": {"center": [0, 0], "radius": -1}}}"#; 30].join(", ");
    let found = problems(&scene_of(&objects));
    assert_eq!(found.len(), 20);
    assert!(error_of(scene_of(&objects).as_bytes()).to_string().ends_with("and 40 more problems, not shown"));
}

/// The walk copies what the reader accepted before it stopped, which must not hide a mistake.
#[test]
fn a_mistake_is_found_wherever_it_is_in_a_list() {
    let good = r#"{"point": {"position": [9, 12, 16]}}"#;
    let wrong = [
        (r#"{"color": [1, 1, 1]}"#, ": expected exactly one of"),
        (r#"{"pont": {"position": [9, 12, 16]}}"#, ".pont: unknown key `pont`"),
        (r#"{"point": {"position": [9, 12]}}"#, ".point.position: expected an array of 3 elements"),
        (r#"{"point": {"position": [9, 12, "16"]}}"#, ".point.position[2]: expected a number"),
        (r#"{"point": {"position": [9, 12, 16]}, "samples": 4}"#, ".samples: `samples` is for"),
        ("5", ": expected an object, found 5"),
        ("[9]", ": expected an object, found an array"),
    ];
    for (wrong, message) in wrong {
        for (at, separator) in (0..4).flat_map(|at| [(at, ","), (at, " ,\n  ")]) {
            let mut lights = [good; 4];
            lights[at] = wrong;
            let lights = format!("\"lights\": [{}], \"objects\"", lights.join(separator));
            let text = scene_of("").replacen("\"objects\"", &lights, 1);
            finds(&text, &[&format!("lights[{at}]{message}")]);
        }
    }
}
