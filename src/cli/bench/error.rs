//! `raywalk bench error`: how far pictures are off, and how long they take.

use super::scenes::{self, SceneOptions};
use super::{TableFormat, arithmetic, limits, samplers};
use crate::cli::failure::Failure;
use crate::cli::inputs::Inputs;
use crate::cli::options::MAX_THREADS;
use crate::cli::progress::ProgressOptions;
use crate::cli::sampling_spec::{sampling, sampling_or};
use clap::Args;
use raywalk::scene::Sampling;
use raywalk::study::bench::limits as measured;
use raywalk::study::bench::samplers::Reference;
use std::path::PathBuf;

/// Measure the error and the time of pictures
///
/// Compares every method of sampling over its settings with the mean of two pictures with many samples. `front` marks the Pareto front: no
/// other setting is both faster and more accurate. --arithmetic compares every arithmetic with f64 instead, --depths and --cutoffs what
/// limits of the ray tree lose and save.
#[derive(Args)]
pub struct ErrorBench {
    #[command(flatten)]
    scenes: SceneOptions,
    /// Every arithmetic instead: by hand with 2 to 15 decimals, f32, f64
    #[arg(long, group = "ladder", conflicts_with_all = ["sampling", "reference", "runs", "target", "chart"])]
    arithmetic: bool,
    /// Every max_depth up to the scene's own instead
    #[arg(long, group = "ladder", conflicts_with_all = ["sampling", "reference", "runs", "target", "chart"])]
    depths: bool,
    /// Cutoffs from 0.3 to 0.001 instead, with what they can lose
    #[arg(long, group = "ladder", conflicts_with_all = ["sampling", "reference", "runs", "target", "chart"])]
    cutoffs: bool,
    /// A method to compare; may be given several times. Without it, every method over its settings
    #[arg(long, value_name = "SPEC", value_parser = sampling)]
    sampling: Vec<Sampling>,
    /// The method of the two pictures whose mean is the reference, or `exact`: the areas that flat-coloured polygons, disks, spheres and
    /// ellipsoids cover, or the penumbras of a disk on diffuse surfaces. Without it, `exact` where the scene has such areas and nothing
    /// else, otherwise sobol:1024
    #[arg(long, value_name = "SPEC", value_parser = reference)]
    reference: Option<Reference>,
    /// How many pictures each setting renders, with different seeds
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=10_000))]
    runs: u16,
    /// Report the fastest setting with no more than this error
    #[arg(long, value_name = "RMSE", value_parser = error, allow_negative_numbers = true)]
    target: Option<f64>,
    /// Draw error against time into this SVG file
    #[arg(long, alias = "svg", value_name = "FILE")]
    chart: Option<PathBuf>,
    /// The number of threads; 0 is one per core
    #[arg(long, value_name = "N", default_value_t = 0, value_parser = clap::value_parser!(u16).range(0..=MAX_THREADS))]
    threads: u16,
    #[command(flatten)]
    progress: ProgressOptions,
    /// How to print the table
    #[arg(long, value_enum, default_value = "text")]
    format: TableFormat,
}

impl ErrorBench {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        raywalk::threads::want(self.threads.into());
        let otherwise: &[&str] = if self.arithmetic {
            &scenes::FEW
        } else if self.depths || self.cutoffs {
            &scenes::BRANCHING
        } else {
            &scenes::SAMPLED
        };
        let names = self.scenes.names(otherwise);
        let loaded = names.iter().map(|name| self.scenes.load(name)).collect::<Result<Vec<_>, _>>()?;
        let (scenes, inputs): (Vec<_>, Vec<_>) = loaded.into_iter().unzip();
        if self.arithmetic {
            return arithmetic::run(&scenes, self.threads.into(), self.format);
        }
        if self.depths || self.cutoffs {
            let ladder = if self.depths { measured::depths } else { measured::cutoffs };
            return limits::run(&scenes, ladder, self.threads.into(), self.format);
        }
        let request = samplers::Request {
            methods: match self.sampling.is_empty() {
                true => samplers::settings(),
                false => self.sampling.clone(),
            },
            reference: self.reference,
            runs: self.runs.into(),
            threads: self.threads.into(),
            target: self.target,
            chart: self.chart,
            progress: self.progress,
            inputs: inputs.into_iter().fold(Inputs::none(), Inputs::and),
            format: self.format,
        };
        request.run(&scenes)
    }
}

fn reference(text: &str) -> Result<Reference, String> {
    const EXACT: &str = "exact";
    match text {
        EXACT => Ok(Reference::Exact),
        _ => sampling_or(&[EXACT], text).map(Reference::Sampled),
    }
}

fn error(text: &str) -> Result<f64, String> {
    let error = text.parse().ok().filter(|error: &f64| *error > 0.0 && error.is_finite());
    error.ok_or_else(|| format!("expected an error above 0, in units of white, found `{text}`"))
}
