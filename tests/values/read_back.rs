//! What a line shows is what was computed: the numbers put in, read back as a formula, give the shown result, as far as the
//! rounding of the shown numbers tells.
//!
//! Every number that is read stands for all that are rounded to it, and the formula is evaluated on these intervals.

use crate::intervals::{Part, agrees, read};
use crate::notations::{of_html, of_tex};
use crate::random_scenes;
use crate::support;
use glam::DVec3;
use proptest::prelude::*;
use raywalk::log::formula::QUANTILE;
use raywalk::log::{Decision, Log, Miss, SkipReason, Step, Tree, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::decided;
use raywalk::report::language::Language;
use raywalk::report::schematic::Stage;
use raywalk::report::solution::{Task, html, latex, markdown};
use raywalk::report::{Style, computation_in};
use raywalk::scene::builtin;
use raywalk::scene::file::schema::Formulas;
use serde_json::json;
use std::collections::BTreeMap;

#[test]
fn shown_lines_read_back() {
    let mut read = 0;
    for arithmetic in [Arithmetic::F64, Arithmetic::Decimal(3), Arithmetic::DecimalProducts(3), Arithmetic::F32] {
        for name in builtin::names() {
            let scene = support::scene(name);
            for pixel in support::grid(&scene, 4) {
                read += check(&record::pixel(&scene, pixel, arithmetic), arithmetic);
            }
        }
        for seed in 0..40 {
            let scene = random_scenes::scene(seed);
            for pixel in [[2, 2], [4, 3], [6, 5]] {
                read += check(&record::pixel(&scene, pixel, arithmetic), arithmetic);
            }
        }
    }
    assert!(read > 20_000, "{read} lines");
}

#[test]
fn the_issue_s_lines_are_bracketed() {
    let scene = support::scene("motion-blur");
    let log = record::pixel(&scene, [60, 40], Arithmetic::F64);
    let tree = Tree::of(&log.events);
    let lines: Vec<_> = (0..log.events.len())
        .filter_map(|event| computation_in(Language::English, &log, &tree, event, Style::default()))
        .filter_map(|computation| computation.substituted)
        .collect();
    assert!(!lines.iter().any(|line| line.contains("/1.000·10") || line.contains("⁻⁵²")), "{lines:#?}");
}

/// Where the products of dot products are rounded they are shown so: step 7 of the source text.
#[test]
fn rounded_products_are_shown() {
    let scene = support::scene_in("textbook", Arithmetic::DecimalProducts(3));
    let log = record::pixel(&scene, [160, 120], Arithmetic::DecimalProducts(3));
    let tree = Tree::of(&log.events);
    let lines = (0..log.events.len())
        .filter_map(|event| computation_in(Language::English, &log, &tree, event, Style::default()))
        .filter(|computation| computation.symbol == "N·L")
        .map(|computation| computation.line());
    let lines: Vec<_> = lines.collect();
    assert_eq!(lines[1], "N·L = 0.533 + 0.035 + 0.220 = 0.788");
}

#[test]
fn a_wrong_line_is_found() {
    for (line, result, is_right) in [
        ("9 − 178.024 + 13.244²", "6.379", true),
        ("9 − 178.024 + 13.244²", "6.579", false),
        ("9 − 25 + (5.000·10⁻⁵)²", "-16.000", true),
        ("-12/1.000·10⁻⁵", "-1.200·10⁶", false),
        ("-12/(1.000·10⁻⁵)", "-1.200·10⁶", true),
        ("√(4)·(1, 2, 3)", "(2, 4, 6)", true),
        ("√(4)·(1, 2, 3)", "(2, 4, 7)", false),
        ("|(3, 4, 0)|²", "25", true),
        ("min(1, 1/(0.500 + 0.100·2))", "1", true),
    ] {
        assert_eq!(agrees(line, result, '.', 0.0).unwrap_or(false), is_right, "{line} = {result}");
    }
}

/// The worked solutions put in the same numbers, in their own notations.
#[test]
fn worked_solutions_read_back() {
    let mut read = [0; 3];
    let scenes = builtin::names().map(support::scene).chain((0..20).map(random_scenes::scene));
    for scene in scenes {
        let log = record::pixel(&scene, support::middle(&scene), Arithmetic::F64);
        // What is written out in full takes long.
        if log.events.len() > 4000 {
            continue;
        }
        let tree = Tree::of(&log.events);
        for (language, mark) in [(Language::English, '.'), (Language::Spanish, ',')] {
            let stage = Stage { things: &[], upright: 1 };
            let task = Task { log: &log, tree: &tree, stage, language, style: Style::default() };
            let texts = [of_tex(&markdown(&task)), of_tex(&latex(&task)), of_html(&html(&task))];
            for (format, equations) in texts.iter().enumerate() {
                for (line, result) in equations {
                    let verdict = agrees(line, result, mark, 0.0);
                    assert_eq!(verdict, Ok(true), "{}, {format}: {line} = {result}", scene.name);
                    read[format] += 1;
                }
            }
        }
    }
    assert!(read.iter().all(|read| *read > 1000), "{read:?}");
}

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
                    let line = decided::line_in(Language::English, &log, &tree, event, Style::default());
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
                    let line = decided::line_in(Language::English, &log, &tree, event, Style::default());
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
    let keys = || tree.own_events(node).flat_map(|at| log.events[at].given.iter()).map(|(name, _)| name.key());
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
        let line = decided::line_in(Language::English, &log, &tree, miss, Style::default()).expect("a comparison");
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
    let line = |event| decided::line_in(Language::English, &log, &tree, event, Style::default());
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
                let line = || decided::line_in(Language::English, &log, &tree, event, Style::default());
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

/// By hand total reflection is told by the formula that is printed: that is the one whose rounded numbers decided.
#[test]
fn total_reflection_by_hand_is_told_by_the_printed_formula() {
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
                        let line = decided::line_in(Language::English, &log, &tree, event, Style::default());
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

/// Reads all lines of a log in both languages; how many there were.
fn check(log: &Log, arithmetic: Arithmetic) -> usize {
    // By hand a value was rounded before it was shown; in single precision it may have become zero.
    let rounding = match arithmetic {
        Arithmetic::Decimal(_) | Arithmetic::DecimalProducts(_) => 5.001e-4,
        Arithmetic::F32 => f64::from(f32::MIN_POSITIVE),
        _ => 0.0,
    };
    let tree = Tree::of(&log.events);
    let mut read = 0;
    for (language, mark) in [(Language::English, '.'), (Language::Spanish, ',')] {
        for event in 0..log.events.len() {
            for digits in [3, 1] {
                let Some(computation) = computation_in(language, log, &tree, event, Style { digits }) else { continue };
                let Some(line) = computation.substituted else { continue };
                // What is left out of a long sum can't be read, and quantiles have tests of their own.
                if line.contains('…') || line.starts_with(QUANTILE) {
                    continue;
                }
                let verdict = agrees(&line, &computation.result, mark, rounding);
                let place = || format!("{}, event {event}: {}", log.header.scene.name, computation.symbol);
                assert_eq!(verdict, Ok(true), "{}: {line} = {}", place(), computation.result);
                read += 1;
            }
        }
    }
    read
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, ..ProptestConfig::default() })]

    /// Surfaces on the sides of a checkerboard's cubes, or as near to one as the next numbers are.
    #[test]
    fn floors_are_those_of_the_shown_numbers(
        size in prop_oneof![(1..2000_u32).prop_map(|k| f64::from(k) / 1000.0), 0.01..3.0, (3..12_u32).prop_map(|k| 1.0 / f64::from(k))],
        cubes in -6..7_i32, steps in -2..3_i32, axis in 0..3_usize, tilt in prop_oneof![Just(0.0), -0.01..0.01],
    ) {
        let mut height = size * f64::from(cubes);
        for _ in 0..steps.abs() {
            height = if steps < 0 { height.next_down() } else { height.next_up() };
        }
        let mut plane = [tilt, tilt, tilt];
        plane[axis] = 1.0;
        let mut eye = [0.3, 0.7, 0.45];
        eye[axis] += height + 4.0;
        let mut target = [0.1, 0.2, 0.3];
        target[axis] = height;
        let text = format!(
            r#"{{"format": "raywalk-scene/1", "camera": {{"position": {eye:?}, "look_at": {target:?}, "up": [0.1, 1.7, 0.9], "resolution": [6, 4]}},
            "lights": [{{"point": {{"position": {eye:?}}}}}],
            "materials": {{"tiles": {{"diffuse": [1, 1, 1], "pattern": {{"checker": {{"a": [1, 1, 1], "b": [0, 0, 0], "size": {size:?}}}}}}}}},
            "objects": [{{"shape": {{"plane": {{"coefficients": [{}, {}, {}, {:?}]}}}}, "material": "tiles"}}]}}"#,
            plane[0], plane[1], plane[2], -height
        );
        let scene = support::scene_of(text.as_bytes(), "tiles");
        let read: usize = (0..4).map(|k| floors(&record::pixel(&scene, [k, k], Arithmetic::F64))).sum();
        prop_assert!(read >= 4 * 2 * 3 * 2, "{read}");
    }
}

