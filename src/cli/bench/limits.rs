//! `raywalk bench error --depths` and `--cutoffs`: what limits of the ray tree lose and save.

use super::TableFormat;
use super::table::{print_measured, quoted};
use crate::cli::failure::Failure;
use raywalk::render::RenderError;
use raywalk::scene::Scene;
use raywalk::scene::file::visible;
use raywalk::study::bench::limits::{Ladder, Limit, Limited};
use raywalk::study::ladder::Deviation;
use serde::Serialize;
use std::fmt::Write;

#[derive(Serialize)]
struct Measured {
    scene: String,
    #[serde(flatten)]
    ladder: Ladder,
}

/// Measures the scenes with one of the ladders and prints the table.
pub fn run(
    scenes: &[Scene],
    ladder: fn(&Scene, usize) -> Result<Ladder, RenderError>,
    threads: usize,
    format: TableFormat,
) -> Result<(), Failure> {
    let measure = |scene: &Scene| Ok(Measured { scene: scene.name.clone(), ladder: ladder(scene, threads)? });
    print_measured(scenes, measure, format, text, csv)
}

/// The name of a limit, and its value.
fn words(limit: Limit) -> (&'static str, String) {
    match limit {
        Limit::MaxDepth(depth) => ("max_depth", depth.to_string()),
        Limit::Cutoff(cutoff) => ("cutoff", cutoff.to_string()),
    }
}

/// A table a scene.
fn text(measured: &[Measured]) -> String {
    let mut text = String::new();
    for Measured { scene, ladder } in measured {
        let (name, reference) = words(ladder.reference);
        let _ = writeln!(text, "{}, against {name} {reference}", visible(scene));
        let _ = writeln!(
            text,
            "  {name:<10} {:>10} {:>9} {:>10} {:>10} {:>10} {:>10}",
            "rays/px", "seconds", "rmse", "worst", "visible", "bound"
        );
        for Limited { limit, rays_per_pixel, seconds, deviation, bound } in &ladder.rungs {
            let Deviation { rmse, worst, visible } = deviation;
            let bound = match (limit, bound) {
                (Limit::MaxDepth(_), _) => String::new(),
                (Limit::Cutoff(_), None) => "none".into(),
                (Limit::Cutoff(_), Some(bound)) => format!("{bound:.1e}"),
            };
            let row = format!(
                "  {:<10} {rays_per_pixel:>10.2} {seconds:>9.4} {rmse:>10.1e} {worst:>10.1e} {:>9.2}% {bound:>10}",
                words(*limit).1,
                visible * 100.0
            );
            let _ = writeln!(text, "{}", row.trim_end());
        }
    }
    text.push_str(
        "errors in units of the scene's white; bound: the most that a cutoff can have taken from a channel of a pixel; visible: \
         pixels off by more than one of 255 levels\n",
    );
    text
}

fn csv(measured: &[Measured]) -> String {
    let mut text = "scene,limit,value,reference,rays_per_pixel,seconds,rmse,worst,visible,bound\n".to_owned();
    for Measured { scene, ladder } in measured {
        let reference = words(ladder.reference).1;
        for Limited { limit, rays_per_pixel, seconds, deviation, bound } in &ladder.rungs {
            let Deviation { rmse, worst, visible } = deviation;
            let (name, value) = words(*limit);
            let bound = bound.map(|bound| bound.to_string()).unwrap_or_default();
            let _ = writeln!(
                text,
                "{},{name},{value},{reference},{rays_per_pixel},{seconds},{rmse},{worst},{visible},{bound}",
                quoted(scene)
            );
        }
    }
    text
}
