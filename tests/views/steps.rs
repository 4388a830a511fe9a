//! Where the source text explains a value: its section, and in the numeric example the step of the calculation.

use crate::support;
use raywalk::log::{Log, Name, Tree, What};
use raywalk::record::{self, Arithmetic};
use raywalk::report::tag::{is_left_out, tag};
use raywalk::scene::builtin;
use std::collections::{BTreeMap, BTreeSet};

/// The steps of section 1.3, read off the source text: the ray's path, the step, the keys.
const STEPS: &[(&str, &str, &str)] = &[
    ("C", "1", "ray.length ray.direction"),
    ("C", "2", "plane.v_d plane.v_o plane.t"),
    ("C", "3", "hit.point"),
    ("C", "4", "hit.normal reflect.direction"),
    ("C R", "5a", "sphere.oc sphere.l2_oc"),
    ("C R", "5b", "sphere.t_a"),
    ("C R", "5d", "sphere.t2_a"),
    ("C R", "5e", "sphere.t"),
    ("C R", "5f", "hit.point"),
    ("C R", "5g", "hit.normal"),
    ("C R", "6", "light.vector light.distance light.direction view.direction half.sum half.length half.direction"),
    ("C R", "7", "shade.n_dot_l shade.n_dot_h shade.local"),
    ("C", "8", "view.direction light.vector light.distance light.direction half.sum half.length half.direction"),
    ("C", "8", "shade.n_dot_l shade.n_dot_h shade.local combine.local combine.reflected combine.color"),
];

/// The steps that a log's values are tagged with, by the ray's path and the quantity's key.
fn steps(log: &Log) -> BTreeMap<(String, String), String> {
    let tree = Tree::of(&log.events);
    let noted = |event: usize| match log.events[event].what {
        What::Note { name, .. } => Some((tree.path(tree.owner(event)), name.key().to_owned())),
        _ => None,
    };
    let step = |event: usize| {
        let tag = tag(log, &tree, event)?;
        let (_, step) = tag.split_once(" (")?;
        Some((noted(event)?, step.trim_end_matches(')').to_owned()))
    };
    (0..log.events.len()).filter_map(step).collect()
}

#[test]
fn the_numeric_example_has_the_steps_of_the_text() {
    let of_keys = |(path, step, keys): &(&str, &str, &str)| {
        let one = |key: &str| (((*path).to_owned(), key.to_owned()), (*step).to_owned());
        keys.split(' ').map(one).collect::<Vec<_>>()
    };
    let expected: BTreeMap<_, _> = STEPS.iter().flat_map(of_keys).collect();
    assert_eq!(expected.len(), 38);
    let scene = support::scene("textbook");
    for arithmetic in [Arithmetic::Decimal(3), Arithmetic::F64, Arithmetic::F32, Arithmetic::Printed] {
        assert_eq!(steps(&record::pixel(&scene, [160, 120], arithmetic)), expected, "{arithmetic}");
    }
    // Another pixel is another walk.
    assert_eq!(steps(&record::pixel(&scene, [159, 120], Arithmetic::F64)), BTreeMap::new());
}

/// The book tests the sphere by the reflected ray only, and takes it that light arrives.
#[test]
fn what_the_book_leaves_out_is_the_cameras_sphere_and_shadow_rays() {
    let log = record::pixel(&support::scene("textbook"), [160, 120], Arithmetic::F64);
    let tree = Tree::of(&log.events);
    let place = |event: usize| {
        let What::Note { name, .. } = log.events[event].what else { return None };
        let path = tree.path(tree.owner(event));
        Some(format!("{path} {}", name.key()))
    };
    let left_out: BTreeSet<_> =
        (0..log.events.len()).filter(|event| is_left_out(&log, &tree, *event)).filter_map(place).collect();
    // What is transmitted is nothing, and the sphere, at the depth limit, reflects nothing.
    let sums = [
        "C R combine.color",
        "C R combine.local",
        "C R combine.reflected",
        "C R combine.transmitted",
        "C combine.transmitted",
    ];
    let tests = [
        "C R S1 plane.t",
        "C R S1 plane.v_d",
        "C R S1 plane.v_o",
        "C S1 sphere.l2_oc",
        "C S1 sphere.oc",
        "C S1 sphere.t2_a",
        "C S1 sphere.t_a",
    ];
    let camera = ["C sphere.l2_oc", "C sphere.oc", "C sphere.t2_a", "C sphere.t_a"];
    let expected: BTreeSet<_> = [sums.as_slice(), &tests, &camera].concat().into_iter().map(str::to_owned).collect();
    assert_eq!(left_out, expected);
}

#[test]
fn other_walks_have_sections_only() {
    for scene in builtin::names().filter(|name| *name != "textbook").map(support::scene) {
        for pixel in support::grid(&scene, 6) {
            let log = record::pixel(&scene, pixel, Arithmetic::F64);
            assert_eq!(steps(&log), BTreeMap::new(), "{}", log.header.scene.name);
        }
    }
    let text = builtin::text("textbook").expect("a scene");
    for (there, other) in [("[17, 9, 8]", "[17, 9, 7]"), ("[9, 12, 16]", "[9, 12, 17]"), ("[16, 2, 7]", "[16, 2, 8]")] {
        let changed = text.replace(there, other);
        assert_ne!(changed, text);
        let scene = support::scene_of(changed.as_bytes(), "textbook");
        let log = record::pixel(&scene, [160, 120], Arithmetic::F64);
        assert_eq!(steps(&log), BTreeMap::new(), "{other}");
        let tree = Tree::of(&log.events);
        assert!((0..log.events.len()).any(|event| tag(&log, &tree, event).as_deref() == Some("1.3")));
    }
}

/// Section 1.3 has a plane and a sphere; of other shapes, of how a pixel becomes a ray, and of bounds, the text has no formula.
#[test]
fn what_the_text_has_no_formula_for_has_no_section() {
    let without = ["ellipsoid.", "quadratic.", "triangle.", "polygon.", "box.", "axis.", "cylinder.", "cone.", "disk."];
    for name in Name::all() {
        let has_none = without.iter().any(|shape| name.key().starts_with(shape));
        assert!(!has_none || name.section().is_empty(), "{name:?}");
        let section = name.section();
        assert!(
            section.is_empty() || section.split('.').all(|part| part.parse::<u32>().is_ok()),
            "{name:?}: {section}"
        );
    }
    assert_eq!([Name::SphereT2a, Name::PlaneT, Name::HitPoint].map(Name::section), ["1.3"; 3]);
}
