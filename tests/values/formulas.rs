//! Every value of a log can be checked on paper: its formula text, evaluated on the values that the log holds, gives the
//! logged value to the last bit, in f64, in f32 and by hand.
//!
//! The book's own arithmetic (`printed`) is left out: it puts in numbers that don't follow from its formulas.

use crate::provoking_scenes::{Options, everything, straight_through};
use crate::random_scenes;
use crate::support;
use glam::DVec3;
use raywalk::geometry::shape::SphereMethod;
use raywalk::log::{Log, Name, Tree, Value, What};
use raywalk::probe::round_half_away;
use raywalk::record::{self, Arithmetic};
use raywalk::report::evaluate::{Within, evaluate_within, result};
use raywalk::scene::{Algorithm, Formulas, ReflectedScale, Scene, Skip, Specular, builtin};
use serde_json::json;
use std::collections::BTreeMap;

/// The decimals of the arithmetic by hand.
const DIGITS: u32 = 3;

const ARITHMETICS: [Arithmetic; 3] = [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(DIGITS)];

/// What only degenerate shapes and rays come to: an ellipsoid too small for the arithmetic, corner normals that cancel, a ray
/// along the plane of a triangle or polygon. Where they occur they are checked like all others.
const DEGENERATE: [Name; 4] = [Name::HitNormalFacing, Name::HitNormalFlat, Name::TriangleTInBox, Name::PolygonTInBox];

/// How often each formula must have been checked, in each arithmetic.
const ENOUGH: usize = 25;

/// Before the shapes, behind them, above, and inside some of them.
const EYES: [[f64; 3]; 10] = [
    [-0.7, 0.6, 1.0],
    [-0.2, 0.7, -1.2],
    [0.0, 0.6, 4.0],
    [0.3, 0.5, -3.0],
    [0.5, 4.0, 0.5],
    [-2.2, 0.0, 0.0],
    [1.7, -0.3, 0.0],
    [3.9, -0.4, 0.05],
    [2.9, 1.4, 0.3],
    [-3.55, 1.5, 0.2],
];

