//! Layers that are asked for by name: a value is that of the pixel's log, and lights and classes of paths add up to the picture.

#![allow(clippy::unwrap_used)]

use crate::random::Random;
use crate::{random_scenes, support};
use proptest::prelude::*;
use raywalk::log::plane::{Plane, ValueAt};
use raywalk::log::{Decision, Log, Name, RayKind, Step, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::render::layers::{Layered, NoPlane, Planes, classes_of, lights_of};
use raywalk::render::{Canvas, Job, Settings, render_job};
use raywalk::scene::{Color, Sampling, Scene};
use std::collections::BTreeMap;
use std::sync::atomic::AtomicBool;

fn layered(scene: &Scene, planes: &[Plane], settings: Settings) -> Layered {
    let planes = Planes::of(scene, planes).unwrap_or_else(|error| panic!("{error}"));
    match render_job(Job::Layers(planes), scene, &settings, |_| (), &AtomicBool::new(false)).unwrap().film {
        Canvas::Layers(layered) => layered,
        other => panic!("layers, not {other:?}"),
    }
}

fn of_pixel([x, y]: [u32; 2], scene: &Scene, planes: &[Plane], arithmetic: Arithmetic) -> Layered {
    let settings = Settings { crop: [x, y, x + 1, y + 1], arithmetic, threads: 1, ..Settings::whole(scene) };
    layered(scene, planes, settings)
}

/// A value of a log, and the test around it.
struct Found {
    value: Value,
    test: Option<usize>,
}

/// The values of a quantity by the path that has them, with the numbers of samples and splits; those of a light also by the path of its shadow ray.
fn values_by_path(log: &Log, tree: &Tree, wanted: Name) -> BTreeMap<String, Vec<Found>> {
    let mut found: BTreeMap<String, Vec<Found>> = BTreeMap::new();
    for (at, event) in log.events.iter().enumerate() {
        let given = log.given(at).iter().copied();
        let noted = match event.what {
            What::Note { name, value } => Some((name, value)),
            _ => None,
        };
        for (_, value) in given.chain(noted).filter(|(name, _)| name.key() == wanted.key()) {
            let node = tree.owner(at);
            let step = |node: usize| tree.nodes()[node].step;
            let is_place = |node: &usize| {
                matches!(
                    step(*node),
                    Some(Step::Ray { .. } | Step::Light { .. } | Step::Sample { .. } | Step::Pixel(_))
                )
            };
            let is_test = |node: &usize| matches!(step(*node), Some(Step::Test { .. } | Step::Motion { .. }));
            let test = tree.around(node).take_while(|node| !is_place(node)).find(is_test);
            let path = tree.path(node);
            if let Some(Step::Light { light, split }) = tree.around(node).find(is_place).and_then(step) {
                let split = if split == 0 { String::new() } else { format!(".{split}") };
                found.entry(format!("{path} S{}{split}", light + 1)).or_default().push(Found { value, test });
            }
            found.entry(path).or_default().push(Found { value, test });
        }
    }
    found
}

/// Of several values of a ray that of the test that found the nearest hit, or else the first.
fn chosen(log: &Log, tree: &Tree, found: &[Found]) -> Value {
    let of_nearest = found.iter().filter_map(|one| {
        let test = one.test?;
        let ray = tree.around(test).find(|node| tree.ray(*node).is_some())?;
        let nearest = tree.own_events(ray).find_map(|event| match log.events[event].decision()? {
            Decision::Nearest { object } | Decision::Occluded { object } => Some(object),
            _ => None,
        })?;
        match tree.nodes()[test].step? {
            Step::Test { object, .. } if object == nearest => Some((0, one.value)),
            Step::Motion { object } if object == nearest => Some((1, one.value)),
            _ => None,
        }
    });
    of_nearest.min_by_key(|(rank, _)| *rank).map_or(found[0].value, |(_, value)| value)
}

fn components(value: Value) -> Vec<f64> {
    value.components().to_vec()
}

/// `3 C R.12 S1.4` is `C R S1`.
fn without_numbers(path: &str) -> String {
    let rays = path.split(' ').filter(|step| !step.starts_with(|first: char| first.is_ascii_digit()));
    rays.map(|step| step.split('.').next().unwrap_or(step)).collect::<Vec<_>>().join(" ")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    /// With the numbers of sample and split it is the one value of the log, bit for bit; without them the mean of all.
    #[test]
    fn a_value_is_that_of_the_log(seed in any::<u64>()) {
        let scene = match seed % 4 { 0 => random_scenes::adaptive(seed), 1 => random_scenes::crowded(seed), _ => random_scenes::scene(seed) };
        let mut random = Random::new(!seed);
        for arithmetic in [Arithmetic::F64, Arithmetic::F32, Arithmetic::Decimal(3), Arithmetic::Perturbed(seed)] {
            let pixel = [random.below(9) as u32, random.below(7) as u32];
            let log = record::pixel(&scene, pixel, arithmetic);
            let tree = Tree::of(&log.events);
            let names: Vec<Name> = log.events.iter().enumerate().flat_map(|(at, event)| {
                let noted = if let What::Note { name, .. } = event.what { Some(name) } else { None };
                log.given(at).iter().map(|(name, _)| *name).chain(noted).collect::<Vec<_>>()
            }).collect();
            for _ in 0..6 {
                let name = names[random.below(names.len())];
                let by_path = values_by_path(&log, &tree, name);
                let (path, found) = by_path.iter().nth(random.below(by_path.len())).unwrap();
                let one: Plane = format!("value:{}@{path}", name.key()).parse().unwrap();
                let all: Plane = format!("value:{}@{}", name.key(), without_numbers(path)).parse().unwrap();
                let layered = of_pixel(pixel, &scene, &[one.clone(), all.clone()], arithmetic);
                let numbers = layered.numbers(0);
                // Outside every ray there may be several samples with values of their own.
                if !path.is_empty() {
                    let expected = components(chosen(&log, &tree, found));
                    let bits = |numbers: &[f64]| numbers.iter().map(|x| (x + 0.0).to_bits()).collect::<Vec<_>>();
                    prop_assert_eq!(bits(&numbers[..one.numbers()]), bits(&expected), "{} {}", arithmetic, one);
                }
                let same = by_path.iter().filter(|(other, _)| without_numbers(other) == without_numbers(path));
                let values: Vec<_> = same.flat_map(|(path, found)| match path.as_str() {
                    "" => found.iter().map(|found| components(found.value)).collect(),
                    _ => vec![components(chosen(&log, &tree, found))],
                }).collect();
                for (axis, number) in numbers[one.numbers()..].iter().enumerate() {
                    let mean = values.iter().map(|value| value[axis]).sum::<f64>() / values.len() as f64;
                    let size = values.iter().map(|value| value[axis].abs()).fold(0.0, f64::max);
                    prop_assert!((number - mean).abs() <= 1e-12 * size, "{all}: {number} against {mean}");
                }
            }
        }
    }

    /// Whatever samples a pixel, lights and classes of paths add up to its colour.
    #[test]
    fn lights_and_classes_add_up_to_the_picture(seed in any::<u64>()) {
        let mut scene = match seed % 4 { 0 => random_scenes::adaptive(seed), _ => random_scenes::scene(seed) };
        scene.tracing.max_depth = (seed % 7) as u32;
        let lights = lights_of(&scene);
        let classes: Vec<Plane> =
            classes_of(&scene).iter().map(|class| format!("class:{class}").parse().unwrap()).collect();
        let planes: Vec<Plane> = lights.iter().chain(&classes).cloned().collect();
        let settings = Settings { threads: 1, ..Settings::whole(&scene) };
        let layered = layered(&scene, &planes, settings);
        for (at, seen) in layered.pixels().iter().enumerate() {
            let numbers = layered.numbers(at);
            let (of_lights, of_classes) = numbers.split_at(3 * lights.len());
            for part in [of_lights, of_classes] {
                let sum: Color = part.chunks(3).map(Color::from_slice).sum();
                let error = (sum - seen.color).abs().max_element();
                prop_assert!(error <= 1e-12 * seen.color.max_element().max(1.0), "{:?} {sum} {}", scene.sampling, seen.color);
            }
        }
    }

    /// What a light brings is what the scene looks like when everything else is dark. (Samplers that look at colours take other samples then.)
    #[test]
    fn a_light_brings_what_it_brings_alone(seed in any::<u64>()) {
        let scene = random_scenes::scene(seed);
        let looks = matches!(scene.sampling, Sampling::Adaptive { .. } | Sampling::Guided(_) | Sampling::Statistical(_));
        prop_assume!(!looks);
        let lights = lights_of(&scene);
        let settings = Settings { threads: 1, ..Settings::whole(&scene) };
        let parts = layered(&scene, &lights, settings);
        for (number, plane) in lights.iter().enumerate() {
            let mut alone = scene.clone();
            for (light, other) in alone.lights.iter_mut().enumerate() {
                if light != number {
                    other.color = Color::ZERO;
                }
            }
            if number != scene.lights.len() {
                alone.ambient = Color::ZERO;
            }
            if number != scene.lights.len() + 1 {
                alone.background = Color::ZERO;
            }
            let expected = layered(&alone, &[], settings);
            for (at, seen) in expected.pixels().iter().enumerate() {
                let brought = Color::from_slice(&parts.numbers(at)[3 * number..3 * number + 3]);
                prop_assert!((brought - seen.color).abs().max_element() <= 1e-12, "{plane}: {brought} against {}", seen.color);
            }
        }
    }
}

/// The numeric example is of one light, two paths, and one bounce: each class is a product that a hand can check.
#[test]
fn classes_of_the_numeric_example() {
    let scene = support::scene("textbook");
    let pixel = support::middle(&scene);
    let names = ["class:LDE", "class:LSE", "class:LDSE", "class:LSSE", "class:L(D|S)S*E", "class:A.*", "class:BS*E"];
    let planes = names.map(|name| name.parse().unwrap());
    let layered = of_pixel(pixel, &scene, &planes, Arithmetic::F64);
    let log = record::pixel(&scene, pixel, Arithmetic::F64);
    let account = raywalk::report::contributions::account(&log, &Tree::of(&log.events), 0);
    let of_account = |class: &str| {
        let parts = account.contributions.iter().filter(|one| one.class == class);
        parts.fold(Color::ZERO, |sum, one| sum + Color::from(one.color))
    };
    let brought = |at: usize| Color::from_slice(&layered.numbers(0)[3 * at..3 * at + 3]);
    let near = |a: Color, b: Color| (a - b).abs().max_element() < 1e-9;
    // The account has both terms of a surface together.
    let [direct, reflected] = ["L(D|S)", "L(D|S)S"].map(|start| of_account(&format!("{start}E")));
    let of_all =
        |bounces: &str| ["L(D|S)", "LD", "LS"].map(|start| of_account(&format!("{start}{bounces}E"))).into_iter().sum();
    assert!(direct + reflected != Color::ZERO || of_all("") != Color::ZERO);
    assert!(near(brought(0) + brought(1), of_all("")), "{} {}", brought(0), brought(1));
    assert!(near(brought(2) + brought(3), of_all("S")));
    assert!(near((0..4).map(brought).sum(), brought(4)));
    assert!(near(brought(4) + brought(5) + brought(6), layered.pixels()[0].color));
}

/// Crop and threads change no bit, and neither does what else is asked for.
#[test]
fn planes_have_the_same_bits_in_every_crop() {
    let mut scene = support::scene("glass-and-mirror");
    scene.sampling = Sampling::Sobol { n: 2 };
    let planes = ["value:shade.n_dot_l@C R", "light:ambient", "class:L.S*E"].map(|name| name.parse().unwrap());
    let crop = [150, 110, 190, 128];
    let settings = Settings { crop, threads: 2, ..Settings::whole(&scene) };
    let whole = layered(&scene, &planes, settings);
    let part = layered(&scene, &planes, Settings { crop: [160, 115, 171, 121], threads: 1, ..settings });
    let plain = layered(&scene, &[], settings);
    assert_eq!(whole.film(), plain.film());
    let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    for row in 0..6 {
        for column in 0..11 {
            let [at, in_whole] = [row * 11 + column, (row + 5) * 40 + column + 10];
            assert_eq!(bits(part.numbers(at)), bits(whole.numbers(in_whole)));
        }
    }
    assert!(whole.numbers_of(0).any(|number| !number.is_nan()) && whole.numbers_of(0).any(f64::is_nan));
}

#[test]
fn what_a_scene_lacks_is_refused_with_what_it_has() {
    let scene = support::scene("textbook");
    let refused = |name: &str| Planes::of(&scene, &[name.parse().unwrap()]).unwrap_err();
    assert!(matches!(refused("light:lampp"), NoPlane::Light { known, .. } if known.contains(&"ambient".to_owned())));
    assert!(matches!(refused("class:LDDE"), NoPlane::Class { known, .. } if known.contains(&"LDSE".to_owned())));
    let wanted: ValueAt = "shade.n_dot_l@C R".parse().unwrap();
    assert_eq!(wanted.path.steps[1].kind, RayKind::Reflected);
}
