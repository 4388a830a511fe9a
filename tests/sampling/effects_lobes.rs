//! Blurred bounces against the lobe cosⁿ: directions, zones, means by quadrature, and the limit of the mirror.

use crate::support::scene_of;
use glam::DVec3;
use raywalk::geometry::Ray;
use raywalk::log::Name;
use raywalk::probe::{Probe, Quantity, Silent};
use raywalk::scene::Scene;
use raywalk::trace::camera_ray;
use std::f64::consts::PI;

/// Sees the directions that a blurred bounce takes: across the lobe by its own axes, and along it.
#[derive(Default)]
struct Directions {
    middle: DVec3,
    axes: [DVec3; 2],
    taken: Vec<[f64; 3]>,
}

impl Probe for Directions {
    fn given<Q: Quantity>(&mut self, name: Name, value: Q) {
        if name == Name::LobeMiddle {
            self.middle = DVec3::from_slice(value.value().components());
        }
    }

    fn note<Q: Quantity>(&mut self, name: Name, value: Q) -> Q {
        let triple = || DVec3::from_slice(value.value().components());
        match name {
            Name::LobeAxis1 => self.axes[0] = triple(),
            Name::LobeAxis2 => self.axes[1] = triple(),
            Name::LobeDirection => {
                let direction = triple();
                self.taken.push([self.axes[0], self.axes[1], self.middle].map(|axis| axis.dot(direction)));
            }
            _ => {}
        }
        value
    }
}

/// 10⁶ directions that the tracer takes, 16 a hit: chi-square over bins of equal angles, whose probability is the lobe's own (four
/// standard deviations), and each zone has its sixteenth.
#[test]
fn directions_follow_the_lobe_and_zones_are_equally_likely() {
    const HITS: u32 = 62_500;
    // Straight down, so that the lobe stands upright and nothing of it lies on the wrong side.
    let ray = Ray::along(DVec3::Y, DVec3::NEG_Y);
    for exponent in [0.0, 1.0, 10.0, 500.0] {
        let material =
            format!(r#"{{"weights": {{"local": 0, "reflected": 1}}, "gloss_exponent": {exponent:?}, "samples": 16}}"#);
        let mut scene = scene(&material);
        // Rings of equal width up to where little is left, and sectors.
        let reach = libm::acos(libm::pow(0.02, 1.0 / (exponent + 1.0)));
        let outside = |theta: f64| libm::pow(libm::cos(theta).max(0.0), exponent + 1.0);
        let mut bins = [[0_u32; 12]; 11];
        let mut zones = [0_u32; 16];
        for seed in 0..HITS {
            scene.seed = seed.into();
            let mut probe = Directions::default();
            camera_ray(&scene, |_| Some(ray), &mut probe);
            assert_eq!(probe.taken.len(), 16);
            for [x, y, z] in probe.taken {
                assert!((x * x + y * y + z * z - 1.0).abs() < 1e-14);
                let (theta, turn) = (libm::atan2(libm::hypot(x, y), z), libm::atan2(y, x) / (2.0 * PI));
                let sector = turn - turn.floor();
                bins[((theta / reach * 10.0) as usize).min(10)][((sector * 12.0) as usize).min(11)] += 1;
                let ring = ((1.0 - outside(theta)) * 4.0) as usize;
                zones[ring.min(3) * 4 + ((sector * 4.0) as usize).min(3)] += 1;
            }
        }
        let total = f64::from(HITS) * 16.0;
        let mut chi_square = 0.0;
        for (ring, sectors) in bins.iter().enumerate() {
            let side = |k: usize| outside(reach * k as f64 / 10.0);
            let part = side(ring) - if ring == 10 { 0.0 } else { side(ring + 1) };
            let expected = total * part / 12.0;
            let squares = sectors.iter().map(|count| f64::from(*count) - expected).map(|off| off * off);
            chi_square += squares.sum::<f64>() / expected;
        }
        // Stratified counts scatter less than independent ones: only too much is wrong.
        assert!(chi_square < 131.0 + 4.0 * 16.2, "n = {exponent}: {chi_square}");
        // Rounding may carry a direction over a zone's border.
        assert!(zones.iter().all(|count| count.abs_diff(HITS) <= 2), "n = {exponent}: {zones:?}");
    }
}

/// A plane y = 0 that only bounces, between two walls: white where x > 5, nothing elsewhere.
fn scene(material: &str) -> Scene {
    let text = format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 1, 9], "direction": [0, 0, -1]}}, "ambient": [1, 1, 1],
            "materials": {{"blurred": {material}, "white": {{"ambient": [1, 1, 1]}}}},
            "objects": [{{"shape": {{"plane": {{"coefficients": [0, 1, 0, 0]}}}}, "material": "blurred"}},
                        {{"shape": {{"plane": {{"coefficients": [-1, 0, 0, 5]}}}}, "material": "white"}}],
            "tracing": {{"max_depth": 1}}}}"#
    );
    scene_of(text.as_bytes(), "lobe")
}

