//! `raywalk diff`: two logs or two pictures compared.

mod logs;
mod pictures;

use super::config::ConfigChoice;
use super::failure::Failure;
use super::inputs;
use super::look::Look;
use super::options::{ColorChoice, ReportFormat};
use super::walk::has_terminal;
use clap::Args;
use raywalk::files::{KeyPath, Kind, Opened, Source, Wanted, escape_hidden};
use raywalk::render::export::{self, Beside, MAX_PICTURE_BYTES, PictureError, READABLE};
use raywalk::report::diff::Tolerance;
use raywalk::scene::file::{self};
use raywalk_guard::Endings;
use std::path::{Path, PathBuf};

/// What `--help` says behind the options.
fn more() -> String {
    LOGS.to_owned() + " Pictures are " + READABLE + MORE
}

const LOGS: &str = "\
Logs are aligned by the paths of their rays. The first divergence is reported with its cause, then every value, decision and step that \
differs with the operands that it comes from, and how the difference grows on its way to the colour.";

const MORE: &str = ". The layers that an OpenEXR (.exr) has beside its colours are compared, too.

A component of a value differs when it exceeds each tolerance that is given: |A - B| > E with --abs, |A - B| > E*s with --rel, s \
being the largest component of both values. Without any, every difference counts.

Exit code 0: nothing differs; 1: something does; 2: the two can't be compared, or a log is damaged (a line can't be read, the end \
line is missing or doesn't fit) or has quantities that raywalk doesn't know. What differs up to there is printed all the same; with \
--allow-damaged the exit code is 0 or 1 as the differences say.

Examples:
  raywalk diff hand.ndjson f64.ndjson --digits 3
  raywalk diff a.ndjson.gz b.json --rel 1e-9 --brief
  raywalk diff a.ndjson b.ndjson --walk
  raywalk diff pinned.ndjson all.ndjson --common
  raywalk diff a.png b.png --abs 0.01 -o heat.png";

/// Compare two logs or two pictures.
#[derive(Args)]
#[command(after_long_help = more())]
pub struct Diff {
    /// A log, or a picture such as .png or .exr, also compressed with gzip or zstd; `-` for standard input
    a: PathBuf,
    /// The log or picture to compare it with
    b: PathBuf,
    /// Round the values of logs to N decimals, half away from zero, to compare and show them
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(0..=15))]
    digits: Option<u32>,
    /// The tolerated absolute difference; in integer pictures white is 1
    #[arg(long, value_name = "E", value_parser = tolerance)]
    abs: Option<f64>,
    /// The tolerated difference in proportion to the largest component of both values
    #[arg(long, value_name = "E", value_parser = tolerance)]
    rel: Option<f64>,
    /// Compare only what both logs have: one of them may lack pixels, steps or quantities
    #[arg(long)]
    common: bool,
    /// Compare damaged or truncated logs, and logs with unknown quantities, as far as they can be read
    #[arg(long)]
    allow_damaged: bool,
    /// How to print the differences
    #[arg(long, value_enum, default_value = "text")]
    format: ReportFormat,
    /// Show only the first divergence of two logs and the counts
    #[arg(long)]
    brief: bool,
    /// Walk through both logs in the terminal, side by side; for regions, through the first pixel that differs
    #[arg(long, conflicts_with_all = ["format", "brief"])]
    walk: bool,
    #[command(flatten)]
    look: Look,
    #[command(flatten)]
    config: ConfigChoice,
    /// Write the differences of two pictures as a picture: black where they are equal, white where they differ most
    #[arg(long, short, value_name = "HEAT.png")]
    output: Option<PathBuf>,
}

/// What can be compared.
enum Compared {
    Log(Opened),
    /// With what its file has beside the colours.
    Picture(String, export::Picture, Option<Vec<Beside>>),
}

