//! Area lights with `{"min": …, "max": …}`: where a part of one may be hidden they have the bits of as many points as `max`; in full view their
//! rule has the mean but for the error in `docs/sampling.md`; what is reported as hidden is.

use super::shadow_shafts::{all_pixels, compare};
use super::skips::picture;
use crate::random::Random;
use crate::random_scenes;
use crate::support;
use glam::DVec3;
use raywalk::geometry::Ray;
use raywalk::log::{Asking, Decision, Tree, Value, What};
use raywalk::probe::{Probe, Silent};
use raywalk::record::{self, Arithmetic};
use raywalk::report::language::Language;
use raywalk::report::{Style, contributions, words};
use raywalk::scene::{Index, LightKind, Scene};
use raywalk::trace::camera_ray;
use serde_json::json;

/// Gathers why lights are asked as they are.
#[derive(Default)]
struct Reasons(Vec<Asking>);

impl Probe for Reasons {
    fn mark(&mut self, decision: Decision) {
        if let Decision::Asked { why, .. } = decision {
            self.0.push(why);
        }
    }
}

/// The scene with this many points of each area light, always.
fn with_all(scene: &Scene, samples: u32) -> Scene {
    let mut scene = scene.clone();
    for light in &mut scene.lights {
        if let LightKind::Area(area) = &mut light.kind {
            area.adaptive = None;
            area.samples = samples;
        }
    }
    scene
}

fn bits(color: DVec3) -> [u64; 3] {
    color.to_array().map(f64::to_bits)
}

#[test]
fn whoever_looks_on_sees_the_same_colours() {
    for seed in 0..40 {
        let scene = random_scenes::adaptive(seed);
        compare(&scene, &format!("seed {seed}"), all_pixels(&scene));
        let all_tests = Scene { index: Index::of_all(&scene.objects), ..scene.clone() };
        let film = picture(&scene).0;
        for pixel @ [x, y] in support::grid(&scene, 3) {
            let rendered = film[(y * scene.camera.resolution[0] + x) as usize];
            for scene in [&scene, &all_tests] {
                let log = record::pixel(scene, pixel, Arithmetic::F64);
                let Some(What::Result { color }) = log.events.last().map(|event| &event.what) else {
                    panic!("a log ends with the result");
                };
                assert_eq!(color.map(f64::to_bits), bits(rendered), "seed {seed}, pixel {pixel:?}");
            }
        }
    }
}

