//! `raywalk trace`: the log of a pixel or a ray.

use super::failure::Failure;
use super::options::{ColorChoice, TracingOptions, numbers, pixel_in};
use super::output::Output;
use super::scene_argument;
use clap::{Args, ValueEnum};
use glam::DVec3;
use raywalk::log::{Log, file as log_file};
use raywalk::record::{self, Arithmetic};
use raywalk::report::{self, Style};
use raywalk::scene::Scene;
use raywalk::scene::file::validate::limits::{MAX_COORDINATE, MIN_LENGTH};
use std::path::PathBuf;

/// Write the log of a pixel or a ray.
#[derive(Args)]
pub struct Trace {
    /// A scene file (JSON or NFF, also packed by gzip), `-` for standard input, or a built-in scene
    scene: PathBuf,
    #[command(flatten)]
    subject: Subject,
    /// What to write
    #[arg(long, value_enum, default_value = "ndjson")]
    format: TraceFormat,
    /// Decimals in the text
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(0..=15))]
    digits: u32,
    /// Say nothing but errors
    #[arg(long, short)]
    quiet: bool,
    /// Where to write; standard output without it
    #[arg(long, short, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    tracing: TracingOptions,
}

/// What to trace.
#[derive(Args, Default, Clone, Debug, PartialEq)]
#[group(multiple = false)]
pub struct Subject {
    /// A pixel: column and row from the top left
    #[arg(long, value_name = "X,Y", value_parser = numbers::<u32, 2>)]
    pub pixel: Option<[u32; 2]>,
    /// A ray: its origin and its direction
    #[arg(long, value_name = "OX,OY,OZ,DX,DY,DZ", value_parser = finite_ray, allow_hyphen_values = true)]
    pub ray: Option<[f64; 6]>,
}

#[derive(Clone, Copy, ValueEnum)]
enum TraceFormat {
    /// One event a line.
    Ndjson,
    /// One document.
    Json,
    /// The walk as text.
    Text,
}

impl Trace {
    /// Runs the command.
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        if self.subject.pixel.is_none() && self.subject.ray.is_none() {
            return Err(Failure::caller("trace: expected --pixel X,Y or --ray OX,OY,OZ,DX,DY,DZ"));
        }
        let loaded = scene_argument::load(&self.scene, &self.tracing.import(), colors)?;
        let scene = self.tracing.apply(loaded)?;
        let output = Output::create(self.output.as_deref(), &self.scene)?;
        let log = self.subject.log(&scene, &self.tracing)?;
        let in_memory = |error: std::io::Error| Failure::machine(format!("cannot write the log: {error}"));
        let bytes = match self.format {
            TraceFormat::Ndjson => log_file::to_ndjson(&log).map_err(in_memory)?,
            TraceFormat::Json => log_file::to_json(&log).map_err(in_memory)?,
            TraceFormat::Text => report::text::text(&log, Style { digits: self.digits }).into_bytes(),
        };
        output.commit(&bytes)
    }
}

impl Subject {
    /// The log of the pixel or ray; of the middle pixel if neither is named.
    pub fn log(&self, scene: &Scene, tracing: &TracingOptions) -> Result<Log, Failure> {
        match (self.pixel, self.ray) {
            (_, Some(_)) if tracing.arithmetic == Arithmetic::Printed => Err(not_printed()),
            (_, Some([ox, oy, oz, dx, dy, dz])) => {
                Ok(record::ray(scene, DVec3::new(ox, oy, oz), DVec3::new(dx, dy, dz), tracing.arithmetic))
            }
            (pixel, None) => {
                let middle = scene.camera.resolution.map(|side| side / 2);
                let pixel = pixel_in(scene, pixel.unwrap_or(middle))?;
                if pixel != middle && tracing.arithmetic == Arithmetic::Printed {
                    return Err(not_printed());
                }
                Ok(record::pixel(scene, pixel, tracing.arithmetic))
            }
        }
    }
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
