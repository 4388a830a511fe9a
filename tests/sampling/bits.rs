//! Every method gives the same bits in a picture, in any part of it, on any number of threads, and in the log of a pixel.

use crate::edges;
use crate::edges::{camera_rays, picture_in_order, picture_with, scene as edge_scene};
use crate::support;
use raywalk::log::{Header, Log, Name, RayKind, Step, Subject, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::render::TileOrder;
use raywalk::scene::{Guided, Sampling, Scene, Statistical};
use std::collections::BTreeSet;

const METHODS: [Sampling; 10] = [
    Sampling::Center {},
    Sampling::Regular { n: 2 },
    Sampling::Shared { n: 2 },
    Sampling::Adaptive { threshold: 0.05, depth: 3 },
    Sampling::Stochastic { n: 5 },
    Sampling::Random { n: 3 },
    Sampling::Sobol { n: 6 },
    Sampling::Statistical(Statistical { confidence: 0.9, tolerance: 0.1, min: 4, max: 40 }),
    Sampling::Guided(Guided { tolerance: 0.02, min: 4, max: 64 }),
    Sampling::Guided(Guided { tolerance: 0.05, min: 3, max: 11 }),
];

/// Scenes with edges, small objects and curved mirrors, in a size that no tile divides.
fn scenes(sampling: Sampling) -> impl Iterator<Item = Scene> {
    ["figure-6", "figure-16", "figure-19", "figure-20"].into_iter().map(move |name| {
        let text = raywalk::scene::builtin::text(name).expect("a built-in scene");
        let mut file = raywalk::scene::file::check(text.as_bytes(), name).expect("a good scene").scene;
        file.camera.resolution = [41, 35];
        let mut scene = raywalk::scene::build(&file, &Default::default()).expect("a supported scene");
        scene.sampling = sampling;
        scene.seed = 7;
        scene
    })
}

fn bits(color: glam::DVec3) -> [u64; 3] {
    color.to_array().map(f64::to_bits)
}

#[test]
fn any_number_of_threads_and_any_crop_give_the_same_bits() {
    for sampling in METHODS {
        for scene in scenes(sampling) {
            let whole = picture_with(&scene, [0, 0, 41, 35], 1);
            for threads in [2, 7, 16] {
                let other = picture_with(&scene, [0, 0, 41, 35], threads);
                assert!(whole.film == other.film, "{sampling:?}, {} on {threads} threads", scene.name);
                assert_eq!(whole.counts, other.counts, "{sampling:?}, {} on {threads} threads", scene.name);
            }
            for crop @ [left, top, right, bottom] in [[3, 5, 40, 34], [17, 0, 18, 35], [16, 16, 32, 32]] {
                let part = picture_with(&scene, crop, 2);
                let places = (top..bottom).flat_map(|row| (left..right).map(move |column| [column, row]));
                for ([column, row], pixel) in places.zip(part.film.pixels()) {
                    let in_whole = whole.film.pixels()[(row * 41 + column) as usize];
                    assert_eq!(bits(*pixel), bits(in_whole), "{sampling:?}, {}: {column},{row}", scene.name);
                }
            }
        }
    }
}

/// Whichever tile is taken up first, and by whom: the same bits, and no corner is traced twice.
#[test]
fn any_order_of_the_tiles_gives_the_same_bits() {
    for sampling in METHODS {
        let mut scene = scenes(sampling).next().expect("a scene");
        scene.camera.resolution = [75, 70];
        let crop = [0, 0, 75, 70];
        let whole = picture_with(&scene, crop, 1);
        for (key, threads) in [(1, 1), (2, 16), (3, 16), (4, 5)] {
            // 25 tiles of 16 pixels.
            let other = picture_in_order(&scene, crop, threads, TileOrder::Shuffled(key));
            assert!(whole.film == other.film, "{sampling:?}, order {key} on {threads} threads");
            assert_eq!(whole.counts, other.counts, "{sampling:?}, order {key} on {threads} threads");
        }
        assert!(whole.film == picture_with(&scene, crop, 16).film, "{sampling:?}, in order on 16 threads");
    }
}

#[test]
fn a_log_has_exactly_the_samples_of_the_picture() {
    for sampling in METHODS {
        for scene in scenes(sampling) {
            let whole = picture_with(&scene, [0, 0, 41, 35], 2);
            for pixel @ [column, row] in support::grid(&scene, 5) {
                let log = record::pixel(&scene, pixel, Arithmetic::F64);
                let Some(What::Result { color }) = log.events.last().map(|event| &event.what) else {
                    panic!("a log ends with the result");
                };
                let rendered = whole.film.pixels()[(row * 41 + column) as usize];
                assert_eq!(color.map(f64::to_bits), bits(rendered), "{sampling:?}, {}: {pixel:?}", scene.name);
                // One pixel alone takes the rays of its log: what it shares, it shares with nobody.
                let alone = picture_with(&scene, [column, row, column + 1, row + 1], 1);
                assert_eq!(camera_rays(&alone), places(&log).len() as u64, "{sampling:?}, {}: {pixel:?}", scene.name);
            }
        }
    }
}

/// The camera rays of a whole picture are those of its pixels' logs, and corners that several pixels have are traced once.
#[test]
fn shared_corners_are_traced_once() {
    for sampling in [Sampling::Shared { n: 2 }, Sampling::Adaptive { threshold: 0.05, depth: 3 }] {
        for scene in scenes(sampling) {
            let mut all = BTreeSet::new();
            for row in 0..35 {
                for column in 0..41 {
                    all.extend(places(&record::pixel(&scene, [column, row], Arithmetic::F64)));
                }
            }
            let whole = picture_with(&scene, [0, 0, 41, 35], 2);
            assert_eq!(camera_rays(&whole), all.len() as u64, "{sampling:?}, {}", scene.name);
        }
    }
}

/// The places of the picture that the camera rays of a log go through, each once.
fn places(log: &Log) -> BTreeSet<[u64; 2]> {
    let tree = Tree::of(&log.events);
    let is_camera = |node: &usize| matches!(tree.nodes()[*node].step, Some(Step::Ray { kind: RayKind::Camera, .. }));
    let rays: Vec<_> = (0..tree.nodes().len()).filter(is_camera).collect();
    let direction = |ray: &usize| {
        tree.own_events(*ray).find_map(|event| match log.events[event].what {
            What::Note { name: Name::RayDirection, value: Value::Triple([x, y, _]) } => {
                Some([x.to_bits(), y.to_bits()])
            }
            _ => None,
        })
    };
    let places: BTreeSet<_> = rays.iter().filter_map(direction).collect();
    assert_eq!(places.len(), rays.len(), "no ray is traced twice");
    places
}

#[test]
fn another_seed_gives_another_picture_only_where_numbers_are_random() {
    let disc = edges::Shape::Disc { x: 0.1, y: 0.2, radius: 9.4 };
    for sampling in METHODS {
        let mut scene = edge_scene(disc, sampling);
        let first = edges::red(&edges::picture(&scene));
        scene.seed = 1;
        let other = edges::red(&edges::picture(&scene));
        let is_random = !matches!(
            sampling,
            Sampling::Center {} | Sampling::Regular { .. } | Sampling::Shared { .. } | Sampling::Adaptive { .. }
        );
        assert_eq!(first != other, is_random, "{sampling:?}");
    }
}

/// What the header of a log says of the sampling is what a scene file says.
#[test]
fn the_header_of_a_log_can_be_read_as_a_scene() {
    let text = raywalk::scene::builtin::text("figure-19").expect("a built-in scene");
    for sampling in METHODS {
        let scene = Scene { sampling, ..support::scene("figure-19") };
        let header = record::header(&scene, Subject::Pixel([0, 0]), Arithmetic::F64);
        let mut file: serde_json::Value = serde_json::from_str(text).expect("JSON");
        file["sampling"] = serde_json::to_value(&header.sampling).expect("JSON");
        assert_eq!(support::scene_of(file.to_string().as_bytes(), "again").sampling, sampling);
        let written = serde_json::to_string(&header).expect("JSON");
        assert_eq!(serde_json::from_str::<Header>(&written).expect("a header"), header, "{written}");
    }
}
