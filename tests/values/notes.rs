//! The formulas as the source text prints them, and the roundings that it does: `--formulas notes`, `--round-products`, the compensated
//! exponent and the second pseudocode's scale.

use crate::calls::{prints, says};
use crate::formulas::Checked;
use crate::provoking_scenes::{Options, everything};
use crate::support::{self, scene_in};
use glam::DVec3;
use raywalk::geometry::shape::SphereMethod;
use raywalk::log::{Log, Name, Tree, Value, What, scope};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::{Formulas, ReflectedScale, Scene, Specular, builtin};
use serde_json::Value as Json;

const HAND: Arithmetic = Arithmetic::Decimal(3);

fn round(x: f64) -> f64 {
    let scaled = (x.abs() * 1000.0 + 0.5 + 1e-9).floor() / 1000.0;
    if scaled == 0.0 { 0.0 } else { scaled.copysign(x) }
}

/// The logged value of a symbol at an event.
fn number(log: &Log, tree: &Tree, event: usize, symbol: &str) -> f64 {
    match scope::operand(&log.events, tree, event, symbol).expect("an operand").value {
        Value::Number(x) => x,
        Value::Triple(triple) => panic!("{symbol} is {triple:?}"),
    }
}

fn triple(log: &Log, tree: &Tree, event: usize, symbol: &str) -> DVec3 {
    match scope::operand(&log.events, tree, event, symbol).expect("an operand").value {
        Value::Triple(triple) => triple.into(),
        Value::Number(x) => panic!("{symbol} is {x}"),
    }
}

#[test]
fn refractions_by_hand_are_those_of_the_printed_formula() {
    let [mut refractions, mut reflections, mut apart] = [0; 3];
    let glass = ["glass-and-mirror", "total-reflection", "transmission", "frosted-glass", "glass-shadows"];
    for name in glass {
        let scene = scene_in(name, HAND);
        for pixel in support::grid(&scene, 12) {
            let log = record::pixel(&scene, pixel, Arithmetic::Decimal(3));
            let tree = Tree::of(&log.events);
            for (at, event) in log.events.iter().enumerate() {
                let What::Note { name, value } = event.what else { continue };
                let (value, number) = (value.components(), |symbol| number(&log, &tree, at, symbol));
                match name.key() {
                    "refract.cos_2" => {
                        let (eta, cos_1) = (number("η"), number("cosφ_1"));
                        let printed = round((1.0 - (1.0 - cos_1 * cos_1) / (eta * eta)).sqrt());
                        assert_eq!(value, [printed], "{:?}, η {eta}, cosφ_1 {cos_1}", log.header.subject);
                        // By the robust formula, from the same numbers.
                        let across = triple(&log, &tree, at, "d") + triple(&log, &tree, at, "N") * cos_1;
                        apart += u32::from(round((eta * eta - across.length_squared()).sqrt() / eta) != printed);
                        refractions += 1;
                    }
                    "refract.direction" if name.form() != "bent" => {
                        let [d, n] = ["d", "N"].map(|symbol| triple(&log, &tree, at, symbol));
                        let refracted = d / number("η") - n * (number("cosφ_2") - number("cosφ_1") / number("η"));
                        assert_eq!(value, refracted.normalize().to_array().map(round));
                    }
                    "reflect.direction" if name.form() != "bent" => {
                        let [d, n] = ["d", "N"].map(|symbol| triple(&log, &tree, at, symbol));
                        let reflected = (d - n * 2.0 * d.dot(n)).normalize();
                        assert_eq!(value, reflected.to_array().map(round));
                        // Three components that err by half a thousandth each.
                        let length = DVec3::from_slice(value).length();
                        assert!((length - 1.0).abs() <= 0.0005 * 3.0_f64.sqrt() + 1e-12, "|R| = {length}");
                        reflections += 1;
                    }
                    _ => {}
                }
            }
        }
    }
    assert!(refractions >= 321 && reflections >= 321, "{refractions} refractions, {reflections} reflections");
    assert!(apart * 10 > refractions, "the formulas hardly differ: {apart} of {refractions}");
}

