//! `raywalk walk`: the viewer; without a terminal the same walk as text.

use super::failure::{Failure, INTERRUPTED, TERMINATED};
use super::options::{ColorChoice, TracingOptions, numbers};
use super::output::{self, Output};
use super::scene_argument::{self, Input};
use super::trace::Subject;
use clap::Args;
use raywalk::log::{Log, file as log_file};
use raywalk::report::{self, Style};
use raywalk::scene::file::visible;
use raywalk::tui::{self, Exit, Outcome, Palette, Theme};
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};

/// Walk through a pixel, a ray or a saved log in the terminal.
#[derive(Args, Default)]
pub struct Walk {
    /// A scene file (JSON or NFF), a saved log, `-` for standard input, or a built-in scene
    #[arg(value_name = "SCENE or LOG", default_value = "textbook")]
    walked: PathBuf,
    #[command(flatten)]
    subject: Subject,
    /// The step to begin at
    #[arg(long, value_name = "STEP")]
    at: Option<usize>,
    /// Print the walk as text instead of opening the viewer
    #[arg(long)]
    plain: bool,
    /// Draw the viewer with ASCII characters only
    #[arg(long)]
    ascii: bool,
    /// Write a picture of the viewer instead of opening it
    #[arg(long, value_name = "FILE.svg")]
    screenshot: Option<PathBuf>,
    /// The keys to press before the screenshot, such as `nnn` or `l<Down><Space>`
    #[arg(long, value_name = "KEYS", requires = "screenshot", default_value = "", hide_default_value = true)]
    keys: String,
    /// The size of the screenshot in characters
    #[arg(long, value_name = "COLUMNS,ROWS", requires = "screenshot", value_parser = numbers::<u16, 2>)]
    screen: Option<[u16; 2]>,
    #[command(flatten)]
    tracing: TracingOptions,
}

/// The screenshot's size unless it is asked for.
const SCREEN: [u16; 2] = [110, 30];

impl Walk {
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        // `raywalk` alone has no arguments to take a default from.
        let walked = if self.walked.as_os_str().is_empty() { Path::new("textbook") } else { &self.walked };
        let input = scene_argument::read(walked, colors)?;
        let (log, warning) = self.log(&input, colors)?;
        if let Some(path) = &self.screenshot {
            let [width, height] = self.screen.unwrap_or(SCREEN);
            let options = self.options(Palette::True, warning);
            let picture = tui::picture(log, &options, &self.keys, width, height);
            return Output::create(Some(path), walked)?.commit(picture.as_bytes());
        }
        if self.plain || !has_terminal() {
            if let Some(warning) = warning {
                eprintln!("warning: {}: {warning}", visible(&input.name));
            }
            return output::print(report::text::text(&log, Style::default()).as_bytes());
        }
        let outcome = tui::run(log, self.options(palette(colors), warning))
            .map_err(|error| Failure::machine(format!("the terminal can't be used: {error}")))?;
        self.leave(walked, &outcome)
    }

    /// The log to walk through, and what to warn of.
    fn log(&self, input: &Input, colors: ColorChoice) -> Result<(Log, Option<String>), Failure> {
        if is_log(&input.bytes) {
            let read = log_file::read(&input.bytes)
                .map_err(|error| Failure::caller(format!("{}:{error}", visible(&input.name))))?;
            return Ok((read.log, read.ending.warning()));
        }
        let scene = self.tracing.apply(scene_argument::scene(input, &self.tracing.import(), colors)?.scene)?;
        Ok((self.subject.log(&scene, &self.tracing)?, None))
    }

    fn options(&self, palette: Palette, warning: Option<String>) -> tui::Options {
        tui::Options { theme: Theme::new(palette, self.ascii), start: self.at, warning, note: None }
    }

    /// Ends as the viewer was left; prints the way back to the place.
    fn leave(&self, walked: &Path, outcome: &Outcome) -> Result<(), Failure> {
        match outcome.exit {
            Exit::Interrupted => return Err(Failure::silent(INTERRUPTED)),
            Exit::Terminated => return Err(Failure::silent(TERMINATED)),
            Exit::Quit => {}
        }
        if walked != Path::new("-") {
            let pixel = outcome.position.pixel.map_or(String::new(), |[x, y]| format!(" --pixel {x},{y}"));
            let walked = walked.to_string_lossy();
            let back = format!("back here: raywalk walk {}{pixel} --at {}\n", visible(&walked), outcome.position.at);
            return output::print(back.as_bytes());
        }
        Ok(())
    }
}

/// The colours that the terminal is asked for.
fn palette(colors: ColorChoice) -> Palette {
    let has_true_color = std::env::var("COLORTERM").is_ok_and(|said| said == "truecolor" || said == "24bit");
    match (colors.applies_to(&io::stdout()), has_true_color) {
        (false, _) => Palette::None,
        (true, false) => Palette::Indexed,
        (true, true) => Palette::True,
    }
}

/// Whether there is a terminal that can show the viewer.
fn has_terminal() -> bool {
    let is_dumb = std::env::var_os("TERM").is_none_or(|term| term.is_empty() || term == "dumb");
    io::stdout().is_terminal() && !is_dumb
}

/// Whether the bytes are a log rather than a scene.
fn is_log(bytes: &[u8]) -> bool {
    let start = bytes.trim_ascii_start();
    start.starts_with(b"{\"log\"") || start.starts_with(b"{\"header\"")
}
