//! What is left out changes no picture: each rule by itself, all together and none give the same bits. What a cutoff loses is bounded.

use crate::support;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use raywalk::log::{Decision, Log, Name, SkipReason, Term, What};
use raywalk::record::{self, Arithmetic};
use raywalk::render::{Counter, Settings, render};
use raywalk::report::language::Language;
use raywalk::scene::{Ceilings, Color, Sampling, Scene, Skip, builtin};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::sync::atomic::AtomicBool;

/// The picture of a scene, and what was counted.
pub fn picture(scene: &Scene) -> (Vec<Color>, Counter) {
    let settings = Settings { threads: 2, counts_rays: true, ..Settings::whole(scene) };
    let rendered = render(scene, &settings, |_| (), &AtomicBool::new(false)).expect("a picture");
    (rendered.film.into_pixels(), rendered.counts.expect("counts"))
}

/// How often each rule left something out.
pub fn skipped(counter: &Counter) -> BTreeMap<&'static str, u64> {
    counter.statistics(0, Default::default(), 0).skipped
}

/// Asserts that no choice of rules changes a bit; says what all of them left out.
fn is_the_same_whatever_is_skipped(scene: &mut Scene) -> BTreeMap<&'static str, u64> {
    let mut with = |skip: Skip| {
        scene.tracing.skip = skip;
        picture(scene)
    };
    let (expected, nothing_skipped) = with(Skip::NONE);
    let bits = |pixels: &[Color]| pixels.iter().map(|color| color.to_array().map(f64::to_bits)).collect::<Vec<_>>();
    for rule in SkipReason::ALL {
        for skip in [Skip::ALL.without(rule), Skip::NONE.with(rule)] {
            let (found, counter) = with(skip);
            assert_eq!(bits(&found), bits(&expected), "{rule:?} {skip:?}");
            let is_off = !skip.has(rule) && rule != SkipReason::Behind;
            assert!(!is_off || skipped(&counter)[rule.word()] == 0, "{rule:?}");
        }
    }
    let (found, counter) = with(Skip::ALL);
    assert_eq!(bits(&found), bits(&expected));
    let without = skipped(&nothing_skipped);
    assert!(SkipReason::ALL.iter().all(|rule| *rule == SkipReason::Behind || without[rule.word()] == 0), "{without:?}");
    skipped(&counter)
}

#[test]
fn no_built_in_picture_shows_what_was_skipped() {
    let mut in_all = BTreeMap::new();
    for name in builtin::names() {
        let mut scene = support::changed_scene(name, |file| file.camera.resolution = [20, 15]);
        scene.sampling = Sampling::Center {};
        for (rule, count) in is_the_same_whatever_is_skipped(&mut scene) {
            *in_all.entry(rule).or_insert(0) += count;
        }
    }
    // The scenes have no cutoff, no filters that together let nothing through and no lights that nothing uses.
    for rule in SkipReason::ALL {
        let is_rare = matches!(
            rule,
            SkipReason::Cutoff
                | SkipReason::ZeroPath
                | SkipReason::ZeroLight
                | SkipReason::ZeroPathLocal
                | SkipReason::ZeroPathLight
        );
        assert!(is_rare || in_all[rule.word()] > 0, "{rule:?}: {in_all:?}");
    }
}

/// A number that a coefficient or a weight may be.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![3 => Just(0.0), 1 => Just(-0.0), 1 => Just(1.0), 3 => 0.0..1.0_f64, 1 => Just(1e-200)]
}

fn color() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![2 => Just([0.0; 3]), 3 => [number(), number(), number()]]
}