#[test]
fn a_reflected_direction_that_is_not_normalised_keeps_its_length_in_f64() {
    let scene = support::changed_scene("hall-of-mirrors", |file| file.tracing.max_depth = 40);
    let mut longest = 0;
    for pixel in support::grid(&scene, 8) {
        let log = record::pixel(&scene, pixel, Arithmetic::F64);
        let mut bounces = 0;
        for event in &log.events {
            let What::Note { name: Name::ReflectDirection, value } = event.what else { continue };
            bounces += 1;
            let length = DVec3::from_slice(value.components()).length();
            // A product, a difference and the error of N's length, each by a few roundings, for each bounce before.
            let bound = f64::from(bounces + 1) * 16.0 * f64::EPSILON;
            assert!((length - 1.0).abs() <= bound, "after {bounces} bounces |R| is 1 + {:e}", length - 1.0);
        }
        longest = longest.max(bounces);
    }
    assert!(longest >= 20, "{longest} bounces in a row");
}

/// The red result of a call of the program.
#[track_caller]
fn red(options: &[&str]) -> f64 {
    let log = prints(&[&["trace", "textbook", "--pixel", "160,120"], options].concat());
    let result: Json = serde_json::from_str(log.lines().rev().nth(1).expect("a result")).expect("JSON");
    result["result"]["color"][0].as_f64().expect("a number")
}

#[test]
fn both_results_by_hand() {
    assert_eq!(red(&["--arithmetic", "decimal:3"]), 394.134);
    assert_eq!(red(&["--arithmetic", "decimal:3", "--round-products"]), 394.024);
    assert_eq!(red(&["--arithmetic", "decimal:3", "--formulas", "robust"]), 394.134);
    let table = prints(&["textbook"]);
    assert!(table.contains("394.134") && table.contains("--round-products"), "{table}");
    assert!(table.contains("N_2·L_2 0.788, I_local-2 (red) 289.186, I_global (red) 394.024."), "{table}");
    let table: Json = serde_json::from_str(&prints(&["textbook", "--format", "json"])).expect("JSON");
    assert_eq!(table["result"]["strict_round_products"].as_f64(), Some(394.024));
    assert_eq!(table["result"]["strict"].as_f64(), Some(394.134));
}

#[test]
fn only_the_products_of_dot_products_are_rounded() {
    let mut checked = Checked::default();
    let mut plain = Checked::default();
    for name in builtin::names() {
        let scene = scene_in(name, HAND);
        for pixel in support::grid(&scene, 6) {
            checked.check(&record::pixel(&scene, pixel, Arithmetic::DecimalProducts(3)));
            // The same log read as one without rounded products has other dot products.
            let mut log = record::pixel(&scene, pixel, Arithmetic::DecimalProducts(3));
            log.header.tracing.round_products = false;
            plain.check(&log);
        }
    }
    checked.assert_nothing_wrong();
    assert!(plain.has_wrong(Name::ShadeNDotL) && plain.has_wrong(Name::SphereL2oc));
    assert!(!plain.has_wrong(Name::HitPoint) && !plain.has_wrong(Name::ShadeLocal));
}

#[test]
fn rounded_products_are_for_arithmetic_by_hand_only() {
    for arithmetic in ["f64", "f32", "perturbed:1", "printed"] {
        let call = ["trace", "textbook", "--pixel", "160,120", "--round-products", "--arithmetic", arithmetic];
        says(2, &call, "--round-products: only by hand, with --arithmetic decimal:N");
    }
}