/// Also where one object is said to hide the light: each of its points is hidden then.
#[test]
fn where_no_rule_is_used_the_bits_are_those_of_all_points() {
    let mut counts = [0; 4];
    for seed in 0..120 {
        let scene = random_scenes::adaptive(seed);
        let plain = with_all(&scene, 9);
        for pixel in all_pixels(&scene) {
            let mut reasons = Reasons::default();
            let color = raywalk::sampling::pixel(&scene, pixel, &mut reasons);
            for why in &reasons.0 {
                counts[*why as usize] += 1;
            }
            if !reasons.0.contains(&Asking::Rule) {
                let expected = raywalk::sampling::pixel(&plain, pixel, &mut Silent);
                assert_eq!(bits(color), bits(expected), "seed {seed}, pixel {pixel:?}");
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 100), "{counts:?}");
}

/// A light of any form over a floor at y = 0.
fn lamp(random: &mut Random) -> serde_json::Value {
    let mut part = |least: f64, most: f64| least + (most - least) * random.part();
    let center = [part(-3.0, 3.0), part(0.5, 4.0), part(-3.0, 3.0)];
    let mut light = json!({"name": "lamp", "samples": {"min": 1, "max": 4}});
    let turned = DVec3::new(part(-1.0, 1.0), part(-1.0, 1.0), part(-1.0, 1.0));
    let across = turned.any_orthonormal_vector();
    let size = part(0.05, 1.0);
    let other = size * part(0.2, 1.0);
    match (part(0.0, 5.0)) as u32 {
        kind @ 0..2 => {
            let (u, v) = (across * size, turned.cross(across).normalize() * other);
            let corner = DVec3::from(center) - (u + v) / 2.0;
            light["rectangle"] = json!({"corner": corner.to_array(), "edge_u": u.to_array(), "edge_v": v.to_array()});
            light["by"] = json!(["area", "solid_angle"][kind as usize]);
        }
        2 => light["disk"] = json!({"center": center, "normal": turned.to_array(), "radius": size / 2.0}),
        kind => {
            light["sphere"] = json!({"center": center, "radius": size / 2.0});
            light["by"] = json!(["area", "solid_angle"][kind as usize - 3]);
        }
    }
    match part(0.0, 5.0) as u32 {
        0 => light["attenuation"] = json!([1.0, 0.5, 0.0]),
        1 => light["attenuation"] = json!([0.5, 0.0, 3.0]),
        // It is 1 up to somewhere about the lamp, and has a bend there.
        2 => light["attenuation"] = json!([0.0, 0.0, part(0.02, 0.5)]),
        _ => {}
    }
    light
}

/// A floor under a lamp, and more.
fn floor(
    lamp: &serde_json::Value,
    material: &serde_json::Value,
    specular: &str,
    objects: &[serde_json::Value],
) -> Scene {
    let plane = json!({"name": "floor", "shape": {"plane": {"coefficients": [0, 1, 0, 0]}}, "material": "floor"});
    let objects: Vec<_> = [plane].iter().chain(objects).cloned().collect();
    let text = json!({
        "format": "raywalk-scene/1",
        "camera": {"position": [0, 0.5, 9], "direction": [0, 0, -1]},
        "lights": [lamp],
        "materials": {"floor": material, "other": {"ambient": [1, 1, 1]}},
        "objects": objects,
        "tracing": {"specular": specular},
    });
    support::scene_of(text.to_string().as_bytes(), "lamp")
}

/// What the floor shows at a point to an eye above.
fn seen<P: Probe>(scene: &Scene, at: DVec3, eye: DVec3, probe: &mut P) -> f64 {
    let ray = Ray::along(eye, at - eye);
    camera_ray(scene, |_| Some(ray), probe).x
}

/// Against 9216 stratified points, whose own error is below 10⁻⁴ of the light.
#[test]
fn rules_are_as_right_as_they_are_said_to_be() {
    let (mut used, mut worst, mut wrong) = ([0; 2], [0.0_f64; 2], Vec::new());
    for seed in 0..1500 {
        let mut random = Random::new(seed);
        let lamp = lamp(&mut random);
        let is_glossy = random.below(2) == 1;
        let shininess = [1.0, 3.0, 10.0, 40.0, 200.0][random.below(5)];
        let specular = ["half_vector", "reflection_vector"][random.below(2)];
        let material = match is_glossy {
            true => json!({"diffuse": [0.5, 0.5, 0.5], "specular": [0.5, 0.5, 0.5], "shininess": shininess}),
            false => json!({"diffuse": [1, 1, 1]}),
        };
        let scene = floor(&lamp, &material, specular, &[]);
        let at = DVec3::new(2.0 * random.part() - 1.0, 0.0, 2.0 * random.part() - 1.0);
        // Toward the mirrored light, where a highlight is, or anywhere.
        let center = scene.lights[0].seen_from(at, &mut Silent).expect("it stands elsewhere").direction;
        let eye = match random.below(2) {
            0 => DVec3::new(-center.x, center.y.abs().max(0.1), -center.z) + random.point() * 0.2,
            _ => DVec3::new(random.part() - 0.5, 0.05 + random.part(), random.part() - 0.5),
        };
        let eye = at + DVec3::new(eye.x, eye.y.max(0.02), eye.z);
        let mut reasons = Reasons::default();
        let found = seen(&scene, at, eye, &mut reasons);
        if reasons.0 != [Asking::Rule] {
            continue;
        }
        let expected = seen(&with_all(&scene, 9216), at, eye, &mut Silent);
        let error = (found / expected - 1.0).abs();
        let kind = usize::from(is_glossy);
        used[kind] += 1;
        worst[kind] = worst[kind].max(error);
        let most = [5e-4, 1e-3][kind];
        if error > most {
            wrong.push(format!(
                "seed {seed}: {found}, not {expected}: {error}; {lamp} {material} {specular} {at} {eye}"
            ));
        }
    }
    println!("{used:?} {worst:?}");
    assert!(wrong.is_empty(), "{wrong:#?}");
    assert!(used[0] > 300 && used[1] > 100, "{used:?}");
}

/// A convex object somewhere between floor and lamp.
fn occluder(random: &mut Random) -> serde_json::Value {
    let mut part = |least: f64, most: f64| least + (most - least) * random.part();
    let center = DVec3::new(part(-1.0, 1.0), part(0.1, 1.5), part(-1.0, 1.0));
    let size = part(0.2, 1.5);
    let mut about =
        |size: f64| (center + DVec3::new(part(-size, size), part(-size, size), part(-size, size))).to_array();
    let (a, b, c) = (about(2.0 * size), about(2.0 * size), about(2.0 * size));
    let center = center.to_array();
    let shape = match part(0.0, 8.0) as u32 {
        0 => json!({"sphere": {"center": center, "radius": size}}),
        1 => json!({"ellipsoid": {"center": center, "radii": [size, 0.5 * size, 0.8 * size]}}),
        2 => json!({"disk": {"center": center, "normal": [0.3, 1, 0.2], "radius": size}}),
        3 => json!({"triangle": {"vertices": [a, b, c]}}),
        4 => {
            let at = |x: f64, z: f64| [center[0] + size * x, center[1], center[2] + size * z];
            json!({"polygon": {"vertices": [at(-1.0, -1.0), at(1.0, -1.2), at(1.3, 0.9), at(part(-1.0, 1.0), 1.4), at(-0.9, 1.0)]}})
        }
        5 => {
            // A notch, through which light comes.
            let at = |x: f64, z: f64| [center[0] + size * x, center[1], center[2] + size * z];
            json!({"polygon": {"vertices": [at(-1.0, -1.0), at(0.0, 0.2), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)]}})
        }
        6 => json!({"box": {"min": center, "max": [center[0] + size, center[1] + 0.3 * size, center[2] + size]}}),
        _ => {
            let top = [center[0] + 0.2, center[1] + 0.5 * size, center[2]];
            json!({"cylinder": {"base": center, "apex": top, "radius": size, "caps": part(0.0, 1.0) < 0.5}})
        }
    };
    json!({"name": "occluder", "shape": shape, "material": "other"})
}

