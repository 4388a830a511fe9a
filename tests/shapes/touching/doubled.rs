//! A shape that is in a scene twice looks as it does alone.

use super::world::{Frame, World, difference, wrong};
use crate::random::Random;
use glam::DVec3;
use raywalk::geometry::Mesh;
use serde_json::{Value, json};
use std::collections::BTreeSet;

pub enum Form {
    Shape(Value),
    Mesh(Mesh),
}

pub const CUBE: [[f64; 3]; 8] = [
    [-0.7, -0.6, -0.5],
    [0.7, -0.6, -0.5],
    [0.7, 0.6, -0.5],
    [-0.7, 0.6, -0.5],
    [-0.5, -0.5, 0.6],
    [0.6, -0.5, 0.6],
    [0.6, 0.5, 0.6],
    [-0.5, 0.5, 0.6],
];

/// The quads of [`CUBE`], wound outward.
pub const QUADS: [[u32; 4]; 6] = [[3, 2, 1, 0], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];

pub fn halves(quads: &[[u32; 4]]) -> Vec<[u32; 3]> {
    quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect()
}

/// All ten shapes about the middle of a frame, with names; a box stands upright.
pub fn forms(frame: &Frame) -> Vec<(&'static str, Form)> {
    let (at, length) = (|own| frame.at(own), |own| frame.length(own));
    let middle = frame.point([0.0; 3]);
    let half = DVec3::new(0.8, 0.7, 0.9) * frame.length(1.0);
    let round = |extra: Value| {
        let mut shape = json!({"base": at([0.1, -0.2, -0.7]), "apex": at([-0.2, 0.1, 0.9])});
        shape.as_object_mut().expect("an object").append(&mut extra.as_object().expect("an object").clone());
        shape
    };
    let cylinder = |caps: bool, inward: bool| json!({"cylinder": round(json!({"radius": length(0.6), "caps": caps, "inward": inward}))});
    let cone = |apex: f64, caps: bool, inward: bool| {
        let radii = json!({"base_radius": length(0.7), "apex_radius": length(apex), "caps": caps, "inward": inward});
        json!({"cone": round(radii)})
    };
    let corners = [[-1.0, -0.9, 0.0], [1.0, -0.8, 0.0], [0.1, -0.1, 0.0], [1.1, 0.9, 0.0], [-0.9, 1.0, 0.0]];
    let triangle = [[-1.1, -0.9, 0.1], [1.2, -0.8, -0.1], [0.1, 1.3, 0.2]].map(at);
    let shapes = [
        ("plane", frame.plane([0.0; 3], [0.1, -0.2, 1.0])),
        ("sphere", json!({"sphere": {"center": at([0.0; 3]), "radius": length(0.9)}})),
        ("inward sphere", json!({"sphere": {"center": at([0.0; 3]), "radius": length(0.9), "inward": true}})),
        (
            "ellipsoid",
            json!({"ellipsoid": {"center": at([0.0; 3]), "radii": [length(0.9), length(0.5), length(1.1)],
                "rotation": frame.rows()}}),
        ),
        ("triangle", json!({"triangle": {"vertices": triangle}})),
        ("polygon", frame.polygon(&corners)),
        ("box", json!({"box": {"min": (middle - half).to_array(), "max": (middle + half).to_array()}})),
        ("tube", cylinder(false, false)),
        ("cylinder", cylinder(true, false)),
        ("inward cylinder", cylinder(true, true)),
        ("open cone", cone(0.2, false, false)),
        ("cone", cone(0.0, true, false)),
        ("inward cone", cone(0.3, true, true)),
        (
            "disk",
            json!({"disk": {"center": at([0.0; 3]), "normal": frame.way([0.3, -0.2, 1.0]), "radius": length(1.1)}}),
        ),
    ];
    let shapes = shapes.map(|(name, shape)| (name, Form::Shape(shape)));
    shapes.into_iter().chain([("mesh", Form::Mesh(frame.mesh(&CUBE, &halves(&QUADS))))]).collect()
}

pub const MATERIALS: [&str; 3] = ["matt", "mirror", "glass"];

