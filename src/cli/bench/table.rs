//! Tables as text and as CSV, and how they are printed.

use super::TableFormat;
use crate::cli::failure::Failure;
use crate::cli::output;
use raywalk::files::escape_hidden_lines;
use raywalk::log::table::aligned;
use raywalk::render::RenderError;
use raywalk::scene::Scene;
use raywalk::study::bench::Spread;
use serde::Serialize;
use serde_json::{Value, json};

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
    print(format, || text(&measured), || csv(&measured), || json!({ "scenes": measured }))
}

/// Prints what was measured in the format that is asked for.
pub fn print(
    format: TableFormat,
    text: impl FnOnce() -> String,
    csv: impl FnOnce() -> String,
    json: impl FnOnce() -> Value,
) -> Result<(), Failure> {
    let table = match format {
        TableFormat::Text => text(),
        TableFormat::Csv => csv(),
        TableFormat::Json => format!("{:#}\n", json()),
    };
    output::print(table.as_bytes())
}

/// A table below its heads: the first column is text, the others are numbers.
pub fn text<R: AsRef<[String]>>(heads: &[&str], rows: impl IntoIterator<Item = R>) -> String {
    let heads: Vec<String> = heads.iter().map(|head| (*head).to_owned()).collect();
    let rows = rows.into_iter().map(|row| row.as_ref().to_vec());
    let lines = aligned(std::iter::once(heads).chain(rows), |column| column > 0);
    lines.iter().map(|line| format!("  {line}\n")).collect()
}

/// Rows as CSV, their heads, with commas between them, in the first line.
pub fn csv<R: AsRef<[String]>>(heads: &str, rows: impl IntoIterator<Item = R>) -> String {
    let lines = rows.into_iter().map(|row| csv_line(&row.as_ref()));
    format!("{heads}\n{}", lines.collect::<String>())
}

/// A row as a line of CSV.
pub fn csv_line(row: &impl Serialize) -> String {
    let mut writer = csv::WriterBuilder::new().has_headers(false).from_writer(Vec::new());
    writer.serialize(row).expect("numbers and texts are written into memory");
    let line = writer.into_inner().expect("memory takes what is written");
    escape_hidden_lines(&String::from_utf8_lossy(&line))
}

/// The median and the quartiles of a figure, with all digits.
pub fn quartiles(figure: &Spread) -> [String; 3] {
    [figure.median, figure.lower, figure.upper].map(|x| x.to_string())
}

/// A figure that may be absent, with all digits.
pub fn or_blank(figure: Option<impl ToString>) -> String {
    figure.map(|figure| figure.to_string()).unwrap_or_default()
}