fn material() -> impl Strategy<Value = String> {
    let coefficients = [color(), color(), color(), color()];
    let pattern = prop::option::weighted(0.2, (color(), color()));
    let parts = (coefficients, [color(), color(), color()], 1.0..2.0_f64, 0.0..40.0_f64, pattern);
    parts.prop_map(|(k, weights, ior, n, pattern)| {
        let checker = |(a, b)| format!(r#""pattern": {{"checker": {{"a": {a:?}, "b": {b:?}, "size": 0.5}}}},"#);
        let pattern = pattern.map(checker).unwrap_or_default();
        format!(
            r#"{{"ambient": {:?}, "diffuse": {:?}, "specular": {:?}, "transmission": {:?}, "shininess": {n}, "ior": {ior}, {pattern}
                "weights": {{"local": {:?}, "reflected": {:?}, "transmitted": {:?}}}}}"#,
            k[0], k[1], k[2], k[3], weights[0], weights[1], weights[2]
        )
    })
}

/// A small scene of spheres before a wall.
pub fn small_scene() -> impl Strategy<Value = Scene> {
    let place = || [-2.0..2.0_f64, -2.0..2.0_f64, -2.0..2.0_f64];
    let sphere = (place(), 0.2..1.2_f64, 0..3_usize);
    let area = prop::option::weighted(0.2, 0.1..0.8_f64);
    let light = (place(), color(), area);
    let parts = (
        prop::collection::vec(material(), 3),
        prop::collection::vec(sphere, 1..5),
        prop::collection::vec(light, 0..3),
        color(),
        color(),
        prop::sample::select(vec!["recursive", "whitted", "foley"]),
    );
    parts.prop_map(|(materials, spheres, lights, ambient, background, algorithm)| {
        let mut text = String::new();
        let materials: Vec<_> = (0..).zip(materials).map(|(k, material)| format!(r#""m{k}": {material}"#)).collect();
        for (center, radius, material) in spheres {
            let shape = format!(r#"{{"sphere": {{"center": {center:?}, "radius": {radius}}}}}"#);
            let _ = write!(text, r#"{{"shape": {shape}, "material": "m{material}"}}, "#);
        }
        let lights: Vec<_> = (lights.iter().enumerate())
            .map(|(k, (place, color, area))| {
                let kind = match area {
                    None => format!(r#""point": {{"position": {place:?}}}"#),
                    Some(radius) => {
                        format!(r#""sphere": {{"center": {place:?}, "radius": {radius}}}, "samples": 2"#)
                    }
                };
                format!(r#"{{"name": "l{k}", {kind}, "color": {color:?}}}"#)
            })
            .collect();
        let text = format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 6], "direction": [0, 0, -1],
                "resolution": [9, 7]}}, "ambient": {ambient:?}, "background": {background:?}, "lights": [{}],
                "materials": {{{}}}, "objects": [{text}{{"shape": {{"plane": {{"coefficients": [0, 0, 1, 3]}}}},
                "material": "m0"}}], "tracing": {{"algorithm": "{algorithm}", "max_depth": 5}}}}"#,
            lights.join(", "),
            materials.join(", ")
        );
        support::scene_of(text.as_bytes(), "small")
    })
}

#[test]
fn no_random_picture_shows_what_was_skipped() {
    let mut in_all = BTreeMap::<_, u64>::new();
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    for _ in 0..150 {
        let mut scene = small_scene().new_tree(&mut runner).expect("a scene").current();
        for (rule, count) in is_the_same_whatever_is_skipped(&mut scene) {
            *in_all.entry(rule).or_default() += count;
        }
    }
    let seen = |rule: &SkipReason| *rule == SkipReason::Cutoff || in_all[rule.word()] > 0;
    assert!(SkipReason::ALL.iter().all(seen), "{in_all:?}");
}

/// Every set of rules on one scene, and a few of them on each of many.
#[test]
fn no_set_of_rules_changes_a_bit() {
    let bits = |scene: &Scene| {
        let (pixels, _) = picture(scene);
        pixels.iter().map(|color| color.to_array().map(f64::to_bits)).collect::<Vec<_>>()
    };
    let rules = SkipReason::ALL;
    let set = |mask: u64| {
        let chosen = (0..).zip(rules).filter(|(k, _)| mask >> k & 1 == 1);
        chosen.fold(Skip::NONE, |skip, (_, rule)| skip.with(rule))
    };
    let compares = |scene: &mut Scene, masks: &mut dyn Iterator<Item = u64>| {
        scene.tracing.skip = Skip::NONE;
        let expected = bits(scene);
        for mask in masks {
            scene.tracing.skip = set(mask);
            assert_eq!(bits(scene), expected, "{:?}", scene.tracing.skip);
        }
    };
    let mut scene = super::skipped_light::all_kinds();
    compares(&mut scene, &mut (0..1 << rules.len()));
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    for k in 0..60 {
        let mut scene = small_scene().new_tree(&mut runner).expect("a scene").current();
        compares(&mut scene, &mut (0..8).map(|at| raywalk::random::hash(k, at) % (1 << rules.len())));
    }
}

/// Asserts that a cutoff loses no more than is said, and says how much of the bound it was at most.
fn loses_no_more_than_is_said(scene: &mut Scene, cutoff: f64) -> f64 {
    scene.tracing.skip = Skip::ALL;
    scene.tracing.cutoff = 0.0;
    let (whole, _) = picture(scene);
    scene.tracing.cutoff = cutoff;
    scene.ceilings = Ceilings::of(scene);
    let (cut, counter) = picture(scene);
    let statistics = counter.statistics_of(scene.sampling.largest_share(), 0, Default::default(), 0);
    let Some(lost) = statistics.lost else {
        assert_eq!(statistics.skipped["cutoff"], 0);
        assert!(whole == cut);
        return 0.0;
    };
    let (largest, sum) = (Color::from(lost.largest.expect("a bound")), Color::from(lost.sum.expect("a bound")));
    let mut sum_of_losses = Color::ZERO;
    let mut part = 0.0_f64;
    for (whole, cut) in whole.iter().zip(&cut) {
        // Both pictures are rounded: by far less than this.
        let loss = *whole - *cut - *whole * 1e-14;
        assert!(loss.cmple(largest).all(), "{loss} is more than {largest}");
        sum_of_losses += loss;
        part = part.max((loss / largest.max(Color::splat(f64::MIN_POSITIVE))).max_element());
    }
    assert!(sum_of_losses.cmple(sum).all(), "{sum_of_losses} is more than {sum}");
    part
}

#[test]
fn cutoffs_lose_no_more_than_is_said() {
    let mut most = 0.0_f64;
    for name in builtin::names() {
        for (cutoff, sampling) in
            [(0.05, Sampling::Center {}), (0.3, Sampling::Regular { n: 2 }), (0.9, Sampling::Shared { n: 1 })]
        {
            let mut scene = support::changed_scene(name, |file| file.camera.resolution = [16, 12]);
            scene.sampling = sampling;
            most = most.max(loses_no_more_than_is_said(&mut scene, cutoff));
        }
    }
    // The bound is one, and not out of sight.
    assert!((0.05..=1.0).contains(&most), "{most}");
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    for _ in 0..150 {
        let mut scene = small_scene().new_tree(&mut runner).expect("a scene").current();
        loses_no_more_than_is_said(&mut scene, 0.4);
    }
}

/// A red and a blue glass before a wall without specular light, a mirror that shows nothing of itself, and a lamp behind the wall.
fn filters() -> Scene {
    let text = r#"{"format": "raywalk-scene/1",
        "camera": {"position": [0, 0, 5], "direction": [0, 0, -1], "resolution": [3, 3], "vertical_fov": 20},
        "lights": [{"name": "lamp", "point": {"position": [0, 0, 9]}}, {"name": "hidden", "point": {"position": [0, 0, -9]}}],
        "materials": {
            "red": {"diffuse": [0.1, 0, 0], "weights": {"local": 1, "transmitted": [0.9, 0, 0]}},
            "blue": {"diffuse": [0, 0, 0.1], "specular": [1, 1, 1], "weights": {"local": 0, "transmitted": [0, 0, 0.9]}}},
        "objects": [
            {"name": "front", "shape": {"plane": {"coefficients": [0, 0, 1, -1]}}, "material": "red"},
            {"name": "back", "shape": {"plane": {"coefficients": [0, 0, 1, 0]}}, "material": "blue"}]}"#;
    support::scene_of(text.as_bytes(), "filters")
}

