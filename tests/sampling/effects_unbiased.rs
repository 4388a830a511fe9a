//! Every effect under every method that draws its samples at random: over 100 seeds no pixel's mean is off.

use crate::support::scene_of;
use raywalk::record::{Arithmetic, pixel_color};
use raywalk::scene::{Guided, Sampling, Scene};
use std::f64::consts::PI;

const METHODS: [Sampling; 6] = [
    Sampling::Stochastic { n: 4 },
    Sampling::Stochastic { n: 7 },
    Sampling::Random { n: 4 },
    Sampling::Sobol { n: 4 },
    Sampling::Sobol { n: 7 },
    Sampling::Guided(GUIDED),
];

/// With a maximum of samples such that some pixels take them all and others don't.
const GUIDED: Guided = Guided { tolerance: 0.01, min: 4, max: 64 };

const SEEDS: u64 = 100;

/// A scene of 16 pixels in a row, each half a unit wide at the distance 1, with what their reds should be.
struct Case {
    scene: Scene,
    expected: [f64; 16],
}

impl Case {
    /// The scene from its parts, and a pixel's red as a function of where its left and right sides are, at the distance 1.
    fn new(camera: &str, lights: &str, objects: &str, expected: impl Fn([f64; 2]) -> f64) -> Case {
        let text = format!(
            r#"{{"format": "raywalk-scene/1",
                "camera": {{"resolution": [16, 1], "vertical_fov": {:?}, {camera}}}, "lights": [{lights}], "ambient": [1, 1, 1],
                "materials": {{"white": {{"ambient": [1, 1, 1]}}, "film": {{"specular": [1, 1, 1], "shininess": 0}},
                    "glossy": {{"weights": {{"local": 0, "reflected": 1}}, "gloss_exponent": 60}},
                    "frosted": {{"ior": 1.5, "weights": {{"local": 0, "transmitted": 1}}, "translucency_exponent": 60}}}},
                "objects": [{objects}], "tracing": {{"max_depth": 1}}}}"#,
            2.0 * libm::atan(WIDTH / 2.0).to_degrees(),
        );
        let side = |k: usize| (k as f64 - 8.0) * WIDTH;
        Case {
            scene: scene_of(text.as_bytes(), "case"),
            expected: std::array::from_fn(|k| expected([side(k), side(k + 1)])),
        }
    }

    /// The sum of z² over the pixels that show something between all and nothing, which with 100 seeds is Student's t squared: its mean is
    /// 99/97 and its variance less than 2.3. At four standard deviations, and no pixel alone more than 4.5 off.
    #[track_caller]
    fn is_unbiased(&self, name: &str) {
        for sampling in METHODS {
            let (mut sum, mut count) = (0.0, 0.0);
            for (column, expected) in (0..16).zip(self.expected) {
                let value = |seed| {
                    let scene = Scene { sampling, seed, ..self.scene.clone() };
                    pixel_color(&scene, [column, 0], Arithmetic::F64).x
                };
                let values: Vec<_> = (0..SEEDS).map(value).collect();
                let mean = values.iter().sum::<f64>() / SEEDS as f64;
                if !(0.15..=0.85).contains(&expected) {
                    // Of nearly always the same value the variance isn't known: that of independent zeros and ones bounds it.
                    let error = (expected * (1.0 - expected) / (4 * SEEDS) as f64).sqrt();
                    let off = (mean - expected).abs();
                    assert!(off < 4.5 * error + 1e-9, "{name}, {sampling:?}, {column}: {mean} of {expected}");
                    continue;
                }
                let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / 99.0;
                let z = (mean - expected) / (variance / SEEDS as f64).sqrt();
                assert!(z.abs() < 4.5, "{name}, {sampling:?}, {column}: {mean}, expected {expected}, z = {z}");
                sum += z * z;
                count += 1.0;
            }
            assert!(count >= 4.0, "{name}: {count} pixels, {:?}", self.expected);
            let deviation = (sum - count * 99.0 / 97.0) / libm::sqrt(2.3 * count);
            println!("{name}, {sampling:?}: {deviation:.2} standard deviations, {count} pixels");
            assert!(deviation < 4.0, "{name}, {sampling:?}: {deviation} standard deviations");
        }
    }
}

/// A pixel's width at the distance 1.
const WIDTH: f64 = 0.05;

/// The mean over an interval.
fn mean([from, to]: [f64; 2], of: impl Fn(f64) -> f64) -> f64 {
    const STEPS: u32 = 200;
    (0..STEPS).map(|k| of(from + (to - from) * (f64::from(k) + 0.5) / f64::from(STEPS))).sum::<f64>() / f64::from(STEPS)
}

/// The part of the unit disc on which u ≤ x.
fn segment(x: f64) -> f64 {
    let x = x.clamp(-1.0, 1.0);
    0.5 + (x * (1.0 - x * x).sqrt() + libm::asin(x)) / PI
}

