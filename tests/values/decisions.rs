//! What a decision was taken by is shown with its numbers, and holds for them.

use crate::intervals::{Part, agrees, read};
use crate::random_scenes;
use crate::support;
use glam::DVec3;
use raywalk::log::{Decision, Log, Miss, SkipReason, Step, Tree, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::Style;
use raywalk::report::language::Language;
use raywalk::report::{decided, notation};
use raywalk::scene::builtin;
use serde_json::json;
use std::collections::BTreeMap;

/// What a decision was taken by holds for the numbers that are shown.
#[test]
fn comparisons_hold() {
    let mut shown = 0;
    for arithmetic in [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(3), Arithmetic::Perturbed(3)] {
        let scenes = builtin::names().map(support::scene).chain((0..40).map(random_scenes::scene));
        for scene in scenes {
            for pixel in support::grid(&scene, 3) {
                let log = record::pixel(&scene, pixel, arithmetic);
                let tree = Tree::of(&log.events);
                for event in 0..log.events.len() {
                    for comparison in decided::comparisons(&log, &tree, event, Style::default()) {
                        assert!(comparison.relation.holds(comparison.values), "{comparison:?}");
                        shown += 1;
                    }
                    let line = notation::line(Language::English, &log, &tree, event, Style::default());
                    line.iter().flat_map(|line| line.split("; ")).for_each(|line| shown_holds(&scene.name, line));
                }
            }
        }
    }
    assert!(shown > 20_000, "{shown} comparisons");
}

/// Of spheres, cylinders and cones every decision has its numbers, but for one: that an end of the ray lies on the surface. No comparison of
/// the log tells that.
#[test]
fn round_bodies_decide_by_numbers() {
    let mut counts: BTreeMap<(&str, &str), usize> = BTreeMap::new();
    let mut at_an_end = 0;
    for arithmetic in [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(3), Arithmetic::Perturbed(3)] {
        let scenes = builtin::names().map(support::scene).chain((0..100).map(random_scenes::scene));
        for scene in scenes {
            for pixel in support::grid(&scene, 3) {
                let log = record::pixel(&scene, pixel, arithmetic);
                let tree = Tree::of(&log.events);
                for (event, mark) in log.events.iter().enumerate() {
                    let What::Mark(decision) = &mark.what else { continue };
                    let Some(body) = round_body(&log, &tree, event) else { continue };
                    let line = notation::line(Language::English, &log, &tree, event, Style::default());
                    let kind = match decision {
                        Decision::Miss { why: Miss::BeginsThere } => continue,
                        Decision::Miss { why: Miss::Beyond } if line.is_none() && arithmetic != Arithmetic::F64 => {
                            at_an_end += 1;
                            continue;
                        }
                        Decision::Hit => "hit",
                        Decision::Miss { .. } => "miss",
                        Decision::Outside | Decision::Inside => "side",
                        _ => continue,
                    };
                    let noted =
                        || tree.own_events(tree.owner(event)).map(|at| &log.events[at].what).collect::<Vec<_>>();
                    assert!(line.is_some(), "{} {pixel:?} {arithmetic:?}: {body}: {:#?}", scene.name, noted());
                    *counts.entry((body, kind)).or_default() += 1;
                }
            }
        }
    }
    assert!(counts.len() == 7 && counts.values().all(|count| *count > 1000), "{counts:?}");
    assert!(at_an_end < 20, "{at_an_end}");
}

/// The body whose test an event belongs to.
fn round_body(log: &Log, tree: &Tree, event: usize) -> Option<&'static str> {
    let node = tree.owner(event);
    let is_test = matches!(tree.nodes()[node].step, Some(Step::Test { .. }));
    let keys = || tree.own_events(node).flat_map(|at| log.given(at)).map(|(name, _)| name.key());
    let is_of = |body: &&str| keys().any(|key| key.split('.').next() == Some(body));
    is_test.then(|| ["sphere", "cylinder", "cone"].into_iter().find(is_of)).flatten()
}

