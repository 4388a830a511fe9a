//! Weights above 1 multiply at every level; what comes of them stays a number.

use crate::support::scene_of;
use raywalk::log::{Decision, Event, Log, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{Scene, Skip, builtin};
use serde_json::{Value as Json, json};

/// A built-in scene whose materials and settings of tracing are changed.
fn changed(name: &str, tracing: Json, change: impl Fn(&mut Json)) -> Scene {
    let mut scene: Json = serde_json::from_str(builtin::text(name).expect("a scene")).expect("JSON");
    scene["tracing"] = tracing;
    let materials = scene["materials"].as_object_mut().expect("materials");
    materials.values_mut().for_each(|material| change(&mut material["weights"]));
    scene_of(scene.to_string().as_bytes(), name)
}

/// A square pane of a material.
fn pane(z: f64, material: &str) -> Json {
    let corners = [[-9.0, -9.0, z], [9.0, -9.0, z], [9.0, 9.0, z], [-9.0, 9.0, z]];
    json!({"shape": {"polygon": {"vertices": corners}}, "material": material})
}

fn log(scene: &Scene) -> Log {
    let pixel = scene.camera.resolution.map(|side| side / 2);
    record::pixel(scene, pixel, Arithmetic::F64)
}

/// The number of a log that is the largest; what isn't a number is larger than all.
fn largest(log: &Log) -> f64 {
    let of_event = |event: &Event| {
        let value = match event.what {
            What::Note { value, .. } => Some(value),
            What::Result { color } => Some(Value::Triple(color)),
            _ => None,
        };
        let all = value.into_iter().chain(log.events.given(event).iter().map(|(_, value)| *value));
        all.flat_map(|value| value.components().to_vec()).collect::<Vec<_>>()
    };
    let numbers = log.events.iter().flat_map(of_event).map(f64::abs);
    numbers.max_by(f64::total_cmp).expect("a number")
}

fn result(log: &Log) -> [f64; 3] {
    let of_event = |event: &Event| match event.what {
        What::Result { color } => Some(color),
        _ => None,
    };
    log.events.iter().rev().find_map(of_event).expect("a result")
}

/// Two mirrors face each other.
#[test]
fn mirrors_that_make_more_of_light() {
    let hall = |weight: f64| {
        log(&changed("hall-of-mirrors", json!({"max_depth": 12}), |weights| weights["reflected"] = json!(weight)))
    };
    let bright = hall(1e90);
    assert!(largest(&bright).is_finite(), "{}", largest(&bright));
    assert_eq!(result(&bright), [1e150; 3]);
    // Below the limit nothing is lost: all that twelve mirrors make of the last local colour is there.
    let most = result(&hall(1e10));
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
            let largest = largest(&record::pixel(&scene, pixel, Arithmetic::F64));
            assert!(largest.is_finite(), "{name} {pixel:?}: {largest}");
        }
    }
}

/// Everything that multiplies in a local colour at once, behind panes that make more of the light; whatever is skipped.
#[test]
fn local_colours_that_overflow() {
    let scene = |local: f64, skip: Skip| {
        let checker = json!({"a": [1e100, 1, 1], "b": [1e100, 1, 1], "size": 1});
        let text = json!({
            "format": "raywalk-scene/1",
            "camera": {"position": [0, 0, 9], "direction": [0, 0, -1], "resolution": [4, 3]},
            "lights": [{"point": {"position": [1, 2, 6]}, "color": [1e100, 1e100, 0]}],
            "materials": {
                "ball": {"diffuse": [1e100, 1, 1], "weights": {"local": local}, "pattern": {"checker": checker}},
                "pane": {"weights": {"local": 0, "transmitted": [1e100, 1e-100, 1]}}
            },
            "objects": [
                {"shape": {"sphere": {"center": [0, 0, 0], "radius": 2}}, "material": "ball"},
                pane(3.0, "pane"), pane(3.5, "pane"), pane(4.0, "pane"), pane(4.5, "pane")
            ]
        });
        let mut scene = scene_of(text.to_string().as_bytes(), "bright");
        scene.tracing.skip = skip;
        scene
    };
    for local in [0.0, 1e-100, 1.0, 1e100] {
        let [all, none] = [Skip::ALL, Skip::NONE].map(|skip| log(&scene(local, skip)));
        assert_eq!(result(&all).map(f64::to_bits), result(&none).map(f64::to_bits), "{local:e}");
        assert!(largest(&all).is_finite() && largest(&none).is_finite(), "{local:e}");
        // Four panes before the eye make 1e400 of it.
        let red = if local == 0.0 { 0.0 } else { 1e150 };
        assert_eq!(result(&none)[0], red, "{local:e}");
    }
}

/// A product of weights that is large for a while and small in the end isn't cut off before it is small.
#[test]
fn a_cutoff_asks_for_the_whole_product() {
    let weights = [1e60, 1e60, 1e-100, 1e-10];
    let name = |number: usize| format!("pane-{number}");
    let material = |number| (name(number), json!({"weights": {"local": 0, "transmitted": weights[number]}}));
    let text = json!({
        "format": "raywalk-scene/1",
        "camera": {"position": [0, 0, 9], "direction": [0, 0, -1], "resolution": [1, 1]},
        "background": [1, 1, 1],
        "tracing": {"cutoff": 1e-3, "max_depth": 4},
        "materials": (0..4).map(material).collect::<serde_json::Map<_, _>>(),
        "objects": (0..4).map(|number| pane(-(number as f64), &name(number))).collect::<Vec<_>>()
    });
    let brought = result(&log(&scene_of(text.to_string().as_bytes(), "panes")));
    assert!(brought.iter().all(|channel| (channel / 1e10 - 1.0).abs() < 1e-15), "{brought:?}");
}

/// Against an index of 1e17 nothing is left of a refracted direction, in any arithmetic; nor by hand of a mirrored one without decimals.
#[test]
fn directions_of_which_nothing_is_left() {
    let scene = |weights: Json, direction: [f64; 3]| {
        let text = json!({
            "format": "raywalk-scene/1",
            "camera": {"position": [0, 0, 9], "direction": direction, "up": [0, 1, 0], "resolution": [1, 1]},
            "materials": {"glass": {"ior": 1e17, "weights": weights}},
            "objects": [
                {"shape": {"sphere": {"center": [0, 0, 0], "radius": 2}}, "material": "glass"},
                {"shape": {"cone": {"base": [4e9, 0, 0], "base_radius": 1, "apex": [0, 20, 0], "apex_radius": 6}}}
            ]
        });
        scene_of(text.to_string().as_bytes(), "dense")
    };
    let glass = scene(json!({"transmitted": 1}), [0.0, 0.0, -1.0]);
    for arithmetic in [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(3)] {
        let log = record::pixel(&glass, [0, 0], arithmetic);
        assert!(largest(&log).is_finite(), "{arithmetic}");
        let is_lost = |event: &Event| matches!(event.what, What::Mark(Decision::Undefined { quantity }) if quantity.key() == "refract.direction");
        assert!(log.events.iter().any(is_lost), "{arithmetic}");
    }
    let mirror = scene(json!({"reflected": 1}), [0.1, 0.1, -1.0]);
    assert!(largest(&record::pixel(&mirror, [0, 0], Arithmetic::Decimal(0))).is_finite());
}
