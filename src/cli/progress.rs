//! How far the work is, on standard error.

use super::output::tell_for_now;
use clap::{Args, ValueEnum};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt;
use std::io::{self, IsTerminal, Read, Write, stderr};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Whether and how progress is shown.
#[derive(Args, Debug, Clone, Default)]
pub struct ProgressOptions {
    /// Show progress: `auto` on a terminal only, `json` as one object a line
    #[arg(long, value_enum, default_value = "auto")]
    progress: ProgressChoice,
    /// Print errors only
    #[arg(long, short)]
    pub quiet: bool,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum ProgressChoice {
    #[default]
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
    /// `None` if unknown.
    total: Option<u64>,
    started: Instant,
    last: Option<Instant>,
}

/// Input that shows how much of it was read.
pub struct Reading<R> {
    input: R,
    progress: Progress,
}

impl ProgressOptions {
    /// Starts to show progress toward `total` pixels.
    pub fn start(&self, total: u64) -> Progress {
        self.of(Some(total), true, "{bar:40} {percent:>3} %  {spent} elapsed, {rest} left")
    }

    /// Says what is being done before there is anything else to see, on a line that goes when it is done.
    pub fn doing(&self, what: &str) -> Doing {
        let is_shown = !self.quiet
            && match self.progress {
                ProgressChoice::Auto => stderr().is_terminal(),
                ProgressChoice::Always => true,
                ProgressChoice::Never | ProgressChoice::Json => false,
            };
        let doing = Doing { is_shown };
        doing.now(what);
        doing
    }

    /// Shows how much of a file has been read; `size` is `None` if unknown.
    pub fn reading<R: Read>(&self, input: R, size: Option<u64>) -> Reading<R> {
        /// Less is read too fast for a bar.
        const MUCH: u64 = 8 << 20;
        let template = match size {
            Some(_) => "reading {bar:40} {percent:>3} %  {rest} left",
            None => "reading {bytes}",
        };
        Reading { input, progress: self.of(size, size.is_none_or(|size| size >= MUCH), template) }
    }

    /// Progress toward `total`; work that takes `long` is shown unless the options say otherwise.
    fn of(&self, total: Option<u64>, is_long: bool, template: &str) -> Progress {
        let shows_bar = match self.progress {
            _ if self.quiet => false,
            ProgressChoice::Auto => is_long && stderr().is_terminal(),
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
        let bar = ProgressBar::with_draw_target(total, ProgressDrawTarget::stderr());
        let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
        let style = style.with_key("spent", |state: &ProgressState, text: &mut dyn fmt::Write| {
            let _ = text.write_str(&duration(state.elapsed()));
        });
        bar.set_style(style.with_key("rest", |state: &ProgressState, text: &mut dyn fmt::Write| {
            let _ = text.write_str(&duration(state.eta()));
        }));
        Progress::Bar(bar)
    }
}

/// A duration in whole seconds, or from two minutes on in minutes, from two hours on in hours.
fn duration(time: Duration) -> String {
    match time.as_secs() {
        seconds @ ..120 => format!("{seconds} s"),
        seconds @ 120..7200 => format!("{} min", seconds / 60),
        seconds => format!("{} h", seconds / 3600),
    }
}

impl<R: Read> Read for Reading<R> {
    fn read(&mut self, place: &mut [u8]) -> io::Result<usize> {
        let count = self.input.read(place)?;
        self.progress.advance(count as u64);
        Ok(count)
    }
}

impl<R> Drop for Reading<R> {
    fn drop(&mut self) {
        self.progress.finish();
    }
}

/// Says what is being done until it is dropped.
pub struct Doing {
    is_shown: bool,
}

impl Doing {
    /// What is being done now.
    pub fn now(&self, what: &str) {
        if self.is_shown {
            tell_for_now(&format!("{what} ..."));
        }
    }
}

impl Drop for Doing {
    fn drop(&mut self) {
        if self.is_shown {
            tell_for_now("");
        }
    }
}

impl Progress {
    /// Some more pixels (or bytes) are done.
    pub fn advance(&self, more: u64) {
        match self {
            Progress::Hidden => {}
            Progress::Bar(bar) => bar.inc(more),
            Progress::Json(lines) => {
                if let Ok(mut lines) = lines.lock() {
                    lines.advance(more);
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
    fn advance(&mut self, more: u64) {
        if more == 0 {
            return;
        }
        self.done += more;
        let is_due = self.last.is_none_or(|last| last.elapsed() >= Duration::from_secs(1));
        if is_due || Some(self.done) == self.total {
            self.last = Some(Instant::now());
            let seconds = self.started.elapsed().as_secs_f64();
            let total = self.total.map_or("null".to_owned(), |total| total.to_string());
            // A closed standard error is no failure.
            let _ = writeln!(
                stderr(),
                "{{\"progress\":{{\"done\":{},\"total\":{total},\"seconds\":{seconds:.3}}}}}",
                self.done
            );
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn durations_have_a_unit_of_their_size() {
        let seconds = |count| duration(Duration::from_secs(count));
        assert_eq!([0, 86, 119].map(seconds), ["0 s", "86 s", "119 s"]);
        assert_eq!([120, 7199, 7200].map(seconds), ["2 min", "119 min", "2 h"]);
    }
}