const FORWARD: &str = r#""position": [0, 0, 0], "direction": [0, 0, -1]"#;

/// A white half-plane x ≤ 0 at a distance, moved by so much.
fn half_plane(distance: f64, moved: f64) -> String {
    format!(
        r#"{{"shape": {{"polygon": {{"vertices": [[-99, -99, {z:?}], [0, -99, {z:?}], [0, 99, {z:?}], [-99, 99, {z:?}]]}}}},
            "material": "white", "motion": {{"translation": [{moved:?}, 0, 0]}}}}"#,
        z = -distance
    )
}

/// A ray from the point u·r of the lens hits the plane at the distance z in u·r·(1 − z/f) + x·z.
#[test]
fn an_edge_out_of_focus() {
    let camera = format!(r#"{FORWARD}, "lens": {{"radius": 1.6, "focus_distance": 4}}"#);
    let part = |x: f64| segment(-x * 2.0 / (1.6 * (1.0 - 2.0 / 4.0)));
    Case::new(&camera, "", &half_plane(2.0, 0.0), |pixel| mean(pixel, part)).is_unbiased("lens");
}

#[test]
fn an_edge_that_moves() {
    let camera = format!(r#"{FORWARD}, "shutter": [0, 1]"#);
    // At the time t the edge is at t·8 pixels; it passes the place x from 8·WIDTH·t = x on.
    let part = |x: f64| (1.0 - x / (8.0 * WIDTH)).clamp(0.0, 1.0);
    Case::new(&camera, "", &half_plane(2.0, 16.0 * WIDTH), |pixel| mean(pixel, part)).is_unbiased("motion");
}

/// The floor under a disc of light behind an edge at half its height, which sees the part of it on which u > −x.
#[test]
fn a_penumbra() {
    let camera = r#""position": [0, 1, 0], "direction": [0, -1, 0], "up": [0, 0, -1]"#;
    let light = r#"{"disk": {"center": [0, 3, 0], "normal": [0, 1, 0], "radius": 0.3}}"#;
    let objects = r#"{"shape": {"plane": {"coefficients": [0, 1, 0, 0]}}, "material": "film"},
        {"shape": {"polygon": {"vertices": [[0, 1.5, 99], [0, 1.5, -99], [-99, 1.5, -99], [-99, 1.5, 99]]}}}"#;
    Case::new(camera, light, objects, |pixel| mean(pixel, |x| segment(x / 0.3))).is_unbiased("area light");
}

/// The part of the lobe cos⁶⁰ about a direction in the plane z = 0 that goes to the right of the line straight up or down.
///
/// That line's plane cuts the lobe through its middle's angle α: what lies beyond it is ∫ over the angle φ about the axis of
/// cosⁿ⁺¹ of the angle at which the plane is met, tan θ·cos φ = tan α.
fn beyond(alpha: f64) -> f64 {
    const STEPS: u32 = 200;
    let slope = libm::tan(alpha.abs());
    // Half the turns meet the plane; the others never do.
    let far = |k: u32| {
        let cos_phi = libm::cos(PI * (f64::from(k) + 0.5) / f64::from(STEPS) - PI / 2.0);
        libm::pow(1.0 + slope * slope / (cos_phi * cos_phi), -61.0 / 2.0)
    };
    let part = (0..STEPS).map(far).sum::<f64>() / f64::from(2 * STEPS);
    if alpha > 0.0 { 1.0 - part } else { part }
}

#[test]
fn a_blurred_reflection() {
    // The white ceiling over the right half is so high that only the direction counts, not where the mirror was met.
    let camera = r#""position": [0, 1, 0], "direction": [0, -1, 0], "up": [0, 0, -1]"#;
    let objects = r#"{"shape": {"plane": {"coefficients": [0, 1, 0, 0]}}, "material": "glossy"},
        {"shape": {"polygon": {"vertices": [[0, 1e6, -9e6], [9e6, 1e6, -9e6], [9e6, 1e6, 9e6], [0, 1e6, 9e6]]}}, "material": "white"}"#;
    Case::new(camera, "", objects, |pixel| mean(pixel, |x| beyond(libm::atan(x)))).is_unbiased("gloss");
}

#[test]
fn a_blurred_transmission() {
    let camera = r#""position": [0, 1, 0], "direction": [0, -1, 0], "up": [0, 0, -1]"#;
    let objects = r#"{"shape": {"plane": {"coefficients": [0, 1, 0, 0]}}, "material": "frosted"},
        {"shape": {"polygon": {"vertices": [[0, -1e6, -9e6], [9e6, -1e6, -9e6], [9e6, -1e6, 9e6], [0, -1e6, 9e6]]}}, "material": "white"}"#;
    // Snell's law: the sine is divided by the index.
    let refracted = |x: f64| libm::asin(libm::sin(libm::atan(x)) / 1.5);
    Case::new(camera, "", objects, |pixel| mean(pixel, |x| beyond(refracted(x)))).is_unbiased("translucency");
}
