//! The format as a JSON Schema of a line.

use super::keys;
use super::kinds::{Field, Kind, MARKS, Of, STEPS};
use crate::log::header::{FORMAT, Header};
use crate::log::name::Name;
use schemars::generate::SchemaSettings;
use serde_json::{Map, Value, json};

/// The schema of a line of `raywalk-log/1`, JSON Schema draft 2020-12. Beside the words of the standard each quantity has its
/// `symbol`, `unit`, `section` and `formulas`, by their forms.
///
/// It describes the lines that raywalk writes. A reader passes over other fields, so that later versions may add some.
pub fn json_schema() -> Value {
    let settings = SchemaSettings::draft2020_12().with(|settings| settings.inline_subschemas = true);
    let mut header = settings.into_generator().into_root_schema_for::<Header>().to_value();
    if let Some(header) = header.as_object_mut() {
        header.remove("$schema");
        header.insert("title".to_owned(), "The first line".into());
        header["properties"]["log"] = json!({"const": FORMAT, "description": "The format and its version."});
    }
    let nodes: Vec<_> = [pixel()].into_iter().chain(STEPS.iter().map(of_kind)).collect();
    let decisions: Vec<_> = MARKS.iter().map(of_kind).collect();
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "$id": FORMAT,
        "title": "A line of a raywalk log",
        "oneOf": [
            {"$ref": "#/$defs/header"},
            {"$ref": "#/$defs/enter"},
            {"$ref": "#/$defs/note"},
            {"$ref": "#/$defs/mark"},
            {"$ref": "#/$defs/leave"},
            {"$ref": "#/$defs/result"},
            {"$ref": "#/$defs/end"},
        ],
        "$defs": {
            "header": header,
            "enter": event("A node begins", &json!({
                "enter": {"oneOf": nodes},
            }), &json!({
                "parent": {"type": "integer", "minimum": 0, "description": "The node around it; a pixel has none."},
                "path": {"type": "string", "description": "The way of a ray from the eye, such as `C R S1`."},
            })),
            "note": note(),
            "mark": event("A decision", &json!({"mark": {"oneOf": decisions}}), &json!({})),
            "leave": event("The node ends", &json!({"leave": closed(&Map::new(), &[])}), &json!({})),
            "result": event("The colour of the pixel or ray; linear, not clipped", &json!({
                "result": closed_json(&json!({"color": {"$ref": "#/$defs/triple"}}), &["color"]),
            }), &json!({})),
            "end": closed_json(&json!({
                "end": closed_json(&json!({
                    "events": {"type": "integer", "minimum": 0, "description": "How many events precede it."},
                    "digest": {"type": "string", "pattern": "^blake3:[0-9a-f]{64}$", "description": "The digest of all bytes before this line."},
                }), &["events"]),
            }), &["end"]),
            "given": given(),
            "number": {"type": "number"},
            "triple": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
        },
    })
}

/// An object of these fields and no others.
fn closed(properties: &Map<String, Value>, required: &[&str]) -> Value {
    json!({"type": "object", "properties": properties, "required": required, "additionalProperties": false})
}

fn closed_json(properties: &Value, required: &[&str]) -> Value {
    closed(properties.as_object().unwrap_or(&Map::new()), required)
}

/// An event with what only events of its kind have.
fn event(title: &str, required: &Value, optional: &Value) -> Value {
    let common = json!({
        "at": {"type": "integer", "minimum": 0, "description": "The number of the event in its pixel, from 1; 0 opens a pixel of a region."},
        "node": {"type": "integer", "minimum": 0, "description": "The node that it belongs to; 0 is the pixel."},
        "given": {"$ref": "#/$defs/given"},
        "digits": {"anyOf": [{"$ref": "#/$defs/number"}, {"$ref": "#/$defs/triple"}],
            "description": "So many significant digits of each component agree in several perturbed runs."},
        "decision_differs": {"const": true, "description": "They don't take the same decision."},
    });
    let parts = [&common, required, optional].map(|part| part.as_object().cloned().unwrap_or_default());
    let properties: Map<_, _> = parts.into_iter().flatten().collect();
    let own = required.as_object().into_iter().flat_map(Map::keys).map(String::as_str);
    let required: Vec<&str> = ["at", "node"].into_iter().chain(own).collect();
    let mut event = closed(&properties, &required);
    event["title"] = title.into();
    event
}

/// The node of a pixel, which has no fields by name.
fn pixel() -> Value {
    let place = json!({"type": "array", "items": {"type": "integer", "minimum": 0}, "minItems": 2, "maxItems": 2});
    let mut pixel = closed_json(&json!({"pixel": place}), &["pixel"]);
    pixel["description"] = "A pixel of a region: its column and row.".into();
    pixel
}

/// `{"word":{…}}`
fn of_kind(kind: &Kind) -> Value {
    let properties: Map<_, _> = kind.fields.iter().map(|field| (field.key.to_owned(), of_field(field))).collect();
    let required: Vec<_> = kind.fields.iter().filter(|field| !field.is_optional).map(|field| field.key).collect();
    let mut schema = closed_json(&json!({kind.word: closed(&properties, &required)}), &[kind.word]);
    schema["description"] = kind.meaning.into();
    schema
}

fn of_field(field: &Field) -> Value {
    match field.value {
        Of::Object | Of::Light => json!({"type": "string"}),
        Of::Words(words) => json!({"enum": words()}),
        Of::Whole(least) => json!({"type": "integer", "minimum": least}),
        Of::Triple => json!({"$ref": "#/$defs/triple"}),
        Of::Quantity => json!({"enum": keys().iter().map(|(key, _)| *key).collect::<Vec<_>>()}),
    }
}

/// A computed quantity: one schema a key.
fn note() -> Value {
    let all = keys();
    let mut note = event(
        "A quantity was computed",
        &json!({
            "note": {"enum": all.iter().map(|(key, _)| *key).collect::<Vec<_>>(), "description": "Its key."},
            "value": {},
        }),
        &json!({"form": {"type": "string", "description": "By which of several formulas; absent for the usual one."}}),
    );
    note["oneOf"] = all.iter().map(|(key, names)| quantity(key, names)).collect();
    note
}

fn quantity(key: &str, names: &[Name]) -> Value {
    let forms: Vec<_> = names.iter().map(|name| name.form()).filter(|form| !form.is_empty()).collect();
    let formulas: Map<_, _> =
        names.iter().filter_map(|name| Some((name.form().to_owned(), name.formula()?.into()))).collect();
    let form = if forms.is_empty() { json!(false) } else { json!({"enum": forms}) };
    let Some(first) = names.first() else { return json!(false) };
    let mut quantity = json!({
        "properties": {"note": {"const": key}, "form": form, "value": value(*first)},
        "symbol": first.symbol(),
        "unit": first.unit().text(),
        "formulas": formulas,
    });
    // What is absent is absent.
    if !first.section().is_empty() {
        quantity["section"] = first.section().into();
    }
    quantity
}

fn value(name: Name) -> Value {
    json!({"$ref": if name.is_triple() { "#/$defs/triple" } else { "#/$defs/number" }})
}

/// The inputs of an event.
fn given() -> Value {
    let properties: Map<_, _> = keys().iter().map(|(key, names)| ((*key).to_owned(), value(names[0]))).collect();
    let mut given = closed(&properties, &[]);
    given["description"] = "Inputs that the problem states, used from this event on. No arithmetic rounds them.".into();
    given
}
