//! How near to each other two surfaces are in the same place: what their own numbers, the ray and a motion have rounded.

use super::world::{Frame, World, wrong};
use crate::random::Random;
use serde_json::json;

const SQUARE: [[f64; 3]; 4] = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];

/// Looks from so far at a square around the frame's middle, under a light straight above.
fn world(frame: &Frame, far: f64) -> World {
    World::seen(frame, [0.3 * far, 0.2 * far, far], [0.0; 3], 20.0 / far, [20, 15])
        .light(json!({"directional": {"direction": frame.way([0.1, 0.2, -1.0])}}))
        .material("matt", json!({"diffuse": [1, 1, 1]}))
        .material("sheet", json!({"weights": {"local": 0, "transmitted": 0.5}}))
}

/// The coordinates of a large one are rounded by more than a small one is, and by more than the ray.
#[test]
fn a_small_sheet_in_the_plane_of_a_large_one() {
    let mut random = Random::new(401);
    for large in [1.0, 1e2, 1e4, 1e6, 1e9] {
        let frame = Frame::turned(&mut random, 0.0, 1.0);
        let world = world(&frame, 2.0);
        let wide =
            [[-1.7, -2.0, 0.0], [1.5, -1.5, 0.0], [1.4, 1.8, 0.0], [-1.9, 1.5, 0.0]].map(|own| own.map(|x| x * large));
        let [small, wide] = [SQUARE, wide].map(|corners| frame.polygon(&corners));
        for [first, second] in [[&small, &wide], [&wide, &small]] {
            let single = world.clone().object("matt", first.clone());
            let both = single.clone().object("matt", second.clone()).picture();
            let (count, worst) = wrong(&both, &single.picture(), 1e-9);
            assert_eq!(count, 0, "{large}: off by {worst:e}");
        }
    }
}

/// The point of a sheet that is seen from afar is off by more than its own coordinates tell; so is what lies just behind.
#[test]
fn the_second_of_two_sheets_seen_from_afar() {
    let mut random = Random::new(402);
    for far in [3.0, 1e2, 1e4, 1e6] {
        let frame = Frame::turned(&mut random, 0.0, 1.0);
        let world = world(&frame, far);
        let sheet = frame.polygon(&SQUARE);
        let floor = frame.polygon(&SQUARE.map(|[x, y, z]| [2.0 * x, 3.0 * y, z]));
        let bare = world.clone().object("matt", floor.clone());
        let covered = world.clone().object("sheet", sheet).object("matt", floor).picture();
        let half_and_half: Vec<_> = bare.picture().into_iter().map(|color| color * 0.25).collect();
        let (count, worst) = wrong(&covered, &half_and_half, 1e-9);
        assert_eq!(count, 0, "{far} away: off by {worst:e}");
    }
}

/// Where it has been moved to is rounded by the size of its own coordinates.
#[test]
fn a_sheet_that_has_moved_into_the_plane_of_another() {
    let mut random = Random::new(403);
    for far in [1.0, 1e3, 1e6] {
        let frame = Frame::turned(&mut random, 0.0, 1.0);
        let world = world(&frame, 2.0).set("/camera/shutter", json!([1, 1]));
        let [x, y, z] = [0.7 * far, 0.3 * far, far];
        let away = frame.polygon(&SQUARE.map(|[u, v, w]| [u - x, v - y, w - z]));
        let shift = json!({"translation": frame.vector([x, y, z]).to_array()});
        let turn = json!({"rotation": {"axis": frame.way([0.0, 0.0, 1.0]), "point": frame.at([x, y, z]), "degrees": 0.01 / far}});
        let floor = frame.polygon(&SQUARE.map(|[x, y, z]| [2.0 * x, 3.0 * y, z]));
        let right = world.clone().object("matt", floor.clone()).picture();
        for (shape, motion) in [(away, shift), (frame.polygon(&SQUARE), turn)] {
            let before = world.clone().object("matt", shape.clone()).moving(&motion).object("matt", floor.clone());
            let after = world.clone().object("matt", floor.clone()).object("matt", shape).moving(&motion);
            for both in [before, after] {
                let (count, worst) = wrong(&both.picture(), &right, 1e-9);
                assert_eq!(count, 0, "{far} away, {motion}: off by {worst:e}");
            }
        }
    }
}

/// A lamp that lies in a ceiling lights the room: the ceiling isn't before it.
#[test]
fn a_light_in_the_plane_of_a_ceiling() {
    let mut random = Random::new(404);
    for far in [0.0, 1.0, 1e3] {
        let frame = Frame::turned(&mut random, far, 1.0);
        let panel = json!({"rectangle": {"corner": frame.at([-0.2, -0.3, 1.1]), "edge_u": frame.span([0.5, 0.0, 0.0]),
            "edge_v": frame.span([0.0, 0.6, 0.0])}, "samples": 4});
        let round = json!({"disk": {"center": frame.at([0.1, 0.2, 1.1]), "normal": frame.way([0.0, 0.0, -1.0]),
            "radius": frame.length(0.3)}, "samples": 4});
        let bulb = json!({"point": {"position": frame.at([0.1, -0.2, 1.1])}});
        for light in [panel, round, bulb] {
            let world = World::seen(&frame, [0.3, 0.2, 0.9], [0.0; 3], 60.0, [20, 15])
                .light(light.clone())
                .material("matt", json!({"diffuse": [1, 1, 1]}));
            let open = world.object("matt", frame.polygon(&SQUARE.map(|own| own.map(|x| x * 3.0))));
            let closed = open.clone().object("matt", frame.polygon(&SQUARE.map(|[x, y, _]| [4.0 * x, 3.0 * y, 1.1])));
            let (count, worst) = wrong(&closed.picture(), &open.picture(), 1e-9);
            assert_eq!(count, 0, "{light}, {far} away: off by {worst:e}");
        }
    }
}

/// A square of glass whose second pair of triangles is cut along the other diagonal: what is seen through it and what is lit through it
/// have crossed the same surfaces.
#[test]
fn a_mesh_cut_twice_is_crossed_twice_by_every_ray() {
    let mut random = Random::new(405);
    for far in [0.0, 1e3] {
        let frame = Frame::turned(&mut random, far, 1.0);
        let world = World::seen(&frame, [0.2, 0.1, 2.0], [0.0; 3], 20.0, [20, 15]);
        let mesh = frame.mesh(&SQUARE, &[[0, 1, 2], [0, 2, 3], [0, 1, 3], [1, 2, 3]]);
        let world = world.material("sheet", json!({"weights": {"local": 0, "transmitted": 0.5}}));
        let bare = world.picture();
        let found = world.mesh("sheet", mesh).picture();
        let right: Vec<_> = bare.into_iter().map(|color| color * 0.25).collect();
        let (count, worst) = wrong(&found, &right, 1e-9);
        assert_eq!(count, 0, "{far}: off by {worst:e}");
    }
}
