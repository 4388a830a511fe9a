//! `raywalk bench error` of methods of sampling.

use super::TableFormat;
use super::machine::Machine;
use super::table::{self, or_blank, quartiles};
use crate::cli::failure::Failure;
use crate::cli::inputs::Inputs;
use crate::cli::output::Output;
use crate::cli::progress::{Progress, ProgressOptions};
use raywalk::files::escape_hidden;
use raywalk::scene::builtin;
use raywalk::scene::{Guided, Sampling, Scene, Statistical};
use raywalk::study::bench::chart::{self, Panel};
use raywalk::study::bench::exact::{self, Exact};
use raywalk::study::bench::samplers::{CompareError, Comparing, Comparison, Outcome, Reference, compare};
use serde::Serialize;
use serde_json::json;
use std::path::PathBuf;

/// What is asked for.
pub struct Request {
    /// The methods.
    pub methods: Vec<Sampling>,
    /// What is compared with; `None` for exact areas where the scene has them, and two pictures with [`OTHERWISE`] where it doesn't.
    pub reference: Option<Reference>,
    /// How often each setting renders.
    pub runs: usize,
    /// On how many threads.
    pub threads: usize,
    /// The error for which the best setting is reported.
    pub target: Option<f64>,
    /// Where error against time is drawn.
    pub chart: Option<PathBuf>,
    /// Whether and how progress is shown.
    pub progress: ProgressOptions,
    /// The files of the scenes, which the chart may not overwrite.
    pub inputs: Inputs,
    /// How the table is printed.
    pub format: TableFormat,
}

#[derive(Serialize)]
struct Measured {
    scene: String,
    size: [u32; 2],
    #[serde(flatten)]
    comparison: Comparison,
    /// The fastest setting with no more than the error that was asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    best: Option<String>,
}

impl Measured {
    fn panel(&self) -> Panel<'_> {
        Panel { title: title(self), comparison: &self.comparison }
    }
}

impl Request {
    /// Measures the scenes, prints the table and draws the chart.
    pub fn run(self, scenes: &[Scene]) -> Result<(), Failure> {
        let machine = Machine::this();
        let chart = self.chart.as_ref().map(|path| Output::create(Some(path), &self.inputs)).transpose()?;
        // The reference is two pictures.
        let progress = self.progress.start((scenes.len() * (self.methods.len() + 2)) as u64);
        let measured = scenes.iter().map(|scene| self.measure(scene, &progress)).collect::<Result<Vec<_>, _>>();
        progress.finish();
        let measured = measured?;
        if let Some(chart) = chart {
            let panels: Vec<_> = measured.iter().map(Measured::panel).collect();
            let about = format!("{machine}; medians of {} runs with their quartiles", self.runs);
            chart.commit(chart::svg(&panels, &about).as_bytes())?;
        }
        let json = || {
            let mut all = json!({ "machine": machine, "runs": self.runs, "threads": self.threads, "scenes": measured });
            if let Some(target) = self.target {
                all["target"] = target.into();
            }
            all
        };
        table::print(self.format, || self.text(&machine, &measured), || csv(&measured), json)
    }

    fn measure(&self, scene: &Scene, progress: &Progress) -> Result<Measured, Failure> {
        let reference = self.reference.unwrap_or_else(|| match Exact::of(scene) {
            Ok(_) => Reference::Exact,
            Err(_) => Reference::Sampled(OTHERWISE),
        });
        let comparing = Comparing { reference, runs: self.runs, threads: self.threads };
        let comparison = compare(scene, &self.methods, comparing, || progress.advance(1));
        let comparison = comparison.map_err(|error| match error {
            CompareError::Render(error) => Failure::machine(error.to_string()),
            CompareError::NotExact(why) => Failure::caller(format!(
                "scene `{}` has no exact reference: {why}; built-in scenes that have one: {}",
                escape_hidden(&scene.name),
                scenes_with_exact().join(", ")
            )),
        })?;
        let best = self.target.and_then(|target| comparison.best(target)).map(|best| best.sampling.clone());
        Ok(Measured { scene: scene.name.clone(), size: scene.camera.resolution, comparison, best })
    }

    /// A table a scene.
    fn text(&self, machine: &Machine, measured: &[Measured]) -> String {
        let mut text = format!("{machine}\n");
        for scene in measured {
            text += &format!("{}\n", title(scene));
            text += &table::text(&HEADS, scene.comparison.outcomes.iter().map(row));
            if let Some(target) = self.target {
                text.push_str(&told(scene, target));
            }
        }
        text.push_str("errors in units of the scene's white");
        if measured.iter().any(|scene| !is_of_areas(&scene.comparison)) {
            text.push_str("; errors no greater than the reference's own say nothing");
        }
        text.push('\n');
        text
    }
}

/// The sampling of the reference of scenes without an exact one.
const OTHERWISE: Sampling = Sampling::Sobol { n: 1024 };

