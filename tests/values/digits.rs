//! How many digits can be trusted: perturbed runs, what they have in common, and where they decide differently.

use crate::support::{grid, middle, scene, scene_of, snapshots};
use raywalk::log::{Decision, Digits, Event, Log, Value, What, file};
use raywalk::probe::Perturbed;
use raywalk::record::digits::{ALL_DIGITS, RUNS};
use raywalk::record::{self, Arithmetic, Part};
use raywalk::render::digits::Summary;
use raywalk::render::{Canvas, Job, Settings, render, render_job};
use raywalk::report::language::Language;
use raywalk::report::{Style, text};
use raywalk::scene::{Index, Sampling, Scene, Skip};
use std::sync::atomic::AtomicBool;

fn log(scene: &Scene, pixel: [u32; 2], seed: u64) -> Log {
    record::bounded(scene, Part::Pixel(pixel), Arithmetic::Perturbed(seed)).expect("a short log")
}

/// The digits of a value's least exact component; `None` where a decision differs.
fn fewest(event: &Event) -> Option<f64> {
    match event.digits.as_deref().expect("digits") {
        Digits::Significant(count) => Some(count.components().iter().copied().fold(ALL_DIGITS, f64::min)),
        Digits::DecisionDiffers => None,
    }
}

#[track_caller]
fn of_key(log: &Log, key: &str) -> Option<f64> {
    let is_it = |event: &&Event| matches!(event.what, What::Note { name, .. } if name.key() == key);
    fewest(log.events.iter().find(is_it).unwrap_or_else(|| panic!("no {key}")))
}

fn of_result(log: &Log) -> Option<f64> {
    fewest(log.events.last().expect("a result"))
}

#[test]
fn well_conditioned_values_keep_their_digits() {
    let textbook = scene("textbook");
    for seed in 0..20 {
        let log = log(&textbook, middle(&textbook), seed);
        for key in ["ray.length", "ray.direction", "plane.v_d", "plane.t", "light.distance"] {
            assert!(of_key(&log, key) >= Some(14.0), "seed {seed}: {key} {:?}", of_key(&log, key));
        }
        assert!(of_result(&log) >= Some(13.0), "seed {seed}: {:?}", of_result(&log));
    }
}

/// A sphere of radius 1 whose centre lies `across` beside the ray, `away` along it.
fn far_sphere(away: f64, across: f64, method: &str) -> Log {
    // The ray runs along (2, 3, 6)/7; (3, -2, 0)/√13 is perpendicular.
    let root = 13.0_f64.sqrt();
    let center = [2.0, 3.0, 6.0].map(|x| x / 7.0 * away);
    let center = [center[0] + 3.0 / root * across, center[1] - 2.0 / root * across, center[2]];
    let scene = scene_of(
        format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [2, 3, 6]}},
                "objects": [{{"name": "ball", "shape": {{"sphere": {{"center": {center:?}, "radius": 1}}}}}}],
                "tracing": {{"sphere_method": "{method}"}}}}"#
        )
        .as_bytes(),
        "far",
    );
    let part = Part::Ray { origin: glam::DVec3::ZERO, direction: glam::DVec3::new(2.0, 3.0, 6.0) };
    record::bounded(&scene, part, Arithmetic::Perturbed(3)).expect("a short log")
}

/// r² − L2oc + T_A² has the condition number (r² + L2oc + T_A²)/T2_A: the digits lost are its logarithm.
#[test]
fn cancellation_loses_the_digits_that_the_condition_number_says() {
    for away in [1e2, 1e3, 1e4, 1e5, 1e6] {
        let t2_a = 1.0 - 0.5 * 0.5;
        let lost = libm::log10(2.0 * away * away / t2_a);
        let kept = of_key(&far_sphere(away, 0.5, "geometric"), "sphere.t2_a").expect("the same decisions");
        assert!((ALL_DIGITS - lost - kept).abs() <= 1.2, "{away:e}: {lost} lost, {kept} kept");
        // The way to the line is a difference of vectors of that length, not of their squares.
        let lost = libm::log10(2.0 * 0.5 * away / t2_a);
        let kept = of_key(&far_sphere(away, 0.5, "robust"), "sphere.t2_a").expect("the same decisions");
        assert!((ALL_DIGITS - lost - kept).abs() <= 1.2, "{away:e}, robust: {lost} lost, {kept} kept");
    }
}

