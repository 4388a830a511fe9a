//! Samples of a pixel are traced together through large trees: each sees what it would see alone.

use crate::support;
use raywalk::probe::{Probe, Silent};
use raywalk::sampling;
use raywalk::scene::{Sampling, Scene, Statistical};
use serde_json::json;

/// A probe that sees every test, before which each ray goes alone.
struct Watching;

impl Probe for Watching {}

const METHODS: [Sampling; 5] = [
    Sampling::Regular { n: 3 },
    Sampling::Stochastic { n: 5 },
    Sampling::Random { n: 8 },
    Sampling::Sobol { n: 17 },
    Sampling::Statistical(Statistical { confidence: 0.9, tolerance: 0.05, min: 4, max: 24 }),
];

/// The knot before a lens while the shutter is open, with a moving ball before it and another one around the eye.
fn knot(sampling: Sampling, around_eye: f64) -> Scene {
    let scene = support::changed_scene("mesh", |file| {
        file.camera.resolution = [24, 18];
        file.camera.lens = serde_json::from_value(json!({"radius": 0.1, "focus_distance": 5.0})).expect("a lens");
        file.camera.shutter = [0.0, 1.0];
        let balls = json!([
            {"name": "ball", "shape": {"sphere": {"center": [0.3, -1.2, 0.2], "radius": 0.3}}, "material": "brass",
             "motion": {"translation": [0.4, 0.0, 0.1]}},
            {"name": "eye", "shape": {"sphere": {"center": [1.5, -4.5, 2.2], "radius": around_eye}}, "material": "glass"}
        ]);
        let glass = json!({"ior": 1.3, "weights": {"local": 0.2, "transmitted": 0.8}});
        file.materials.insert("glass", serde_json::from_value(glass).expect("a material"));
        file.objects.extend(serde_json::from_value::<Vec<_>>(balls).expect("objects"));
    });
    Scene { sampling, seed: 3, ..scene }
}

#[test]
fn samples_that_walk_together_see_what_each_sees_alone() {
    for sampling in METHODS {
        for around_eye in [0.5, 0.05] {
            let scene = knot(sampling, around_eye);
            assert!(scene.index.has_large_trees(), "worth walking together");
            let [width, height] = scene.camera.resolution;
            for pixel in (0..height).flat_map(|y| (0..width).map(move |x| [x, y])) {
                let bits = |color: glam::DVec3| color.to_array().map(f64::to_bits);
                let together = bits(sampling::pixel(&scene, pixel, &mut Silent));
                let alone = bits(sampling::pixel(&scene, pixel, &mut Watching));
                assert_eq!(together, alone, "{sampling:?}, pixel {pixel:?}, {around_eye}");
            }
        }
    }
}