#[test]
fn the_issue_s_floor_reads_back() {
    let scene = support::changed_scene("motion-blur", |file| {
        file.camera.resolution = [60, 45];
        file.tracing.formulas = Some(Formulas::Notes);
    });
    assert!(floors(&record::pixel(&scene, [53, 21], Arithmetic::F64)) > 20);
}

/// Reads all floors of a log, in exact arithmetic; how many there were.
#[track_caller]
fn floors(log: &Log) -> usize {
    let tree = Tree::of(&log.events);
    let mut read = 0;
    for (language, mark) in [(Language::English, '.'), (Language::Spanish, ',')] {
        for event in 0..log.events.len() {
            for digits in [3, 1, 12] {
                let Some(computation) = computation_in(language, log, &tree, event, Style { digits }) else { continue };
                let Some((before, inner)) = computation.substituted.as_ref().and_then(|line| line.split_once('⌊'))
                else {
                    continue;
                };
                let inner = inner.strip_suffix('⌋').expect("nothing behind it");
                let (above, below) = match inner.rsplit_once('/') {
                    Some((above, below)) => (decimals(above, mark), decimals(below, mark)),
                    None => (decimals(inner, mark), vec![(1, 0)]),
                };
                let results = decimals(&computation.result, mark);
                if before.is_empty() {
                    for (above, result) in above.iter().zip(&results) {
                        assert_eq!(
                            floor(*above, below[0]),
                            result.0,
                            "{} = {}",
                            computation.line(),
                            computation.result
                        );
                    }
                } else {
                    // σ − 2·⌊σ/2⌋, of whole numbers.
                    assert_eq!(above[0].0 - 2 * floor(above[0], below[0]), results[0].0, "{}", computation.line());
                }
                read += 1;
            }
        }
    }
    read
}

/// The numbers of a triple, or one, each with its digits and how many of them are decimals.
fn decimals(text: &str, mark: char) -> Vec<(i128, i32)> {
    let text = text.trim_matches(['(', ')']);
    let number = |text: &str| {
        let (mantissa, power) = text.trim().split_once("·10").unwrap_or((text.trim(), ""));
        let power: String = power
            .chars()
            .map(|c| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|digit| digit == c).map_or('-', |k| char::from(b'0' + k as u8)))
            .collect();
        let places = mantissa.split_once(mark).map_or(0, |(_, decimals)| decimals.len() as i32);
        let digits = mantissa.replace(mark, "").parse().expect("a number");
        (digits, places - power.parse::<i32>().unwrap_or(0))
    };
    text.split(if mark == ',' { ';' } else { ',' }).map(number).collect()
}

/// The floor of a quotient.
fn floor((above, places): (i128, i32), (below, of_below): (i128, i32)) -> i128 {
    let ten = |places: i32| 10_i128.pow(places.try_into().expect("not negative"));
    let most = places.max(of_below);
    // The smallest numbers here are above 10⁻²⁰ in size.
    (above * ten(most - places)).div_euclid(below * ten(most - of_below))
}
