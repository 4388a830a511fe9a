//! `raywalk walk`: the viewer; without a terminal the same walk as text.

use super::failure::Failure;
use super::options::{ColorChoice, TracingOptions};
use super::scene_argument::{self, Input};
use super::trace::Subject;
use super::{output, scene_argument as argument};
use clap::Args;
use raywalk::log::{Log, file as log_file};
use raywalk::report::{self, Style};
use std::path::{Path, PathBuf};

/// Walk through a pixel, a ray or a saved log in the terminal.
#[derive(Args, Default)]
pub struct Walk {
    /// A scene file, a saved log, `-` for standard input, or a built-in scene
    #[arg(default_value = "textbook")]
    subject_of: PathBuf,
    #[command(flatten)]
    subject: Subject,
    #[command(flatten)]
    tracing: TracingOptions,
}

impl Walk {
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        let named = if self.subject_of.as_os_str().is_empty() { Path::new("textbook") } else { &self.subject_of };
        let input = scene_argument::read(named, colors)?;
        let log = self.log(&input, colors)?;
        output::print(report::text::text(&log, Style::default()).as_bytes())
    }

    fn log(&self, input: &Input, colors: ColorChoice) -> Result<Log, Failure> {
        if is_log(&input.bytes) {
            let read = log_file::read(&input.bytes)
                .map_err(|error| Failure::caller(format!("{}:{error}", raywalk::scene::file::visible(&input.name))))?;
            if let Some(warning) = read.ending.warning() {
                eprintln!("warning: {}: {warning}", raywalk::scene::file::visible(&input.name));
            }
            return Ok(read.log);
        }
        let scene = self.tracing.apply(argument::scene(input, colors)?.scene)?;
        self.subject.log(&scene, &self.tracing)
    }
}

/// Whether the bytes are a log rather than a scene.
fn is_log(bytes: &[u8]) -> bool {
    let start = bytes.trim_ascii_start();
    start.starts_with(b"{\"log\"") || start.starts_with(b"{\"header\"")
}
