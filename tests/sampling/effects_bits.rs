//! Pictures with every effect at once have the same bits on any number of threads, in any crop, and in the log of a pixel.

use crate::edges::{picture_in_order, picture_with};
use crate::support;
use raywalk::log::{RayKind, Step, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::render::TileOrder;
use raywalk::scene::{Adaptive, Guided, LightKind, Sampling, Scene, Statistical};
use std::collections::BTreeSet;

const METHODS: [Sampling; 10] = [
    Sampling::Center {},
    Sampling::Regular { n: 2 },
    Sampling::Shared { n: 1 },
    Sampling::Adaptive { threshold: 0.3, depth: 1 },
    Sampling::Stochastic { n: 3 },
    Sampling::Random { n: 3 },
    Sampling::Sobol { n: 2 },
    Sampling::Statistical(Statistical { confidence: 0.9, tolerance: 0.3, min: 4, max: 8 }),
    Sampling::Guided(Guided { tolerance: 0.1, min: 4, max: 16 }),
    Sampling::Guided(Guided { tolerance: 0.05, min: 3, max: 11 }),
];

fn scene(sampling: Sampling) -> Scene {
    let scene = support::scene_of(include_bytes!("../support/effects.json"), "effects");
    Scene { sampling, seed: 5, ..scene }
}

/// The same with lights that are asked for as many points as it takes.
fn adaptive_scene(sampling: Sampling) -> Scene {
    let mut scene = scene(sampling);
    for light in &mut scene.lights {
        if let LightKind::Area(area) = &mut light.kind {
            (area.samples, area.adaptive) = (4, Some(Adaptive::new(&area.surface, area.by, 2)));
        }
    }
    scene
}

#[test]
fn threads_crops_and_logs_agree() {
    let adaptive = [METHODS[4], METHODS[8]].map(adaptive_scene);
    for scene in METHODS.into_iter().map(scene).chain(adaptive) {
        let sampling = scene.sampling;
        let whole = picture_with(&scene, [0, 0, 41, 31], 1);
        for threads in [2, 7, 16] {
            let other = picture_with(&scene, [0, 0, 41, 31], threads);
            assert!(whole.film == other.film && whole.counts == other.counts, "{sampling:?} on {threads} threads");
        }
        let shuffled = picture_in_order(&scene, [0, 0, 41, 31], 16, TileOrder::Shuffled(6));
        assert!(whole.film == shuffled.film && whole.counts == shuffled.counts, "{sampling:?} in another order");
        let bits = |color: glam::DVec3| color.to_array().map(f64::to_bits);
        let [left, top, right, bottom] = [5, 7, 33, 22];
        let part = picture_with(&scene, [left, top, right, bottom], 2);
        let places = (top..bottom).flat_map(|row| (left..right).map(move |column| [column, row]));
        for ([column, row], pixel) in places.zip(part.film.pixels()) {
            let in_whole = whole.film.pixels()[(row * 41 + column) as usize];
            assert_eq!(bits(*pixel), bits(in_whole), "{sampling:?}: {column},{row}");
        }
        for pixel @ [column, row] in support::grid(&scene, 6) {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let Some(What::Result { color }) = log.events.last().map(|event| &event.what) else {
                panic!("a log ends with the result");
            };
            let rendered = whole.film.pixels()[(row * 41 + column) as usize];
            assert_eq!(color.map(f64::to_bits), bits(rendered), "{sampling:?}: {pixel:?}");
        }
    }
}

/// Of several rays from one place each has a path of its own; logs are read back as they were written.
#[test]
fn every_ray_has_a_path_of_its_own() {
    let scene = scene(Sampling::Stochastic { n: 2 });
    for pixel in support::grid(&scene, 5) {
        let log = record::pixel(&scene, pixel, Arithmetic::F64);
        let tree = Tree::of(&log.events);
        let mut paths = BTreeSet::new();
        for node in 0..tree.nodes().len() {
            if matches!(tree.nodes()[node].step, Some(Step::Ray { .. })) {
                assert!(paths.insert(tree.path(node)), "{pixel:?}: {} twice", tree.path(node));
            }
        }
        let written = raywalk::log::file::to_ndjson(&log).expect("memory");
        let read = raywalk::log::file::read(&written).expect("a log").log;
        assert!(read == log, "{pixel:?}");
    }
}

/// Each zone, each point of a light, has directions of its own.
#[test]
fn splits_have_numbers_and_differ() {
    let scene = support::scene("polished-surface");
    let mut most = 0;
    for pixel in support::grid(&scene, 12) {
        let log = record::pixel(&scene, pixel, Arithmetic::F64);
        let mut directions = BTreeSet::new();
        let mut splits = Vec::new();
        for event in &log.events {
            if let What::Enter { step: Step::Ray { kind: RayKind::Reflected, split, .. }, .. } = event.what {
                splits.push(split);
                let given = log.events.given(event).iter().find(|(name, _)| name.key() == "ray.direction");
                let Some((_, Value::Triple(direction))) = given else { panic!("a ray is given its direction") };
                directions.insert(direction.map(f64::to_bits));
            }
        }
        assert_eq!(directions.len(), splits.len());
        assert!(splits.windows(2).all(|pair| pair[0] < pair[1]), "{splits:?}");
        most = most.max(splits.len());
    }
    assert_eq!(most, 16);
}