/// Lights of every kind, a floor beneath, and materials that crossing twice changes nothing of.
pub fn world(frame: &Frame, from: [f64; 3], resolution: [u32; 2]) -> World {
    let lamp = json!({"point": {"position": frame.at([3.0, -1.0, 4.0])}, "color": [0.5, 0.6, 0.4]});
    let sun = json!({"directional": {"direction": frame.way([0.4, 0.5, -1.0])}, "color": [0.4, 0.3, 0.5]});
    let inside = json!({"point": {"position": frame.at([0.05, 0.02, 0.1])}, "color": [0.1, 0.2, 0.1]});
    let panel = json!({"rectangle": {"corner": frame.at([-3.0, -2.0, 3.0]), "edge_u": frame.span([1.0, 0.0, 0.0]),
        "edge_v": frame.span([0.0, 1.0, 0.5])}, "samples": 3, "color": [0.3, 0.3, 0.4]});
    let matt = json!({"ambient": [0.1, 0.1, 0.1], "diffuse": [0.6, 0.5, 0.7], "specular": [0.3, 0.3, 0.3],
        "shininess": 9, "pattern": {"checker": {"a": [1, 1, 1], "b": [0.6, 0.5, 0.4], "size": frame.length(0.37)}}});
    let mirror = json!({"diffuse": [0.5, 0.6, 0.4], "weights": {"local": 0.5, "reflected": 0.6}});
    let glass = json!({"diffuse": [0.3, 0.4, 0.5], "transmission": [0.3, 0.3, 0.3], "transmission_exponent": 6,
        "ior": 1.4, "weights": {"local": 0.4, "reflected": 0.3, "transmitted": 1}});
    World::seen(frame, from, [0.0; 3], 45.0, resolution)
        .set("/ambient", json!([0.2, 0.2, 0.3]))
        .set("/tracing", json!({"max_depth": 3}))
        .light(lamp)
        .light(sun)
        .light(inside)
        .light(panel)
        .material("matt", matt)
        .material("mirror", mirror)
        .material("glass", glass)
}

/// A floor, and the form this many times, before it and behind it in the order of the scene.
pub fn with(world: &World, frame: &Frame, form: &Form, material: &str, times: usize, motion: Option<&Value>) -> World {
    let add = |world: World| {
        let world = match form {
            Form::Shape(shape) => world.object(material, shape.clone()),
            Form::Mesh(mesh) => world.mesh(material, mesh.clone()),
        };
        match motion {
            None => world,
            Some(motion) => world.moving(motion),
        }
    };
    let first = if times == 0 { world.clone() } else { add(world.clone()) };
    let world = first.object("matt", frame.plane([0.0, 0.0, -1.9], [0.0, 0.1, 1.0]));
    (1..times).fold(world, |world, _| add(world))
}

/// What is tested here is the bound of its roundings: a shape that isn't tested has none.
#[test]
fn every_shape_of_a_scene_file_is_tested() {
    let schema = raywalk::scene::file::schema::json_schema();
    let shapes = schema["$defs"]["Shape"]["oneOf"].as_array().expect("the shapes").iter();
    let shapes: BTreeSet<_> = shapes.filter_map(|shape| shape["required"][0].as_str()).map(str::to_owned).collect();
    let forms = forms(&Frame::upright(DVec3::ZERO, 1.0));
    let key = |form: &Form| match form {
        Form::Shape(shape) => shape.as_object().and_then(|shape| shape.keys().next().cloned()).expect("a shape"),
        Form::Mesh(_) => "mesh".to_owned(),
    };
    let tested: BTreeSet<String> = forms.iter().map(|(_, form)| key(form)).collect();
    assert_eq!(tested, shapes, "the shapes of `forms`, and those of the schema");
}

const FRAMES: [(f64, f64); 5] = [(0.0, 1.0), (1e3, 1.0), (1e6, 1.0), (3.0, 1e-4), (1e4, 1e5)];

#[test]
fn every_shape_twice_or_thrice_is_the_single_one() {
    let mut random = Random::new(101);
    let mut seen = 0;
    for (far, scale) in FRAMES {
        let frame = Frame::turned(&mut random, far, scale);
        let from = [[1.6, -2.5, 1.9], [-2.1, 1.5, -1.2]][random.below(2)];
        let world = world(&frame, from, [16, 12]);
        for (name, form) in forms(&frame) {
            for material in MATERIALS {
                let single = with(&world, &frame, &form, material, 1, None).picture();
                let times = 2 + random.below(2);
                let multiple = with(&world, &frame, &form, material, times, None).picture();
                let (count, worst) = wrong(&multiple, &single, 1e-9);
                assert_eq!(count, 0, "{times} of {name} of {material}, {far} sizes of {scale} away: off by {worst:e}");
                let bare = with(&world, &frame, &form, material, 0, None).picture();
                let is_seen = |(with, without)| difference(with, without) > 1e-3;
                seen += single.iter().zip(&bare).filter(|(with, without)| is_seen((**with, **without))).count();
            }
        }
    }
    assert!(seen > 10_000, "{seen}");
}

