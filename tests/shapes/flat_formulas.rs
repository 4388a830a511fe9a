//! The formulas of the flat shapes, evaluated on the values that the log holds, give the logged values to the last bit.
//!
//! The scene has each flat shape from its front and its back, with and without normals at its corners.

use crate::support;
use raywalk::log::{Decision, Log, Name, Term, Tree, Value, What};
use raywalk::probe::round_half_away;
use raywalk::record::{self, Arithmetic};
use raywalk::report::evaluate::evaluate;
use std::collections::BTreeMap;

const SCENE: &str = r#"{
  "format": "raywalk-scene/1",
  "camera": {"position": [0.1, 2.2, 9.3], "direction": [0.03, -0.2, -1], "vertical_fov": 60, "resolution": [64, 48]},
  "ambient": [0.2, 0.2, 0.3],
  "background": [0.3, 0.4, 0.5],
  "lights": [
    {"name": "near", "point": {"position": [3.5, 6, 5]}, "color": [0.9, 0.8, 0.7]},
    {"name": "sun", "directional": {"direction": [-0.3, -1, -0.4]}, "color": [0.4, 0.4, 0.2]},
    {"name": "behind", "point": {"position": [-1, 3, -7]}, "color": [0.5, 0.4, 0.7]}
  ],
  "materials": {
    "mirror": {"diffuse": [0.7, 0.5, 0.4], "specular": [0.3, 0.6, 0.2], "shininess": 9,
               "weights": {"local": 0.8, "reflected": 0.4, "transmitted": 0}},
    "glass": {"diffuse": [0.1, 0.1, 0.2], "specular": [0.5, 0.5, 0.5], "shininess": 30, "ior": 1.5,
              "transmission": [0.5, 0.5, 0.6], "weights": {"local": 0.3, "reflected": 0.2, "transmitted": 0.8}}
  },
  "objects": [
    {"name": "floor", "material": "mirror",
     "shape": {"polygon": {"vertices": [[-6, 0, 6], [6, 0, 6], [2, 0, 0], [6, 0, -6], [-6, 0, -6]]}}},
    {"name": "sheet", "material": "glass",
     "shape": {"triangle": {"vertices": [[-4, 0.5, 1], [-1.5, 0.4, 2], [-3, 3.1, 0.5]]}}},
    {"name": "bent sheet", "material": "glass",
     "shape": {"triangle": {"vertices": [[1, 2.3, 1], [3.5, 2.2, 0.5], [2, 4.1, 0.2]],
               "normals": [[-1.5, -0.2, 1], [1.5, -0.2, 1], [0, 1.5, 1]]}}},
    {"name": "arrow", "material": "mirror",
     "shape": {"polygon": {"vertices": [[-2.5, 2.5, -2], [0.5, 2.5, -2.1], [-1.5, 3.5, -2.07], [-2.5, 5.5, -2.1]],
               "normals": [[-1, -1, 1], [2, -0.2, 0.6], [0.1, 0.1, 0.9], [-0.3, 2, 1]]}}},
    {"name": "back", "material": "mirror",
     "shape": {"triangle": {"vertices": [[-1, 2.3, 1], [-1.2, 3.8, 0.2], [0.6, 2.2, 0.5]],
               "normals": [[1.5, -0.2, -1], [-1.5, -0.2, -1], [0, 1.5, -1]]}}},
    {"name": "reverse", "material": "glass",
     "shape": {"triangle": {"vertices": [[-4.5, 2.1, 0], [-3.5, 4.4, 0.3], [-2.6, 2.2, 0.2]]}}},
    {"name": "back wall", "material": "mirror",
     "shape": {"polygon": {"vertices": [[-9, -2, -8], [-9, 9, -8.5], [9, 9, -8.5], [9, -2, -8]]}}},
    {"name": "crate", "material": "glass", "shape": {"box": {"min": [0.5, 0.1, -1], "max": [2.25, 1.6, 1.5]}}},
    {"name": "lid", "material": "mirror",
     "shape": {"disk": {"center": [-0.8, 0.9, 2.5], "normal": [0.2, 0.3, 1.1], "radius": 0.7}}},
    {"name": "coin", "material": "glass",
     "shape": {"disk": {"center": [3.6, 1.1, 2.5], "normal": [0.2, 0.3, -1.1], "radius": 0.9}}}
  ],
  "tracing": {"max_depth": 3}
}"#;

const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(3)];

/// The keys of flat shapes.
const FLAT: [&str; 4] = ["triangle.", "polygon.", "box.", "disk."];

#[test]
fn every_formula_of_a_flat_shape_gives_the_logged_value() {
    let scene = support::scene_of(SCENE.as_bytes(), "flat");
    for arithmetic in ARITHMETICS {
        let mut counts: BTreeMap<Name, usize> = BTreeMap::new();
        let mut leaks: BTreeMap<&str, usize> = BTreeMap::new();
        for pixel in support::grid(&scene, 32) {
            let log = record::pixel(&scene, pixel, arithmetic);
            check(&log, arithmetic, &mut counts);
            for event in &log.events {
                if let What::Mark(Decision::LeakGuard { what } | Decision::Bent { what }) = event.what {
                    *leaks.entry(what.word()).or_default() += 1;
                }
            }
        }
        let is_flat = |name: &Name| {
            FLAT.iter().any(|key| name.key().starts_with(key) || name.form().starts_with(&key[..key.len() - 1]))
                || name.form().starts_with("mean")
        };
        // Only rays along its plane come to a t kept in the box, and few ask for twice the digits (`tests/values/formulas.rs` does).
        let is_common = |name: &Name| name.formula().is_some() && !["in_box", "doubled"].contains(&name.form());
        let with_formula = || Name::all().filter(is_flat).filter(is_common);
        let unchecked: Vec<_> = with_formula().filter(|name| counts.get(name).is_none_or(|count| *count < 5)).collect();
        assert!(with_formula().count() > 25 && unchecked.is_empty(), "{arithmetic}: not checked: {unchecked:?}");
        for what in [Term::Shadow, Term::Reflected] {
            assert!(leaks.contains_key(what.word()), "{arithmetic}: {what:?} never ran on the wrong side: {leaks:?}");
        }
    }
}

fn check(log: &Log, arithmetic: Arithmetic, counts: &mut BTreeMap<Name, usize>) {
    let tree = Tree::of(&log.events);
    for (at, event) in log.events.iter().enumerate() {
        let What::Note { name, value } = event.what else { continue };
        assert!(value.components().iter().all(|x| x.is_finite()), "{name:?} is {value:?}");
        let Some(evaluated) = evaluate(log, &tree, at, name) else { continue };
        let exact = evaluated.unwrap_or_else(|why| panic!("{:?}, {name:?}: {why}", log.header.subject));
        let expected = rounded(exact, arithmetic);
        let subject = log.header.subject;
        assert!(expected.same_bits(&value), "{arithmetic} {subject:?} {name:?} is {value:?}, its formula {expected:?}");
        *counts.entry(name).or_default() += 1;
    }
}

fn rounded(value: Value, arithmetic: Arithmetic) -> Value {
    let round = |x: f64| match arithmetic {
        Arithmetic::F32 => f64::from((x as f32).clamp(f32::MIN, f32::MAX)),
        Arithmetic::Decimal(digits) => round_half_away(x, digits),
        _ => x,
    };
    match value {
        Value::Number(x) => Value::Number(round(x)),
        Value::Triple(triple) => Value::Triple(triple.map(round)),
    }
}
