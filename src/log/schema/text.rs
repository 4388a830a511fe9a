//! The format for people.

use super::keys;
use super::kinds::{Field, Kind, MARKS, Of, STEPS};
use crate::files::escape::width;
use crate::log::header::FORMAT;

const LINES: &[[&str; 2]] = &[
    ["{\"log\":…}", "the header: what was traced, how, and the names of objects and lights"],
    [
        "{\"at\":N,\"node\":M,\"enter\":{…}}",
        "a node begins; parent is the node around it, path the way of a ray from the eye",
    ],
    [
        "{\"at\":N,\"node\":M,\"note\":KEY,\"value\":V}",
        "a quantity was computed; form tells by which of several formulas",
    ],
    ["{\"at\":N,\"node\":M,\"mark\":{…}}", "a decision was taken"],
    ["{\"at\":N,\"node\":M,\"leave\":{}}", "the node ends"],
    ["{\"at\":N,\"node\":0,\"result\":{\"color\":V}}", "the colour of the pixel or ray"],
    [
        "{\"end\":{\"events\":N,\"digest\":D}}",
        "the last line: how many events there are, and the blake3 digest of all bytes before it",
    ],
];

const FIELDS: &[[&str; 2]] = &[
    ["given", "inputs that the problem states, by their keys, used from this event on; no arithmetic rounds them"],
    ["digits", "of several runs in perturbed arithmetic: this many significant digits of each component agree"],
    ["decision_differs", "true where they don't take the same decision"],
];

/// The whole format.
pub fn text() -> String {
    let rows = |rows: &[[&str; 2]]| aligned(&rows.iter().map(|row| row.map(str::to_owned)).collect::<Vec<_>>());
    let kind = |kind: &Kind| [kind.written(), kind.meaning.to_owned()];
    let pixel = ["{\"pixel\":[X,Y]}", "a pixel of a region: its column and row"].map(str::to_owned);
    let nodes: Vec<_> = [pixel].into_iter().chain(STEPS.iter().map(kind)).collect();
    let decisions: Vec<_> = MARKS.iter().map(kind).collect();
    format!(
        "{FORMAT}: a line is a JSON object\n\nLines\n{}\nFields that any event may have\n{}\nNodes (enter)\n{}\nDecisions (mark)\n{}\n{}",
        rows(LINES),
        rows(FIELDS),
        aligned(&nodes),
        aligned(&decisions),
        quantities()
    )
}

/// The table of all quantities.
pub fn quantities() -> String {
    let heads = ["key", "form", "symbol", "formula", "unit", "values", "section"].map(str::to_owned);
    let row = |(number, name): (usize, &super::Name)| {
        let key = if number == 0 { name.key() } else { "" };
        let values = if name.is_triple() { "3" } else { "1" };
        let formula = name.formula().unwrap_or("–");
        [key, name.form(), name.symbol(), formula, name.unit().text(), values, name.section()].map(str::to_owned)
    };
    let rows: Vec<_> = keys().iter().flat_map(|(_, names)| names.iter().enumerate().map(row)).collect();
    let rows: Vec<_> = [heads].into_iter().chain(rows).collect();
    format!("Quantities (note, given)\n{}", aligned(&rows))
}

impl Kind {
    /// Its object, such as `{"miss":{"why":…}}`.
    fn written(&self) -> String {
        let fields: Vec<_> = self.fields.iter().map(Field::written).collect();
        format!("{{\"{}\":{{{}}}}}", self.word, fields.join(","))
    }
}

impl Field {
    fn written(&self) -> String {
        let value = match self.value {
            Of::Object => "OBJECT".to_owned(),
            Of::Light => "LIGHT".to_owned(),
            Of::Words(words) => words().join("|"),
            Of::Whole(_) => "N".to_owned(),
            Of::Triple => "[A,B,C]".to_owned(),
            Of::Quantity => "KEY".to_owned(),
        };
        let mark = if self.is_optional { "?" } else { "" };
        format!("\"{}\"{mark}:{value}", self.key)
    }
}

/// Rows whose columns are below each other; a row whose first column is very wide pushes none of the others aside.
fn aligned<const N: usize>(rows: &[[String; N]]) -> String {
    const WIDEST: usize = 90;
    let widest = |column: usize| rows.iter().map(|row| width(&row[column])).filter(|width| *width <= WIDEST).max();
    let widths: [usize; N] = std::array::from_fn(|column| widest(column).unwrap_or(0));
    let line = |row: &[String; N]| {
        let cells = row.iter().zip(widths);
        let padded: Vec<_> =
            cells.map(|(cell, columns)| format!("{cell}{}", " ".repeat(columns.saturating_sub(width(cell))))).collect();
        format!("  {}\n", padded.join("  ").trim_end())
    };
    rows.iter().map(line).collect()
}