const TOUCHED: &str = r#"{"format": "raywalk-scene/1", "name": "touched",
    "camera": {"position": [0, 0, 0], "direction": [0, 0, -5], "resolution": [1, 1]}, "ambient": [1, 1, 1], "background": [0.5, 0.5, 0.5],
    "materials": {"plain": {"ambient": [0.25, 0.5, 0.75]}},
    "objects": [{"name": "ball", "shape": {"sphere": {"center": [0, 1, -5], "radius": 1}}, "material": "plain"},
                {"name": "wall", "shape": {"plane": {"coefficients": [0, 0, 1, 9]}}, "material": "plain"}],
    "tracing": {"sphere_method": "geometric"}}"#;

fn meets_the_ball(log: &Log) -> bool {
    log.events.iter().any(|event| event.what == What::Mark(Decision::Nearest { object: 0 }))
}

#[test]
fn runs_that_decide_differently_have_no_digits_in_common() {
    let touched = scene_of(TOUCHED.as_bytes(), "touched");
    let mut seen = [false; 2];
    for seed in 0..64 {
        let run = |run| Arithmetic::Perturbed(Perturbed::seed_of_run(seed, run));
        let hits = (0..RUNS as u64).filter(|k| meets_the_ball(&record::pixel(&touched, [0, 0], run(*k)))).count();
        let differs = hits > 0 && hits < RUNS;
        seen[usize::from(differs)] = true;
        let log = log(&touched, [0, 0], seed);
        // What precedes the decision keeps its digits, and so does the other object.
        assert!(of_key(&log, "ray.direction") >= Some(15.0), "seed {seed}");
        assert!(of_key(&log, "plane.t") >= Some(15.0), "seed {seed}");
        assert!(of_key(&log, "sphere.t2_a").is_some_and(|digits| digits < 1.0), "seed {seed}");
        for key in ["hit.point", "hit.normal", "shade.local", "combine.color"] {
            assert_eq!(of_key(&log, key).is_none(), differs, "seed {seed}: {key}");
        }
        assert_eq!(of_result(&log).is_none(), differs, "seed {seed}");
        let marks = log.events.iter().filter(|event| matches!(event.what, What::Mark(_)));
        let differing = marks.filter(|event| event.digits.is_some()).count();
        // Hit or miss, and the nearest object.
        assert_eq!(differing, if differs { 2 } else { 0 }, "seed {seed}");
    }
    assert_eq!(seen, [true, true], "both happen");
}

#[test]
fn the_walk_says_how_many_digits_there_are() {
    let touched = scene_of(TOUCHED.as_bytes(), "touched");
    let walk = text::text(Language::English, &log(&touched, [0, 0], 1), Style::default());
    snapshots().bind(|| insta::assert_snapshot!("digits_touched_sphere", walk));
}

#[test]
fn digits_read_back() {
    for (scene, seed) in [(scene_of(TOUCHED.as_bytes(), "touched"), 1), (scene("textbook"), 7)] {
        let log = log(&scene, middle(&scene), seed);
        for bytes in [file::to_ndjson(&log), file::to_json(&log)] {
            let read = file::read(&bytes.expect("written")).expect("a log");
            assert_eq!(read.ending, file::Ending::Complete);
            assert_eq!(read.log, log);
        }
    }
}

fn settings(crop: [u32; 4], threads: usize) -> Settings {
    Settings { crop, arithmetic: Arithmetic::F64, threads, counts_rays: false, order: Default::default() }
}

/// A built-in scene in 40 × 30 pixels.
fn small(name: &str) -> Scene {
    let text = raywalk::scene::builtin::text(name).expect("built in");
    let mut file: serde_json::Value = serde_json::from_str(text).expect("JSON");
    file["camera"]["resolution"] = serde_json::json!([40, 30]);
    scene_of(file.to_string().as_bytes(), name)
}

