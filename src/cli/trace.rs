//! `raywalk trace`: the log of a pixel, a ray or a region, or a view of a saved one.

mod close_up;
mod of_log;
mod of_region;

use super::causes;
use super::failure::{Failure, shown};
use super::frames;
use super::options::{TracingOptions, numbers, pixel_in, warning_of_sampling};
use super::output::{self, Output, Sink};
use super::progress::ProgressOptions;
use super::region;
use super::scene_argument::{self, Input, Named};
use super::views::{Lang, TraceFormat, TreeOf, View};
use clap::Args;
use close_up::CloseUpOf;
use glam::DVec3;
use raywalk::files::escape_hidden;
use raywalk::log::header::MAX_NAMES;
use raywalk::log::{Log, Shard, file as log_file};
use raywalk::probe::CutOff;
use raywalk::record::{self, Arithmetic, Part};
use raywalk::report::Style;
use raywalk::scene::Scene;
use raywalk::scene::file::validate::limits::{MAX_COORDINATE, MIN_LENGTH};
use raywalk::study::rounding::Rounding;
use std::io;
use std::path::PathBuf;

/// Write the log of a pixel, a ray or a region, or a view of one.
#[derive(Args)]
pub struct Trace {
    /// A scene file (JSON or NFF, also compressed with gzip or zstd), a saved log, `-` for standard input, or a built-in scene
    #[arg(value_name = "SCENE or LOG")]
    scene: PathBuf,
    #[command(flatten)]
    subject: Subject,
    /// The pixels of a rectangle: its left, top, right and bottom side, the last two exclusive
    #[arg(long, value_name = "X0,Y0,X1,Y1", value_parser = numbers::<u32, 4>, group = "Subject", allow_hyphen_values = true)]
    region: Option<[u32; 4]>,
    /// What to write; without it ndjson, and text with --causes
    #[arg(long, value_enum, value_name = "FORMAT")]
    format: Option<TraceFormat>,
    /// The language of text views (text, markdown, latex, html, dot, svg, mermaid)
    #[arg(long, value_enum, value_name = "LANGUAGE", default_value = "en")]
    lang: Lang,
    /// Instead of the log, show which roundings of decimal:N or f32 caused the error of the result: the result with only
    /// one quantity rounded, and with all but it, for every quantity (as text or json)
    #[arg(long)]
    causes: bool,
    /// What dot, svg and mermaid draw: rays with all that they hit, or the calls of the algorithm (figure 9)
    #[arg(long, value_enum, value_name = "OF", default_value = "rays")]
    tree: TreeOf,
    /// Draw a close-up of one hit instead, as svg, latex or text: its vectors in their planes, the zones of a blurred bounce, or the points
    /// of an area light with the weights of their shadow rays
    #[arg(long, value_enum, value_name = "VIEW")]
    view: Option<CloseUpOf>,
    /// Whose hit --view shows, such as `C R`; without it the first ray that has what it shows. With `--view light`, `C R S2` is light 2 at
    /// that hit
    #[arg(long, value_name = "RAY", requires = "view")]
    path: Option<String>,
    /// Decimals in text views
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(0..=15))]
    digits: u32,
    /// Which frame of an animation, from 1; without it the first
    #[arg(long, value_name = "K", value_parser = frames::number)]
    frames: Option<u32>,
    /// Of a region, write only the I-th of N shards, which `raywalk merge` joins; one that exists already and is complete isn't
    /// written again
    #[arg(long, value_name = "I/N")]
    shard: Option<Shard>,
    /// Where to write; standard output without it. What is named `.gz` or `.zst` is compressed
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    tracing: TracingOptions,
    #[command(flatten)]
    progress: ProgressOptions,
}

/// What to trace.
#[derive(Args, Default, Clone, Debug, PartialEq)]
#[group(multiple = false)]
pub struct Subject {
    /// A pixel: column and row from the top left
    #[arg(long, value_name = "X,Y", value_parser = numbers::<u32, 2>, allow_hyphen_values = true)]
    pub pixel: Option<[u32; 2]>,
    /// A ray: its origin and its direction
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ", value_parser = finite_ray, allow_hyphen_values = true)]
    pub ray: Option<[f64; 6]>,
}

