//! Optics with answers known from geometry: what the formulas must come to, not only that they agree with themselves.

use crate::support::scene_of;
use glam::DVec3;
use raywalk::log::{Decision, Log, Tree, Value, What};
use raywalk::record::{self, Arithmetic};
use raywalk::scene::Scene;

/// A scene of these materials, objects and lights; ambient light and background are as given.
fn scene(ambient: f64, background: f64, materials: &str, objects: &str, lights: &str) -> Scene {
    let text = format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [0, 0, -1]}},
            "ambient": [{ambient}, {ambient}, {ambient}], "background": [{background}, {background}, {background}],
            "materials": {{{materials}}}, "objects": [{objects}], "lights": [{lights}]}}"#
    );
    scene_of(text.as_bytes(), "physics")
}

fn log_of_ray(scene: &Scene, origin: [f64; 3], direction: [f64; 3]) -> Log {
    record::ray(scene, DVec3::from(origin), DVec3::from(direction), Arithmetic::F64)
}

fn red(log: &Log) -> f64 {
    match log.events.last().map(|event| &event.what) {
        Some(What::Result { color }) => color[0],
        _ => panic!("a log ends with its result"),
    }
}

/// The values noted under this key in the node of the ray with this path or inside it.
fn noted(log: &Log, path: &str, key: &str) -> Vec<Value> {
    let tree = Tree::of(&log.events);
    let noted = |(event, happening): (usize, &raywalk::log::Event)| match happening.what {
        What::Note { name, value } if name.key() == key && tree.path(tree.owner(event)) == path => Some(value),
        _ => None,
    };
    log.events.iter().enumerate().filter_map(noted).collect()
}

fn marks(log: &Log) -> Vec<Decision> {
    let mark = |event: &raywalk::log::Event| match event.what {
        What::Mark(decision) => Some(decision),
        _ => None,
    };
    log.events.iter().filter_map(mark).collect()
}

#[track_caller]
fn nearly(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 4e-16 * expected.abs().max(1.0), "{found} is not {expected}");
    }
}

const GLASS: &str = r#""glass": {"ior": 1.5, "weights": {"local": 0, "reflected": 0, "transmitted": 1}}"#;
const FLOOR_OF_GLASS: &str =
    r#"{"name": "floor", "shape": {"plane": {"coefficients": [0, 2, 0, 0]}}, "material": "glass"}"#;

#[test]
fn snell_at_45_degrees() {
    let scene = scene(0.0, 1.0, GLASS, FLOOR_OF_GLASS, "");
    let log = log_of_ray(&scene, [0.0, 3.0, 0.0], [1.0, -1.0, 0.0]);
    let sine = 0.5_f64.sqrt() / 1.5;
    nearly(noted(&log, "C", "refract.direction")[0].components(), &[sine, -(1.0 - sine * sine).sqrt(), 0.0]);
    nearly(noted(&log, "C", "plane.t")[0].components(), &[18.0_f64.sqrt()]);
    // From below, inside the glass, the way back: the surface is left again, at 45 degrees.
    let back = log_of_ray(&scene, [0.0, -3.0, 0.0], [sine, (1.0 - sine * sine).sqrt(), 0.0]);
    nearly(noted(&back, "C", "refract.eta")[0].components(), &[1.0 / 1.5]);
    nearly(noted(&back, "C", "refract.direction")[0].components(), &[0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0]);
    assert_eq!(red(&log), 1.0);
}

#[test]
fn no_light_leaves_glass_at_a_flat_angle() {
    let materials =
        format!(r#"{GLASS}, "gap": {{"ior": 1, "weights": {{"local": 0, "reflected": 1, "transmitted": 1}}}}"#);
    let objects = format!(
        r#"{FLOOR_OF_GLASS}, {{"name": "gap", "shape": {{"plane": {{"coefficients": [-1, 0, 0, 5]}}}}, "material": "gap"}}"#
    );
    let scene = scene(0.0, 1.0, &materials, &objects, "");
    let log = log_of_ray(&scene, [0.0, 3.0, 0.0], [1.0, -1.0, 0.0]);
    // In the glass the ray goes down at sin = 0.471; on the upright gap its angle of incidence is beyond 41.8 degrees.
    assert!(marks(&log).contains(&Decision::TotalInternalReflection));
    assert!(noted(&log, "C T", "refract.direction").is_empty());
    let sine = 0.5_f64.sqrt() / 1.5;
    nearly(noted(&log, "C T", "reflect.direction")[0].components(), &[-sine, -(1.0 - sine * sine).sqrt(), 0.0]);
}

#[test]
fn a_sphere_of_glass_bends_a_ray_twice_and_the_axis_not_at_all() {
    let ball = r#"{"name": "ball", "shape": {"sphere": {"center": [0, 0, 0], "radius": 1}}, "material": "glass"}"#;
    let scene = scene(0.0, 1.0, GLASS, ball, "");
    let axis = log_of_ray(&scene, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0]);
    nearly(noted(&axis, "C", "sphere.t")[0].components(), &[4.0]);
    nearly(noted(&axis, "C T", "sphere.t")[0].components(), &[2.0]);
    nearly(noted(&axis, "C T", "refract.direction")[0].components(), &[0.0, 0.0, -1.0]);
    // Off the axis by b: sin of incidence is b, deviation twice the difference of the angles.
    let b = 0.6_f64;
    let log = log_of_ray(&scene, [b, 0.0, 5.0], [0.0, 0.0, -1.0]);
    nearly(noted(&log, "C", "hit.normal")[0].components(), &[0.6, 0.0, 0.8]);
    let deviation = 2.0 * (libm::asin(b) - libm::asin(b / 1.5));
    let out = noted(&log, "C T", "refract.direction")[0];
    nearly(out.components(), &[-libm::sin(deviation), 0.0, -libm::cos(deviation)]);
}

