//! `raywalk bench overhead`: what it costs to see the values of a computation.

use super::TableFormat;
use super::machine::Machine;
use super::scenes::{self, SceneOptions};
use super::table::{self, quartiles};
use crate::cli::failure::Failure;
use clap::Args;
use raywalk::files::escape_hidden;
use raywalk::study::bench::overhead::{Cost, Overhead, overhead};
use serde::Serialize;
use serde_json::json;

/// Measure what recording, counting and other arithmetic cost
///
/// Every pixel is computed on one thread without a probe (silent), counted, recorded, in f32, by hand, by hand and recorded, and
/// perturbed. Ratios are those of pairs of runs, one right after the other; times are processor time.
#[derive(Args)]
pub struct OverheadBench {
    #[command(flatten)]
    scenes: SceneOptions,
    /// How many pairs of runs
    #[arg(long, value_name = "N", default_value_t = 11, value_parser = clap::value_parser!(u16).range(1..=10_000))]
    pairs: u16,
    /// How to print the table
    #[arg(long, value_enum, default_value = "text")]
    format: TableFormat,
}

#[derive(Serialize)]
struct Measured {
    scene: String,
    #[serde(flatten)]
    overhead: Overhead,
}

impl OverheadBench {
    /// Runs the command.
    pub fn run(self) -> Result<(), Failure> {
        let machine = Machine::this();
        let measure = |name: &std::path::PathBuf| {
            let (scene, _) = self.scenes.load(name)?;
            let overhead = overhead(&scene, self.pairs.into());
            let overhead = overhead.map_err(|error| {
                Failure::caller(format!("{}: {error}, expected fewer samples a pixel", escape_hidden(&scene.name)))
            })?;
            Ok(Measured { scene: scene.name, overhead })
        };
        let measured = self.scenes.names(&scenes::FEW).iter().map(measure).collect::<Result<Vec<_>, Failure>>()?;
        let json = || json!({ "machine": machine, "scenes": measured });
        table::print(self.format, || text(&machine, &measured), || csv(&measured), json)
    }
}

/// A table a scene.
fn text(machine: &Machine, measured: &[Measured]) -> String {
    let mut text = format!("{machine}\n");
    for Measured { scene, overhead } in measured {
        let Overhead { pixels, rays_per_pixel, events_per_pixel, event_bytes_per_pixel, costs } = overhead;
        text += &format!("{}: {pixels} pixels, {rays_per_pixel:.2} rays a pixel\n", escape_hidden(scene));
        text += &format!(
            "  a pixel's log has {events_per_pixel:.1} events in {event_bytes_per_pixel:.0} bytes of memory\n"
        );
        let row = |Cost { way, ns_per_pixel, ns_per_ray, ratio }: &Cost| {
            let [pixel, ray] = [ns_per_pixel.median, *ns_per_ray].map(|ns| format!("{ns:.0}"));
            let quartiles = format!("({:.3} {:.3})", ratio.lower, ratio.upper);
            [(*way).to_owned(), pixel, ray, format!("{:.3}", ratio.median), quartiles]
        };
        text += &table::text(&["probe", "ns/pixel", "ns/ray", "ratio", "(quartiles)"], costs.iter().map(row));
    }
    text
}

fn csv(measured: &[Measured]) -> String {
    let heads = "scene,probe,ns_per_pixel,ns_per_pixel_lower_quartile,ns_per_pixel_upper_quartile,ns_per_ray,ratio,\
        ratio_lower_quartile,ratio_upper_quartile,pairs,events_per_pixel";
    let rows = measured.iter().flat_map(|Measured { scene, overhead }| {
        overhead.costs.iter().map(move |Cost { way, ns_per_pixel, ns_per_ray, ratio }| {
            let about = [scene.clone(), (*way).to_owned()];
            let counts = [ratio.count.to_string(), overhead.events_per_pixel.to_string()];
            [&about[..], &quartiles(ns_per_pixel), &[ns_per_ray.to_string()], &quartiles(ratio), &counts].concat()
        })
    });
    table::csv(heads, rows)
}
