//! Area lights against what mathematics says: the penumbra of a disk behind a straight edge, and means by quadrature.

use crate::support::scene_of;
use glam::DVec3;
use raywalk::geometry::Ray;
use raywalk::probe::Silent;
use raywalk::scene::Scene;
use raywalk::trace::camera_ray;
use std::f64::consts::PI;

/// A floor at y = 0 under one light; an opaque half-plane at y = 1 where x < 0, if there is an edge.
fn scene(light: &str, material: &str, has_edge: bool) -> Scene {
    let edge = r#", {"shape": {"polygon": {"vertices": [[0, 1, 99], [0, 1, -99], [-99, 1, -99], [-99, 1, 99]]}}}"#;
    let text = format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0.5, 9], "direction": [0, 0, -1]}},
            "lights": [{{{light}}}], "materials": {{"floor": {material}}},
            "objects": [{{"shape": {{"plane": {{"coefficients": [0, 1, 0, 0]}}}}, "material": "floor"}}{}]}}"#,
        if has_edge { edge } else { "" }
    );
    scene_of(text.as_bytes(), "light")
}

/// What the floor shows at a point, with a seed.
fn seen(scene: &mut Scene, x: f64, seed: u64) -> f64 {
    scene.seed = seed;
    let ray = Ray::new(DVec3::new(x, 0.5, 0.0), DVec3::NEG_Y);
    camera_ray(scene, |_| Some(ray), &mut Silent).x
}

/// The mean over 100 seeds lies within four standard errors of the expectation, and the error isn't large.
#[track_caller]
fn is_unbiased(scene: &mut Scene, x: f64, expected: f64, deviation: f64) {
    let values: Vec<_> = (0..100).map(|seed| seen(scene, x, seed)).collect();
    let mean = values.iter().sum::<f64>() / 100.0;
    let variance = values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / 99.0;
    let z = (mean - expected) / (variance / 100.0).sqrt().max(1e-12);
    assert!(z.abs() < 4.0, "at {x}: {mean}, expected {expected}, z = {z}");
    assert!(variance.sqrt() < deviation, "at {x}: standard deviation {}", variance.sqrt());
}

/// The part of the unit disc on which u > −x.
fn segment(x: f64) -> f64 {
    let x = x.clamp(-1.0, 1.0);
    0.5 + (x * (1.0 - x * x).sqrt() + libm::asin(x)) / PI
}

