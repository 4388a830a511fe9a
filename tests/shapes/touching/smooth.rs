//! Meshes whose normals are interpolated: a ray that leaves a face doesn't hit the face that it leaves.

use super::world::{Frame, World, wrong};
use crate::random::Random;
use glam::DVec3;
use raywalk::scene::generate::icosphere;
use serde_json::json;

/// A ball that gives back all light, or lets it through, in a room that is equally bright everywhere, can't be told from the room.
#[test]
fn a_smooth_ball_vanishes_in_a_bright_room() {
    let mut random = Random::new(501);
    let materials = [
        json!({"weights": {"local": 0, "reflected": 1}}),
        json!({"ior": 1.0000001, "weights": {"local": 0, "transmitted": 1}}),
    ];
    for (far, scale) in [(0.0, 1.0), (1e3, 1.0), (3.0, 1e-4)] {
        for level in 0..3 {
            let frame = Frame::turned(&mut random, far, scale);
            let mut ball = icosphere(level);
            ball.positions.iter_mut().for_each(|corner| *corner = frame.point(corner.to_array()));
            let normals = ball.normals.as_mut().expect("normals");
            normals.vectors.iter_mut().for_each(|normal| *normal = frame.vector(normal.to_array()));
            for material in &materials {
                let world = World::seen(&frame, [1.1, -2.5, 0.9], [0.0; 3], 45.0, [40, 30])
                    .set("/background", json!([1, 1, 1]))
                    .set("/tracing", json!({"max_depth": 20}))
                    .material("ball", material.clone())
                    .mesh("ball", ball.clone());
                let found = world.picture();
                let white = vec![DVec3::ONE; found.len()];
                let (count, worst) = wrong(&found, &white, 1e-12);
                assert_eq!(count, 0, "level {level} of {material}, {far} sizes of {scale} away: off by {worst:e}");
            }
        }
    }
}