#[test]
fn options_and_keys_win_over_what_the_formulas_imply() {
    let scene = |tracing: &str, options: &[&str]| {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("ball.json");
        let text = format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 9], "direction": [0, 0, -1]}},
                "objects": [{{"shape": {{"sphere": {{"center": [0, 0, 0], "radius": 1}}}}}}], "tracing": {tracing}}}"#
        );
        std::fs::write(&path, text).expect("a scene");
        let path = path.to_str().expect("UTF-8").to_owned();
        let log = prints(&[&["trace", &path, "--pixel", "160,120"], options].concat());
        let header: Json = serde_json::from_str(log.lines().next().expect("a header")).expect("JSON");
        let word = |key: &str| header["tracing"][key].as_str().unwrap_or("-").to_owned();
        [word("formulas"), word("sphere_method"), word("specular")].join(" ")
    };
    let hand = ["--arithmetic", "decimal:3"];
    let hand_and = |option: [&'static str; 2]| [hand, option].concat();
    assert_eq!(scene("{}", &[]), "- robust half_vector");
    assert_eq!(scene("{}", &hand), "notes geometric half_vector");
    assert_eq!(scene("{}", &["--formulas", "notes"]), "notes geometric half_vector");
    assert_eq!(scene("{}", &hand_and(["--formulas", "robust"])), "- robust half_vector");
    assert_eq!(scene("{}", &hand_and(["--sphere-method", "robust"])), "notes robust half_vector");
    assert_eq!(scene(r#"{"sphere_method": "robust"}"#, &hand), "notes robust half_vector");
    assert_eq!(scene(r#"{"formulas": "robust"}"#, &hand), "- robust half_vector");
    assert_eq!(scene(r#"{"formulas": "notes"}"#, &[]), "notes geometric half_vector");
    let key = r#"{"formulas": "notes", "specular": "reflection_vector"}"#;
    assert_eq!(scene(key, &["--specular", "half_vector_compensated"]), "notes geometric half_vector_compensated");
    assert_eq!(scene(key, &["--formulas", "robust", "--sphere-method", "geometric"]), "- geometric reflection_vector");
}

#[test]
fn wrong_words_are_answered_with_the_right_ones() {
    says(
        2,
        &["walk", "--formulas", "note"],
        "[possible values: robust, notes]\n\n  tip: a similar value exists: 'notes'",
    );
    says(2, &["walk", "--specular", "half"], "half_vector, reflection_vector, half_vector_compensated");
    says(2, &["walk", "--sphere-method", "geometrical"], "tip: a similar value exists: 'geometric'");
}

/// A shown scene reads back as the same scene in every arithmetic: what depends on the arithmetic isn't written out.
#[test]
fn a_shown_scene_is_the_same_by_hand() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("glass-and-mirror.json");
    std::fs::write(&path, prints(&["scene", "show", "glass-and-mirror"])).expect("a file");
    let path = path.to_str().expect("UTF-8");
    for arithmetic in ["f64", "decimal:3"] {
        let log = |scene: &str| prints(&["trace", scene, "--pixel", "100,100", "--arithmetic", arithmetic]);
        assert_eq!(log(path), log("glass-and-mirror"), "{arithmetic}");
    }
}

/// N, L and V with this angle between L and N, and V along N: R is twice as far from V as H is from N.
fn highlight(specular: Specular, degrees: f64) -> f64 {
    let shininess = 255.0;
    let (normal, view) = (DVec3::Z, DVec3::Z);
    let angle = degrees.to_radians();
    let light = DVec3::new(libm::sin(angle), 0.0, libm::cos(angle));
    let options = Options { specular, max_depth: 0, ..Options::DEFAULT };
    let mut scene = everything("highlight", [0.0, 0.0, 5.0], options);
    scene.objects.truncate(1);
    scene.objects[0].shape =
        raywalk::geometry::Shape::Plane(raywalk::geometry::shape::Plane::new([normal.x, normal.y, normal.z, 0.0]));
    scene.index = raywalk::scene::Index::new(&scene.objects);
    let material = &mut scene.materials[scene.objects[0].material];
    (material.ambient, material.diffuse, material.specular) = (DVec3::ZERO, DVec3::ZERO, DVec3::ONE);
    material.shininess = shininess;
    scene.lights.truncate(1);
    let kind = raywalk::scene::LightKind::Directional { travel: -light };
    scene.lights[0] = raywalk::scene::Light { kind, color: DVec3::ONE, attenuation: None, ..scene.lights[0].clone() };
    let log = record::ray(&scene, view * 5.0, -view, Arithmetic::F64);
    let local = |event: &raywalk::log::Event| match event.what {
        What::Note { name, value } if name.key() == "shade.local" => value.components().first().copied(),
        _ => None,
    };
    log.events.iter().find_map(local).expect("a local intensity")
}

#[test]
fn four_times_the_exponent_makes_up_for_the_half_angle() {
    let (r, h) = (highlight(Specular::ReflectionVector, 5.0), highlight(Specular::HalfVector, 5.0));
    let compensated = highlight(Specular::HalfVectorCompensated, 5.0);
    for (found, expected) in [(r, 0.378), (h, 0.784), (compensated, 0.379)] {
        assert!((found - expected).abs() < 5e-4, "{found} is not {expected}");
    }
    for degrees in [1.0_f64, 3.0, 7.0, 20.0, 60.0] {
        let half = libm::cos((degrees / 2.0).to_radians());
        let found = highlight(Specular::HalfVectorCompensated, degrees);
        let expected = libm::pow(half, 4.0 * 255.0);
        assert!((found - expected).abs() <= 1e-12 * expected, "{degrees}°: {found} is not {expected}");
    }
}

#[test]
fn reflected_light_can_be_scaled_by_the_specular_coefficient() {
    let scene = |scale: &str| {
        support::changed_scene("textbook", |file| {
            let tracing = format!(r#"{{"max_depth": 1, "sphere_method": "geometric", "reflected_scale": "{scale}"}}"#);
            file.tracing = serde_json::from_str(&tracing).expect("tracing");
        })
    };
    let red = |scene: &Scene| record::pixel_color(scene, [160, 120], Arithmetic::F64).x;
    assert!((red(&scene("specular")) - 335.418).abs() < 5e-4);
    assert!((red(&scene("weight")) - 393.054).abs() < 5e-4);
    // The ray depends on the weight: without one there is no ray, whatever the coefficient.
    let mut dull = scene("specular");
    dull.materials[0].weights.reflected = DVec3::ZERO;
    let log = record::pixel(&dull, [160, 120], Arithmetic::F64);
    assert!(!log.events.iter().any(|event| matches!(event.what, What::Note { name: Name::ReflectDirection, .. })));
    // A way of weights 0 is left out; that changes nothing.
    let mut black = scene("specular");
    black.materials[0].specular.y = 0.0;
    let skipped = record::pixel_color(&black, [160, 120], Arithmetic::F64);
    black.tracing.skip = raywalk::scene::Skip::NONE;
    assert_eq!(skipped, record::pixel_color(&black, [160, 120], Arithmetic::F64));
    assert_eq!(black.tracing.reflected_scale, ReflectedScale::Specular);
}

#[test]
fn the_notes_in_f64_show_the_same_picture_but_for_roundings() {
    for name in ["glass-and-mirror", "total-reflection", "figure-6"] {
        let (robust, notes) = (support::scene(name), scene_in(name, HAND));
        assert_eq!((notes.tracing.formulas, robust.tracing.formulas), (Formulas::Notes, Formulas::Robust));
        assert_eq!(notes.tracing.sphere_method, SphereMethod::Geometric);
        for pixel in support::grid(&robust, 9) {
            let [a, b] = [&robust, &notes].map(|scene| record::pixel_color(scene, pixel, Arithmetic::F64));
            assert!((a - b).abs().max_element() < 1e-6, "{name} {pixel:?}: {a} and {b}");
        }
    }
}
