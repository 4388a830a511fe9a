//! How far the work is, on standard error.

use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{IsTerminal, Write, stderr};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Whether and how progress is shown.
#[derive(Args, Debug, Clone)]
pub struct ProgressOptions {
    /// Show progress: `auto` on a terminal only, `json` as one object a line
    #[arg(long, value_enum, default_value = "auto")]
    progress: ProgressChoice,
    /// Say nothing but errors
    #[arg(long, short)]
    pub quiet: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum ProgressChoice {
    Auto,
    Always,
    Never,
    Json,
}

/// A running display of progress.
pub enum Progress {
    /// None.
    Hidden,
    /// A bar.
    Bar(ProgressBar),
    /// A line of JSON a second.
    Json(Mutex<JsonLines>),
}

/// Progress as lines of JSON.
pub struct JsonLines {
    done: u64,
    total: u64,
    started: Instant,
    last: Option<Instant>,
}

impl ProgressOptions {
    /// Starts to show progress toward `total` pixels.
    pub fn start(&self, total: u64) -> Progress {
        let shows_bar = match self.progress {
            _ if self.quiet => false,
            ProgressChoice::Auto => stderr().is_terminal(),
            ProgressChoice::Always => true,
            ProgressChoice::Never => false,
            ProgressChoice::Json => {
                let lines = JsonLines { done: 0, total, started: Instant::now(), last: None };
                return Progress::Json(Mutex::new(lines));
            }
        };
        if !shows_bar {
            return Progress::Hidden;
        }
        let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr());
        let template = "{bar:40} {percent:>3} %  {elapsed} gone, {eta} left";
        bar.set_style(ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()));
        Progress::Bar(bar)
    }
}

/// How much of a file has been read, on a terminal and if there is much of it; `size` is `None` where nobody knows.
pub fn of_reading(size: Option<u64>) -> ProgressBar {
    /// Less is read before anybody could see the bar.
    const MUCH: u64 = 8 << 20;
    let (bar, template) = match size {
        Some(size) if size < MUCH => return ProgressBar::hidden(),
        Some(size) => (ProgressBar::new(size), "reading {bar:40} {percent:>3} %  {eta} left"),
        None => (ProgressBar::new_spinner(), "reading {bytes}"),
    };
    bar.with_style(ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()))
}

impl Progress {
    /// Some more pixels are done.
    pub fn advance(&self, pixels: u64) {
        match self {
            Progress::Hidden => {}
            Progress::Bar(bar) => bar.inc(pixels),
            Progress::Json(lines) => {
                if let Ok(mut lines) = lines.lock() {
                    lines.advance(pixels);
                }
            }
        }
    }

    /// All is done, or nothing more will be.
    pub fn finish(&self) {
        if let Progress::Bar(bar) = self {
            bar.finish_and_clear();
        }
    }
}

impl JsonLines {
    fn advance(&mut self, pixels: u64) {
        self.done += pixels;
        let is_due = self.last.is_none_or(|last| last.elapsed() >= Duration::from_secs(1));
        if is_due || self.done == self.total {
            self.last = Some(Instant::now());
            let seconds = self.started.elapsed().as_secs_f64();
            // Nobody reads a closed standard error.
            let _ = writeln!(
                stderr(),
                "{{\"progress\":{{\"done\":{},\"total\":{},\"seconds\":{seconds:.3}}}}}",
                self.done,
                self.total
            );
        }
    }
}
