//! What part of a pixel each of its samples is.

use crate::log::{Decision, Log, Name, Step, Tree, What};
use std::collections::HashMap;

/// The camera rays of a pixel, each with its part of the colour.
pub(super) fn camera_rays(log: &Log, tree: &Tree, pixel: usize) -> Vec<(usize, f64)> {
    let samples: Vec<_> =
        tree.children(pixel).filter(|child| matches!(tree.nodes()[*child].step, Some(Step::Sample { .. }))).collect();
    if samples.is_empty() {
        return rays(tree, pixel).map(|ray| (ray, 1.0)).collect();
    }
    let weights = weights(log, tree, pixel, &samples);
    samples.iter().zip(weights).flat_map(|(sample, weight)| rays(tree, *sample).map(move |ray| (ray, weight))).collect()
}

fn rays(tree: &Tree, node: usize) -> impl Iterator<Item = usize> + '_ {
    tree.children(node).filter(|child| tree.ray(*child).is_some())
}

/// Samples count alike, but where they are corners of cells: there a corner has a quarter of each cell that it belongs to.
fn weights(log: &Log, tree: &Tree, pixel: usize, samples: &[usize]) -> Vec<f64> {
    let header = &log.header;
    let cells = if header.sampling.contains_key("adaptive") {
        let accepted = tree.own_events(pixel).filter_map(|event| match log.events[event].what {
            What::Mark(Decision::Accepted { cell, .. }) => cell,
            _ => None,
        });
        accepted.collect()
    } else if let Some(n) = header.sampling.get("shared").and_then(|shared| shared.get("n")) {
        let n = n.0 as u32;
        let at = |step: u32| f64::from(step) / f64::from(n);
        (0..n).flat_map(|y| (0..n).map(move |x| [at(x), at(y), 1.0 / f64::from(n)])).collect()
    } else {
        return vec![1.0 / samples.len() as f64; samples.len()];
    };
    of_corners(log, tree, samples, cells)
}

fn of_corners(log: &Log, tree: &Tree, samples: &[usize], cells: Vec<[f64; 3]>) -> Vec<f64> {
    let mut by_place: HashMap<[u64; 2], f64> = HashMap::new();
    for [left, top, side] in cells {
        for [x, y] in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]] {
            *by_place.entry(key([left + x * side, top + y * side])).or_insert(0.0) += side * side / 4.0;
        }
    }
    let weight = |sample: &usize| {
        let coordinate = |name: Name| log.input(tree.nodes()[*sample].events.start, name)?.number();
        let place = [coordinate(Name::SampleX)?, coordinate(Name::SampleY)?];
        by_place.get(&key(place)).copied()
    };
    samples.iter().map(|sample| weight(sample).unwrap_or(0.0)).collect()
}

/// A place in the pixel, however its coordinates were computed: to 2⁻³², which is finer than any grid of corners.
fn key(place: [f64; 2]) -> [u64; 2] {
    const STEPS: f64 = (1_u64 << 32) as f64;
    place.map(|x| (x * STEPS + 0.5) as u64)
}
