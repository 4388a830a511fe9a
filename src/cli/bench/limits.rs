//! `raywalk bench error --depths` and `--cutoffs`: what limits of the ray tree lose and save.

use super::TableFormat;
use super::table::{self, or_blank, print_measured};
use crate::cli::failure::Failure;
use raywalk::files::escape_hidden;
use raywalk::render::RenderError;
use raywalk::scene::Scene;
use raywalk::study::bench::limits::{Ladder, Limit, Limited};
use raywalk::study::ladder::Deviation;
use serde::Serialize;

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
        let heads = [name, "rays/px", "seconds", "rmse", "worst", "visible", "bound"];
        let row = |Limited { limit, rays_per_pixel, seconds, deviation, bound }: &Limited| {
            let Deviation { rmse, worst, visible } = deviation;
            let bound = bound.map_or("none".to_owned(), |bound| format!("{bound:.1e}"));
            let [rmse, worst] = [rmse, worst].map(|x| format!("{x:.1e}"));
            let [rays, seconds] = [format!("{rays_per_pixel:.2}"), format!("{seconds:.4}")];
            [words(*limit).1, rays, seconds, rmse, worst, format!("{:.2}%", visible * 100.0), bound]
        };
        let columns = columns(has_bounds(ladder), heads.len());
        let rows = ladder.rungs.iter().map(|rung| row(rung)[..columns].to_vec());
        text += &format!("{}, against {name} {reference}\n", escape_hidden(scene));
        text += &table::text(&heads[..columns], rows);
    }
    let is_bounded = measured.iter().any(|scene| has_bounds(&scene.ladder));
    let bound = match is_bounded {
        true => " bound: the most that a cutoff can have taken from a channel of a pixel;",
        false => "",
    };
    text + &format!("errors in units of the scene's white;{bound} visible: pixels off by more than one of 255 levels\n")
}

fn csv(measured: &[Measured]) -> String {
    let heads = "scene,limit,value,reference,rays_per_pixel,seconds,rmse,worst,visible,bound";
    let is_bounded = measured.iter().any(|scene| has_bounds(&scene.ladder));
    let columns = columns(is_bounded, 10);
    let rows = measured.iter().flat_map(|Measured { scene, ladder }| {
        let reference = words(ladder.reference).1;
        ladder.rungs.iter().map(move |Limited { limit, rays_per_pixel, seconds, deviation, bound }| {
            let Deviation { rmse, worst, visible } = deviation;
            let (name, value) = words(*limit);
            let [rays, seconds, rmse, worst, visible] =
                [rays_per_pixel, seconds, rmse, worst, visible].map(f64::to_string);
            let about = [scene.clone(), name.to_owned(), value, reference.clone()];
            [&about[..], &[rays, seconds, rmse, worst, visible, or_blank(*bound)]].concat()[..columns].to_vec()
        })
    });
    table::csv(if is_bounded { heads } else { heads.trim_end_matches(",bound") }, rows)
}

/// How many columns a table has: the last one only where there are bounds.
fn columns(has_bounds: bool, all: usize) -> usize {
    if has_bounds { all } else { all - 1 }
}
