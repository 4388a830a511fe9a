//! Every value of a log can be checked on paper: its formula text, evaluated on the values that the log holds, gives the
//! logged value to the last bit, in f64, in f32 and by hand.
//!
//! The book's own arithmetic (`printed`) is left out: it puts in numbers that don't follow from its formulas.

use crate::provoking_scenes::{Options, everything, straight_through};
use crate::support;
use glam::DVec3;
use raywalk::geometry::shape::SphereMethod;
use raywalk::log::{Log, Name, Tree, Value, What};
use raywalk::probe::round_half_away;
use raywalk::record::{self, Arithmetic};
use raywalk::report::evaluate::evaluate;
use raywalk::scene::{Algorithm, Formulas, ReflectedScale, Scene, Skip, Specular, builtin};
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
        // Surfaces in the same place, and bounces by interpolated normals that run on the wrong side.
        let touching = support::scene_of(include_bytes!("../support/touching.json"), "touching");
        for pixel in support::grid(&touching, 24) {
            checked.check(&record::pixel(&touching, pixel, arithmetic));
        }
        for k in 0..40 {
            let eye = DVec3::new(2.0, 3.4, f64::from(k % 5) * 0.1);
            let direction = DVec3::new(1.0, -0.05 - f64::from(k) * 1e-4, 0.01);
            checked.check(&record::ray(&touching, eye, direction, arithmetic));
        }
        for scene in straight_scenes() {
            for eye in [DVec3::new(0.0, 0.0, 4.0), DVec3::new(0.0, 0.0, 0.5)] {
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
            assert_eq!(verdict.is_some_and(|verdict| verdict.is_err()), name.formula().is_some(), "{name:?}");
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
        let formulas = || Name::all().filter(|name| name.formula().is_some() && !DEGENERATE.contains(name));
        let too_few: Vec<_> = formulas().filter(|name| count(*name) < ENOUGH).map(|name| (name, count(name))).collect();
        assert!(too_few.is_empty(), "{arithmetic}: checked less than {ENOUGH} times: {too_few:?}");
    }
}

/// Whether the formula of a noted quantity gives its value; `None` if it has no formula.
fn verdict(log: &Log, tree: &Tree, at: usize, arithmetic: Arithmetic) -> Option<Result<(), String>> {
    let What::Note { name, value } = log.events[at].what else { return None };
    let verdict = evaluate(log, tree, at, name)?.and_then(|exact| {
        let expected = rounded(exact, arithmetic);
        let difference = || format!("{name:?} is {value:?}, its formula gives {expected:?}");
        if expected.same_bits(&value) { Ok(()) } else { Err(difference()) }
    });
    Some(verdict)
}

fn rounded(value: Value, arithmetic: Arithmetic) -> Value {
    let round = |x: f64| match arithmetic {
        Arithmetic::F64 => x,
        Arithmetic::F32 => f64::from((x as f32).clamp(f32::MIN, f32::MAX)),
        Arithmetic::Decimal(digits) => round_half_away(x, digits),
        other => panic!("{other} has values that no formula gives"),
    };
    match value {
        Value::Number(x) => Value::Number(round(x)),
        Value::Triple(triple) => Value::Triple(triple.map(round)),
    }
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