/// The picture is that of the logs, whatever the threads and the crop.
#[test]
fn a_picture_of_digits_is_the_same_in_parts_and_on_any_threads() {
    let never = AtomicBool::new(false);
    // Figure 16 is sampled until the mean is certain, and a perturbed run may need another number of samples.
    for (name, has_doubts) in [("figure-6", false), ("figure-16", true)] {
        let scene = small(name);
        let picture = |crop, threads| {
            let job = Job::Digits { seed: 9 };
            match render_job(job, &scene, &settings(crop, threads), |_| {}, &never).expect("it runs").film {
                Canvas::Digits(film) => film,
                other => panic!("digits, not {other:?}"),
            }
        };
        let whole = picture([0, 0, 40, 30], 1);
        assert_eq!(whole, picture([0, 0, 40, 30], 3), "{name}");
        let part = picture([7, 11, 30, 29], 2);
        for [x, y] in [[7, 11], [29, 28], [20, 15], [13, 22]] {
            let in_part = part.pixels()[((y - 11) * 23 + x - 7) as usize];
            assert_eq!(in_part, whole.pixels()[(y * 40 + x) as usize], "{name} {x},{y}");
        }
        for (index, pixel) in whole.pixels().iter().enumerate().step_by(7) {
            let at = [index as u32 % 40, index as u32 / 40];
            assert_eq!(of_result(&log(&scene, at, 9)).unwrap_or(0.0), pixel.x, "{name} {at:?}");
        }
        assert_eq!(Summary::of(&whole).without > 0, has_doubts, "{name}: {:?}", Summary::of(&whole));
        assert!(Summary::of(&whole).median > 14.5, "{name}: {:?}", Summary::of(&whole));
    }
}

#[test]
fn a_perturbed_picture_is_that_of_the_logs() {
    let never = AtomicBool::new(false);
    let mut scene = small("figure-6");
    for sampling in [Sampling::Center {}, Sampling::Shared { n: 2 }] {
        scene.sampling = sampling;
        let arithmetic = Arithmetic::Perturbed(4);
        let settings = Settings { arithmetic, ..settings([10, 10, 20, 18], 2) };
        let film = render(&scene, &settings, |_| {}, &never).expect("it runs").film;
        let mut differs_from_f64 = 0;
        for (index, color) in film.pixels().iter().enumerate() {
            let at = [10 + index as u32 % 10, 10 + index as u32 / 10];
            assert_eq!(record::pixel_color(&scene, at, arithmetic), *color, "{sampling:?} {at:?}");
            differs_from_f64 += u32::from(record::pixel_color(&scene, at, Arithmetic::F64) != *color);
        }
        assert!(differs_from_f64 > 40, "{differs_from_f64}");
    }
}

/// What is tested or traced besides moves no other value.
#[test]
fn further_tests_and_rays_change_no_colour() {
    for name in ["figure-6", "transmission", "table-top"] {
        let plain = scene(name);
        let (mut all_tests, mut no_skips) = (scene(name), scene(name));
        all_tests.index = Index::of_all(&all_tests.objects);
        no_skips.tracing.skip = Skip::NONE;
        for pixel in grid(&plain, 6) {
            let color = |scene: &Scene| record::pixel_color(scene, pixel, Arithmetic::Perturbed(2));
            assert_eq!(color(&all_tests), color(&plain), "{name} {pixel:?}");
            assert_eq!(color(&no_skips), color(&plain), "{name} {pixel:?}");
        }
    }
}

/// Cells are counted, and counts aren't rounded: an ulp on them would exchange the colours.
#[test]
fn checkers_keep_their_colours() {
    let scene = scene("table-top");
    let mut checkered = 0;
    for pixel in grid(&scene, 12) {
        let log = log(&scene, pixel, 5);
        let parities = log.events.iter().filter_map(|event| match event.what {
            What::Note { name, value: Value::Number(parity) } if name.key() == "pattern.parity" => Some(parity),
            _ => None,
        });
        checkered += parities.inspect(|parity| assert!([0.0, 1.0].contains(parity), "{pixel:?}: {parity}")).count();
    }
    assert!(checkered > 20, "{checkered}");
}