#[test]
fn with_every_sampler() {
    let mut random = Random::new(102);
    let samplers = [
        json!({"none": {}}),
        json!({"regular": {"n": 2}}),
        json!({"shared": {"n": 1}}),
        json!({"adaptive": {"threshold": 0.05, "depth": 1}}),
        json!({"stochastic": {"n": 2}}),
        json!({"random": {"n": 2}}),
        json!({"sobol": {"n": 2}}),
        json!({"statistical": {"confidence": 0.9, "tolerance": 0.1, "min": 2, "max": 4}}),
        json!({"guided": {"tolerance": 0.1, "min": 2, "max": 4}}),
    ];
    for sampling in samplers {
        let frame = Frame::turned(&mut random, 100.0, 1.0);
        let forms = forms(&frame);
        for material in MATERIALS {
            let (name, form) = &forms[random.below(forms.len())];
            let gloss = json!({"diffuse": [0.5, 0.6, 0.4], "ior": 1.2, "gloss_exponent": 40, "translucency_exponent": 30,
                "samples": 2, "weights": {"local": 0.5, "reflected": 0.4, "transmitted": 1}});
            let world = world(&frame, [1.6, -2.5, 1.9], [16, 12]);
            let world = world.set("/sampling", sampling.clone()).material("glass", gloss);
            let world = world.set("/camera/lens", json!({"radius": 0.01, "focus_distance": 3}));
            let [single, double] = [1, 2].map(|times| with(&world, &frame, form, material, times, None).picture());
            let (count, worst) = wrong(&double, &single, 1e-9);
            assert_eq!(count, 0, "{name} of {material} with {sampling}: off by {worst:e}");
        }
    }
}

#[test]
fn while_it_moves() {
    let mut random = Random::new(103);
    for (far, scale) in FRAMES {
        let frame = Frame::turned(&mut random, far, scale);
        let world = world(&frame, [1.6, -2.5, 1.9], [16, 12]);
        let world = world.set("/camera/shutter", json!([0.1, 0.9])).set("/sampling", json!({"stochastic": {"n": 2}}));
        let shift = frame.span([0.4, 0.3, 0.2]);
        let turn = json!({"axis": frame.way([0.2, 0.9, 0.1]), "point": frame.at([0.5, 0.1, 0.3]), "degrees": 50});
        for motion in [json!({"translation": shift}), json!({"translation": shift, "rotation": turn})] {
            for (name, form) in forms(&frame) {
                let material = MATERIALS[random.below(3)];
                let [single, double] =
                    [1, 2].map(|times| with(&world, &frame, &form, material, times, Some(&motion)).picture());
                let (count, worst) = wrong(&double, &single, 1e-9);
                assert_eq!(
                    count, 0,
                    "{name} of {material}, {far} sizes of {scale} away, moving by {motion}: off by {worst:e}"
                );
            }
        }
    }
}

/// The faces of a quad's outline again: the same triangles from other corners, turned over, and cut along the other diagonal.
fn again(quads: &[[u32; 4]], how: usize) -> Vec<[u32; 3]> {
    quads
        .iter()
        .flat_map(|[a, b, c, d]| match how {
            0 => [[*a, *b, *c], [*a, *c, *d]],
            1 => [[*b, *c, *a], [*d, *a, *c]],
            2 => [[*c, *b, *a], [*c, *a, *d]],
            3 => [[*a, *b, *d], [*b, *c, *d]],
            _ => [[*d, *b, *a], [*d, *c, *b]],
        })
        .collect()
}

#[test]
fn a_mesh_with_doubled_faces_is_the_mesh_with_each_face_once() {
    let mut random = Random::new(104);
    // An open valley, whose quads are flat.
    let valley =
        [[-1.0, -0.9, 0.5], [0.1, -1.0, -0.1], [1.0, -0.9, 0.6], [1.0, 0.9, 0.6], [0.1, 1.0, -0.1], [-1.0, 0.9, 0.5]];
    let quads = [[0, 1, 4, 5], [1, 2, 3, 4]];
    for (far, scale) in FRAMES {
        for how in 0..5 {
            let frame = Frame::turned(&mut random, far, scale);
            let world = world(&frame, [1.6, -2.5, 1.9], [16, 12]);
            // A sheet that light crosses without being bent.
            let sheet =
                json!({"diffuse": [0.3, 0.4, 0.5], "weights": {"local": 0.4, "reflected": 0.3, "transmitted": 1}});
            let world = world.material("glass", sheet);
            for material in MATERIALS {
                let once = frame.mesh(&valley, &halves(&quads));
                let mut twice = once.clone();
                twice.faces.extend(again(&quads, how));
                // Repeated vertices, as files have them.
                if random.below(2) == 0 {
                    let count = twice.positions.len() as u32;
                    twice.positions.extend_from_within(..);
                    twice.faces[4..].iter_mut().flatten().for_each(|corner| *corner += count);
                }
                let [once, twice] =
                    [once, twice].map(|mesh| with(&world, &frame, &Form::Mesh(mesh), material, 1, None).picture());
                let (count, worst) = wrong(&twice, &once, 1e-9);
                assert_eq!(count, 0, "{how} of {material}, {far} sizes of {scale} away: off by {worst:e}");
            }
        }
    }
}
