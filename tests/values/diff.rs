//! Comparing logs: which step is which, where they part first, and why.

use crate::support;
use raywalk::log::{Event, Log, Name, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::diff::{
    Comparison, Difference, Entry, Format, Json, Numbering, Side, Statement, Summary, Text, Tolerance, Why, compare,
    header_differences, telling_apart,
};
use raywalk::report::side_by_side::Run;
use raywalk::scene::file::schema::SceneFile;
use serde_json::json;

const EXACT: Tolerance = Tolerance { digits: None, absolute: None, relative: None, is_of_common: false };
const BY_THREE: Tolerance = Tolerance { digits: Some(3), ..EXACT };

fn textbook(arithmetic: Arithmetic) -> Log {
    record::pixel(&support::scene("textbook"), [160, 120], arithmetic)
}

fn changed(name: &str, change: impl FnOnce(&mut SceneFile)) -> Log {
    let scene = support::changed_scene(name, change);
    record::pixel(&scene, support::middle(&scene), Arithmetic::F64)
}

/// Compares two logs, as `diff` does.
fn compared(a: &Log, b: &Log, tolerance: &Tolerance) -> Comparison {
    let mut b = b.clone();
    Numbering::unify(&a.header, &mut b.header).apply(&mut b.events);
    let (tree_a, tree_b) = (Tree::of(&a.events), Tree::of(&b.events));
    compare(Run { log: a, tree: &tree_a }, Run { log: &b, tree: &tree_b }, tolerance)
}

fn quantity(entry: &Entry) -> &str {
    match &entry.what {
        Statement::Value { name: Some(name), .. } => name.key(),
        Statement::Value { name: None, .. } => "result",
        Statement::Decision { .. } => "decision",
        Statement::Only { what, .. } => what,
    }
}

fn way(entries: &[Entry]) -> Vec<(&str, &str)> {
    entries.iter().map(|entry| (&*entry.path, quantity(entry))).collect()
}

/// The difference of a quantity in a ray.
#[track_caller]
fn found<'c>(comparison: &'c Comparison, path: &str, key: &str) -> &'c Difference {
    let is_it = |difference: &&Difference| difference.entry.path == path && quantity(&difference.entry) == key;
    comparison.differences.iter().find(is_it).unwrap_or_else(|| panic!("no difference of {key} in {path}"))
}

/// What comes from an object of another kind says so, and nothing comes from a decision of another object's test.
#[test]
fn steps_of_another_kind_of_shape_come_from_that_change() {
    let shape = |shape: serde_json::Value| serde_json::from_value(shape).expect("a shape");
    let wall = json!({"box": {"min": [3, -50, -50], "max": [4, 50, 50]}});
    let ball = json!({"box": {"min": [15, 7, 6], "max": [19, 11, 10]}});
    let tower = json!({"cylinder": {"base": [17, 9, 5], "apex": [17, 9, 11], "radius": 3, "caps": true}});
    let textbook = textbook(Arithmetic::F64);
    for (plane, sphere) in [(Some(&wall), Some(&ball)), (Some(&wall), None), (None, Some(&tower))] {
        let other = changed("textbook", |scene| {
            for (object, of) in [(0, plane), (1, sphere)] {
                if let Some(of) = of {
                    scene.objects[object].shape = shape(of.clone());
                }
            }
        });
        for [a, b] in [[&textbook, &other], [&other, &textbook]] {
            let comparison = compared(a, b, &EXACT);
            let kinds: Vec<_> = comparison.changed.iter().map(|changed| changed.input.clone()).collect();
            let expected = [("objects.plane", plane), ("objects.sphere", sphere)];
            let expected: Vec<_> = expected.into_iter().filter(|(_, of)| of.is_some()).map(|(name, _)| name).collect();
            assert_eq!(kinds, expected);
            for difference in &comparison.differences {
                let kind = difference.kind.as_ref().map(|kind| kind.input.clone());
                let is_alone = matches!(difference.entry.what, Statement::Only { .. });
                let of_test = difference.entry.node.strip_prefix("test ").filter(|_| is_alone);
                let of_test = of_test.map(|object| format!("objects.{object}"));
                // Every difference comes from one of the changes, and a step of a test that only one log has from that of its object.
                assert!(kind.is_some() && (of_test.is_none() || of_test == kind), "{difference:#?}");
                assert!(difference.why != Why::Itself && difference.why != Why::First, "{difference:#?}");
            }
            assert_eq!(comparison.first.expect("a difference").why, Why::OtherKind);
        }
    }
    // The point where the reflected ray hits the box is O + d·t in both logs: t alone moves it.
    let other = changed("textbook", |scene| scene.objects[1].shape = shape(ball.clone()));
    let comparison = compared(&textbook, &other, &EXACT);
    let point = found(&comparison, "C R", "hit.point");
    assert_eq!(point.why, Why::Operands);
    let from: Vec<_> = point.from.iter().map(|(entry, _)| quantity(entry).split(' ').next()).collect();
    assert_eq!(from, [Some("sphere.t")]);
    assert!(point.own < 1e-12 && (point.from[0].1 - 0.853).abs() < 1e-3, "{point:#?}");
}

