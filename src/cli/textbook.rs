//! `raywalk textbook`: the numeric example as a table.

use super::failure::Failure;
use super::inputs;
use super::options::TracingOptions;
use super::{output, scene_argument};
use clap::{Args, ValueEnum};
use raywalk::files::{Wanted, escape_hidden, escape_hidden_json, escape_hidden_lines};
use raywalk::record::Arithmetic;
use raywalk::scene::Scene;
use raywalk::scene::file::nff::Import;
use raywalk::study::textbook::{self, Checked, Example, MAX_TABLE_BYTES, TableError, Worked};
use std::path::{Path, PathBuf};

/// Show the numeric example: printed, recomputed, by hand, exact; or check a worked example of your own
///
/// With `--with` a table of comma-separated values is checked: `quantity` is a name of the log such as sphere.t2_a, `printed` a number
/// or a triple "(x, y, z)"; of colours red alone is enough. Each value is recomputed by hand, with three decimals, from the
/// values that the table has before it. The first row of a name is its first occurrence, the second its second; where that
/// leaves a choice, a column `path` names the ray (C, C R, C R S1). Rows without a printed value are skipped.
#[derive(Args)]
pub struct Textbook {
    /// Which example: that of the source text, or a second one with refraction, total reflection and an attenuated shadow
    #[arg(long, value_enum, value_name = "NAME", default_value = "textbook")]
    example: ExampleName,
    /// A table of printed values to check instead, `-` for standard input; exits with 1 where one departs
    #[arg(long, value_name = "FILE.csv")]
    with: Option<PathBuf>,
    /// How to print it
    #[arg(long, value_enum, default_value = "text")]
    format: TableFormat,
}

#[derive(Clone, Copy, ValueEnum)]
enum ExampleName {
    /// The numeric example of the source text, section 1.3.
    Textbook,
    /// A glass ball with a bubble before a screen.
    Refraction,
}

#[derive(Clone, Copy, ValueEnum)]
enum TableFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
    /// For documents.
    Markdown,
}

impl Textbook {
    /// Runs the command; `false` where a value of somebody's own table departs.
    pub fn run(self) -> Result<bool, Failure> {
        let example = match self.example {
            ExampleName::Textbook => Example::Textbook,
            ExampleName::Refraction => Example::Refraction,
        };
        let scene = scene_of(example)?;
        if let Some(path) = &self.with {
            inputs::reads([path]);
            let checked = check(path, example, &scene)?;
            let text = match self.format {
                TableFormat::Text => escape_hidden_lines(&checked.text()),
                TableFormat::Json => escape_hidden_json(&checked.json()).into_owned(),
                TableFormat::Markdown => escape_hidden_lines(&checked.markdown()),
            };
            output::print(text.as_bytes())?;
            return Ok(checked.departures().next().is_none());
        }
        let table = textbook::table(example, &scene);
        let text = match self.format {
            TableFormat::Text => table.text(),
            TableFormat::Json => table.json(),
            TableFormat::Markdown => table.markdown(),
        };
        output::print(text.as_bytes())?;
        Ok(true)
    }
}

/// The scene of an example, by hand.
pub fn scene_of(example: Example) -> Result<Scene, Failure> {
    let loaded = scene_argument::scene(&scene_argument::built_in(example.scene())?, &Import::default())?;
    let by_hand = TracingOptions { arithmetic: Arithmetic::Decimal(3), ..TracingOptions::default() };
    by_hand.apply(loaded)
}

/// Reads a table and checks it. A table that doesn't fit the example may be one of another.
fn check(path: &Path, example: Example, scene: &Scene) -> Result<Checked, Failure> {
    let wanted = Wanted { what: "a table", max_bytes: MAX_TABLE_BYTES };
    let text = wanted.read(path).map_err(|error| Failure::scene(&error))?;
    let said = |error: &TableError, hint: &str| {
        let name = path.to_string_lossy();
        Failure::caller(format!("{}: {}{hint}", escape_hidden(&name), escape_hidden(&error.to_string())))
    };
    let worked = Worked::parse(&text).map_err(|error| said(&error, ""))?;
    let error = match worked.check(scene) {
        Ok(checked) => return Ok(checked),
        Err(error) => error,
    };
    for other in Example::ALL.into_iter().filter(|other| *other != example) {
        if worked.check(&scene_of(other)?).is_ok() {
            // Its scene is named as the example is.
            return Err(said(&error, &format!("; the table fits another example: --example {}", other.scene())));
        }
    }
    Err(said(&error, ""))
}
