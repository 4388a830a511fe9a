//! Which rounding caused the error of a result by hand.

use crate::support::{middle, scene, scene_of, snapshots};
use raywalk::probe::CutOff;
use raywalk::record::{self, Arithmetic, Part};
use raywalk::report::Style;
use raywalk::report::language::Language;
use raywalk::scene::{Sampling, Scene};
use raywalk::study::rounding::{self, Cause, Change, MAX_CAUSES, Rounding, Study};

fn study(scene: &Scene, rounding: Rounding) -> Study {
    rounding::study(scene, Part::Pixel(middle(scene)), rounding).expect("a short computation")
}

#[track_caller]
fn cause<'s>(study: &'s Study, path: &str, key: &str) -> &'s Cause {
    let found = study.causes.iter().find(|cause| cause.path == path && cause.name.key() == key);
    found.unwrap_or_else(|| panic!("no {key} in {path}"))
}

#[track_caller]
fn is_to_three_decimals(found: f64, expected: &str) {
    assert_eq!(format!("{found:+.3}"), expected);
}

#[test]
fn the_numeric_example() {
    let textbook = scene("textbook");
    let study = study(&textbook, Rounding::Decimal(3));
    is_to_three_decimals(study.rounded[0], "+394.134");
    is_to_three_decimals(study.exact[0], "+393.054");
    is_to_three_decimals(study.rounded[0] - study.exact[0], "+1.080");
    is_to_three_decimals(cause(&study, "C", "ray.direction").only.color[0], "+1.030");
    is_to_three_decimals(cause(&study, "C", "reflect.direction").only.color[0], "+0.909");
    is_to_three_decimals(cause(&study, "C R", "half.direction").only.color[0], "+0.061");
    assert!(!study.decides_otherwise);
    // The two that matter most come first, and sizes fall.
    let keys: Vec<_> = study.causes.iter().take(2).map(|cause| cause.name.key()).collect();
    assert_eq!(keys, ["ray.direction", "reflect.direction"]);
    assert!(study.causes.windows(2).all(|pair| pair[0].only.size() >= pair[1].only.size()));
    // A direction that comes from a rounded one is rounded already: without its own rounding nothing changes.
    assert_eq!(cause(&study, "C", "reflect.direction").all_but.color[0], study.rounded[0] - study.exact[0]);
    assert!((1.0..2.0).contains(&study.spread[0]), "{:?}", study.spread);
}

#[test]
fn the_results_are_those_of_the_arithmetics() {
    for name in ["textbook", "figure-8", "transmission"] {
        let scene = scene(name);
        for (rounding, arithmetic) in
            [(Rounding::Decimal(4), Arithmetic::Decimal(4)), (Rounding::Single, Arithmetic::F32)]
        {
            let study = study(&scene, rounding);
            let color = |arithmetic| record::pixel_color(&scene, middle(&scene), arithmetic).to_array();
            assert_eq!(study.rounded, color(arithmetic), "{name}");
            // f64 takes more digits where it wants them, which moves the last bits.
            let pairs = study.exact.into_iter().zip(color(Arithmetic::F64));
            assert!(pairs.clone().all(|(ours, f64s)| (ours - f64s).abs() <= 1e-13 * f64s.abs()), "{name}: {pairs:?}");
            assert_eq!(Rounding::of(arithmetic), Some(rounding));
        }
    }
}

/// The rounding of the last quantity alone moves the result by itself, and by nothing else.
#[test]
fn the_last_rounding_is_its_own_error() {
    let textbook = scene("textbook");
    let study = study(&textbook, Rounding::Decimal(2));
    let last = study.causes.iter().find(|cause| cause.path == "C" && cause.name.key() == "combine.color");
    let exact = study.exact[0];
    let expected = (exact * 100.0).round() / 100.0 - exact;
    assert_eq!(last.expect("the result's quantity").only.color[0], expected);
}

#[test]
fn a_ray_tree_that_changes_is_reported() {
    // The line passes the centre at (5.3 − 0.5)/|(0, 0.1, −5)| = 0.960, inside. With the direction (0, 0.020, −1.000) rounded
    // to (0, 0, −1) it passes at 1.06, outside.
    let scene = scene_of(
        br#"{"format": "raywalk-scene/1", "ambient": [1, 1, 1], "background": [0.5, 0.5, 0.5],
            "camera": {"position": [0, 0, 0], "direction": [0, 0.1, -5], "resolution": [1, 1]},
            "materials": {"plain": {"ambient": [0.25, 0.5, 0.75]}},
            "objects": [{"name": "ball", "shape": {"sphere": {"center": [0, 1.06, -5], "radius": 1}}, "material": "plain"}],
            "tracing": {"sphere_method": "geometric"}}"#,
        "grazed",
    );
    let study = study(&scene, Rounding::Decimal(1));
    assert!(study.decides_otherwise);
    let changed = |change: &Change| change.decides_otherwise;
    assert!(changed(&cause(&study, "C", "ray.direction").only));
    assert!(!changed(&cause(&study, "C", "sphere.oc").only));
    let text = study.text(Language::English, Style::default());
    assert!(text.contains("Rounding changes the ray tree") && text.contains(") *"), "{text}");
}

#[test]
fn the_table() {
    let textbook = scene("textbook");
    let study = study(&textbook, Rounding::Decimal(3));
    snapshots().bind(|| insta::assert_snapshot!("causes_textbook", study.text(Language::English, Style::default())));
    snapshots().bind(|| {
        insta::assert_snapshot!("causes_textbook_es", study.text(Language::Spanish, Style::default().with(2)))
    });
    let json: serde_json::Value = serde_json::from_str(&study.json()).expect("JSON");
    assert_eq!(json["causes"].as_array().expect("causes").len(), study.causes.len());
    assert_eq!(json["causes"][0]["quantity"], "ray.direction");
    assert_eq!(json["causes"][0]["only"]["change"][0].as_f64(), Some(study.causes[0].only.color[0]));
}

#[test]
fn too_many_quantities_are_refused() {
    let mut textbook = scene("textbook");
    textbook.sampling = Sampling::Shared { n: 16 };
    let refused = rounding::study(&textbook, Part::Pixel(middle(&textbook)), Rounding::Decimal(3));
    assert!(matches!(refused, Err(CutOff::TooLong { most: MAX_CAUSES })));
}