/// K_e with n_e = 0 counts every visible point of the light alike: the floor shows the part of the light that it sees. The point
/// u of the light, 2 above the floor, is seen past the edge at half its height from x > −u.
#[test]
fn the_penumbra_of_a_disk_behind_an_edge_is_a_circular_segment() {
    let visible = r#"{"specular": [1, 1, 1], "shininess": 0}"#;
    let adaptive = r#"{"min": 4, "max": 16}"#;
    for (samples, deviation) in [("1", 0.52), ("16", 0.09), (adaptive, 0.09), ("256", 0.012)] {
        let light =
            format!(r#""disk": {{"center": [0, 2, 0], "normal": [0, -3, 0], "radius": 0.5}}, "samples": {samples}"#);
        let mut scene = scene(&light, visible, true);
        for k in -4..=4 {
            let x = f64::from(k) * 0.115;
            is_unbiased(&mut scene, x, segment(x / 0.5), deviation);
        }
        // Beyond the penumbra there is no noise.
        for seed in 0..10 {
            assert_eq!(seen(&mut scene, -0.51, seed), 0.0);
            assert!((seen(&mut scene, 0.51, seed) - 1.0).abs() < 1e-12);
        }
    }
}

/// N·L times the attenuation [1, 0.5, 0] of a point light at this place, seen from (x, 0, 0).
fn lit(x: f64, [u, v, w]: [f64; 3]) -> f64 {
    let distance = ((u - x) * (u - x) + v * v + w * w).sqrt();
    v.max(0.0) / distance * (1.0 / (1.0 + 0.5 * distance)).min(1.0)
}

fn weight(power: f64, rho: f64) -> f64 {
    libm::pow(libm::cos(PI / 2.0 * rho).max(0.0), power)
}

/// The weighted mean over a grid of the unit square of (value, weight).
fn quadrature(of: impl Fn(f64, f64) -> [f64; 2]) -> f64 {
    const N: u32 = 400;
    let at = |k: u32| (f64::from(k) + 0.5) / f64::from(N);
    let (mut sum, mut weights) = (0.0, 0.0);
    for k in 0..N * N {
        let [value, weight] = of(at(k % N), at(k / N));
        sum += value * weight;
        weights += weight;
    }
    sum / weights
}

const DIFFUSE: &str = r#"{"diffuse": [1, 1, 1]}"#;

#[test]
fn the_mean_over_a_weighted_light_is_that_of_quadrature() {
    for power in [0.0, 1.0, 7.5, 200.0] {
        let profile = format!(r#""attenuation": [1, 0.5, 0], "profile": {{"cosine_power": {power:?}}}, "samples": 16"#);
        let disk = format!(r#""disk": {{"center": [0.5, 1, 0], "normal": [0, 1, 0], "radius": 1.5}}, {profile}"#);
        let rectangle =
            format!(r#""rectangle": {{"corner": [-1, 1, -1], "edge_u": [3, 0.5, 0], "edge_v": [0, 0, 2]}}, {profile}"#);
        let (mut disk, mut rectangle) = (scene(&disk, DIFFUSE, false), scene(&rectangle, DIFFUSE, false));
        for x in [-1.0, 0.7] {
            let on_disk = quadrature(|rho, turn| {
                let (cos, sin) = (libm::cos(2.0 * PI * turn), libm::sin(2.0 * PI * turn));
                [lit(x, [0.5 + 1.5 * rho * cos, 1.0, 1.5 * rho * sin]), rho * weight(power, rho)]
            });
            is_unbiased(&mut disk, x, on_disk, 0.05);
            let on_rectangle = quadrature(|u, v| {
                let rho = (2.0 * u - 1.0).abs().max((2.0 * v - 1.0).abs());
                [lit(x, [-1.0 + 3.0 * u, 1.0 + 0.5 * u, -1.0 + 2.0 * v]), weight(power, rho)]
            });
            is_unbiased(&mut rectangle, x, on_rectangle, 0.05);
        }
    }
}

#[test]
fn the_mean_over_a_sphere_is_that_of_quadrature() {
    let light = r#""sphere": {"center": [0.5, 2, 0], "radius": 1.2}, "attenuation": [1, 0.5, 0], "samples": 16"#;
    let mut scene = scene(light, DIFFUSE, false);
    let expected = quadrature(|height, turn| {
        let (y, turn) = (2.0 * height - 1.0, 2.0 * PI * turn);
        let across = (1.0 - y * y).sqrt();
        let point = [0.5 + 1.2 * across * libm::cos(turn), 2.0 + 1.2 * y, 1.2 * across * libm::sin(turn)];
        [lit(-0.5, point), 1.0]
    });
    is_unbiased(&mut scene, -0.5, expected, 0.05);
}

/// A light that nothing hides has no noise from its profile: shadow rays lie as dense as it says, and count alike.
#[test]
fn a_profile_makes_no_noise() {
    let light = r#""disk": {"center": [0, 2, 0], "normal": [0, 1, 0], "radius": 0.5}, "profile": {"cosine_power": 5}, "samples": 4"#;
    let mut scene = scene(light, r#"{"specular": [1, 1, 1], "shininess": 0}"#, false);
    assert!((0..50).all(|seed| (seen(&mut scene, 0.3, seed) - 1.0).abs() < 1e-12));
}

/// The mean by solid angle: each part of the surface that faces the point counts by cos θ/d².
fn by_solid_angle(from: [f64; 3], point: [f64; 3], normal: [f64; 3]) -> f64 {
    let toward = [0, 1, 2].map(|axis| point[axis] - from[axis]);
    let along: f64 = (0..3).map(|axis| toward[axis] * normal[axis]).sum();
    let distance = toward.iter().map(|x| x * x).sum::<f64>().sqrt();
    along / (distance * distance * distance)
}

/// Of a rectangle its whole surface counts, from both sides; the profile weighs each shadow ray, and its mean by area is 1.
#[test]
fn the_mean_over_a_rectangle_by_solid_angle_is_that_of_quadrature() {
    for power in [0.0, 1.0, 7.5] {
        let light = format!(
            r#""rectangle": {{"corner": [-1, 1, -1], "edge_u": [3, 0.5, 0], "edge_v": [0, 0, 2]}}, "attenuation": [1, 0.5, 0],
               "profile": {{"cosine_power": {power:?}}}, "samples": 16, "by": "solid_angle""#
        );
        let mut scene = scene(&light, DIFFUSE, false);
        let profile = |u: f64, v: f64| weight(power, (2.0 * u - 1.0).abs().max((2.0 * v - 1.0).abs()));
        let mean = quadrature(|u, v| [profile(u, v), 1.0]);
        for x in [-1.0, 0.7] {
            let expected = quadrature(|u, v| {
                let point = [-1.0 + 3.0 * u, 1.0 + 0.5 * u, -1.0 + 2.0 * v];
                let seen = by_solid_angle([x, 0.0, 0.0], point, [-0.5, 3.0, 0.0]).abs();
                [lit(x, point) * profile(u, v) / mean, seen]
            });
            is_unbiased(&mut scene, x, expected, 0.2);
        }
    }
}

/// Of a sphere the cap counts that faces the point.
#[test]
fn the_mean_over_a_sphere_by_solid_angle_is_that_of_quadrature() {
    let light = r#""sphere": {"center": [0.5, 2, 0], "radius": 1.2}, "attenuation": [1, 0.5, 0], "samples": 16, "by": "solid_angle""#;
    let mut scene = scene(light, DIFFUSE, false);
    let expected = quadrature(|height, turn| {
        let (y, turn) = (2.0 * height - 1.0, 2.0 * PI * turn);
        let across = (1.0 - y * y).sqrt();
        let outward = [across * libm::cos(turn), y, across * libm::sin(turn)];
        let point = [0.5 + 1.2 * outward[0], 2.0 + 1.2 * outward[1], 1.2 * outward[2]];
        [lit(-0.5, point), by_solid_angle([-0.5, 0.0, 0.0], point, outward.map(|x| -x)).max(0.0)]
    });
    is_unbiased(&mut scene, -0.5, expected, 0.05);
}

/// The two means differ: near a wide light, what is straight above counts for more by solid angle; far away they are the same.
#[test]
fn by_area_and_by_solid_angle_are_the_same_from_far_away() {
    let at = |height: f64, by: &str, seed: u64| {
        let light = format!(
            r#""rectangle": {{"corner": [-1, {height:?}, -1], "edge_u": [2, 0, 0], "edge_v": [0, 0, 2]}}, "samples": 400, "by": "{by}""#
        );
        seen(&mut scene(&light, DIFFUSE, false), 0.0, seed)
    };
    let apart = |height: f64| (at(height, "area", 1) - at(height, "solid_angle", 1)).abs();
    assert!(apart(0.3) > 0.1, "{}", apart(0.3));
    assert!(apart(100.0) < 1e-5, "{}", apart(100.0));
}

/// All directions count alike: a light that nothing hides has no noise, and a sphere's penumbra is that of the disk that is seen.
#[test]
fn by_solid_angle_shadow_rays_count_alike() {
    let visible = r#"{"specular": [1, 1, 1], "shininess": 0}"#;
    for light in [
        r#""sphere": {"center": [0, 2, 0], "radius": 0.5}, "samples": 4, "by": "solid_angle""#,
        r#""rectangle": {"corner": [-1, 2, -1], "edge_u": [2, 0, 0], "edge_v": [0, 0, 2]}, "samples": 4, "by": "solid_angle""#,
    ] {
        let mut scene = scene(light, visible, false);
        assert!((0..50).all(|seed| (seen(&mut scene, 0.3, seed) - 1.0).abs() < 1e-12), "{light}");
    }
    let light = r#""sphere": {"center": [0, 2, 0], "radius": 0.5}, "samples": 64, "by": "solid_angle""#;
    let mut scene = scene(light, visible, true);
    // The edge at x = 0 halves the cap as it is seen from below its middle.
    is_unbiased(&mut scene, 0.0, 0.5, 0.1);
    for seed in 0..10 {
        // From (x, 0) the edge hides all of the light where its tangent plane lies beyond: sin β = 0.5/√(x² + 4) for tan α = x.
        assert_eq!(seen(&mut scene, -0.6, seed), 0.0);
        assert!((seen(&mut scene, 0.6, seed) - 1.0).abs() < 1e-12);
    }
}
