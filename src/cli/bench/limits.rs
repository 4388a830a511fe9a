//! `raywalk bench error --depths` and `--cutoffs`: what limits of the ray tree lose and save.

use super::TableFormat;
use super::table::{print_measured, quoted};
use crate::cli::failure::Failure;
use raywalk::files::escape_hidden;
use raywalk::render::RenderError;
use raywalk::scene::Scene;
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

/// Whether a ladder has bounds: of what cutoffs lose there is one, of what depth limits lose there is none.
fn has_bounds(ladder: &Ladder) -> bool {
    matches!(ladder.reference, Limit::Cutoff(_))
}

/// A table a scene.
fn text(measured: &[Measured]) -> String {
    let mut text = String::new();
    for Measured { scene, ladder } in measured {
        let (name, reference) = words(ladder.reference);
        let head = if has_bounds(ladder) { "      bound" } else { "" };
        let _ = writeln!(text, "{}, against {name} {reference}", escape_hidden(scene));
        let _ = writeln!(
            text,
            "  {name:<10} {:>10} {:>9} {:>10} {:>10} {:>10}{head}",
            "rays/px", "seconds", "rmse", "worst", "visible"
        );
        for Limited { limit, rays_per_pixel, seconds, deviation, bound } in &ladder.rungs {
            let Deviation { rmse, worst, visible } = deviation;
            let bound = match (has_bounds(ladder), bound) {
                (false, _) => String::new(),
                (true, None) => format!(" {:>10}", "none"),
                (true, Some(bound)) => format!(" {bound:>10.1e}"),
            };
            let _ = writeln!(
                text,
                "  {:<10} {rays_per_pixel:>10.2} {seconds:>9.4} {rmse:>10.1e} {worst:>10.1e} {:>9.2}%{bound}",
                words(*limit).1,
                visible * 100.0
            );
        }
    }
    let is_bounded = measured.iter().any(|scene| has_bounds(&scene.ladder));
    let bound = match is_bounded {
        true => " bound: the most that a cutoff can have taken from a channel of a pixel;",
        false => "",
    };
    let _ = writeln!(
        text,
        "errors in units of the scene's white;{bound} visible: pixels off by more than one of 255 levels"
    );
    text
}

fn csv(measured: &[Measured]) -> String {
    let is_bounded = measured.iter().any(|scene| has_bounds(&scene.ladder));
    let head = if is_bounded { ",bound" } else { "" };
    let mut text = format!("scene,limit,value,reference,rays_per_pixel,seconds,rmse,worst,visible{head}\n");
    for Measured { scene, ladder } in measured {
        let reference = words(ladder.reference).1;
        for Limited { limit, rays_per_pixel, seconds, deviation, bound } in &ladder.rungs {
            let Deviation { rmse, worst, visible } = deviation;
            let (name, value) = words(*limit);
            let bound = match (is_bounded, bound) {
                (false, _) => String::new(),
                (true, None) => ",".to_owned(),
                (true, Some(bound)) => format!(",{bound}"),
            };
            let _ = writeln!(
                text,
                "{},{name},{value},{reference},{rays_per_pixel},{seconds},{rmse},{worst},{visible}{bound}",
                quoted(scene)
            );
        }
    }
    text
}