fn seen(scene: &mut Scene, direction: DVec3, seed: u64) -> f64 {
    scene.seed = seed;
    let ray = Ray::along(-direction, direction);
    camera_ray(scene, |_| Some(ray), &mut Silent).x
}

/// The part of the lobe on the right side of the plane that sees the white wall.
fn quadrature(middle: DVec3, exponent: f64, upward: bool) -> f64 {
    const N: u32 = 600;
    let across = middle.cross(DVec3::X);
    let across = across / across.length();
    let other = middle.cross(across);
    let (mut white, mut all) = (0.0, 0.0);
    for k in 0..N {
        let theta = PI / 2.0 * (f64::from(k) + 0.5) / f64::from(N);
        let weight = libm::pow(libm::cos(theta), exponent) * libm::sin(theta);
        for j in 0..N {
            let turn = 2.0 * PI * (f64::from(j) + 0.5) / f64::from(N);
            let aside = across * libm::cos(turn) + other * libm::sin(turn);
            let direction = middle * libm::cos(theta) + aside * libm::sin(theta);
            if (direction.y > 0.0) == upward {
                all += weight;
                white += if direction.x > 0.0 { weight } else { 0.0 };
            }
        }
    }
    white / all
}

/// Over 100 seeds within four standard errors, and what the mean over the zones that are kept adds to it: less than 1 in the
/// number of zones.
#[track_caller]
fn is_mean(scene: &mut Scene, direction: DVec3, expected: f64, bias: f64) {
    let values: Vec<_> = (0..100).map(|seed| seen(scene, direction, seed)).collect();
    let mean = values.iter().sum::<f64>() / 100.0;
    let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / 99.0;
    let off = (mean - expected).abs();
    assert!(off < 4.0 * (variance / 100.0).sqrt() + bias, "{mean}, expected {expected}");
}

#[test]
fn the_mean_of_a_blurred_reflection_is_that_of_quadrature() {
    for exponent in [1.0, 8.0, 90.0] {
        let material = |samples: u32| {
            format!(
                r#"{{"weights": {{"local": 0, "reflected": 1}}, "gloss_exponent": {exponent}, "samples": {samples}}}"#
            )
        };
        for direction in [DVec3::new(0.2, -1.0, 0.3), DVec3::new(-0.1, -0.25, -1.0)] {
            let direction = direction / direction.length();
            let middle = DVec3::new(direction.x, -direction.y, direction.z);
            let expected = quadrature(middle, exponent, true);
            is_mean(&mut scene(&material(256)), direction, expected, 0.5 / 256.0 + 1e-3);
            if exponent == 90.0 && direction.y < -0.5 {
                // Nothing is rejected here: 16 zones, and one ray of the whole lobe, are unbiased.
                is_mean(&mut scene(&material(16)), direction, expected, 1e-3);
                is_mean(&mut scene(&material(1)), direction, expected, 1e-3);
            }
        }
    }
}

#[test]
fn the_mean_of_a_blurred_transmission_is_that_of_quadrature() {
    for exponent in [3.0, 40.0] {
        let material = format!(
            r#"{{"ior": 1.5, "weights": {{"local": 0, "transmitted": 1}}, "translucency_exponent": {exponent}, "samples": 250}}"#
        );
        let direction = DVec3::new(0.3, -1.0, 0.6);
        let direction = direction / direction.length();
        // Snell's law: the part along the surface is divided by the index.
        let along = DVec3::new(direction.x, 0.0, direction.z) / 1.5;
        let middle = DVec3::new(along.x, -(1.0 - along.length_squared()).sqrt(), along.z);
        is_mean(&mut scene(&material), direction, quadrature(middle, exponent, false), 0.5 / 256.0 + 1e-3);
    }
}

#[test]
fn an_endless_exponent_is_the_mirror() {
    let mirror = r#"{"weights": {"local": 0, "reflected": 1}}"#;
    let sharp = r#"{"weights": {"local": 0, "reflected": 1}, "gloss_exponent": 1e100, "samples": 16}"#;
    let (mut mirror, mut sharp) = (scene(mirror), scene(sharp));
    for k in -20..20 {
        let direction = DVec3::new(f64::from(k) / 7.0 + 0.01, -1.0, 0.4);
        assert_eq!(seen(&mut mirror, direction, 3), seen(&mut sharp, direction, 3), "{direction}");
    }
}

/// `samples` rays are the next square number of zones.
#[test]
fn zones_are_a_square_grid() {
    for (samples, zones) in [(1, 1), (2, 4), (4, 4), (5, 9), (16, 16), (17, 25), (1 << 20, 1 << 20)] {
        let material = format!(r#"{{"weights": {{"reflected": 1}}, "gloss_exponent": 5, "samples": {samples}}}"#);
        assert_eq!(scene(&material).materials[0].zones, zones);
    }
}
