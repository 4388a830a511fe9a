//! Words of tables, and how they are printed.

use super::TableFormat;
use crate::cli::failure::Failure;
use crate::cli::output;
use raywalk::files::escape_hidden;
use raywalk::render::RenderError;
use raywalk::scene::Scene;
use serde::Serialize;

/// Measures scene after scene and prints the table; `text` and `csv` lay it out.
pub fn print_measured<M: Serialize>(
    scenes: &[Scene],
    measure: impl Fn(&Scene) -> Result<M, RenderError>,
    format: TableFormat,
    text: fn(&[M]) -> String,
    csv: fn(&[M]) -> String,
) -> Result<(), Failure> {
    let measured: Result<Vec<_>, _> = scenes.iter().map(measure).collect();
    let measured = measured.map_err(|error| Failure::machine(error.to_string()))?;
    let table = match format {
        TableFormat::Text => text(&measured),
        TableFormat::Csv => csv(&measured),
        TableFormat::Json => format!("{:#}\n", serde_json::json!({ "scenes": measured })),
    };
    output::print(table.as_bytes())
}

/// A text as a cell of CSV.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", escape_hidden(text).replace('"', "\"\""))
}
