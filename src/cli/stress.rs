//! `raywalk stress`: cases with exact answers, and how far the program is from them.

use super::failure::{Failure, shown};
use super::inputs;
use super::options::ReportFormat;
use super::output;
use clap::Args;
use raywalk::files::{Wanted, escape_hidden, escape_hidden_json};
use raywalk::scene::file::MAX_BYTES;
use raywalk::study::stress::{self, Family, Way};
use serde_json::json;
use std::path::{Path, PathBuf};

/// Measure numerical stability on cases with exact answers
#[derive(Args)]
pub struct Stress {
    /// Files of cases, `-` for standard input; without any, a built-in sample
    #[arg(value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Print only the answers, as NDJSON, one line per case
    #[arg(long)]
    answers: bool,
    /// The decimals of the column of arithmetic by hand
    #[arg(long, value_name = "N", default_value_t = 6, conflicts_with = "answers", value_parser = clap::value_parser!(u32).range(0..=15))]
    decimals: u32,
    /// How to print the report
    #[arg(long, value_enum, default_value = "text", conflicts_with = "answers")]
    format: ReportFormat,
}

impl Stress {
    /// Runs the command; `false` where a requirement doesn't hold.
    pub fn run(self) -> Result<bool, Failure> {
        inputs::reads(&self.files);
        let families = self.families()?;
        if self.answers {
            let (text, unanswered) = answers(&families)?;
            output::print(text.as_bytes())?;
            return match unanswered {
                0 => Ok(true),
                count => Err(Failure::caller(format!("{count} cases can't be answered, see their lines"))),
            };
        }
        let table = stress::table(&families, &Way::others(self.decimals))
            .map_err(|error| Failure::caller(escape_hidden(&error).into_owned()))?;
        let text = match self.format {
            ReportFormat::Text => table.text(|name| escape_hidden(name).into_owned()),
            ReportFormat::Json => escape_hidden_json(&table.json()).into_owned(),
        };
        output::print(text.as_bytes())?;
        Ok(table.holds())
    }

    fn families(&self) -> Result<Vec<Family>, Failure> {
        if self.files.is_empty() {
            return stress::samples().map_err(Failure::caller);
        }
        self.files.iter().map(|path| read(path)).collect()
    }
}

/// A line a case, and how many of them say why there is no answer.
fn answers(families: &[Family]) -> Result<(String, usize), Failure> {
    let mut text = String::new();
    let mut unanswered = 0;
    for family in families {
        let answers = stress::answers(family)
            .map_err(|error| Failure::caller(escape_hidden(&format!("{}: {error}", family.family)).into_owned()))?;
        for (case, out) in family.cases.iter().zip(answers) {
            let line = match out {
                Ok(out) => json!({"id": case.id, "out": out}),
                Err(error) => json!({"id": case.id, "error": error}),
            };
            unanswered += usize::from(line.get("error").is_some());
            text.push_str(&escape_hidden_json(&line.to_string()));
            text.push('\n');
        }
    }
    Ok((text, unanswered))
}

fn read(path: &Path) -> Result<Family, Failure> {
    let text = Wanted { what: "a file of cases", max_bytes: MAX_BYTES }.read(path);
    let text = text.map_err(|error| Failure::scene(&error))?;
    stress::parse(&text).map_err(|error| Failure::caller(format!("{}: {}", shown(path), escape_hidden(&error))))
}
