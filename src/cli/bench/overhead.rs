//! `raywalk bench overhead`: what it costs to see the values of a computation.

use super::TableFormat;
use super::machine::Machine;
use super::scenes::{self, SceneOptions};
use super::table::quoted;
use crate::cli::failure::Failure;
use crate::cli::options::ColorChoice;
use crate::cli::output;
use clap::Args;
use raywalk::files::escape_hidden;
use raywalk::study::bench::overhead::{Cost, Overhead, overhead};
use serde::Serialize;
use std::fmt::Write;

/// What recording, counting and other arithmetic cost
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
    pub fn run(self, colors: ColorChoice) -> Result<(), Failure> {
        let machine = Machine::this();
        let measure = |name: &std::path::PathBuf| {
            let (scene, _) = self.scenes.load(name, colors)?;
            let overhead = overhead(&scene, self.pairs.into());
            let overhead = overhead.map_err(|error| {
                Failure::caller(format!("{}: {error}, expected fewer samples a pixel", escape_hidden(&scene.name)))
            })?;
            Ok(Measured { scene: scene.name, overhead })
        };
        let measured = self.scenes.names(&scenes::FEW).iter().map(measure).collect::<Result<Vec<_>, Failure>>()?;
        let text = match self.format {
            TableFormat::Text => text(&machine, &measured),
            TableFormat::Csv => csv(&measured),
            TableFormat::Json => {
                format!("{:#}\n", serde_json::json!({ "machine": machine, "scenes": measured }))
            }
        };
        output::print(text.as_bytes())
    }
}

/// A table a scene.
fn text(machine: &Machine, measured: &[Measured]) -> String {
    let mut text = format!("{machine}\n");
    for Measured { scene, overhead } in measured {
        let Overhead { pixels, rays_per_pixel, events_per_pixel, event_bytes_per_pixel, costs } = overhead;
        let _ = writeln!(text, "{}: {pixels} pixels, {rays_per_pixel:.2} rays a pixel", escape_hidden(scene));
        let _ = writeln!(
            text,
            "  a pixel's log has {events_per_pixel:.1} events in {event_bytes_per_pixel:.0} bytes of memory"
        );
        let _ = writeln!(text, "  {:<18} {:>10} {:>10} {:>8}  (quartiles)", "probe", "ns/pixel", "ns/ray", "ratio");
        for Cost { way, ns_per_pixel, ns_per_ray, ratio } in costs {
            let _ = writeln!(
                text,
                "  {way:<18} {:>10.0} {ns_per_ray:>10.0} {:>8.3}  ({:.3} {:.3})",
                ns_per_pixel.median, ratio.median, ratio.lower, ratio.upper
            );
        }
    }
    text
}

fn csv(measured: &[Measured]) -> String {
    let mut text = "scene,probe,ns_per_pixel,ns_per_pixel_lower_quartile,ns_per_pixel_upper_quartile,ns_per_ray,ratio,\
                    ratio_lower_quartile,ratio_upper_quartile,pairs,events_per_pixel\n"
        .to_owned();
    for Measured { scene, overhead } in measured {
        for Cost { way, ns_per_pixel: ns, ns_per_ray, ratio } in &overhead.costs {
            let _ = writeln!(
                text,
                "{},{way},{},{},{},{ns_per_ray},{},{},{},{},{}",
                quoted(scene),
                ns.median,
                ns.lower,
                ns.upper,
                ratio.median,
                ratio.lower,
                ratio.upper,
                ratio.count,
                overhead.events_per_pixel
            );
        }
    }
    text
}
