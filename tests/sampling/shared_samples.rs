//! Samples that pixels share: each corner is traced once, and a pixel has the same bits however it is reached.

use raywalk::log::{Event, Log, Parameter, Step, Tree, What, file as log_file};
use raywalk::record::{self, Arithmetic};
use raywalk::render::{Rendered, Settings, render};
use raywalk::scene::file::schema::{Sampling, SceneFile};
use raywalk::scene::{Scene, build, builtin, file};
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// A built-in scene in a small size, with the corners of n × n cells a pixel.
fn shared(name: &str, n: u32, resolution: [u32; 2]) -> Scene {
    let text = builtin::text(name).expect("a built-in scene");
    let mut file = file::check(text.as_bytes(), name).expect("a good scene").scene;
    file.camera.resolution = resolution;
    file.sampling = Sampling::Shared { n };
    built(&file)
}

fn built(file: &SceneFile) -> Scene {
    build(file, &Default::default()).expect("a supported scene")
}

fn whole(scene: &Scene) -> Settings {
    Settings { threads: 2, counts_rays: true, ..Settings::whole(scene) }
}

fn rendered(scene: &Scene, settings: &Settings) -> Rendered {
    render(scene, settings, |_| (), &AtomicBool::new(false)).expect("a picture")
}

fn camera_rays(rendered: &Rendered) -> u64 {
    let counts = rendered.counts.as_ref().expect("counts");
    let statistics = counts.statistics(0, Default::default(), 0);
    let json = serde_json::to_value(statistics).expect("JSON");
    assert_eq!(json["samples"], json["rays"]["camera"]);
    json["rays"]["camera"].as_u64().expect("a number")
}

#[test]
fn every_corner_is_traced_once() {
    for (n, expected) in [(1, 8 * 6), (2, 15 * 11), (3, 22 * 16)] {
        let scene = shared("figure-6", n, [7, 5]);
        assert_eq!(camera_rays(&rendered(&scene, &whole(&scene))), expected, "n = {n}");
    }
}

#[test]
fn a_pixel_has_the_same_bits_in_a_picture_a_crop_and_alone() {
    for n in [1, 2, 3] {
        let scene = shared("figure-6", n, [20, 35]);
        for arithmetic in [Arithmetic::F64, Arithmetic::Decimal(3)] {
            let settings = Settings { arithmetic, ..whole(&scene) };
            let film = rendered(&scene, &settings).film;
            let [left, top, right, bottom] = [3, 5, 19, 25];
            let crop = Settings { crop: [left, top, right, bottom], threads: 1, counts_rays: false, ..settings };
            let part = rendered(&scene, &crop).film;
            let of_part = part.pixels().iter();
            for ((x, y), pixel) in (top..bottom).flat_map(|y| (left..right).map(move |x| (x, y))).zip(of_part) {
                let bits = |color: glam::DVec3| color.to_array().map(f64::to_bits);
                let in_whole = film.pixels()[(y * 20 + x) as usize];
                let alone = record::pixel_color(&scene, [x, y], arithmetic);
                assert_eq!(bits(*pixel), bits(in_whole), "{x},{y}");
                assert_eq!(bits(*pixel), bits(alone), "{x},{y}");
            }
        }
    }
}

#[test]
fn a_log_shows_the_corners_as_samples() {
    let scene = shared("figure-6", 1, [20, 20]);
    let log = record::pixel(&scene, [10, 9], Arithmetic::F64);
    let tree = Tree::of(&log.events);
    let samples: Vec<_> = tree.children(0).map(|node| tree.nodes()[node].step).collect();
    assert_eq!(samples, [1, 2, 3, 4].map(|number| Some(Step::Sample { number })));
    let rays: Vec<_> = tree.children(0).flat_map(|sample| tree.children(sample)).map(|ray| tree.path(ray)).collect();
    assert_eq!(rays, ["1 C", "2 C", "3 C", "4 C"]);
    assert_eq!(log.header.sampling["shared"]["n"], Parameter(1.0));
    let results = |log: &Log| log.events.iter().filter(|event| is_result(event)).count();
    assert_eq!(results(&log), 1, "samples have none");

    let lines = log_file::to_ndjson(&log).expect("a log");
    let text = String::from_utf8(lines.clone()).expect("UTF-8");
    assert!(
        text.contains("\"enter\":{\"sample\":{\"number\":4}},\"parent\":0,\"given\":{\"sample.x\":1,\"sample.y\":1,\"sample.weight\":1}}"),
        "{text}"
    );
    assert!(text.contains("\"path\":\"4 C\""));
    assert_eq!(log_file::read(&lines).expect("a log").log, log);
}

fn is_result(event: &Event) -> bool {
    matches!(event.what, What::Result { .. })
}

#[test]
fn a_corner_is_the_mean_of_its_pixels_neighbours() {
    // A picture of one pixel is the mean of the four corners, which are the centres of pixels twice as far apart.
    let corners = shared("figure-6", 1, [1, 1]);
    let result = record::pixel_color(&corners, [0, 0], Arithmetic::F64);
    let log = record::pixel(&corners, [0, 0], Arithmetic::F64);
    let tree = Tree::of(&log.events);
    let colors: Vec<_> = tree.children(0).map(|sample| came_to(&corners, &log, &tree, sample)).collect();
    let [a, b, c, d] = colors[..] else { panic!("four corners") };
    let error = result - ((a + b) + (c + d)) / 4.0;
    assert!(error.cmple(result * f64::EPSILON).all(), "{result}");
}

/// The colour that the ray of a sample brings.
fn came_to(scene: &Scene, log: &Log, tree: &Tree, sample: usize) -> glam::DVec3 {
    let ray = tree.children(sample).next().expect("a ray");
    let combined = tree.children(ray).find(|node| tree.nodes()[*node].step == Some(Step::Combine));
    let Some(combined) = combined else { return scene.background };
    let mut last = tree.own_events(combined).filter_map(|event| match log.events[event].what {
        What::Note { name: raywalk::log::Name::CombineColor, value } => Some(value),
        _ => None,
    });
    glam::DVec3::from_slice(last.next_back().expect("a colour").components())
}

#[test]
fn many_corners_are_traced_strip_by_strip() {
    let text = r#"{"format": "raywalk-scene/1", "background": [1, 2, 3], "objects": [],
        "camera": {"position": [0, 0, 1], "direction": [0, 0, -1], "resolution": [9, 8]},
        "sampling": {"shared": {"n": 60}}}"#;
    let scene = built(&file::check(text.as_bytes(), "empty.json").expect("a good scene").scene);
    let pixels = AtomicU64::new(0);
    let count = |more| {
        pixels.fetch_add(more, Ordering::Relaxed);
    };
    let rendered = render(&scene, &whole(&scene), count, &AtomicBool::new(false)).expect("a picture");
    assert_eq!(camera_rays(&rendered), 541 * 481);
    assert_eq!(pixels.into_inner(), 72, "progress counts pixels");
    assert_eq!(rendered.film.pixels(), [scene.background; 72]);
}

#[test]
fn a_picture_can_be_stopped() {
    let scene = shared("figure-6", 1, [8, 8]);
    assert!(render(&scene, &whole(&scene), |_| (), &AtomicBool::new(true)).is_err());
}
