//! Weights above 1 multiply at every level; what comes of them stays a number.

use crate::support::scene_of;
use raywalk::log::{Log, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{Scene, builtin};
use serde_json::{Value as Json, json};

/// A built-in scene whose materials and settings of tracing are changed.
fn changed(name: &str, tracing: Json, change: impl Fn(&mut Json)) -> Scene {
    let mut scene: Json = serde_json::from_str(builtin::text(name).expect("a scene")).expect("JSON");
    scene["tracing"] = tracing;
    let materials = scene["materials"].as_object_mut().expect("materials");
    materials.values_mut().for_each(|material| change(&mut material["weights"]));
    scene_of(scene.to_string().as_bytes(), name)
}

fn log(scene: &Scene) -> Log {
    let pixel = scene.camera.resolution.map(|side| side / 2);
    record::pixel(scene, pixel, Arithmetic::F64)
}

/// All numbers of a log, the largest first.
fn numbers(log: &Log) -> Vec<f64> {
    let of_event = |event: &raywalk::log::Event| {
        let value = match event.what {
            What::Note { value, .. } => Some(value),
            What::Result { color } => Some(Value::Triple(color)),
            _ => None,
        };
        let all = value.into_iter().chain(event.given.iter().map(|(_, value)| *value));
        all.flat_map(|value| value.components().to_vec()).collect::<Vec<_>>()
    };
    let mut numbers: Vec<f64> = log.events.iter().flat_map(of_event).collect();
    numbers.sort_by(|a, b| b.abs().total_cmp(&a.abs()));
    numbers
}

fn result(log: &Log) -> [f64; 3] {
    let results = log.events.iter().filter_map(|event| match event.what {
        What::Result { color } => Some(color),
        _ => None,
    });
    results.last().expect("a result")
}

/// Two mirrors face each other.
#[test]
fn mirrors_that_make_more_of_light() {
    let hall = |weight: f64| {
        changed("hall-of-mirrors", json!({"max_depth": 12}), |weights| weights["reflected"] = json!(weight))
    };
    let bright = log(&hall(1e90));
    let largest = numbers(&bright)[0];
    assert!(largest.is_finite(), "{largest}");
    assert!(result(&bright).iter().all(|channel| (1e149..=1e150).contains(channel)), "{:?}", result(&bright));
    // Below the limit nothing is lost: all that twelve mirrors make of the last local colour is there.
    let most = result(&log(&hall(1e10)));
    assert!(most.iter().all(|channel| (1e115..1e125).contains(channel)), "{most:?}");
}

/// Glass that makes more of the light in shadow rays, and along the path.
#[test]
fn glass_that_makes_more_of_light() {
    for name in ["glass-shadows", "glass-and-mirror"] {
        let scene = changed(name, json!({"cutoff": 1e-3, "max_depth": 6}), |weights| {
            if weights["transmitted"] != json!(0) {
                weights["transmitted"] = json!(1e100);
                weights["reflected"] = json!([1e100, 0, 1e-100]);
            }
            weights["local"] = json!(1e100);
        });
        let [width, height] = scene.camera.resolution;
        for pixel in (0..12).flat_map(|row| (0..16).map(move |column| [column * width / 16, row * height / 12])) {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let largest = numbers(&log)[0];
            assert!(largest.is_finite(), "{name} {pixel:?}: {largest}");
        }
    }
}
