//! `raywalk scene schema`: a schema by the letter of draft 2020-12 that takes every scene there is.
//!
//! That it refuses what the reader refuses is asked of each text in the tests of `scene/file`.

use jsonschema::Validator;
use raywalk::scene::file::schema::json_schema;
use raywalk::scene::{builtin, generate};
use serde_json::Value;

fn schema() -> Validator {
    jsonschema::draft202012::new(&json_schema()).expect("a good schema")
}

#[track_caller]
fn takes(name: &str, text: &str) {
    let value = serde_json::from_str(text).expect("JSON");
    let errors: Vec<_> = schema().iter_errors(&value).map(|error| error.to_string()).collect();
    assert!(errors.is_empty(), "{name}: {errors:#?}");
}

#[test]
fn it_is_a_schema() {
    assert!(jsonschema::draft202012::meta::is_valid(&json_schema()));
    assert_eq!(json_schema()["$schema"], "https://json-schema.org/draft/2020-12/schema");
}

#[test]
fn it_takes_every_scene() {
    for name in builtin::names() {
        takes(name, builtin::text(name).expect("a built-in scene"));
    }
    takes("shapes", include_str!("../support/shapes.json"));
    let mut flake = Vec::new();
    generate::sphere_flake(1, &mut flake).expect("memory can be written to");
    takes("sphere-flake", &String::from_utf8(flake).expect("UTF-8"));
}

#[test]
fn every_object_is_closed_and_every_key_is_explained() {
    let mut keys = 0;
    each(&json_schema(), &mut |schema| {
        let Some(properties) = schema.get("properties").and_then(Value::as_object) else { return };
        assert_eq!(schema["additionalProperties"], false, "{schema:#}");
        let is_choice = properties.len() == 1;
        for (key, property) in properties {
            let is_explained = property.get("description").is_some() || is_choice;
            assert!(is_explained, "{key} in {schema:#}");
            keys += 1;
        }
    });
    assert!(keys > 80, "{keys} keys");
}

/// Shows every value inside, itself included.
fn each(value: &Value, see: &mut impl FnMut(&Value)) {
    see(value);
    match value {
        Value::Array(elements) => elements.iter().for_each(|element| each(element, see)),
        Value::Object(fields) => fields.values().for_each(|field| each(field, see)),
        _ => {}
    }
}

#[test]
fn it_refuses_what_is_no_scene() {
    let good = builtin::text("textbook").expect("a built-in scene");
    for (old, new) in [
        ("\"background\"", "\"backgruond\""),
        ("[16, 2, 7]", "[16, 2]"),
        ("[16, 2, 7]", "[16, 2, 7, 1]"),
        ("[16, 2, 7]", "[16, 2, \"7\"]"),
        ("\"radius\": 3", "\"radius\": 0"),
        ("\"radius\": 3", "\"radius\": null"),
        ("\"max_depth\": 1", "\"max_depth\": 257"),
        ("\"max_depth\": 1", "\"max_depth\": 1.5"),
        ("\"recursive\"", "\"recursiv\""),
        ("{\"sphere\":", "{\"shpere\":"),
        ("raywalk-scene/1", "raywalk-scene/2"),
        ("\"shininess\": 2,", "\"shininess\": -1,"),
        ("\"shininess\": 2,", "\"ior\": 0,"),
        ("\"white\": 255", "\"white\": -1"),
        ("\"point\": {\"position\": [9, 12, 16]}, ", ""),
    ] {
        assert!(good.contains(old), "the numeric example has no {old}");
        let bad: Value = serde_json::from_str(&good.replacen(old, new, 1)).expect("JSON");
        assert!(!schema().is_valid(&bad), "{new}");
    }
}
