//! Words of tables, and how they are printed.

use super::TableFormat;
use crate::cli::failure::Failure;
use crate::cli::output;
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

/// Rows as CSV, below the names of their columns if there are any: a row is a struct or a tuple, whose parts may be tuples and lists.
pub fn csv(head: &str, rows: impl IntoIterator<Item = impl Serialize>) -> String {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    let written = if head.is_empty() { Ok(()) } else { writer.write_record(head.split(',')) };
    written.expect("memory takes what is written");
    rows.into_iter().for_each(|row| writer.serialize(row).expect("every row has a cell for each column"));
    let bytes = writer.into_inner().expect("memory takes what is written");
    String::from_utf8(bytes).expect("cells are made of texts and numbers")
}
