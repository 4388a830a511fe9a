//! `raywalk textbook`: the numeric example as a table.

use super::failure::Failure;
use super::options::{ColorChoice, TracingOptions};
use super::{output, scene_argument};
use clap::{Args, ValueEnum};
use raywalk::scene::file::nff::Import;
use raywalk::study::textbook;

/// Show the numeric example of the source text.
#[derive(Args)]
pub struct Textbook {
    /// How to print it
    #[arg(long, value_enum, default_value = "text")]
    format: TableFormat,
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
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        let loaded = scene_argument::scene(&scene_argument::built_in("textbook")?, &Import::default(), colors)?;
        let scene = TracingOptions::default().apply(loaded)?;
        let table = textbook::table(&scene);
        let text = match self.format {
            TableFormat::Text => table.text(),
            TableFormat::Json => table.json(),
            TableFormat::Markdown => table.markdown(),
        };
        output::print(text.as_bytes())
    }
}