const MATT: &str = r#""matt": {"diffuse": [0.5, 0.5, 0.5]}"#;
const FLOOR: &str = r#"{"name": "floor", "shape": {"plane": {"coefficients": [0, 1, 0, 0]}}, "material": "matt"}"#;
const LAMP: &str = r#"{"name": "lamp", "point": {"position": [0, 4, 0]}, "color": [8, 8, 8]"#;

#[track_caller]
fn floor_under_a_lamp_shows(materials: &str, objects: &str, light: &str, expected: f64) {
    let materials = format!("{MATT}{materials}");
    let scene = scene(0.0, 0.0, &materials, &format!("{FLOOR}{objects}"), &format!("{light}}}"));
    nearly(&[red(&log_of_ray(&scene, [0.0, 1.0, 0.0], [0.0, -1.0, 0.0]))], &[expected]);
}

#[test]
fn a_lamp_over_the_floor() {
    // 8 · 0.5 · cos 0
    floor_under_a_lamp_shows("", "", LAMP, 4.0);
    // Four away: 1 / (1 + 0.5·4 + 0.0625·16) = 1/4.
    floor_under_a_lamp_shows("", "", &format!(r#"{LAMP}, "attenuation": [1, 0.5, 0.0625]"#), 1.0);
    // Fading never brightens.
    floor_under_a_lamp_shows("", "", &format!(r#"{LAMP}, "attenuation": [0.1, 0, 0]"#), 4.0);
    // A light far away, at 60 degrees to the normal.
    let far = r#"{"name": "far", "directional": {"direction": [1.7320508075688772, -1, 0]}, "color": [8, 8, 8]"#;
    floor_under_a_lamp_shows("", "", far, 2.0);
}

#[test]
fn shadows_through_glass_multiply() {
    let filter = |name: &str, y: f64, material: &str| {
        format!(
            r#", {{"name": "{name}", "shape": {{"plane": {{"coefficients": [0, 1, 0, {}]}}}}, "material": "{material}"}}"#,
            -y
        )
    };
    let materials = r#", "half": {"weights": {"local": 0, "transmitted": 0.5}},
        "quarter": {"weights": {"local": 0, "transmitted": 0.25}}, "wall": {"weights": {"transmitted": 0}}"#;
    floor_under_a_lamp_shows(materials, &filter("a", 2.0, "half"), LAMP, 2.0);
    let two = filter("a", 2.0, "half") + &filter("b", 3.0, "quarter");
    floor_under_a_lamp_shows(materials, &two, LAMP, 0.5);
    floor_under_a_lamp_shows(materials, &(two + &filter("c", 3.5, "wall")), LAMP, 0.0);
    // Behind the lamp nothing is in the way.
    floor_under_a_lamp_shows(materials, &filter("c", 5.0, "wall"), LAMP, 4.0);
    // A glass ball counts twice, once in and once out.
    let ball = r#", {"name": "ball", "shape": {"sphere": {"center": [0, 2.5, 0], "radius": 0.5}}, "material": "half"}"#;
    floor_under_a_lamp_shows(materials, ball, LAMP, 1.0);
}

#[test]
fn the_transmitted_lobe_is_highest_along_the_refracted_ray() {
    let paper = r#""paper": {"transmission": [0.75, 0.75, 0.75], "transmission_exponent": 20, "ior": 1.5,
        "weights": {"transmitted": 1e-30}}"#;
    let screen = r#"{"name": "screen", "shape": {"plane": {"coefficients": [0, 0, 1, 0]}}, "material": "paper"}"#;
    let show = |position: &str| {
        let light = format!(r#"{{"name": "lamp", "point": {{"position": {position}}}, "color": [1e30, 1e30, 1e30]}}"#);
        let mut scene = scene(0.0, 0.0, paper, screen, &light);
        scene.tracing.max_depth = 0;
        // The lamp's light crosses no other surface, so the tiny weight only makes the screen a transmitting one.
        log_of_ray(&scene, [0.0, 0.0, 5.0], [0.0, 0.0, -1.0])
    };
    let straight = show("[0, 0, -5]");
    nearly(noted(&straight, "C", "shade.n_dot_transmitted")[0].components(), &[1.0]);
    nearly(&[red(&straight) / 1e30], &[0.75]);
    let aside = show("[4, 0, -5]");
    let between = noted(&aside, "C", "shade.n_dot_transmitted")[0].components()[0];
    assert!(0.0 < between && between < 1.0, "{between}");
}

#[test]
fn a_closed_furnace_has_the_radiance_of_the_series() {
    // Inside a ball whose wall glows with 1 and mirrors one half: 1 + 1/2 + 1/4 + … up to the depth limit.
    let wall = r#""wall": {"ambient": [1, 1, 1], "weights": {"local": 1, "reflected": 0.5}}"#;
    let ball = r#"{"name": "ball", "shape": {"sphere": {"center": [0, 0, 0], "radius": 3}}, "material": "wall"}"#;
    let mut scene = scene(1.0, 0.0, wall, ball, "");
    for depth in [0, 1, 5, 40] {
        scene.tracing.max_depth = depth;
        let expected = 2.0 - libm::exp2(-f64::from(depth));
        nearly(&[red(&log_of_ray(&scene, [0.5, 0.25, -1.0], [0.3, -0.4, 0.8]))], &[expected]);
    }
}
