//! `raywalk bench`: what the program measures about itself.

use super::failure::Failure;
use super::options::{ColorChoice, TracingOptions};
use super::{output, scene_argument};
use clap::{Args, Subcommand, ValueEnum};
use raywalk::render::ask_for_memory;
use raywalk::study::ladder::{Rung, ladder};
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;

/// Measure error and time.
#[derive(Subcommand)]
pub enum Bench {
    /// How far pictures are off, and how long they take
    Error(ErrorBench),
}

/// How far pictures are off, and how long they take
#[derive(Args)]
pub struct ErrorBench {
    /// Scenes: files or built-in names; some of the built-in ones where none is named
    #[arg(value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// In every arithmetic: by hand with 2 to 15 decimals, f32, f64
    #[arg(long, required = true)]
    arithmetic: bool,
    /// Pixels across and down
    #[arg(long, value_name = "WxH", value_parser = super::options::size, default_value = "160x120")]
    size: [u32; 2],
    /// On how many threads; 0 is one a core
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=super::options::MAX_THREADS))]
    threads: u16,
    /// How to print the table
    #[arg(long, value_enum, default_value = "text")]
    format: TableFormat,
}

#[derive(Clone, Copy, ValueEnum)]
enum TableFormat {
    /// For people.
    Text,
    /// For programs.
    Json,
    /// For spreadsheets.
    Csv,
}

/// The scenes that are measured where none is named.
const SCENES: [&str; 4] = ["textbook", "figure-6", "table-top", "glass-and-mirror"];

#[derive(Serialize)]
struct Measured {
    scene: String,
    rungs: Vec<Rung>,
}

impl Bench {
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        let Bench::Error(bench) = self;
        bench.run(colors)
    }
}

impl ErrorBench {
    fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        let scenes = match self.scenes.is_empty() {
            true => SCENES.iter().map(PathBuf::from).collect(),
            false => self.scenes.clone(),
        };
        let measured = scenes.iter().map(|scene| self.measure(scene, colors)).collect::<Result<Vec<_>, _>>()?;
        let text = match self.format {
            TableFormat::Text => text(&measured),
            TableFormat::Csv => csv(&measured),
            TableFormat::Json => format!("{:#}\n", serde_json::json!({ "scenes": measured })),
        };
        output::print(text.as_bytes())
    }

    fn measure(&self, scene: &std::path::Path, colors: ColorChoice) -> Result<Measured, Failure> {
        let options = TracingOptions { size: Some(self.size), ..TracingOptions::default() };
        let scene = options.apply(scene_argument::load(scene, &options.import(), colors)?)?;
        let [width, height] = self.size;
        ask_for_memory([0, 0, width, height]).map_err(|error| Failure::machine(error.to_string()))?;
        let rungs = ladder(&scene, usize::from(self.threads)).map_err(|error| Failure::machine(error.to_string()))?;
        Ok(Measured { scene: scene.name.clone(), rungs })
    }
}

/// A table a scene.
fn text(measured: &[Measured]) -> String {
    let mut text = String::new();
    for Measured { scene, rungs } in measured {
        let _ = writeln!(text, "{}", raywalk::scene::file::visible(scene));
        let _ =
            writeln!(text, "  {:<10} {:>10} {:>10} {:>10} {:>9}", "arithmetic", "rmse", "worst", "visible", "seconds");
        for Rung { arithmetic, seconds, rmse, worst, visible } in rungs {
            let visible = visible * 100.0;
            let _ = writeln!(text, "  {arithmetic:<10} {rmse:>10.1e} {worst:>10.1e} {visible:>9.2}% {seconds:>9.4}");
        }
    }
    text.push_str(
        "errors in units of the scene's white, against f64; that of f64 against the same moved by rounding errors\n",
    );
    text
}

fn csv(measured: &[Measured]) -> String {
    let mut text = "scene,arithmetic,rmse,worst,visible,seconds\n".to_owned();
    for Measured { scene, rungs } in measured {
        let scene = format!("\"{}\"", scene.replace('"', "\"\""));
        for Rung { arithmetic, seconds, rmse, worst, visible } in rungs {
            let _ = writeln!(text, "{scene},{arithmetic},{rmse},{worst},{visible},{seconds}");
        }
    }
    text
}