#[test]
fn by_hand_the_length_is_the_first_to_differ_from_f64() {
    let found = compared(&textbook(Arithmetic::Decimal(3)), &textbook(Arithmetic::F64), &EXACT);
    let first = found.first.expect("a difference");
    assert_eq!(way(&first.way), [("C", "ray.length")]);
    assert_eq!(first.why, Why::Itself);
}

#[test]
fn with_three_digits_it_is_the_distance_of_the_plane_from_the_direction() {
    let found = compared(&textbook(Arithmetic::Decimal(3)), &textbook(Arithmetic::F64), &BY_THREE);
    let first = found.first.as_ref().expect("a difference");
    assert_eq!(way(&first.way), [("C", "plane.t"), ("C", "plane.v_d"), ("C", "ray.direction")]);
    assert_eq!(first.why, Why::Itself);
    let computations = first.computations.as_ref().expect("a quantity");
    assert_eq!(computations[0], "t = V_o/V_d = -12/(-0.946) = 12.685");
    assert_eq!(computations[1], "t = V_o/V_d = -12/(-0.9457) = 12.6886");
}

#[test]
fn the_difference_grows_on_its_way_to_the_color() {
    let found = compared(&textbook(Arithmetic::Decimal(3)), &textbook(Arithmetic::F64), &EXACT);
    let expected = [
        ("C", "ray.direction"),
        ("C", "reflect.direction"),
        ("C R", "sphere.t_a"),
        ("C R", "sphere.t2_a"),
        ("C R", "sphere.t"),
        ("C R", "hit.point"),
        ("C R", "hit.normal"),
        ("C R", "shade.n_dot_h"),
        ("C R", "shade.local"),
        ("C R", "combine.local"),
        ("C R", "combine.color"),
        ("C", "combine.reflected"),
        ("C", "combine.color"),
        ("", "result"),
    ];
    assert_eq!(way(&found.way), expected);
}

#[test]
fn the_views_of_the_numeric_example() {
    let (a, b) = (textbook(Arithmetic::Decimal(3)), textbook(Arithmetic::F64));
    let differences = header_differences(&a.header, &b.header);
    support::snapshots().bind(|| {
        for (name, tolerance) in [("diff_textbook", EXACT), ("diff_textbook_3_digits", BY_THREE)] {
            let found = compared(&a, &b, &tolerance);
            let mut summary = Summary::default();
            summary.add(None, &found);
            let mut text = Text::new(tolerance.digits, false);
            let shown = [text.begin(&a.header, &b.header, &differences), text.pixel(None, &found), text.end(&summary)];
            insta::assert_snapshot!(name, shown.concat());
        }
        let found = compared(&a, &b, &BY_THREE);
        let mut json = Json::new(true);
        let mut summary = Summary::default();
        summary.add(None, &found);
        let shown = [json.begin(&a.header, &b.header, &differences), json.pixel(None, &found), json.end(&summary)];
        let document: serde_json::Value = serde_json::from_str(&shown.concat()).expect("JSON");
        insta::assert_json_snapshot!("diff_textbook_json", document);
    });
}

/// A plane that becomes a box is tested by other steps: none of them comes from a decision that the test takes after it.
#[test]
fn no_cause_comes_after_its_effect() {
    let plane = textbook(Arithmetic::F64);
    let of_box = changed("textbook", |scene| {
        let shape = serde_json::json!({"box": {"min": [3, -50, -50], "max": [4, 50, 50]}});
        scene.objects[0].shape = serde_json::from_value(shape).expect("a box");
    });
    for (a, b) in [(&plane, &of_box), (&of_box, &plane)] {
        let found = compared(a, b, &EXACT);
        let mut inputs = 0;
        for Difference { entry, from, origin, why, .. } in &found.differences {
            let what = quantity(entry);
            if ["plane.normal", "plane.offset", "box.min", "box.max"].iter().any(|key| what.starts_with(key)) {
                assert_eq!((*why, from.len(), origin), (Why::OtherKind, 0, &None), "{what}");
                inputs += 1;
            }
            if ["plane.v_", "plane.t", "box.to_", "box.entry"].iter().any(|key| what.starts_with(key)) {
                assert_eq!(from.len(), 0, "{what} from {from:?}");
            }
            // That a box tells the side before it notes its distance doesn't matter: a plane tells none.
            if what.starts_with("box.t =") {
                assert_eq!((*why, from.len()), (Why::OtherKind, 0));
            }
        }
        assert_eq!(inputs, 8, "the test of the camera's ray and that of the shadow ray");
    }
}