fn marks(log: &Log) -> Vec<(Term, SkipReason)> {
    let mark = |event: &raywalk::log::Event| match event.what {
        What::Mark(Decision::Skipped { what, why }) => Some((what, why)),
        _ => None,
    };
    log.events.iter().filter_map(mark).collect()
}

#[test]
fn a_log_says_what_was_skipped_and_why() {
    let mut scene = filters();
    let found = marks(&record::pixel(&scene, [1, 1], Arithmetic::F64));
    let expected = [
        (Term::Specular, SkipReason::ZeroTerm),
        (Term::Shadow, SkipReason::Behind),
        (Term::Reflected, SkipReason::ZeroWeight),
        (Term::Local, SkipReason::ZeroLocal),
        (Term::Reflected, SkipReason::ZeroWeight),
        (Term::Transmitted, SkipReason::ZeroPath),
    ];
    assert_eq!(found, expected);
    scene.tracing.skip = Skip::NONE;
    let found = marks(&record::pixel(&scene, [1, 1], Arithmetic::F64));
    assert!(found.iter().all(|(_, why)| *why == SkipReason::Behind), "{found:?}");
}

#[test]
fn statistics_count_every_rule() {
    let (_, counter) = picture(&filters());
    let expected =
        [("behind", 9), ("blocked", 0), ("cutoff", 0), ("no_local_term", 0), ("zero_local", 9), ("zero_path", 9)];
    let counted = skipped(&counter);
    for (rule, count) in expected.into_iter().chain([("zero_term", 9), ("zero_weight", 18)]) {
        assert_eq!(counted[rule], count, "{rule}");
    }
    let json = serde_json::to_value(counter.statistics(0, Default::default(), 0)).expect("JSON");
    assert_eq!(json.get("lost"), None);
}