/// The built-in scenes that have an exact reference.
fn scenes_with_exact() -> Vec<&'static str> {
    let has_exact = |name: &&str| Scene::built_in(name).is_ok_and(|scene| exact::is_possible(&scene));
    builtin::names().filter(has_exact).collect()
}

/// Every method over its settings.
pub fn settings() -> Vec<Sampling> {
    let mut settings = vec![Sampling::Center {}];
    settings.extend([2, 3, 4, 6, 8].map(|n| Sampling::Regular { n }));
    settings.extend([1, 2, 4, 8].map(|n| Sampling::Shared { n }));
    for n in [4, 16, 64] {
        settings.extend([Sampling::Random { n }, Sampling::Stochastic { n }, Sampling::Sobol { n }]);
    }
    for threshold in [0.1, 0.02] {
        settings.extend([1, 2, 3, 4].map(|depth| Sampling::Adaptive { threshold, depth }));
    }
    let statistical = |tolerance| Statistical { confidence: 0.95, tolerance, min: 8, max: 1024 };
    settings.extend([0.1, 0.05, 0.02].map(|tolerance| Sampling::Statistical(statistical(tolerance))));
    let guided = |tolerance| Guided { tolerance, min: 4, max: 1024 };
    settings.extend([0.02, 0.005, 0.001].map(|tolerance| Sampling::Guided(guided(tolerance))));
    settings
}

/// Whether the reference is the exact areas, which are only rounded; exact penumbras have an error that is reported.
fn is_of_areas(comparison: &Comparison) -> bool {
    comparison.reference == Reference::Exact.to_string() && comparison.reference_error.is_none()
}

fn title(measured: &Measured) -> String {
    let Measured { scene, size: [width, height], comparison, .. } = measured;
    let Comparison { reference, reference_error, .. } = comparison;
    let is_exact = *reference == Reference::Exact.to_string();
    let against = match reference_error {
        Some(error) if is_exact => format!("the exact penumbra, integrated with an error of about {error:.1e}"),
        None if is_exact => "the exact areas".to_owned(),
        Some(error) => format!("two pictures with {reference}, whose own error is {error:.1e}"),
        None => format!("two pictures with {reference}, whose own error is unknown"),
    };
    format!("{}, {width} x {height} pixels, against {against}", escape_hidden(scene))
}

const HEADS: [&str; 8] =
    ["sampling", "samples/px", "rays/px", "seconds", "(quartiles)", "rmse", "(quartiles)", "front"];

fn row(outcome: &Outcome) -> [String; 8] {
    let Outcome { sampling, samples_per_pixel, rays_per_pixel, seconds, rmse, is_on_front, .. } = outcome;
    let [samples, rays] = [samples_per_pixel, rays_per_pixel].map(|count| format!("{count:.2}"));
    [
        sampling.clone(),
        samples,
        rays,
        format!("{:.4}", seconds.median),
        format!("({:.4} {:.4})", seconds.lower, seconds.upper),
        format!("{:.2e}", rmse.median),
        format!("({:.2e} {:.2e})", rmse.lower, rmse.upper),
        if *is_on_front { "*" } else { "" }.to_owned(),
    ]
}

/// The answer to "best setting for this scene and this error".
fn told(scene: &Measured, target: f64) -> String {
    let doubt = match scene.comparison.reference_error.is_some_and(|error| target < 2.0 * error) {
        true => "; the reference is hardly better itself: take one with more samples",
        false => "",
    };
    match scene.comparison.best(target) {
        Some(Outcome { sampling, seconds, rmse, .. }) => {
            let (seconds, rmse) = (seconds.median, rmse.median);
            format!("  best for an error of at most {target}: {sampling}, {rmse:.2e} in {seconds:.4} s{doubt}\n")
        }
        None => format!("  best for an error of at most {target}: none of these{doubt}\n"),
    }
}

fn csv(measured: &[Measured]) -> String {
    let heads = "scene,width,height,reference,reference_error,sampling,samples_per_pixel,rays_per_pixel,seconds,\
        seconds_lower_quartile,seconds_upper_quartile,cpu_seconds,rmse,rmse_lower_quartile,\
        rmse_upper_quartile,runs,front,best";
    let rows = measured.iter().flat_map(|Measured { scene, size, comparison, best }| {
        let Comparison { reference, reference_error, outcomes } = comparison;
        let [width, height] = size.map(|side| side.to_string());
        let about = [scene.clone(), width, height, reference.clone(), or_blank(*reference_error)];
        outcomes.iter().map(move |outcome| {
            let Outcome { sampling, samples_per_pixel, rays_per_pixel, seconds, cpu_seconds, rmse, .. } = outcome;
            let counts = [sampling.clone(), samples_per_pixel.to_string(), rays_per_pixel.to_string()];
            let cpu = [cpu_seconds.median.to_string()];
            let marks = [outcome.is_on_front, best.as_ref() == Some(sampling)].map(|mark| mark.to_string());
            let runs = [rmse.count.to_string()];
            [&about[..], &counts, &quartiles(seconds), &cpu, &quartiles(rmse), &runs, &marks].concat()
        })
    });
    table::csv(heads, rows)
}