#[test]
fn different_values_look_different() {
    let scene = |x: f64| changed("textbook", |scene| scene.camera.position[0] = x);
    let (a, b) = (scene(16.0), scene(16.000_000_000_000_004));
    let found = compared(&a, &b, &EXACT);
    let mut text = Text::new(None, false);
    let shown = text.pixel(None, &found);
    assert!(shown.contains("  camera.position: "), "{shown}");
    let mut values = 0;
    for Difference { entry, .. } in &found.differences {
        let Statement::Value { a, b, .. } = &entry.what else { continue };
        let style = telling_apart(a, b, None);
        let [a, b] = [a, b].map(|value| raywalk::report::Language::English.value(value, style));
        assert_ne!(a, b);
        assert!(shown.contains(&format!("{a}  ")) && shown.contains(&format!("{b}  ")), "{a}, {b}: {shown}");
        values += 1;
    }
    assert!(values > 20, "{values}");
}

#[test]
fn a_log_is_the_same_as_itself() {
    for name in ["textbook", "table-top", "penumbra", "motion-blur", "figure-19", "frosted-glass", "mesh"] {
        let log = changed(name, |_| ());
        let found = compared(&log, &log, &EXACT);
        assert_eq!(found.differences, [], "{name}");
        assert!(found.values > 10, "{name}: {} values", found.values);
    }
}

#[test]
fn every_changed_value_is_found_and_blamed_on_itself() {
    let a = changed("glass-and-mirror", |_| ());
    let mut checked = 0;
    for at in (0..a.events.len()).step_by(3) {
        let What::Note { name, value } = a.events[at].what else { continue };
        let mut b = a.clone();
        let value = match value {
            Value::Number(x) => Value::Number(x + 1.0),
            Value::Triple([x, y, z]) => Value::Triple([x, y, z + 1.0]),
        };
        b.events[at].what = What::Note { name, value };
        let found = compared(&a, &b, &EXACT);
        let first = &found.differences[0];
        assert_eq!(quantity(&first.entry), name.key());
        assert_eq!(first.origin, None, "{name:?}");
        // What is computed from it no longer fits it, and says so.
        assert!(found.differences[1..].iter().all(|difference| difference.why != Why::Input), "{name:?}");
        checked += 1;
    }
    assert!(checked > 20, "{checked} values");
}

#[test]
fn a_changed_input_of_the_scene_is_the_origin_of_what_follows() {
    let a = changed("textbook", |_| ());
    let b = changed("textbook", |scene| scene.background = [1.0, 2.0, 3.0]);
    assert_eq!(compared(&a, &b, &EXACT).differences, []);
    let b = changed("textbook", |scene| scene.ambient = [181.0, 160.0, 190.0]);
    let comparison = compared(&a, &b, &EXACT);
    let ambient = found(&comparison, "C", "light.ambient");
    assert_eq!((ambient.why, &ambient.origin), (Why::Input, &None));
    let result = found(&comparison, "", "result");
    assert_eq!(quantity(result.origin.as_ref().expect("an origin")), "light.ambient");
}

#[test]
fn a_test_that_only_one_log_has_shifts_nothing() {
    let a = changed("figure-6", |_| ());
    let mut b = a.clone();
    let tree = Tree::of(&b.events);
    let test = (0..tree.nodes().len()).find(|node| {
        let is_test = matches!(tree.nodes()[*node].step, Some(raywalk::log::Step::Test { .. }));
        is_test && tree.own_events(*node).count() > 3
    });
    let test = tree.nodes()[test.expect("a test")].events.clone();
    let values = b.events[test.clone()].iter().filter(|event| matches!(event.what, What::Note { .. })).count();
    b.events.drain(test);
    for (a, b, side) in [(&a, &b, Side::A), (&b, &a, Side::B)] {
        let alone: Vec<_> = compared(a, b, &EXACT).differences;
        let told: Vec<_> = alone.iter().map(|difference| &difference.entry.what).collect();
        let [Statement::Only { side: found, what, values: of_test }] = told[..] else { panic!("{told:#?}") };
        assert_eq!((*found, *of_test), (side, values));
        assert!(what.starts_with("test "), "{what}");
        assert_eq!(alone[0].why, Why::NotNeeded);
    }
}

