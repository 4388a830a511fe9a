//! The comparison of two logs for programs: one JSON document, written piece by piece.

use super::summary::{Pixel, Summary};
use super::{Comparison, Difference, Entry, Format, HeaderDifference, Side, Statement};
use crate::log;
use crate::log::Header;
use serde_json::{Value, json};

/// Writes a comparison piece by piece: what the logs are, then each pixel, then the summary.
#[derive(Clone, Copy, Debug)]
pub struct Json {
    /// Whether to leave out all differences but the first.
    is_brief: bool,
    /// Whether the first difference was written.
    has_first: bool,
    /// Whether a pixel was written.
    has_pixel: bool,
}

impl Format for Json {
    fn begin(&mut self, a: &Header, b: &Header, differences: &[HeaderDifference]) -> String {
        let about = |header: &Header| json!({"scene": header.scene.name, "arithmetic": header.arithmetic, "subject": header.subject});
        format!("{{\"a\":{},\"b\":{},\"header\":{},\"pixels\":[", about(a), about(b), json!(differences))
    }

    fn pixel(&mut self, pixel: Pixel, found: &Comparison) -> String {
        if found.differences.is_empty() || (self.is_brief && self.has_first) {
            return String::new();
        }
        let mut object = json!({});
        if !self.is_brief {
            object["differences"] = found.differences.iter().map(difference).collect();
            object["way"] = found.way.iter().map(entry).collect();
        }
        if let Some(pixel) = pixel {
            object["pixel"] = json!(pixel);
        }
        if !found.changed.is_empty() {
            object["scene"] = json!(found.changed);
        }
        if let (Some(first), false) = (&found.first, self.has_first) {
            self.has_first = true;
            let way: Vec<_> = first.way.iter().map(entry).collect();
            object["first"] = json!({"way": way, "why": first.why});
            if let Some(kind) = &first.kind {
                object["first"]["changed"] = json!(kind);
            }
            if let Some(computations) = &first.computations {
                object["first"]["computations"] = json!(computations);
            }
        }
        self.next(&object)
    }

    fn alone(&mut self, pixel: Pixel, side: Side) -> String {
        self.next(&json!({"pixel": pixel, "only_in": side}))
    }

    fn end(&self, summary: &Summary) -> String {
        let largest = |largest: &Option<(Pixel, Entry)>| {
            largest.as_ref().map(|(pixel, found)| {
                let mut object = entry(found);
                if let Some(pixel) = pixel {
                    object["pixel"] = json!(pixel);
                }
                object
            })
        };
        let mut object = json!({
            "same": summary.is_same(),
            "pixels": {"compared": summary.pixels, "differ": summary.differing_pixels,
                "only_in_a": summary.pixels_only_in_a, "only_in_b": summary.pixels_only_in_b},
            "values": {"compared": summary.values, "differ": summary.differing_values},
            "decisions": summary.decisions,
            "only_in_a": summary.only_in_a,
            "only_in_b": summary.only_in_b,
        });
        // What is absent is absent, never null.
        for (key, found) in [("largest", &summary.largest), ("largest_relative", &summary.largest_relative)] {
            if let Some(found) = largest(found) {
                object[key] = found;
            }
        }
        format!("],\"summary\":{object}}}\n")
    }
}

impl Json {
    /// Begins a comparison; a brief one leaves out all differences but the first.
    pub fn new(is_brief: bool) -> Json {
        Json { is_brief, has_first: false, has_pixel: false }
    }

    fn next(&mut self, object: &Value) -> String {
        let comma = if self.has_pixel { "," } else { "" };
        self.has_pixel = true;
        format!("{comma}\n{object}")
    }
}

fn difference(difference: &Difference) -> Value {
    let mut object = entry(&difference.entry);
    let from = difference.from.iter().map(|(from, effect)| {
        let mut object = place(from);
        if *effect > 0.0 {
            object["effect"] = json!(effect);
        }
        object
    });
    object["why"] = json!(difference.why);
    object["from"] = from.collect();
    if difference.own > 0.0 {
        object["own"] = json!(difference.own);
    }
    if let Some(kind) = &difference.kind {
        object["changed"] = json!(kind);
    }
    if let Some(origin) = &difference.origin {
        object["origin"] = place(origin);
    }
    object
}

/// An entry with its values.
fn entry(found: &Entry) -> Value {
    let mut object = place(found);
    match &found.what {
        Statement::Value { is_input, a, b, distance, .. } => {
            (object["a"], object["b"]) = (value(a), value(b));
            // JSON has no infinity: a number and a triple have no distance.
            if distance.absolute.is_finite() {
                object["absolute"] = json!(distance.absolute);
                object["relative"] = json!(distance.relative);
            }
            if *is_input {
                object["input"] = true.into();
            }
        }
        Statement::Decision { a, b } => (object["a"], object["b"]) = (json!(a), json!(b)),
        Statement::Only { values, .. } => object["values"] = json!(values),
    }
    object
}

/// Where an entry is and what it is, without its values.
fn place(found: &Entry) -> Value {
    let mut object = json!({"path": found.path});
    if !found.node.is_empty() {
        object["node"] = json!(found.node);
    }
    match &found.what {
        Statement::Value { name: Some(name), .. } => {
            object["quantity"] = json!(name.key());
            object["symbol"] = json!(name.symbol());
        }
        Statement::Value { name: None, .. } if found.path.is_empty() => object["quantity"] = json!("result"),
        Statement::Value { name: None, .. } => object["quantity"] = json!("factor"),
        Statement::Decision { .. } => object["quantity"] = json!("decision"),
        Statement::Only { side, what, .. } => {
            object["only_in"] = json!(side);
            object["what"] = json!(what);
        }
    }
    object
}

fn value(value: &log::Value) -> Value {
    value.number().map_or_else(|| json!(value.triple()), |x| json!(x))
}
