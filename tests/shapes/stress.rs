//! Numerical stability: own cases with exact answers always, those of others where they are at hand; and what no list of cases
//! can show, in great numbers: meshes without leaks, rays that don't hit the surface they leave, closed rooms of known light.

use crate::random::Random;
use crate::shared as shared_files;
use crate::support;
use glam::DVec3;
use rayon::prelude::*;
use raywalk::geometry::shape::{Cuboid, Ellipsoid, Plane, Sphere, SphereMethod, Triangle, TriangleMesh};
use raywalk::geometry::{Intersect, Leaving, Mesh, Ray, Shape, Target};
use raywalk::probe::Silent;
use raywalk::scene::generate::{icosphere, knot};
use raywalk::scene::{Index, Scene};
use raywalk::study::stress::{self, Family, Table};
use raywalk::trace::camera_ray;
use std::sync::Arc;

#[test]
fn the_own_sample_holds() {
    let families = stress::samples().expect("a good sample");
    assert_eq!(families.len(), 24, "a family of each kind");
    assert_holds(&stress::table(&families, &[]).expect("cases that can be answered"));
}

#[test]
fn the_cases_of_others_hold() {
    let Some(folder) = shared_files::shared("reference/stress") else { return };
    let files = std::fs::read_dir(folder).expect("a folder of cases");
    let mut paths: Vec<_> = files.map(|file| file.expect("a file of cases").path()).collect();
    paths.sort();
    let read = |path: &std::path::PathBuf| -> Family {
        let text = std::fs::read(path).expect("a readable file");
        stress::parse(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    };
    let families: Vec<_> = paths.iter().map(read).collect();
    let table = stress::table(&families, &[]).expect("cases that can be answered");
    assert!(table.rows.iter().map(|row| row.cases).sum::<usize>() > 1000, "the cases are gone");
    assert_holds(&table);
}

#[track_caller]
fn assert_holds(table: &Table) {
    assert!(table.holds(), "\n{}", table.text(str::to_owned));
}

/// Rays in each of the tests below.
const MANY: u64 = 1_000_000;

/// Rays that share a sequence of random numbers.
const A_BATCH: u64 = 10_000;

/// How many of [`MANY`] rays, shot in batches on all cores, a test counts.
fn count(test: impl Fn(&mut Random) -> bool + Sync) -> usize {
    let batch = |number: u64| {
        let mut random = Random::new(number);
        (0..A_BATCH).filter(|_| test(&mut random)).count()
    };
    (0..MANY / A_BATCH).into_par_iter().map(batch).sum()
}

#[test]
fn no_ray_slips_between_the_triangles_of_a_closed_mesh() {
    let ball = icosphere(3);
    let knot = knot(1);
    // The points inside: about the middle of the ball, and the middles of the knot's rings of eight corners.
    let rings: Vec<DVec3> = knot.positions.chunks(8).map(|ring| ring.iter().sum::<DVec3>() / 8.0).collect();
    let (ball, knot) = (TriangleMesh::new(Arc::new(ball)), TriangleMesh::new(Arc::new(knot)));
    let shapes = [(Shape::Mesh(Arc::new(ball.clone())), &ball), (Shape::Mesh(Arc::new(knot.clone())), &knot)];
    let misses = count(|random| {
        let which = random.below(2);
        let (shape, mesh) = &shapes[which];
        let inside = if which == 0 { random.point() * 0.3 } else { rings[random.below(rings.len())] };
        let target = aim(mesh.mesh(), random);
        let ray = Ray::along(inside, target - inside);
        // From inside the ball every corner is in sight. The knot has edges that a ray only touches before it goes on.
        let reach = if which == 0 { inside.distance(target) * (1.0 + 1e-12) } else { f64::INFINITY };
        shape.first_crossing(Target::two_sided(0), &ray, &mut Silent).is_none_or(|crossing| crossing.t > reach)
    });
    assert_eq!(misses, 0, "of {MANY}");
}

/// A corner of a mesh, or a point on an edge, as well as f64 has it.
fn aim(mesh: &Mesh, random: &mut Random) -> DVec3 {
    let [a, b, _] = mesh.corners(random.below(mesh.faces.len()) as u32);
    match random.below(3) {
        0 => a,
        1 => (a + b) * 0.5,
        _ => a + (b - a) * random.part(),
    }
}

#[test]
fn no_ray_meets_the_convex_surface_that_it_leaves() {
    let self_hits = count(|random| {
        let scale = 10.0_f64.sqrt();
        let scale = (0..random.below(31)).fold(1e-6, |size, _| size * scale);
        let place = random.point() * scale * 100.0;
        let shape = convex(random, scale, place);
        let from = place + random.unit() * scale * (3.0 + random.part());
        let target = place + random.point() * scale * 0.4;
        let ray = Ray::along(from, target - from);
        let Some(crossing) = shape.first_crossing(Target::two_sided(0), &ray, &mut Silent) else { return false };
        let surface = shape.surface(&ray, crossing, &mut Silent);
        let way = random.unit();
        // Some of the ways run along the surface but for a little.
        let along = way - surface.normal * way.dot(surface.normal) + surface.normal * 1e-9 * random.part();
        let way = if random.below(3) == 0 { along } else { way };
        let outward = if way.dot(surface.normal) < 0.0 { -way } else { way };
        let leaving = Some(Leaving { object: 0, primitive: crossing.primitive, side: crossing.side });
        let slack = ray.slack_at(surface.point, &Silent);
        let spawned = Ray { leaving, slack, ..Ray::along(surface.point, outward) };
        shape.first_crossing(Target::two_sided(0), &spawned, &mut Silent).is_some()
    });
    assert_eq!(self_hits, 0, "of {MANY}");
}

/// A convex shape of this size at this place, seen from outside.
fn convex(random: &mut Random, size: f64, place: DVec3) -> Shape {
    match random.below(6) {
        0 | 1 => Shape::Sphere(Sphere::new(place, size, false, SphereMethod::Robust)),
        2 => {
            let normal = random.unit();
            Shape::Plane(Plane::new([normal.x, normal.y, normal.z, -normal.dot(place)]))
        }
        3 => {
            let corners = [0, 1, 2].map(|_| (place + random.unit() * size).to_array());
            Shape::Triangle(Box::new(Triangle::new(corners, None)))
        }
        4 => Shape::Cuboid(Cuboid::new(place - size * 0.5, place + size * 0.5)),
        _ => {
            let radii = DVec3::new(0.5 + random.part(), 0.5 + random.part(), 0.5 + random.part()) * size;
            Shape::Ellipsoid(Box::new(Ellipsoid::new(place, radii, None)))
        }
    }
}

#[test]
fn no_ray_meets_the_convex_mesh_that_it_leaves() {
    let balls: Vec<Shape> = [1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9].map(scaled_ball).into();
    let self_hits = count(|random| {
        let ball = &balls[random.below(balls.len())];
        let Shape::Mesh(mesh) = ball else { unreachable!("a ball is a mesh of triangles") };
        let [a, b, c] = mesh.mesh().corners(random.below(mesh.mesh().faces.len()) as u32);
        let (u, v) = (random.part(), random.part());
        let target = a + ((b - a) * (1.0 - v) + (c - a) * v) * u;
        let size = mesh.mesh().positions[0].length();
        let from = random.unit() * size * 4.0;
        let ray = Ray::along(from, target - from);
        let Some(crossing) = ball.first_crossing(Target::two_sided(0), &ray, &mut Silent) else { return false };
        let surface = ball.surface(&ray, crossing, &mut Silent);
        let way = random.unit();
        let outward = if way.dot(surface.normal) < 0.0 { -way } else { way };
        let leaving = Some(Leaving { object: 0, primitive: crossing.primitive, side: crossing.side });
        let slack = ray.slack_at(surface.point, &Silent);
        let spawned = Ray { leaving, slack, ..Ray::along(surface.point, outward) };
        ball.first_crossing(Target::two_sided(0), &spawned, &mut Silent).is_some()
    });
    assert_eq!(self_hits, 0, "of {MANY}");
}

fn scaled_ball(size: f64) -> Shape {
    let mut ball = icosphere(1);
    ball.normals = None;
    ball.positions.iter_mut().for_each(|corner| *corner *= size);
    Shape::Mesh(Arc::new(TriangleMesh::new(Arc::new(ball))))
}

/// A closed room whose wall glows with 1 and mirrors one half; outside it is black as can be.
fn furnace(shape: &str) -> Scene {
    let text = format!(
        r#"{{"format": "raywalk-scene/1", "camera": {{"position": [0, 0, 0], "direction": [0, 0, -1]}},
            "ambient": [1, 1, 1], "tracing": {{"max_depth": 20}},
            "materials": {{"wall": {{"ambient": [1, 1, 1], "weights": {{"local": 1, "reflected": 0.5}}}}}},
            "objects": [{{"name": "room", "shape": {shape}, "material": "wall"}}]}}"#
    );
    support::scene_of(text.as_bytes(), "furnace")
}