#[test]
fn a_test_that_one_tracer_did_not_need_is_not_the_first_divergence() {
    let scene = support::scene("glass-and-mirror");
    let pixel = support::middle(&scene);
    let [a, b] = [Arithmetic::F64, Arithmetic::Decimal(4)].map(|arithmetic| record::pixel(&scene, pixel, arithmetic));
    let found = compared(&a, &b, &Tolerance { digits: Some(4), ..EXACT });
    let first = found.differences.iter().find(|difference| difference.why != Why::NotNeeded).expect("a difference");
    assert!(found.differences.iter().any(|difference| difference.why == Why::NotNeeded), "tests differ");
    assert_eq!(found.first.expect("a difference").way[0], first.entry);
}

#[test]
fn tests_in_another_order_are_the_same() {
    let a = changed("textbook", |scene| scene.tracing.max_depth = 0);
    let b = changed("textbook", |scene| {
        scene.tracing.max_depth = 0;
        scene.objects.reverse();
    });
    let objects = |log: &Log| {
        log.events.iter().find_map(|event: &Event| match event.what {
            What::Enter { step: raywalk::log::Step::Test { object, .. }, .. } => {
                Some(log.header.object(object).to_owned())
            }
            _ => None,
        })
    };
    assert_ne!(objects(&a), objects(&b), "the first test is another one");
    assert_eq!(compared(&a, &b, &EXACT).differences, []);
}

#[test]
fn a_ray_that_only_one_log_has_comes_from_the_depth_limit() {
    let (a, b) = (changed("textbook", |_| ()), changed("textbook", |scene| scene.tracing.max_depth = 0));
    let comparison = compared(&a, &b, &EXACT);
    let reflected = found(&comparison, "C R", "ray C R, reflected");
    assert_eq!(reflected.why, Why::Before);
    assert_eq!(quantity(&reflected.from[0].0), "depth limit: no reflected ray");
    let result = found(&comparison, "", "result");
    assert_eq!(quantity(result.origin.as_ref().expect("an origin")), "depth limit: no reflected ray");
    // Nothing in the other rays differs.
    let others = comparison.differences.iter().filter(|difference| difference.entry.path.starts_with("C S"));
    assert_eq!(others.count(), 0);
}

#[test]
fn a_decision_comes_from_the_value_that_decides() {
    let a = changed("textbook", |_| ());
    let text = raywalk::scene::builtin::text("textbook").expect("a scene").replace("[17, 9, 8]", "[17, 20, 8]");
    let moved = support::scene_of(text.as_bytes(), "textbook");
    let b = record::pixel(&moved, [160, 120], Arithmetic::F64);
    let comparison = compared(&a, &b, &EXACT);
    let decisions: Vec<_> = comparison
        .differences
        .iter()
        .filter(|difference| matches!(difference.entry.what, Statement::Decision { .. }))
        .map(|difference| (&*difference.entry.path, &*difference.entry.node, quantity(&difference.from[0].0)))
        .collect();
    assert_eq!(decisions, [("C R", "test sphere", "sphere.t2_a"), ("C R", "", "decision")]);
    let t = comparison.differences.iter().find(|difference| quantity(&difference.entry).starts_with("sphere.t = "));
    assert_eq!(t.map(|t| quantity(&t.from[0].0)), Some("decision"));
}

#[test]
fn two_pixels_are_compared_ray_by_ray() {
    let scene = support::scene("textbook");
    let [a, b] = [[160, 120], [161, 120]].map(|pixel| record::pixel(&scene, pixel, Arithmetic::F64));
    let notes = header_differences(&a.header, &b.header);
    assert_eq!(notes.iter().map(|note| note.field).collect::<Vec<_>>(), ["subject"]);
    let comparison = compared(&a, &b, &EXACT);
    // The middle pixel's ray is given, that of another one is computed; they are the same quantity.
    let vector = found(&comparison, "C", "ray.vector");
    assert!(matches!(vector.entry.what, Statement::Value { name: Some(Name::RayVector), .. }));
    let direction = found(&comparison, "C", "ray.direction");
    assert_eq!(quantity(direction.origin.as_ref().expect("an origin")), "ray.vector");
}