/// Mathematics says what misses a cylinder and a cone: here by hand, for rays along the x axis.
#[test]
fn misses_beside_a_length_say_by_what() {
    let cylinder = json!({"cylinder": {"base": [0, 0, 0], "apex": [0, 0, 2], "radius": 1, "caps": true}});
    let tube = json!({"cylinder": {"base": [0, 0, 0], "apex": [0, 0, 2], "radius": 1, "caps": false}});
    // ρ = 1 − z: its tip is at z = 1, the other half of the double cone above.
    let cone =
        json!({"cone": {"base": [0, 0, 0], "base_radius": 1, "apex": [0, 0, 1], "apex_radius": 0, "caps": true}});
    for (shape, origin, direction, expected) in [
        // Over the cylinder: it crosses z = 2 at x = −2, where the ray has t = 3·√1.25, and the wall at x = ±1.
        (&cylinder, [-5.0, 0.0, 0.5], [2.0, 0.0, 1.0], "min(t_1, t_2) > max(t_b, t_a)"),
        (&cylinder, [-5.0, 0.0, -4.0], [2.0, 0.0, 1.0], "max(t_1, t_2) < min(t_b, t_a)"),
        (&cylinder, [-5.0, 0.0, 3.0], [1.0, 0.0, 0.0], "d_w = 0; o_w > l_w"),
        (&cylinder, [-5.0, 0.0, -3.0], [1.0, 0.0, 0.0], "d_w = 0; o_w < 0"),
        (&cylinder, [-5.0, 2.0, 1.0], [1.0, 0.0, 0.0], "Δ < 0"),
        // Through both open ends: at z = 0 and 2 the ray is inside.
        (&tube, [0.5, 0.0, -1.0], [-0.125, 0.0, 1.0], "min(t_1, t_2) < min(t_b, t_a); max(t_1, t_2) > max(t_b, t_a)"),
        (&cone, [-5.0, 0.0, 3.0], [1.0, 0.0, 0.0], "d_w = 0; o_w > l_w"),
        (&cone, [-5.0, 0.0, 1.0], [4.0, 0.0, 1.0], "ρ_o + ρ_d·(t_1 + t_2)/2 < 0"),
        // Steeper than the cone: from over the tip down beside it, so that it enters below the base.
        (&cone, [2.0, 0.0, 2.0], [0.125, 0.0, -1.0], "a < 0; ρ_d > 0; max(t_1, t_2) > max(t_b, t_a)"),
        (&cone, [2.0, 0.0, -2.0], [0.125, 0.0, 1.0], "a < 0; ρ_d ≤ 0; min(t_1, t_2) < min(t_b, t_a)"),
    ] {
        let scene = json!({
            "format": "raywalk-scene/1",
            "camera": {"position": [0, 0, 9], "direction": [0, 0, -1], "vertical_fov": 1, "resolution": [1, 1]},
            "materials": {"m": {}},
            "objects": [{"name": "body", "shape": shape, "material": "m"}],
            "tracing": {"max_depth": 0},
        });
        let scene = support::scene_of(scene.to_string().as_bytes(), "beside");
        let log = record::ray(&scene, DVec3::from_array(origin), DVec3::from_array(direction), Arithmetic::F64);
        let tree = Tree::of(&log.events);
        let is_miss = |event: &usize| log.events[*event].what == What::Mark(Decision::Miss { why: Miss::Beside });
        let miss = (0..log.events.len()).find(is_miss).unwrap_or_else(|| panic!("{expected}: {:?}", log.events));
        let found = decided::comparisons(&log, &tree, miss, Style::default());
        let line = notation::line(Language::English, &log, &tree, miss, Style::default()).expect("a comparison");
        let symbols: Vec<_> = line.split("; ").filter_map(|part| part.split(": ").next()).collect();
        assert_eq!(symbols.join("; "), expected, "{line}");
        assert!(found.iter().all(|comparison| comparison.relation.holds(comparison.values)), "{line}");
    }
}

