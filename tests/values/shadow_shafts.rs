//! What can lie before an area light is found once for all its shadow rays: the colours are those of a tracer that asks for each ray alone.

use super::skips::picture;
use crate::random_scenes;
use crate::support;
use raywalk::probe::{Probe, Silent};
use raywalk::sampling;
use raywalk::scene::Scene;
use serde_json::json;

/// A probe that sees every test.
struct Watching;

impl Probe for Watching {}

/// Asks that the silent tracer, which looks for obstacles with a shaft, gives the colours of one that shows a probe every test.
#[track_caller]
pub fn compare(scene: &Scene, name: &str, pixels: impl IntoIterator<Item = [u32; 2]>) {
    for pixel in pixels {
        let silent = sampling::pixel(scene, pixel, &mut Silent);
        let watched = sampling::pixel(scene, pixel, &mut Watching);
        assert_eq!(
            silent.to_array().map(f64::to_bits),
            watched.to_array().map(f64::to_bits),
            "{name}, pixel {pixel:?}"
        );
    }
}

pub fn all_pixels(scene: &Scene) -> impl Iterator<Item = [u32; 2]> + use<> {
    let [width, height] = scene.camera.resolution;
    (0..height).flat_map(move |y| (0..width).map(move |x| [x, y]))
}

#[test]
fn colours_under_area_lights_are_those_of_rays_alone() {
    let mut free = 0;
    for seed in 0..60 {
        let scene = random_scenes::crowded(seed);
        compare(&scene, &format!("seed {seed}"), all_pixels(&scene));
        free += picture(&scene).1.statistics(0, Default::default(), 0).free_shadow_rays;
    }
    assert!(free > 1000, "{free} shadow rays that nothing could block");
}

/// The knot under a lamp: most of it shades nothing of what it faces.
fn knot(samples: u64) -> Scene {
    support::changed_scene("mesh", |file| {
        file.camera.resolution = [40, 30];
        let lamp = json!([{"name": "lamp", "rectangle": {"corner": [1, -4, 5], "edge_u": [1, 0, 0], "edge_v": [0, 1, 0]}, "samples": samples}]);
        file.lights = serde_json::from_value(lamp).expect("a light");
    })
}

#[test]
fn a_mesh_shades_its_own_far_side_only() {
    let scene = knot(4);
    compare(&scene, "the knot", all_pixels(&scene));
    let statistics = picture(&scene).1.statistics(0, Default::default(), 0);
    let json = serde_json::to_value(&statistics).expect("JSON");
    let [shadow_rays, stopped] = ["rays", "hits"].map(|of| json[of]["shadow"].as_u64().expect("a number"));
    // The first ray of a surface point is searched for always, and without a shaft through the mesh none is saved.
    assert!(statistics.free_shadow_rays * 5 > shadow_rays * 2, "{} of {shadow_rays}", statistics.free_shadow_rays);
    assert!(stopped > 0 && statistics.free_shadow_rays * 4 <= shadow_rays * 3);
}