impl Trace {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        self.tracing.use_threads();
        match scene_argument::open(&self.scene)? {
            Named::Scene(input) => self.of_scene(&input)?,
            Named::Log(opened) => self.of_log(opened)?,
        }
        if let (None, false, Some(path)) = (self.format, self.causes || self.view.is_some(), &self.output)
            && let Some(format) = TraceFormat::of_view(path)
        {
            let word = format.word();
            output::tell(&format!(
                "note: {} is a log in ndjson; --format {word} writes what its name says",
                shown(path)
            ));
        }
        Ok(())
    }

    /// The log of what is traced now.
    fn of_scene(&self, input: &Input) -> Result<(), Failure> {
        if self.subject.pixel.is_none() && self.subject.ray.is_none() && self.region.is_none() {
            let expected = "--pixel X,Y, --ray OX,OY,OZ,DX,DY,DZ or --region X0,Y0,X1,Y1";
            return Err(Failure::caller(format!("trace: expected {expected}")));
        }
        let rounding = self.rounding()?;
        self.check_format(self.region.is_some())?;
        let loaded = scene_argument::scene(input, &self.tracing.import())?;
        let inputs = loaded.inputs.clone();
        let scene = self.tracing.apply(frames::at_one(loaded, self.frames)?)?;
        let names = scene.objects.len() + scene.lights.len();
        if names > MAX_NAMES && matches!(self.format, None | Some(TraceFormat::Ndjson | TraceFormat::Json)) {
            output::tell(&format!(
                "warning: {}: the log names {names} objects and lights; raywalk reads logs with at most {MAX_NAMES}",
                escape_hidden(&self.scene.to_string_lossy())
            ));
        }
        if let Some(region) = self.region {
            return self.of_region(&scene, region, &inputs);
        }
        let part = self.subject.part(&scene, self.tracing.arithmetic())?;
        if let (Part::Pixel(_), false, Some(warning)) = (part, self.progress.quiet, warning_of_sampling(&scene)) {
            output::tell(&format!("warning: {}: {warning}", escape_hidden(&self.scene.to_string_lossy())));
        }
        let arithmetic = self.tracing.arithmetic();
        if let Some(of) = self.view {
            let bytes = self.close_up(of, &short_log(&scene, part, arithmetic)?)?;
            return Output::create(self.output.as_deref(), &inputs)?.commit(&bytes);
        }
        let output = Output::create(self.output.as_deref(), &inputs)?;
        let bytes = match (rounding, self.format) {
            (Some(rounding), format) => {
                let study = causes::study_of(&scene, part, rounding)?;
                let is_json = format == Some(TraceFormat::Json);
                if is_json { study.json() } else { study.text(self.lang.into(), Style::default().with(self.digits)) }
                    .into_bytes()
            }
            (None, None | Some(TraceFormat::Ndjson)) => match arithmetic {
                // Its runs are compared before there are digits to write.
                Arithmetic::Perturbed(_) => {
                    self.view(Some(&scene), &short_log(&scene, part, arithmetic)?, TraceFormat::Ndjson)?
                }
                _ => return output.stream(|out| write_as_it_grows(&scene, part, arithmetic, out)),
            },
            (None, Some(format)) => self.view(Some(&scene), &short_log(&scene, part, arithmetic)?, format)?,
        };
        output.commit(&bytes)
    }

    /// A log that is in memory, in this format.
    fn view(&self, scene: Option<&Scene>, log: &Log, format: TraceFormat) -> Result<Vec<u8>, Failure> {
        let style = Style::of(&log.header, self.digits);
        let view = View { format, tree: self.tree, language: self.lang.into(), style };
        view.bytes(scene, log).map_err(|error| Failure::machine(format!("cannot write the log: {error}")))
    }
}

impl Trace {
    /// The rounding whose effects are to be studied, if any is.
    fn rounding(&self) -> Result<Option<Rounding>, Failure> {
        match self.format {
            _ if !self.causes => Ok(None),
            None | Some(TraceFormat::Text | TraceFormat::Json) => causes::rounding(self.tracing.arithmetic()).map(Some),
            Some(format) => {
                let found = format.word();
                Err(Failure::caller(format!("--causes: expected --format text or json, found {found}")))
            }
        }
    }

