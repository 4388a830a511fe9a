//! Flat surfaces in one plane, whatever shapes they belong to and wherever the plane lies.

use super::world::{Frame, World, wrong};
use crate::random::Random;
use raywalk::geometry::{Mesh, Ray};
use raywalk::probe::Silent;
use raywalk::trace::closest_hit;
use serde_json::{Value, json};

#[derive(Clone)]
enum Form {
    Shape(Value),
    Mesh(Mesh),
}

/// How far every one of [`sheets`] reaches at least from the frame's middle.
const REACH: f64 = 1.0;

/// Flat surfaces in the plane z = 0 of the frame, which all lie around its middle.
fn sheets(frame: &Frame, random: &mut Random) -> Vec<(&'static str, Form)> {
    let mut between = |from: f64, to: f64| from + (to - from) * random.part();
    let mut around = |count: usize| -> Vec<[f64; 3]> {
        let turn = between(0.0, 6.3);
        // So far out that the sides between the corners stay beyond the reach.
        let least = REACH / libm::cos(3.2 / count as f64);
        let corner = |k: usize| {
            let (angle, far) = (turn + std::f64::consts::TAU * k as f64 / count as f64, between(1.1, 1.6) * least);
            [far * libm::cos(angle), far * libm::sin(angle), 0.0]
        };
        (0..count).map(corner).collect()
    };
    let (three, five, seven, six) = (around(3), around(5), around(7), around(6));
    let mut turned_over = five.clone();
    turned_over.reverse();
    let fan: Vec<[u32; 3]> = (1..=6).map(|k| [0, k, k % 6 + 1]).collect();
    let with_middle: Vec<_> = [[0.1, -0.2, 0.0]].into_iter().chain(six).collect();
    let end = |own: f64| frame.at([0.1, 0.05, own]);
    let shape = |shape: Value| Form::Shape(shape);
    vec![
        ("plane", shape(frame.plane([0.3, -0.2, 0.0], [0.0, 0.0, 1.0]))),
        ("plane turned over", shape(frame.plane([-0.7, 0.4, 0.0], [0.0, 0.0, -3.0]))),
        (
            "triangle",
            shape(json!({"triangle": {"vertices": three.iter().map(|own| frame.at(*own)).collect::<Vec<_>>()}})),
        ),
        ("polygon", shape(frame.polygon(&seven))),
        ("polygon turned over", shape(frame.polygon(&turned_over))),
        (
            "disk",
            shape(json!({"disk": {"center": frame.at([0.1, 0.2, 0.0]), "normal": frame.way([0.0, 0.0, 2.0]),
            "radius": frame.length(1.3)}})),
        ),
        (
            "cap",
            shape(
                json!({"cylinder": {"base": end(-1.2), "apex": end(0.0), "radius": frame.length(1.2), "caps": true}}),
            ),
        ),
        (
            "cap of a cone",
            shape(json!({"cone": {"base": end(0.0), "base_radius": frame.length(1.3), "apex": end(-0.8),
            "apex_radius": frame.length(0.4), "caps": true}})),
        ),
        ("mesh", Form::Mesh(frame.mesh(&with_middle, &fan))),
    ]
}

fn add(world: World, material: &str, form: &Form) -> World {
    match form {
        Form::Shape(shape) => world.object(material, shape.clone()),
        Form::Mesh(mesh) => world.mesh(material, mesh.clone()),
    }
}

fn world(frame: &Frame) -> World {
    let lamp = json!({"point": {"position": frame.at([0.7, -0.6, 1.4])}, "color": [0.5, 0.6, 0.4]});
    let sun = json!({"directional": {"direction": frame.way([0.4, 0.5, -1.0])}, "color": [0.4, 0.3, 0.5]});
    let ball = json!({"sphere": {"center": frame.at([-0.8, 0.6, 1.2]), "radius": frame.length(0.2)}, "samples": 2});
    let below = json!({"point": {"position": frame.at([0.1, 0.2, -1.5])}, "color": [3, 3, 3]});
    World::seen(frame, [0.4, -1.1, 1.7], [0.0, 0.0, 0.0], 22.0, [12, 9])
        .light(lamp)
        .light(sun)
        .light(ball)
        .light(below)
        .set("/ambient", json!([0.1, 0.1, 0.1]))
        .material("matt", json!({"ambient": [0.3, 0.3, 0.3], "diffuse": [0.6, 0.5, 0.7], "specular": [0.3, 0.3, 0.3]}))
        .material("mirror", json!({"diffuse": [0.5, 0.6, 0.4], "weights": {"local": 0.5, "reflected": 0.6}}))
        .material(
            "sheet",
            json!({"diffuse": [0.5, 0.6, 0.4], "weights": {"local": 0.5, "reflected": 0.2, "transmitted": 1}}),
        )
}

const FRAMES: [(f64, f64); 5] = [(0.0, 1.0), (1e3, 1.0), (1e6, 1.0), (3.0, 1e-4), (1e4, 1e5)];

#[test]
fn the_first_in_the_scene_hides_the_others() {
    let mut random = Random::new(201);
    let mut lit = 0;
    for (far, scale) in FRAMES {
        let frame = Frame::turned(&mut random, far, scale);
        let sheets = sheets(&frame, &mut random);
        let world = world(&frame);
        for (first_name, first) in &sheets {
            for (second_name, second) in &sheets {
                for material in ["matt", "mirror"] {
                    let single = add(world.clone(), material, first);
                    let both = add(single.clone(), "matt", second);
                    let single_picture = single.picture();
                    let (count, worst) = wrong(&both.picture(), &single_picture, 1e-9);
                    let case = format!("{first_name} of {material} before {second_name}, {far} sizes of {scale} away");
                    assert_eq!(count, 0, "{case}: off by {worst:e}");
                    lit += single_picture.iter().filter(|color| color.x > 0.2).count();
                }
            }
        }
    }
    assert!(lit > 50_000, "{lit}");
}

#[test]
fn rays_from_either_side_meet_the_first() {
    let mut random = Random::new(202);
    let mut below = 0;
    for (far, scale) in FRAMES {
        for _ in 0..10 {
            let frame = Frame::turned(&mut random, far, scale);
            let mut sheets = sheets(&frame, &mut random);
            for k in (1..sheets.len()).rev() {
                sheets.swap(k, random.below(k + 1));
            }
            let scene = sheets.iter().fold(world(&frame), |world, (_, sheet)| add(world, "matt", sheet)).scene();
            for _ in 0..300 {
                let target = random.point() * 0.7;
                let side = if random.below(2) == 0 { 1.0 } else { -0.5 };
                let from = random.point() * 3.0;
                let height = side * libm::pow(10.0, -6.0 * random.part());
                let origin = frame.point([from.x * height.abs().sqrt(), from.y * height.abs().sqrt(), height]);
                let ray = Ray::along(origin, frame.point([target.x, target.y, 0.0]) - origin);
                let hit = closest_hit(&scene, &ray, &mut Silent);
                // From behind solids stand in the way.
                let hit = hit.expect("a sheet");
                if side > 0.0 {
                    let (found, first) = (sheets[hit.object as usize].0, sheets[0].0);
                    assert_eq!(
                        hit.object, 0,
                        "{found} instead of {first}, {far} sizes of {scale} away, from {height:e}"
                    );
                } else {
                    below += 1;
                }
            }
        }
    }
    assert!(below > 3000, "{below}");
}
