//! An interpolated normal can't let light through a surface: what it sends to the other side is traced, counted and black.

use crate::support::scene_of;
use raywalk::log::file::{read, to_ndjson};
use raywalk::log::{Decision, Event, Events, Name, RayKind, Step, Term, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::Scene;

/// A triangle in the plane z = 0, seen from above along −z with this tilt, under one light and between two coloured walls.
fn scene(normals: &str, direction: [f64; 3], light: [f64; 3], material: &str) -> Scene {
    let position = direction.map(|component| -3.0 * component);
    let text = format!(
        r#"{{
          "format": "raywalk-scene/1",
          "camera": {{"position": {position:?}, "direction": {direction:?}, "up": [0, 1, 0.1], "resolution": [5, 5]}},
          "ambient": [0.25, 0.5, 0.125], "background": [1, 1, 1],
          "lights": [{{"name": "lamp", "point": {{"position": {light:?}}}}}],
          "materials": {{"sheet": {{"ambient": [1, 1, 1], "diffuse": [1, 1, 1], {material}}}}},
          "objects": [{{"name": "sheet", "material": "sheet",
            "shape": {{"triangle": {{"vertices": [[-2, -2, 0], [2, -2, 0], [0, 3, 0]]{normals}}}}}}}]
        }}"#
    );
    scene_of(text.as_bytes(), "sheet")
}

const LOCAL: &str = r#""weights": {"local": 1, "reflected": 0, "transmitted": 0}"#;
const MIRROR: &str = r#""weights": {"local": 0, "reflected": 1, "transmitted": 0}"#;
const GLASS: &str = r#""ior": 1.5, "weights": {"local": 0, "reflected": 0, "transmitted": 1}"#;

const TILTED: &str = r#", "normals": [[2, 0, 1], [2, 0, 1], [2, 0, 1]]"#;
const UPRIGHT: &str = r#", "normals": [[0, 0, 1], [0, 0, 3], [0, 0, 0.2]]"#;

fn events(scene: &Scene) -> (Events, [f64; 3]) {
    let log = record::pixel(scene, [2, 2], Arithmetic::F64);
    let Some(What::Result { color }) = log.events.last().map(|event| event.what.clone()) else {
        panic!("a log ends with the result");
    };
    (log.events, color)
}

fn leaks(events: &[Event]) -> Vec<Term> {
    let leak = |event: &Event| match event.what {
        What::Mark(Decision::LeakGuard { what }) => Some(what),
        _ => None,
    };
    events.iter().filter_map(leak).collect()
}

fn rays(events: &[Event], is_meant: impl Fn(RayKind) -> bool) -> usize {
    let is_ray = |event: &&Event| match event.what {
        What::Enter { step: Step::Ray { kind, .. }, .. } => is_meant(kind),
        _ => false,
    };
    events.iter().filter(is_ray).count()
}

#[test]
fn a_light_behind_the_surface_brings_nothing() {
    // The tilted normal sees the light, which is below the plane.
    let (events, color) = events(&scene(TILTED, [0.0, 0.0, -1.0], [5.0, 0.0, -1.0], LOCAL));
    assert_eq!(leaks(&events), [Term::Shadow]);
    assert_eq!(rays(&events, |kind| matches!(kind, RayKind::Shadow { .. })), 1);
    assert_eq!(color, [0.25, 0.5, 0.125]);
    let darkness = |event: &Event| match event.what {
        What::Note { name: Name::ShadowTransmittance, value } => Some(value),
        _ => None,
    };
    assert_eq!(events.iter().find_map(darkness), Some(Value::Triple([0.0; 3])));
}

#[test]
fn a_light_before_the_surface_counts_by_the_interpolated_normal() {
    let (events, color) = events(&scene(TILTED, [0.0, 0.0, -1.0], [5.0, 0.0, 1.0], LOCAL));
    assert_eq!(leaks(&events), []);
    assert!(color[0] > 1.0, "{color:?}");
}

/// The directions that were bent, with what they became.
fn bent(events: &[Event]) -> Vec<(Term, [f64; 3])> {
    let is_bent = |event: &Event| match event.what {
        What::Mark(Decision::Bent { what }) => Some(what),
        _ => None,
    };
    let direction = |event: &Event| match event.what {
        What::Note { name: Name::ReflectDirectionBent | Name::RefractDirectionBent, value: Value::Triple(value) } => {
            Some(value)
        }
        _ => None,
    };
    events.iter().filter_map(is_bent).zip(events.iter().filter_map(direction)).collect()
}

#[test]
fn a_reflection_under_the_surface_is_bent_along_it() {
    // −z on a normal tilted by more than 45° goes on downward, to (0.8, 0, −0.6).
    let (events, color) = events(&scene(TILTED, [0.0, 0.0, -1.0], [5.0, 0.0, 1.0], MIRROR));
    assert_eq!(leaks(&events), []);
    assert_eq!(bent(&events), [(Term::Reflected, [1.0, 0.0, 0.0])]);
    assert_eq!(rays(&events, |kind| kind == RayKind::Reflected), 1);
    assert_eq!(color, [1.0; 3]);
}

#[test]
fn a_transmission_that_stays_above_is_bent_along_the_surface() {
    // Nearly along the surface into a thinner medium: the direction turns away from the inverted normal, and upward.
    let against = r#", "normals": [[-2, 0, 1], [-2, 0, 1], [-2, 0, 1]]"#;
    let thinner = r#""ior": 0.8, "weights": {"local": 0, "reflected": 0, "transmitted": 1}"#;
    let (events, color) = events(&scene(against, [1.0, 0.0, -0.05], [5.0, 0.0, 1.0], thinner));
    assert_eq!(leaks(&events), []);
    assert_eq!(bent(&events), [(Term::Transmitted, [1.0, 0.0, 0.0])]);
    assert_eq!(rays(&events, |kind| kind == RayKind::Transmitted), 1);
    assert_eq!(color, [1.0; 3]);
}

#[test]
fn a_log_holds_the_mark() {
    for (light, material, mark) in [
        ([5.0, 0.0, 1.0], MIRROR, r#""mark":{"bent":{"what":"reflected"}}"#),
        ([5.0, 0.0, -1.0], LOCAL, r#""mark":{"leak_guard":{"what":"shadow"}}"#),
    ] {
        let log = record::pixel(&scene(TILTED, [0.0, 0.0, -1.0], light, material), [2, 2], Arithmetic::F64);
        let bytes = to_ndjson(&log).expect("memory can be written to");
        assert!(String::from_utf8_lossy(&bytes).contains(mark), "{mark}");
        assert_eq!(read(&bytes).expect("a log").log.events, log.events);
    }
}

#[test]
fn equal_normals_change_no_bit() {
    for material in [LOCAL, MIRROR, GLASS] {
        for direction in [[0.0, 0.0, -1.0], [1.0, 0.5, -0.001]] {
            for light in [[5.0, 0.0, 1.0], [5.0, 0.0, -1.0], [3.0, 1.0, 0.0]] {
                let (events_flat, flat) = events(&scene("", direction, light, material));
                let (events_smooth, smooth) = events(&scene(UPRIGHT, direction, light, material));
                assert_eq!(flat.map(f64::to_bits), smooth.map(f64::to_bits));
                assert_eq!((leaks(&events_flat), leaks(&events_smooth)), (vec![], vec![]));
            }
        }
    }
}