impl Diff {
    /// Runs the command; `false` where something differs.
    pub fn run(self, colors: ColorChoice, signals: Option<Endings>) -> Result<bool, Failure> {
        if [&self.a, &self.b].iter().all(|path| **path == Path::new("-")) {
            return Err(Failure::caller("diff - -: only one of the two can come from standard input"));
        }
        if self.look != Look::default() && !self.walk {
            return Err(Failure::caller("--ascii and --theme: only with --walk"));
        }
        if self.config.is_named() && !self.walk {
            return Err(Failure::caller("--config: only with --walk"));
        }
        inputs::reads([&self.a, &self.b]);
        let [a, b] = [open(&self.a)?, open(&self.b)?];
        match (a, b) {
            (Compared::Log(a), Compared::Log(b)) => {
                if self.output.is_some() {
                    return Err(Failure::caller("--output: a heat map is made of two pictures, found two logs"));
                }
                // As `walk` does, it is printed as text where there is no terminal.
                if self.walk && has_terminal() { self.walk(a, b, colors, signals) } else { self.logs(a, b) }
            }
            (Compared::Picture(a_name, a, a_layers), Compared::Picture(b_name, b, b_layers)) => {
                let options = [
                    ("--digits", self.digits.is_some()),
                    ("--brief", self.brief),
                    ("--walk", self.walk),
                    ("--common", self.common),
                    ("--allow-damaged", self.allow_damaged),
                ];
                if let Some((option, _)) = options.iter().find(|(_, is_given)| *is_given) {
                    return Err(Failure::caller(format!("{option}: is for logs, found two pictures")));
                }
                // Only an OpenEXR can have layers: another picture doesn't lack them.
                let layers = a_layers.zip(b_layers).unwrap_or_default();
                self.pictures((&a_name, &a, &layers.0), (&b_name, &b, &layers.1))
            }
            (Compared::Log(log), Compared::Picture(picture, ..))
            | (Compared::Picture(picture, ..), Compared::Log(log)) => {
                let log = escape_hidden(log.name());
                Err(Failure::caller(format!("{log} is a log and {picture} a picture; expected two of a kind")))
            }
        }
    }

    fn tolerance(&self) -> Tolerance {
        Tolerance { digits: self.digits, absolute: self.abs, relative: self.rel, is_of_common: self.common }
    }
}

/// Opens what is compared: a log is read by the way, a picture at once.
fn open(path: &Path) -> Result<Compared, Failure> {
    let refused = |error| Failure::scene(&error);
    let wanted = Wanted { what: "a log or a picture", max_bytes: MAX_PICTURE_BYTES };
    let opened = wanted.open(path).map_err(refused)?;
    let name = escape_hidden(opened.name()).into_owned();
    match Kind::of(opened.beginning()) {
        Kind::Log(_) => return Ok(Compared::Log(opened)),
        Kind::Picture(_) => {}
        kind => {
            if kind == Kind::Utf16
                && let Err(error) = file::check(opened.beginning(), opened.name())
            {
                return Err(refused(error));
            }
            let found = found(kind, opened.beginning());
            return Err(Failure::caller(format!("{name}: expected a log or a picture, {found}")));
        }
    }
    let bytes = opened.bytes().map_err(refused)?;
    let read = export::read(&bytes).and_then(|picture| Ok((picture, export::beside(&bytes)?)));
    let (picture, layers) = read.map_err(|error| match error {
        PictureError::Memory => Failure::machine(format!("{name}: {error}")),
        PictureError::Word { ref place, .. } => {
            let source = Source { name: &name, text: &bytes };
            refused(source.problem(place.clone(), KeyPath::default(), error.to_string()).into())
        }
        _ => Failure::caller(format!("{name}: {error}")),
    })?;
    Ok(Compared::Picture(name, picture, layers))
}

/// What begins like this, and what would help.
fn found(kind: Kind, beginning: &[u8]) -> String {
    let is_scene = String::from_utf8_lossy(beginning).contains("\"raywalk-scene/");
    match beginning.trim_ascii().is_empty() {
        true => "found an empty file".to_owned(),
        false if kind == Kind::Part => "found a part of a picture; `raywalk merge` joins parts".to_owned(),
        false if is_scene => "found a scene; `raywalk trace` writes the log of one of its pixels".to_owned(),
        false => {
            let start: String =
                String::from_utf8_lossy(beginning).chars().take(20).flat_map(char::escape_default).collect();
            format!("found `{start}`")
        }
    }
}

fn tolerance(text: &str) -> Result<f64, String> {
    let expected = || format!("expected a number from 0 on, found `{text}`");
    text.parse().ok().filter(|x: &f64| x.is_finite() && *x >= 0.0).ok_or_else(expected)
}