#[test]
fn no_point_of_a_hidden_light_is_seen() {
    let (mut hidden, mut cases) = (0, 0);
    for seed in 0..1000 {
        let mut random = Random::new(seed);
        let lamp = lamp(&mut random);
        let scene = floor(&lamp, &json!({"diffuse": [1, 1, 1]}), "half_vector", &[occluder(&mut random)]);
        let plain = with_all(&scene, 64);
        for _ in 0..20 {
            let at = DVec3::new(3.0 * random.part() - 1.5, 0.0, 3.0 * random.part() - 1.5);
            // From below, where nothing is between.
            let eye = at + DVec3::new(0.0, 1e-3, 0.0);
            let mut reasons = Reasons::default();
            let found = seen(&scene, at, eye, &mut reasons);
            cases += 1;
            if reasons.0.contains(&Asking::Hidden) {
                hidden += 1;
                assert_eq!(found, 0.0);
                assert_eq!(seen(&plain, at, eye, &mut Silent), 0.0, "seed {seed}, {at}");
            }
        }
    }
    assert!(cases == 20_000 && hidden > 1000, "{hidden} of {cases}");
}

/// What lets light through hides nothing, nor does what a point itself lies on, nor a hollow that it lies in.
#[test]
fn what_lets_light_through_hides_no_light() {
    let lamp = json!({"name": "lamp", "rectangle": {"corner": [-0.5, 3, -0.5], "edge_u": [1, 0, 0], "edge_v": [0, 0, 1]}, "samples": {"min": 4, "max": 16}});
    let material = json!({"diffuse": [1, 1, 1], "weights": {"transmitted": 0.5}});
    let pane = |material: &str| json!({"name": "pane", "shape": {"disk": {"center": [0, 1, 0], "normal": [0, 1, 0], "radius": 5}}, "material": material});
    let at = |objects: &[serde_json::Value]| {
        let scene = floor(&lamp, &material, "half_vector", objects);
        let mut reasons = Reasons::default();
        let eye = DVec3::new(0.1, 0.5, 0.2);
        (seen(&scene, eye * DVec3::new(1.0, 0.0, 1.0), eye, &mut reasons), reasons.0)
    };
    let (free, why) = at(&[]);
    assert_eq!(why, [Asking::Rule]);
    let (dark, why) = at(&[pane("other")]);
    assert_eq!((dark, why), (0.0, vec![Asking::Hidden]));
    let (half, why) = at(&[pane("floor")]);
    assert_eq!(why, [Asking::All]);
    assert!((half / free - 0.5).abs() < 1e-2, "{half} {free}");
    // Around the eye and the point; the light outside is hidden by each of its points.
    let hollow =
        json!({"name": "hollow", "shape": {"sphere": {"center": [0, 0, 0], "radius": 2}}, "material": "other"});
    let (dark, why) = at(&[hollow]);
    assert_eq!((dark, why), (0.0, vec![Asking::All]));
}

