//! `raywalk scene schema`: a schema by the letter of draft 2020-12 that takes every scene there is.
//!
//! That it refuses what the reader refuses is asked of each text in the tests of `scene/file`.

use crate::support;
use jsonschema::Validator;
use raywalk::scene::file::schema::json_schema;
use raywalk::scene::{builtin, generate};
use serde_json::Value;
use std::fmt::Write;
use std::{env, fs};

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

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/scenes.md");

/// docs/scenes.md has a table of every object of the schema, with what it says of each key. `UPDATE_DOCS=1` writes them anew.
#[test]
fn the_page_of_scene_files_has_every_key() {
    const BEGINS: &str = "<!-- The tables are made from the schema. -->\n";
    let page = fs::read_to_string(PAGE).expect("the page");
    let (text, tables) = page.split_once(BEGINS).expect("the place of the tables");
    let made = Reference { schema: json_schema() }.text();
    let example = text.split_once("```json\n").and_then(|(_, rest)| rest.split_once("```")).expect("an example").0;
    takes("the example of the page", example);
    assert_eq!(support::scene_of(example.as_bytes(), "ball").objects.len(), 2);
    if env::var_os("UPDATE_DOCS").is_some() {
        fs::write(PAGE, format!("{text}{BEGINS}{made}")).expect("the page can be written");
    } else {
        assert_eq!(tables, made, "UPDATE_DOCS=1 writes the tables anew");
    }
}

/// The schema as tables for people.
struct Reference {
    schema: Value,
}

impl Reference {
    fn text(&self) -> String {
        let mut text = self.table("The scene", &self.schema);
        for (name, definition) in self.definitions() {
            if definition.get("properties").is_some() {
                text += &self.table(&words(name), definition);
            } else {
                text += &self.choices(name, definition);
            }
        }
        text
    }

    fn definitions(&self) -> impl Iterator<Item = (&String, &Value)> {
        self.schema["$defs"].as_object().into_iter().flatten()
    }

    /// The keys of an object.
    fn table(&self, title: &str, schema: &Value) -> String {
        let mut text =
            format!("\n### {title}\n\n{}\n\n| key | value | default | meaning |\n|---|---|---|---|\n", said(schema));
        let required =
            |key: &str| schema["required"].as_array().is_some_and(|keys| keys.iter().any(|known| known == key));
        for (key, property) in schema["properties"].as_object().into_iter().flatten() {
            let default = match property.get("default") {
                Some(default) => format!("`{default}`"),
                None if required(key) => "required".to_owned(),
                None => String::new(),
            };
            let _ = writeln!(text, "| `{key}` | {} | {default} | {} |", self.kind(property), said(property));
        }
        text
    }

    /// What may stand for a value that has several forms.
    fn choices(&self, name: &str, schema: &Value) -> String {
        let mut text = format!("\n### {}\n\n{}\n\n| value | meaning |\n|---|---|\n", words(name), said(schema));
        for choice in alternatives(schema) {
            let _ = writeln!(text, "| {} | {} |", self.kind(choice), self.said_of_choice(choice));
        }
        text
    }

    /// What a form means, with its own keys.
    fn said_of_choice(&self, choice: &Value) -> String {
        let inner = choice["properties"].as_object().into_iter().flatten().map(|(_, inner)| inner);
        let of_key = |(key, property): (&String, &Value)| format!("`{key}`: {}", said(property));
        let keys: Vec<_> = inner.filter_map(|inner| inner["properties"].as_object()).flatten().map(of_key).collect();
        [vec![said(choice)], keys].concat().join(" ")
    }

    /// What a value is, in a few words.
    fn kind(&self, schema: &Value) -> String {
        if let Some(reference) = schema["$ref"].as_str() {
            let name = words(reference.rsplit('/').next().unwrap_or_default());
            return format!("[{}](#{})", name.to_lowercase(), name.to_lowercase().replace(' ', "-"));
        }
        if let Some(value) = schema.get("const") {
            return format!("`{value}`");
        }
        match schema["type"].as_str() {
            Some("array") => {
                let count = schema["minItems"].as_u64().filter(|_| schema["minItems"] == schema["maxItems"]);
                let of = match schema["items"].get("$ref") {
                    None if schema["items"]["type"] == "array" => format!("lists of {}", schema["items"]["minItems"]),
                    None => "numbers".to_owned() + &range(&schema["items"]),
                    Some(_) => self.kind(&schema["items"]),
                };
                match count {
                    Some(count) => format!("{count} {of}"),
                    None => format!("list of {of}"),
                }
            }
            Some("object") => match schema["properties"].as_object() {
                Some(properties) => {
                    let only = |(key, inner): (&String, &Value)| match inner["type"].as_str() {
                        Some("object") => {
                            let keys: Vec<_> = inner["properties"]
                                .as_object()
                                .into_iter()
                                .flatten()
                                .map(|(key, _)| format!("\"{key}\": …"))
                                .collect();
                            format!("`{{\"{key}\": {{{}}}}}`", keys.join(", "))
                        }
                        _ => format!("`{{\"{key}\": …}}`, {}", self.kind(inner)),
                    };
                    properties.iter().map(only).collect::<Vec<_>>().join(", ")
                }
                None => format!("{} by name", self.kind(&schema["additionalProperties"])),
            },
            Some("integer") => "whole number".to_owned() + &range(schema),
            Some("boolean") => "`true` or `false`".to_owned(),
            Some("string") => "text".to_owned(),
            Some(other) => other.to_owned() + &range(schema),
            None => alternatives(schema).map(|choice| self.kind(choice)).collect::<Vec<_>>().join(" or "),
        }
    }
}

fn alternatives(schema: &Value) -> impl Iterator<Item = &Value> {
    ["oneOf", "anyOf"].into_iter().filter_map(|key| schema[key].as_array()).flatten()
}

/// The description, in one line of a table.
fn said(schema: &Value) -> String {
    schema["description"].as_str().unwrap_or_default().replace('\n', " ").replace('|', "\\|")
}

/// Between which numbers a value must be.
fn range(schema: &Value) -> String {
    let bound = |key: &str| schema.get(key).map(Value::to_string);
    match (bound("minimum"), bound("exclusiveMinimum"), bound("maximum"), bound("exclusiveMaximum")) {
        (Some(least), _, Some(most), _) => format!(" from {least} to {most}"),
        (_, Some(least), _, Some(most)) => format!(" between {least} and {most}"),
        (Some(least), ..) => format!(" ≥ {least}"),
        (_, Some(least), ..) => format!(" > {least}"),
        (.., Some(most), _) => format!(" ≤ {most}"),
        (.., Some(most)) => format!(" < {most}"),
        _ => String::new(),
    }
}

/// `PointLight` as `Point light`.
fn words(name: &str) -> String {
    let mut words = String::new();
    for (at, letter) in name.chars().enumerate() {
        if letter.is_uppercase() && at > 0 {
            words.push(' ');
            words.extend(letter.to_lowercase());
        } else {
            words.push(letter);
        }
    }
    words
}