/// `L2oc > r²: 178.024 > 9` holds for some of the numbers that round to those, and `1 − 0.5² = 0.750 > 0` comes to what it says.
fn shown_holds(scene: &str, line: &str) {
    const SIGNS: [&str; 5] = ["<", "≤", "≥", ">", "="];
    let (symbols, numbers) = line.split_once(": ").expect("symbols, then numbers");
    let numbers = numbers.trim_end_matches(" (with twice the digits)");
    let sign = SIGNS.into_iter().find(|sign| symbols.contains(sign)).expect("a sign");
    let (left, right) = numbers.split_once(sign).expect("two sides");
    let [left, right] = [left, right].map(|side| {
        let (put_in, value) = side.split_once(" = ").map_or((side, side), |(put_in, value)| (put_in, value));
        assert_eq!(agrees(put_in, value, '.', 0.0), Ok(true), "{scene}: {line}");
        match read(value, '.') {
            Ok(Part::Number(value)) => value,
            other => panic!("{scene}: {line}: no number: {other:?}"),
        }
    });
    let holds = match sign {
        "<" => left.low < right.high,
        "≤" => left.low <= right.high,
        "=" => left.low <= right.high && right.low <= left.high,
        "≥" => left.high >= right.low,
        _ => left.high > right.low,
    };
    assert!(holds, "{scene}: {line}");
}

#[test]
fn the_example_s_decisions_have_their_numbers() {
    let scene = support::scene("textbook");
    let log = record::pixel(&scene, [160, 120], Arithmetic::Decimal(3));
    let tree = Tree::of(&log.events);
    let line = |event| notation::line(Language::English, &log, &tree, event, Style::default());
    let lines: Vec<_> = (0..log.events.len()).filter_map(line).collect();
    for expected in ["L2oc > r²: 178.024 > 9", "T_A > 0: 13.244 > 0; T2_A ≥ 0: 6.380 ≥ 0; t > 0: 10.718 > 0"] {
        assert!(lines.iter().any(|line| line == expected), "{expected}: {lines:#?}");
    }
}

#[test]
fn total_reflection_and_lights_behind_have_their_numbers() {
    let mut found = [0; 2];
    for name in builtin::names() {
        let scene = support::scene(name);
        for pixel in support::grid(&scene, 8) {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            let tree = Tree::of(&log.events);
            for (event, mark) in log.events.iter().enumerate() {
                let line = || notation::line(Language::English, &log, &tree, event, Style::default());
                match &mark.what {
                    What::Mark(Decision::TotalInternalReflection) => {
                        let line = line().expect("a comparison");
                        assert!(line.starts_with("η² − |d + cosφ_1·N|² < 0: "), "{line}");
                        found[0] += 1;
                    }
                    What::Mark(Decision::Skipped { why: SkipReason::Behind, .. }) => {
                        assert!(line().is_some_and(|line| line.starts_with("N·L ")), "{name}");
                        found[1] += 1;
                    }
                    _ => {}
                }
            }
        }
    }
    assert!(found.iter().all(|found| *found > 10), "{found:?}");
}

/// By hand total reflection is decided by the formula that is printed: that is the one whose rounded numbers decided.
#[test]
fn total_reflection_by_hand_is_reported_by_the_printed_formula() {
    let mut found = 0;
    for digits in [2, 3] {
        let arithmetic = Arithmetic::Decimal(digits);
        for name in ["total-reflection", "glass-and-mirror", "refraction"] {
            let scene = support::scene_in(name, arithmetic);
            for pixel in support::grid(&scene, 16) {
                let log = record::pixel(&scene, pixel, arithmetic);
                let tree = Tree::of(&log.events);
                for (event, mark) in log.events.iter().enumerate() {
                    if mark.what == What::Mark(Decision::TotalInternalReflection) {
                        let line = notation::line(Language::English, &log, &tree, event, Style::default());
                        let line = line.expect("a comparison");
                        assert!(line.starts_with("1 − (1 − cosφ_1²)/η² < 0: "), "{line}");
                        // The left side comes to what it says.
                        assert!(line.contains("² = -") && line.ends_with(" < 0"), "{line}");
                        found += 1;
                    }
                }
            }
        }
    }
    assert!(found > 20, "{found}");
}