#[test]
fn closed_rooms_have_the_radiance_of_the_series() {
    let rooms = [
        r#"{"sphere": {"center": [0.1, 0.2, -0.1], "radius": 3}}"#,
        r#"{"box": {"min": [-1, -2, -1.5], "max": [1.25, 1, 3]}}"#,
        r#"{"ellipsoid": {"center": [0, 0.1, 0], "radii": [1, 2, 5]}}"#,
        r#"{"cylinder": {"base": [0, -1, 0], "apex": [0.5, 2, 0], "radius": 1.5, "caps": true}}"#,
        r#"{"cone": {"base": [0, -1, 0], "base_radius": 2, "apex": [0, 3, 0.5], "apex_radius": 0.5, "caps": true}}"#,
    ];
    let mut scenes: Vec<_> = rooms.map(furnace).into();
    let mut of_triangles = furnace(rooms[0]);
    of_triangles.objects[0].shape = scaled_ball(2.0);
    of_triangles.index = Index::new(&of_triangles.objects);
    scenes.push(of_triangles);
    let expected = 2.0 - libm::exp2(-20.0);
    for (number, scene) in scenes.iter().enumerate() {
        let wrong = (0..5_000_u64).into_par_iter().filter(|seed| {
            let mut random = Random::new(*seed);
            let ray = Ray::along(random.point() * 0.4, random.unit());
            let color = camera_ray(scene, |_| Some(ray), &mut Silent);
            (color - DVec3::splat(expected)).abs().max_element() > 1e-12
        });
        assert_eq!(wrong.count(), 0, "room {number}");
    }
}
