//! The scene file as a JSON Schema, for editors: what they offer, explain and underline while a scene is written.
//!
//! It is derived from the types of this module, their comments and their defaults; the ranges are at the fields. What a
//! schema can't say (directions that aren't zero, names that exist) only [`validate`](mod@super::super::validate) checks.

use schemars::Schema;
use schemars::generate::SchemaSettings;
use schemars::transform::RecursiveTransform;
use serde_json::Value;

use super::SceneFile;

/// The schema of `raywalk-scene/1`, JSON Schema draft 2020-12.
pub fn json_schema() -> Value {
    generated(SchemaSettings::draft2020_12())
}

/// The same without references: a part that occurs several times is in each of its places.
pub fn inlined_schema() -> Value {
    generated(SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true))
}

fn generated(settings: SchemaSettings) -> Value {
    let generator = settings.with_transform(RecursiveTransform(without_rust)).into_generator();
    let mut schema = generator.into_root_schema_for::<SceneFile>();
    schema.insert("$id".to_owned(), "raywalk-scene/1".into());
    schema.insert("title".to_owned(), "A raywalk scene".into());
    schema.to_value()
}

/// Takes out what is about Rust: a key that may be left out is still never `null`, numbers have no width in bits, and an
/// empty name is one that is filled in.
fn without_rust(schema: &mut Schema) {
    schema.remove("format");
    if schema.get("default").is_some_and(|default| default == "") {
        schema.remove("default");
    }
    let Some(fields) = schema.as_object_mut() else { return };
    if let Some(Value::Array(types)) = fields.get_mut("type") {
        types.retain(|name| name != "null");
        if let [only] = types.as_slice() {
            let only = only.clone();
            fields.insert("type".to_owned(), only);
        }
    }
    let is_null = |schema: &Value| schema.get("type").is_some_and(|name| name == "null");
    let Some(Value::Array(choices)) = fields.get_mut("anyOf") else { return };
    choices.retain(|choice| !is_null(choice));
    if let [Value::Object(only)] = choices.as_slice() {
        let only = only.clone();
        fields.remove("anyOf");
        fields.extend(only);
    }
}
