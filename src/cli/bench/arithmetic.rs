//! `raywalk bench error --arithmetic`: what each arithmetic loses and costs.

use super::TableFormat;
use super::table::{self, print_measured};
use crate::cli::failure::Failure;
use raywalk::files::escape_hidden;
use raywalk::scene::Scene;
use raywalk::study::ladder::{Deviation, Rung, ladder};
use serde::Serialize;

#[derive(Serialize)]
struct Measured {
    scene: String,
    rungs: Vec<Rung>,
}

/// Measures the scenes and prints the table.
pub fn run(scenes: &[Scene], threads: usize, format: TableFormat) -> Result<(), Failure> {
    let measure = |scene: &Scene| Ok(Measured { scene: scene.name.clone(), rungs: ladder(scene, threads)? });
    print_measured(scenes, measure, format, text, csv)
}

/// A table a scene.
fn text(measured: &[Measured]) -> String {
    let row = |Rung { arithmetic, seconds, deviation: Deviation { rmse, worst, visible } }: &Rung| {
        let visible = format!("{:.2}%", visible * 100.0);
        [arithmetic.clone(), format!("{rmse:.1e}"), format!("{worst:.1e}"), visible, format!("{seconds:.4}")]
    };
    let heads = ["arithmetic", "rmse", "worst", "visible", "seconds"];
    let of_scene = |Measured { scene, rungs }: &Measured| {
        format!("{}\n{}", escape_hidden(scene), table::text(&heads, rungs.iter().map(row)))
    };
    measured.iter().map(of_scene).collect::<String>()
        + "errors in units of the scene's white, against f64; that of f64 against the same moved by rounding errors\n"
}

fn csv(measured: &[Measured]) -> String {
    let rows = measured.iter().flat_map(|Measured { scene, rungs }| {
        rungs.iter().map(move |Rung { arithmetic, seconds, deviation: Deviation { rmse, worst, visible } }| {
            let [rmse, worst, visible, seconds] = [rmse, worst, visible, seconds].map(f64::to_string);
            [scene.clone(), arithmetic.clone(), rmse, worst, visible, seconds]
        })
    });
    table::csv("scene,arithmetic,rmse,worst,visible,seconds", rows)
}