/// The weights of a rule's points are logged, are 1 in all, and each is the part of the light that the point has.
#[test]
fn the_log_has_the_rule() {
    let lamp = json!({"name": "lamp", "color": [3, 2, 1], "rectangle": {"corner": [-0.5, 3, -0.5], "edge_u": [1, 0, 0], "edge_v": [0, 0, 1]}, "samples": {"min": 5, "max": 16}});
    let scene = floor(&lamp, &json!({"diffuse": [1, 1, 1]}), "half_vector", &[]);
    let log = record::ray(&scene, DVec3::new(0.1, 1.0, 0.0), DVec3::NEG_Y, Arithmetic::F64);
    let asked = log.events.iter().filter_map(|event| match event.what {
        What::Mark(Decision::Asked { why, points, .. }) => Some((why, points)),
        _ => None,
    });
    assert_eq!(asked.collect::<Vec<_>>(), [(Asking::Rule, 7)]);
    let colors = log.events.iter().filter_map(|event| match event.what {
        What::Note { name, value: Value::Triple(color) } if name.key() == "light.color" => Some(DVec3::from(color)),
        _ => None,
    });
    let colors: Vec<_> = colors.collect();
    assert_eq!(colors.len(), 7);
    assert!((colors.iter().sum::<DVec3>() - DVec3::new(3.0, 2.0, 1.0)).length() < 1e-14);
    // The points of the rule bring the light, each its part.
    let account = contributions::account(&log, &Tree::of(&log.events), 0);
    assert_eq!(account.contributions.len(), 7);
    let Some(What::Result { color }) = log.events.last().map(|event| &event.what) else { panic!("it has a result") };
    let sum = DVec3::from(contributions::sum(&account.contributions));
    assert!((sum - DVec3::from(*color)).length() < 1e-14, "{sum} {color:?}");
    let asked = Decision::Asked { light: 0, why: Asking::Rule, points: 7, object: None };
    let says = |language| words::decision(language, &log.header, &asked, Style::default());
    assert_eq!(says(Language::English), "lamp is in full view: a rule of 7 points gives its mean, without shadow rays");
    assert_eq!(
        says(Language::Spanish),
        "lamp está a plena vista: una regla de 7 puntos da su media, sin rayos de sombra"
    );
}
