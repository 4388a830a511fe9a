//! `raywalk bench error --arithmetic`: what each arithmetic loses and costs.

use super::TableFormat;
use super::table::{print_measured, quoted};
use crate::cli::failure::Failure;
use raywalk::scene::Scene;
use raywalk::study::ladder::{Rung, ladder};
use serde::Serialize;
use std::fmt::Write;

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
    let mut text = String::new();
    for Measured { scene, rungs } in measured {
        let _ = writeln!(text, "{}", raywalk::files::escape_hidden(scene));
        let _ =
            writeln!(text, "  {:<10} {:>10} {:>10} {:>10} {:>9}", "arithmetic", "rmse", "worst", "visible", "seconds");
        for Rung { arithmetic, seconds, rmse, worst, visible } in rungs {
            let visible = visible * 100.0;
            let _ = writeln!(text, "  {arithmetic:<10} {rmse:>10.1e} {worst:>10.1e} {visible:>9.2}% {seconds:>9.4}");
        }
    }
    text.push_str(
        "errors in units of the scene's white, against f64; that of f64 against the same moved by rounding errors\n",
    );
    text
}

fn csv(measured: &[Measured]) -> String {
    let mut text = "scene,arithmetic,rmse,worst,visible,seconds\n".to_owned();
    for Measured { scene, rungs } in measured {
        let scene = quoted(scene);
        for Rung { arithmetic, seconds, rmse, worst, visible } in rungs {
            let _ = writeln!(text, "{scene},{arithmetic},{rmse},{worst},{visible},{seconds}");
        }
    }
    text
}