#[test]
fn every_formula_gives_the_logged_value() {
    for arithmetic in ARITHMETICS {
        let mut checked = Checked::default();
        // A new scene file is checked without code.
        for scene in builtin::names().map(support::scene).chain(scenes()) {
            for pixel in support::grid(&scene, 10) {
                checked.check(&record::pixel(&scene, pixel, arithmetic));
            }
        }
        // Every shape in all its variants, from all around and from inside.
        let shapes = support::scene_of(include_bytes!("../support/shapes.json"), "shapes");
        for eye in EYES.map(DVec3::from) {
            for k in 0..900 {
                let (around, up) = (f64::from(k) * 2.399_963, f64::from(k % 20) / 10.0 - 0.95);
                let across = (1.0 - up * up).sqrt();
                let direction = DVec3::new(across * libm::cos(around), up, across * libm::sin(around));
                checked.check(&record::ray(&shapes, eye, direction, arithmetic));
            }
        }
        // Area lights, blurred bounces, lens, shutter and motion.
        let effects = support::scene_of(include_bytes!("../support/effects.json"), "effects");
        for pixel in support::grid(&effects, 9) {
            checked.check(&record::pixel(&effects, pixel, arithmetic));
        }
        let text =
            include_str!("../../scenes/penumbra.json").replace("\"samples\": 9", r#""samples": {"min": 4, "max": 9}"#);
        let lamp = support::scene_of(text.as_bytes(), "lamp");
        for pixel in [[20, 110], [60, 100], [100, 100], [10, 60], [150, 110]] {
            checked.check(&record::pixel(&lamp, pixel, arithmetic));
        }
        // Coincident surfaces, and bounces by interpolated normals that run on the wrong side.
        let touching = support::scene_of(include_bytes!("../support/touching.json"), "touching");
        for pixel in support::grid(&touching, 24) {
            checked.check(&record::pixel(&touching, pixel, arithmetic));
        }
        for k in 0..40 {
            let eye = DVec3::new(2.0, 3.4, f64::from(k % 5) * 0.1);
            let direction = DVec3::new(1.0, -0.05 - f64::from(k) * 1e-4, 0.01);
            checked.check(&record::ray(&touching, eye, direction, arithmetic));
        }
        // Rays that all but touch: there f64 loses the difference by which they do.
        let grazed = support::scene_of(include_bytes!("../support/grazed.json"), "grazed");
        for (k, height) in (0..400).flat_map(|k| [1.0, -1.0].map(|side| (k, side))) {
            for column in [-6.0, -3.0, 0.0, 3.0] {
                let above = height * (1.0 + f64::from(k % 20 - 10) * 1e-17 * libm::exp10(f64::from(k / 40)));
                let eye = DVec3::new(column, above, 40.0);
                checked.check(&record::ray(&grazed, eye, DVec3::new(0.0, 0.0, -1.0), arithmetic));
            }
        }
        // Methods of sampling that no built-in scene has.
        // Their last samples are a power of two, or none.
        let statistical =
            |max: u32| json!({"statistical": {"confidence": 0.9, "tolerance": 0.3, "min": 4, "max": max}});
        let guided = json!({"guided": {"tolerance": 0.05, "min": 2, "max": 8}});
        for sampling in [json!({"shared": {"n": 2}}), statistical(16), statistical(11), guided] {
            for seed in 0..6 {
                let scene = random_scenes::sampled(seed, sampling.clone());
                for pixel in [[0, 0], [8, 0], [0, 6], [8, 6], [4, 3]] {
                    checked.check(&record::pixel(&scene, pixel, arithmetic));
                }
            }
        }
        for scene in straight_scenes() {
            for depth in 0..16 {
                let eye = DVec3::new(0.0, 0.0, 0.5 + 0.25 * f64::from(depth));
                checked.check(&record::ray(&scene, eye, DVec3::NEG_Z, arithmetic));
            }
        }
        checked.assert_done(arithmetic);
    }
}

#[test]
fn rays_along_a_triangle_have_formulas_too() {
    // Coordinates and steps that binary fractions don't have, so that rays meant to run in the plane run beside it.
    let coordinate = |k: u32| f64::from(k * k * 37 % 101) / 10.0;
    let corners: Vec<_> =
        (0..40).map(|k| [0, 1, 2].map(|corner| [0, 1, 2].map(|axis| coordinate(k * 9 + corner * 3 + axis)))).collect();
    let objects: Vec<_> = corners
        .iter()
        .map(|corners| format!("{{\"shape\": {{\"triangle\": {{\"vertices\": {corners:?}}}}}}}"))
        .collect();
    let text = format!(
        "{{\"format\": \"raywalk-scene/1\", \"camera\": {{\"position\": [0, 0, 9], \"direction\": [0, 0, -1]}}, \"objects\": [{}]}}",
        objects.join(", ")
    );
    let scene = support::scene_of(text.as_bytes(), "triangles");
    let mut checked = Checked::default();
    for corners in &corners {
        let [a, b, c] = corners.map(DVec3::from);
        for turn in 0..200 {
            let aim = a + (b - a) * 0.3 + (c - a) * (f64::from(turn % 7) / 10.0);
            let origin = aim + (b - c) * f64::from(turn / 7) / 10.0 + (a - b) * f64::from(turn % 11);
            // In f64 a quotient of rounding errors is taken with more digits, and stays in the box.
            for arithmetic in [Arithmetic::F64, Arithmetic::F32] {
                checked.check(&record::ray(&scene, origin, aim - origin, arithmetic));
            }
        }
    }
    assert!(checked.wrong.is_empty(), "{:#?}", checked.wrong);
    assert!(checked.counts.contains_key(&Name::TriangleTInBox), "{:#?}", checked.counts);
}

#[test]
fn a_wrong_value_is_found() {
    let scene = everything("wrong", [0.0, 1.0, 4.0], Options::DEFAULT);
    let log = record::pixel(&scene, [24, 16], Arithmetic::F64);
    let tree = Tree::of(&log.events);
    let mut wrong_values = 0;
    for (at, event) in log.events.iter().enumerate() {
        let What::Note { name, value } = event.what else { continue };
        for component in 0..value.components().len() {
            let mut log = log.clone();
            log.events[at].what = What::Note { name, value: one_ulp_up(value, component) };
            let verdict = verdict(&log, &tree, at, Arithmetic::F64);
            // A step more or less lies within the bound of what has twice the digits.
            let has_exact_formula = name.formula().is_some() && !is_bounded(name);
            assert_eq!(verdict.is_some_and(|verdict| verdict.is_err()), has_exact_formula, "{name:?}");
            wrong_values += 1;
        }
    }
    assert!(wrong_values > 500, "{wrong_values} values of {} events", log.events.len());
}

/// How many values of each name were checked, and what was wrong with the others.
#[derive(Default)]
pub struct Checked {
    counts: BTreeMap<Name, usize>,
    wrong: BTreeMap<Name, (usize, String)>,
}

impl Checked {
    pub fn check(&mut self, log: &Log) {
        let arithmetic: Arithmetic = log.header.arithmetic.parse().expect("a header names the arithmetic by its name");
        let tree = Tree::of(&log.events);
        if let Some(What::Result { color }) = log.events.last().map(|event| &event.what) {
            let brought = result(&log.events, &tree, 0);
            assert!(brought.is_some_and(|brought| brought.same_bits(&Value::Triple(*color))), "{brought:?} {color:?}");
        }
        for (at, event) in log.events.iter().enumerate() {
            let What::Note { name, .. } = event.what else { continue };
            match verdict(log, &tree, at, arithmetic) {
                Some(Ok(())) => *self.counts.entry(name).or_default() += 1,
                Some(Err(why)) => {
                    let subject = log.header.subject;
                    let first = || (0, format!("{}, {subject:?}, event {}: {why}", log.header.scene.name, event.at));
                    self.wrong.entry(name).or_insert_with(first).0 += 1;
                }
                None => {}
            }
        }
    }

    /// Whether a value of this name was wrong.
    pub fn has_wrong(&self, name: Name) -> bool {
        self.wrong.contains_key(&name)
    }

    #[track_caller]
    pub fn assert_nothing_wrong(&self) {
        assert!(self.wrong.is_empty(), "{:#?}\nright: {:#?}", self.wrong, self.counts);
    }

    #[track_caller]
    fn assert_done(&self, arithmetic: Arithmetic) {
        assert!(self.wrong.is_empty(), "{arithmetic}: {:#?}\nright: {:#?}", self.wrong, self.counts);
        let count = |name: Name| self.counts.get(&name).copied().unwrap_or(0);
        let is_f64 = arithmetic == Arithmetic::F64;
        // What has twice the digits is rare, and in f64 only. An input with a formula isn't noted.
        let is_asked = |name: &Name| !DEGENERATE.contains(name) && !is_bounded(*name) && *name != Name::PixelSide;
        // Sharp lobes are taken from the sine where an arithmetic has the digits for it, and from the cosine elsewhere.
        let is_other = |name: &Name| name.key().ends_with("_power") && name.form().ends_with("sine") != is_f64;
        let is_asked = |name: &Name| is_asked(name) && !is_other(name);
        let formulas = || Name::all().filter(|name| name.formula().is_some()).filter(is_asked);
        let doubled = || Name::all().filter(|name| is_bounded(*name));
        let never: Vec<_> = doubled().filter(|name| is_f64 && count(*name) == 0).collect();
        assert!(never.is_empty(), "never with twice the digits: {never:?}");
        let too_few: Vec<_> = formulas().filter(|name| count(*name) < ENOUGH).map(|name| (name, count(name))).collect();
        assert!(too_few.is_empty(), "{arithmetic}: checked less than {ENOUGH} times: {too_few:?}");
    }
}

/// Whether a quantity was computed with more digits than what the log holds of its operands.
pub fn is_bounded(name: Name) -> bool {
    name.form().starts_with("doubled")
}

/// Whether the formula of a noted quantity gives its value, or the bound for more digits holds; `None` if it has no formula.
pub fn verdict(log: &Log, tree: &Tree, at: usize, arithmetic: Arithmetic) -> Option<Result<(), String>> {
    let What::Note { name, value } = log.events[at].what else { return None };
    let verdict = evaluate_within(log, tree, at, name)?.and_then(|within| {
        let expected = Within { value: rounded(within.value, arithmetic), ..within };
        let difference = || format!("{name:?} is {value:?}, its formula gives {expected:?}");
        if expected.allows(&value) || is_a_step_away(expected.value, value, arithmetic) {
            Ok(())
        } else {
            Err(difference())
        }
    });
    Some(verdict)
}

fn rounded(value: Value, arithmetic: Arithmetic) -> Value {
    let round = |x: f64| match arithmetic {
        Arithmetic::F64 => x,
        Arithmetic::F32 => f64::from((x as f32).clamp(f32::MIN, f32::MAX)),
        Arithmetic::Decimal(digits) | Arithmetic::DecimalProducts(digits) => round_half_away(x, digits),
        Arithmetic::Perturbed(_) => x,
        Arithmetic::Printed => panic!("the book has values that no formula gives"),
    };
    match value {
        Value::Number(x) => Value::Number(round(x)),
        Value::Triple(triple) => Value::Triple(triple.map(round)),
    }
}

/// A perturbed value is the next one up or down.
fn is_a_step_away(expected: Value, value: Value, arithmetic: Arithmetic) -> bool {
    let (ours, theirs) = (expected.components(), value.components());
    let is_near = |k: usize| (ours[k].next_down()..=ours[k].next_up()).contains(&theirs[k]);
    matches!(arithmetic, Arithmetic::Perturbed(_)) && ours.len() == theirs.len() && (0..ours.len()).all(is_near)
}

/// The scenes in code: each option, and eyes outside and inside the balls.
fn scenes() -> Vec<Scene> {
    let default = Options::DEFAULT;
    let geometric = Options { sphere_method: SphereMethod::Geometric, ..default };
    let notes = Options { formulas: Formulas::Notes, ..geometric };
    let compensated = Options { specular: Specular::HalfVectorCompensated, ..default };
    let by_specular = Options { reflected_scale: ReflectedScale::Specular, ..default };
    let mirrored = Options { specular: Specular::ReflectionVector, ..default };
    let whitted = Options { algorithm: Algorithm::Whitted, max_depth: 3, ..default };
    let foley = Options { algorithm: Algorithm::Foley, max_depth: 3, ..geometric };
    let thorough = Options { skip: Skip::NONE, max_depth: 2, ..default };
    let outside = [0.0, 1.0, 4.0];
    vec![
        everything("robust", outside, default),
        everything("geometric", outside, geometric),
        everything("reflection vector", outside, mirrored),
        everything("reflection vector, at the milky ball", [2.25, 0.75, -3.0], mirrored),
        everything("whitted", outside, whitted),
        everything("notes", outside, notes),
        everything("notes, at the milky ball", [2.25, 0.75, -3.0], notes),
        everything("notes, in the glass", [0.0, 1.0, -5.25], notes),
        everything("compensated", outside, compensated),
        everything("compensated, at the milky ball", [2.25, 0.75, -3.0], compensated),
        everything("reflected light scaled by K_e", outside, by_specular),
        everything("foley", outside, foley),
        everything("nothing skipped", outside, thorough),
        sharp(everything("sharp", outside, default)),
        sharp(everything("sharp, at the milky ball", [2.25, 0.75, -3.0], mirrored)),
        sharp(everything("sharp, compensated", outside, compensated)),
        // In the glass, its centre ahead and behind.
        everything("in the glass", [0.0, 1.0, -2.75], default),
        everything("in the glass, leaving it", [0.0, 1.0, -5.25], default),
        everything("in the glass, leaving it, geometric", [0.0, 1.0, -5.25], geometric),
    ]
}

/// The scene with lobes so narrow that their power isn't taken from the cosine.
fn sharp(mut scene: Scene) -> Scene {
    scene.materials.iter_mut().for_each(|material| material.shininess = 4096.0);
    scene
}

fn straight_scenes() -> [Scene; 2] {
    let mirrored = Options { specular: Specular::ReflectionVector, ..Options::DEFAULT };
    [straight_through(Options::DEFAULT), straight_through(mirrored)]
}

fn one_ulp_up(value: Value, component: usize) -> Value {
    match value {
        Value::Number(x) => Value::Number(x.next_up()),
        Value::Triple(mut triple) => {
            triple[component] = triple[component].next_up();
            Value::Triple(triple)
        }
    }
}