#[test]
fn a_log_says_what_a_cutoff_lost_at_the_most() {
    let mut scene = support::scene("hall-of-mirrors");
    scene.tracing.cutoff = 0.5;
    scene.ceilings = Ceilings::of(&scene);
    let [width, height] = scene.camera.resolution;
    let logs = (0..8).map(|k| record::pixel(&scene, [width * k / 8, height / 2], Arithmetic::Decimal(3)));
    let mut cutoffs = 0;
    for log in logs {
        for event in &log.events {
            let is_cutoff = matches!(event.what, What::Mark(Decision::Skipped { why: SkipReason::Cutoff, .. }));
            let bound = log.events.given(event).iter().find(|(name, _)| *name == Name::CutoffLoss);
            assert_eq!(is_cutoff, bound.is_some());
            cutoffs += usize::from(is_cutoff);
        }
        let text = raywalk::report::text::text(Language::English, &log, Default::default());
        let is_cut = text.contains("its weight is below the cutoff");
        assert_eq!(is_cut, text.contains("of the sample was lost"), "{text}");
    }
    assert!(cutoffs > 3, "{cutoffs}");
}

#[test]
fn a_bound_that_no_number_holds_is_left_out() {
    let mut scene = filters();
    scene.materials.iter_mut().for_each(|material| material.weights.transmitted.x = 1.5);
    scene.tracing.cutoff = 10.0;
    scene.ceilings = Ceilings::of(&scene);
    let (_, counter) = picture(&scene);
    let statistics = counter.statistics(0, Default::default(), 0);
    assert!(statistics.skipped["cutoff"] > 0);
    assert_eq!(serde_json::to_value(statistics.lost).expect("JSON"), serde_json::json!({}));
    assert!(statistics.to_string().contains("lost by cutoffs: no bound"));
}
