//! Trees of so many primitives that several threads grow them: what rays from above hit is known from the grid that they lie in.

use crate::random::Random;
use glam::DVec3;
use raywalk::scene::Scene;
use raywalk::trace::query::Query;
use std::fmt::Write;
use std::fs;

/// Cells in a row of the grid. Threads share trees from 16,384 primitives on.
const SIDE: usize = 140;

const CAMERA: &str = r#""format": "raywalk-scene/1", "camera": {"position": [0, 0, 50], "direction": [0, 0, -1]}"#;

/// What a ray straight down hits.
fn below(scene: &Scene, x: f64, y: f64) -> Option<(u32, u32, f64)> {
    let query = Query::new(DVec3::new(x, y, 50.0), DVec3::NEG_Z);
    query.nearest(scene).map(|hit| (hit.object, hit.primitive, hit.t))
}

#[test]
fn a_ray_hits_the_sphere_of_its_cell() {
    let mut objects = String::new();
    for cell in 0..SIDE * SIDE {
        let (x, y) = ((cell % SIDE) as f64, (cell / SIDE) as f64);
        let comma = if cell == 0 { "" } else { "," };
        write!(objects, r#"{comma}{{"shape": {{"sphere": {{"center": [{x}, {y}, 0], "radius": 0.25}}}}}}"#)
            .expect("text");
    }
    let scene: Scene = format!("{{{CAMERA}, \"objects\": [{objects}]}}").parse().expect("a scene");
    let mut random = Random::new(1);
    for _ in 0..5000 {
        let cell = (random.part() * (SIDE * SIDE) as f64) as usize;
        let (x, y) = ((cell % SIDE) as f64, (cell / SIDE) as f64);
        let hit = below(&scene, x, y);
        assert_eq!(hit.map(|(object, _, t)| (object, t)), Some((cell as u32, 49.75)));
        // Between the spheres there is nothing.
        assert_eq!(below(&scene, x + 0.5, y + 0.5), None);
    }
}

#[test]
fn a_ray_hits_the_triangle_of_its_half_of_a_cell() {
    let mut random = Random::new(2);
    let corners = SIDE + 1;
    let heights: Vec<f64> = (0..corners * corners).map(|_| random.part()).collect();
    let mut mesh = String::new();
    for (corner, height) in heights.iter().enumerate() {
        writeln!(mesh, "v {} {} {height:?}", corner % corners, corner / corners).expect("text");
    }
    for cell in 0..SIDE * SIDE {
        let first = cell / SIDE * corners + cell % SIDE + 1;
        let [a, b, c, d] = [first, first + 1, first + corners + 1, first + corners];
        // Below the diagonal, then above it.
        writeln!(mesh, "f {a} {b} {c}\nf {a} {c} {d}").expect("text");
    }
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("field.obj"), mesh).expect("written");
    let scene = format!("{{{CAMERA}, \"objects\": [{{\"shape\": {{\"mesh\": {{\"path\": \"field.obj\"}}}}}}]}}");
    fs::write(folder.path().join("scene.json"), scene).expect("written");
    let scene = Scene::open(folder.path().join("scene.json")).expect("a scene");
    for _ in 0..5000 {
        let cell = (random.part() * (SIDE * SIDE) as f64) as usize;
        // In the cell, and not on its diagonal.
        let (mut u, mut v) = (0.05 + 0.9 * random.part(), 0.05 + 0.9 * random.part());
        if (u - v).abs() < 1e-3 {
            (u, v) = (0.75, 0.25);
        }
        let height = |right: usize, up: usize| heights[(cell / SIDE + up) * corners + cell % SIDE + right];
        let z = if u > v {
            height(0, 0) + u * (height(1, 0) - height(0, 0)) + v * (height(1, 1) - height(1, 0))
        } else {
            height(0, 0) + v * (height(0, 1) - height(0, 0)) + u * (height(1, 1) - height(0, 1))
        };
        let hit = below(&scene, (cell % SIDE) as f64 + u, (cell / SIDE) as f64 + v);
        let (_, triangle, t) = hit.expect("the field has no holes");
        assert_eq!(triangle as usize, 2 * cell + usize::from(u < v));
        assert!((t - (50.0 - z)).abs() < 1e-12, "{t} {z}");
    }
}