    /// A page or a figure is of one pixel or ray.
    fn check_format(&self, is_region: bool) -> Result<(), Failure> {
        if self.view.is_some() {
            return self.check_close_up(is_region);
        }
        if self.shard.is_some() && !(is_region && matches!(self.format, None | Some(TraceFormat::Ndjson))) {
            return Err(Failure::caller("--shard: expected --region and the format ndjson, which can be joined"));
        }
        match self.format {
            Some(format) if is_region && !format.is_of_regions() => Err(Failure::caller(format!(
                "--format {}: expected a pixel or a ray, found a region, which is written as ndjson, json, text, obj or ply",
                format.word()
            ))),
            _ => Ok(()),
        }
    }
}

impl Subject {
    /// The pixel or ray; the middle pixel if neither is named.
    pub fn part(&self, scene: &Scene, arithmetic: Arithmetic) -> Result<Part, Failure> {
        let is_printed = arithmetic == Arithmetic::Printed;
        match (self.pixel, self.ray) {
            (_, Some(_)) if is_printed => Err(not_printed()),
            (_, Some([ox, oy, oz, dx, dy, dz])) => {
                Ok(Part::Ray { origin: DVec3::new(ox, oy, oz), direction: DVec3::new(dx, dy, dz) })
            }
            (pixel, None) => {
                let middle = scene.camera.resolution.map(|side| side / 2);
                let pixel = pixel_in(scene, pixel.unwrap_or(middle))?;
                if pixel != middle && is_printed { Err(not_printed()) } else { Ok(Part::Pixel(pixel)) }
            }
        }
    }
}

/// The log of a pixel or ray for views that need the whole of it.
pub fn short_log(scene: &Scene, part: Part, arithmetic: Arithmetic) -> Result<Log, Failure> {
    record::bounded(scene, part, arithmetic).map_err(|cut_off| too_long(cut_off, arithmetic))
}

/// Why a log doesn't fit into memory, and what helps.
fn too_long(cut_off: CutOff, arithmetic: Arithmetic) -> Failure {
    let message = match arithmetic {
        Arithmetic::Perturbed(_) => {
            format!("{cut_off}, expected fewer samples or a smaller --max-depth: runs are compared in memory")
        }
        _ => {
            let smaller =
                "expected fewer samples, a smaller --max-depth, or `trace` in ndjson, which is written as it grows";
            format!("{cut_off}, {smaller}")
        }
    };
    match cut_off {
        CutOff::TooLong { .. } => Failure::caller(message),
        CutOff::Memory | CutOff::Io(_) => Failure::machine(message),
    }
}

/// Writes the log of a pixel or ray line by line, so that it may be longer than the memory.
fn write_as_it_grows(scene: &Scene, part: Part, arithmetic: Arithmetic, out: &mut Sink) -> io::Result<()> {
    let header = record::header(scene, part.subject(), arithmetic);
    let mut writer = log_file::Writer::new(out, &header)?;
    record::stream(scene, part, arithmetic, &mut |events| writer.write(events)).map_err(region::plain)?;
    writer.finish().map(|_| ())
}

fn not_printed() -> Failure {
    Failure::caller("--arithmetic printed: the book prints numbers for the middle pixel only")
}

fn finite_ray(text: &str) -> Result<[f64; 6], String> {
    let ray = numbers::<f64, 6>(text)?;
    if let Some(found) = ray.iter().find(|x| !x.is_finite()) {
        return Err(format!("expected finite numbers, found `{found}`"));
    }
    if let Some(found) = ray.iter().find(|x| x.abs() > MAX_COORDINATE) {
        return Err(format!("expected coordinates up to {MAX_COORDINATE:e}, found `{found:e}`"));
    }
    if DVec3::new(ray[3], ray[4], ray[5]).length() < MIN_LENGTH {
        return Err("expected a direction that is not zero".to_owned());
    }
    Ok(ray)
}
