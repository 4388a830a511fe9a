//! What methods that look before they leap may miss: thin objects between corners, blurred ones that few samples see.

use crate::edges;
use crate::edges::{camera_rays, picture, red};
use crate::support;
use raywalk::log::{Acceptance, Decision, Name, What};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{Sampling, Scene, Statistical};

/// White objects before black, the plane z = 0 half a unit a pixel.
fn scene(camera: &str, object: &str, sampling: Sampling) -> Scene {
    let text = format!(
        r#"{{"format": "raywalk-scene/1", "ambient": [1, 1, 1], "materials": {{"white": {{"ambient": [1, 1, 1]}}}},
            "camera": {{"position": [0, 0, 8], "direction": [0, 0, -1], "vertical_fov": 90, "resolution": [32, 32]{camera}}},
            "objects": [{{"shape": {object}, "material": "white"}}]}}"#
    );
    Scene { sampling, ..support::scene_of(text.as_bytes(), "chances") }
}

fn light(scene: &Scene) -> f64 {
    red(&picture(scene)).iter().sum()
}

/// Needles of a breadth of 0.08 pixels and less, slanted, short and long: each has its light, and costs few rays.
#[test]
fn slanted_needles_are_found() {
    let cylinder = |a: [f64; 3], b: [f64; 3]| {
        format!(r#"{{"cylinder": {{"base": {a:?}, "apex": {b:?}, "radius": 0.02, "caps": true}}}}"#)
    };
    for (name, needle) in [
        ("short", cylinder([0.11, 0.13, 0.0], [1.1, 1.37, 0.0])),
        ("long", cylinder([-5.1, -4.93, 0.0], [4.2, 5.51, 0.0])),
        (
            "cone",
            r#"{"cone": {"base": [-3, 2, 0], "base_radius": 0.04, "apex": [2, -3.1, 0], "apex_radius": 0}}"#.to_owned(),
        ),
        ("triangle", r#"{"triangle": {"vertices": [[-3.1, -2.9, 0], [3.3, 2.7, 0], [3.33, 2.8, 0]]}}"#.to_owned()),
        (
            "polygon",
            r#"{"polygon": {"vertices": [[1.3, -2.9, 0], [1.33, -2.9, 0], [-2.97, 2.7, 0], [-3, 2.7, 0]]}}"#.to_owned(),
        ),
    ] {
        let exact = light(&scene("", &needle, Sampling::Regular { n: 64 }));
        let adaptive = picture(&scene("", &needle, Sampling::Adaptive { threshold: 0.02, depth: 5 }));
        let found: f64 = red(&adaptive).iter().sum();
        println!("{name}: {found:.4} of {exact:.4}, {} rays", camera_rays(&adaptive));
        assert!((found / exact - 1.0).abs() < 0.1, "{name}: {found}, expected {exact}");
        // Cells beside the needle aren't cut for it.
        assert!(camera_rays(&adaptive) < 32 * 32 * 16, "{name}: {} rays", camera_rays(&adaptive));
    }
}

const PROMISED: Statistical = Statistical { confidence: 0.95, tolerance: 0.05, min: 8, max: 4096 };

/// A ball far out of focus covers less of the lens than the tolerance in some pixels and more in others: where it covers more, the
/// promised part of the pixels is within the tolerance, and little of the light is lost.
#[test]
fn a_ball_out_of_focus_keeps_its_light() {
    let camera = r#", "lens": {"radius": 0.4, "focus_distance": 4}"#;
    let ball = r#"{"sphere": {"center": [-3.1, -3.1, 0], "radius": 0.12}}"#;
    let exact = red(&picture(&scene(camera, ball, Sampling::Sobol { n: 8192 })));
    let (mut lit, mut held, mut found, mut all) = (0.0, 0.0, 0.0, 0.0);
    for seed in 0..10 {
        let scene = Scene { seed, ..scene(camera, ball, Sampling::Statistical(PROMISED)) };
        for (value, exact) in red(&picture(&scene)).into_iter().zip(&exact) {
            found += value / 10.0;
            all += exact / 10.0;
            if *exact > 0.0 {
                lit += 1.0;
                held += f64::from((value - exact).abs() <= 0.05);
            }
        }
    }
    println!("light {found:.4} of {all:.4}, {:.3} of {lit} pixels held", held / lit);
    assert!(held >= 0.95 * lit, "{held} of {lit}");
    assert!((found / all - 1.0).abs() < 0.3, "{found} of {all}");
}

/// Where nothing is drawn but the place, eight samples that agree are enough; where a lens, a shutter, a light or a lobe is, 59 are
/// asked for, which is 64.
#[test]
fn how_many_samples_must_agree_depends_on_what_they_draw() {
    let away = r#"{"sphere": {"center": [0, 0, 90], "radius": 1}}"#;
    let wall = r#"{"plane": {"coefficients": [0, 0, 1, 0]}}"#;
    let lens = r#", "lens": {"radius": 0.1, "focus_distance": 4}"#;
    let count = |camera: &str, object: &str, light: &str| {
        let sampling = Sampling::Statistical(PROMISED);
        let mut scene = scene(camera, object, sampling);
        if !light.is_empty() {
            scene.effects.area_lights = true;
        }
        camera_rays(&picture(&scene)) / (32 * 32)
    };
    assert_eq!(count("", wall, ""), 8);
    assert_eq!(count(lens, wall, ""), 64);
    assert_eq!(count("", wall, "area"), 64);
    // Rays that hit nothing draw no light.
    assert_eq!(count("", away, "area"), 8);
}

/// The last decision has its figures, also of a number of samples that has no pairs.
#[test]
fn the_last_decision_has_figures() {
    let edge = edges::Shape::HalfPlane { nx: 0.8, ny: -0.6, d: 0.1 };
    for (min, max, tolerance, why) in [
        (5, 6, 0.01, Acceptance::Max),
        (5, 6, 0.9, Acceptance::Interval),
        (4, 13, 0.01, Acceptance::Max),
        (4, 4, 0.01, Acceptance::Max),
    ] {
        let sampling = Sampling::Statistical(Statistical { confidence: 0.9, tolerance, min, max });
        let scene = edges::scene(edge, sampling);
        let log = record::pixel(&scene, [16, 15], Arithmetic::F64);
        let events: Vec<_> = log.events.iter().map(|event| &event.what).collect();
        let accepted = events.iter().rposition(|what| matches!(what, What::Mark(Decision::Accepted { .. })));
        let accepted = accepted.expect("a decision");
        assert!(matches!(events[accepted], What::Mark(Decision::Accepted { why: found, .. }) if *found == why));
        let note = |name: Name| {
            let found = events[accepted - 7..accepted].iter().find_map(|what| match what {
                What::Note { name: noted, value } if *noted == name => Some(value.components()[0]),
                _ => None,
            });
            found.unwrap_or_else(|| panic!("{name:?} of {min} to {max}"))
        };
        let samples = f64::from(max);
        let part = note(Name::StatisticalMean);
        assert!(part > 0.0 && part < 1.0, "an edge crosses the pixel: {part}");
        if !max.is_power_of_two() {
            // Of zeros and ones s² is p(1 − p)·n/(n − 1).
            let expected = (part * (1.0 - part) / (samples - 1.0)).sqrt();
            assert!((note(Name::StatisticalError) - expected).abs() < 1e-15);
            assert_eq!(note(Name::StatisticalFreedom), samples - 1.0);
        }
        assert!(note(Name::StatisticalHalfWidth) > 0.0);
    }
}
