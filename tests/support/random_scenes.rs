//! Scenes made at random: every kind of shape, material, light and sampler.

// Each test file compiles this for itself and uses a part of it.
#![allow(dead_code)]

use crate::random::Random;
use crate::support;
use raywalk::scene::Scene;
use serde_json::{Value, json};

/// The scene of a seed.
pub fn scene(seed: u64) -> Scene {
    let text = text(&mut Random::new(seed)).to_string();
    support::scene_of(text.as_bytes(), "random")
}

/// The scene of a seed, seen through a lens, with another method of sampling.
pub fn sampled(seed: u64, sampling: Value) -> Scene {
    let mut text = text(&mut Random::new(seed));
    text["sampling"] = sampling;
    text["camera"]["lens"] = json!({"radius": 0.05, "focus_distance": 4.0});
    support::scene_of(text.to_string().as_bytes(), "sampled")
}

/// The scene of a seed with so many objects that there is a tree over them, under an area light that is asked for many points.
pub fn crowded(seed: u64) -> Scene {
    support::scene_of(crowd(seed, 24).to_string().as_bytes(), "crowded")
}

/// The file of a scene of this many objects under an area light that is asked for many points.
pub fn crowd(seed: u64, objects: usize) -> Value {
    lit(&mut Random::new(seed), json!(9), objects)
}

/// The scene of a seed, every other time with a tree over its objects, under an area light that is asked for as many points as it takes.
pub fn adaptive(seed: u64) -> Scene {
    let mut random = Random::new(seed);
    let mut scene =
        lit(&mut random, json!({"min": 1 + seed % 5, "max": 9}), if seed.is_multiple_of(2) { 24 } else { 4 });
    let light = &mut scene["lights"][0];
    let is_disk = light["disk"].is_object();
    let is_sphere = light["sphere"].is_object();
    if !is_disk && random.below(2) == 0 {
        light["by"] = json!("solid_angle");
    }
    if !is_sphere && random.below(4) == 0 {
        light["profile"] = json!({"cosine_power": 2.5});
    }
    if random.below(2) == 0 {
        light["attenuation"] = json!([0.5, 0.25, 0.1]);
    }
    support::scene_of(scene.to_string().as_bytes(), "adaptive")
}

fn lit(random: &mut Random, samples: Value, objects: usize) -> Value {
    let mut text = text(random);
    let objects: Vec<_> = (0..objects).map(|number| object(random, number)).collect();
    let mut light = json!({"name": "lamp", "color": color(random), "samples": samples});
    let above = json!([4.0 * random.part() - 2.0, 3.0 + random.part(), 4.0 * random.part() - 1.0]);
    match random.below(3) {
        0 => light["rectangle"] = json!({"corner": above, "edge_u": [0.5, 0.2, 0.0], "edge_v": [0.0, 0.0, 0.5]}),
        1 => light["disk"] = json!({"center": above, "normal": point(random), "radius": 0.4}),
        _ => light["sphere"] = json!({"center": above, "radius": 0.3}),
    }
    (text["objects"], text["lights"], text["sampling"]) = (json!(objects), json!([light]), json!({"none": {}}));
    text
}

fn text(random: &mut Random) -> Value {
    let objects: Vec<_> = (0..3 + random.below(6)).map(|number| object(random, number)).collect();
    let materials: serde_json::Map<_, _> = (0..4).map(|number| (format!("m{number}"), material(random))).collect();
    let lights: Vec<_> = (0..1 + random.below(3)).map(|number| light(random, number)).collect();
    let mut camera = json!({
        "position": [random.part() - 0.5, random.part(), 4.0 + random.part()],
        "direction": [0.3 * (random.part() - 0.5), 0.3 * (random.part() - 0.5), -1.0],
        "vertical_fov": 30.0 + 40.0 * random.part(),
        "resolution": [9, 7],
    });
    if random.below(4) == 0 {
        camera["lens"] = json!({"radius": 0.1, "focus_distance": 4.0});
    }
    if random.below(3) == 0 {
        camera["shutter"] = json!([0.0, 0.75]);
    }
    json!({
        "format": "raywalk-scene/1",
        "camera": camera,
        "ambient": color(random),
        "background": color(random),
        "lights": lights,
        "materials": materials,
        "objects": objects,
        "tracing": {
            "max_depth": 1 + random.below(4),
            "algorithm": (["recursive", "whitted", "foley"][random.below(3)]),
            "specular": (["half_vector", "reflection_vector"][random.below(2)]),
            "sphere_method": (["robust", "geometric"][random.below(2)]),
        },
        "sampling": sampling(random),
    })
}

fn color(random: &mut Random) -> Value {
    json!([random.part(), random.part(), random.part()])
}

fn point(random: &mut Random) -> Value {
    json!((random.point() * 1.5).to_array())
}

fn sampling(random: &mut Random) -> Value {
    match random.below(9) {
        0 => json!({"none": {}}),
        1 => json!({"regular": {"n": 1 + random.below(3)}}),
        2 => json!({"shared": {"n": 1 + random.below(3)}}),
        3 => json!({"adaptive": {"threshold": 0.1, "depth": 2}}),
        4 => json!({"stochastic": {"n": 1 + random.below(7)}}),
        5 => json!({"random": {"n": 1 + random.below(12)}}),
        6 => json!({"sobol": {"n": 1 + random.below(7)}}),
        7 => json!({"guided": {"tolerance": 0.05, "min": 2, "max": 8}}),
        _ => json!({"statistical": {"confidence": 0.9, "tolerance": 0.05, "min": 4, "max": 16}}),
    }
}

fn material(random: &mut Random) -> Value {
    let mut material = json!({
        "ambient": color(random), "diffuse": color(random), "specular": color(random),
        "shininess": ([0.0, 1.0, 20.0, 255.0, 4096.0][random.below(5)]),
        "ior": ([1.0, 1.3, 1.5][random.below(3)]),
        "weights": {"local": 1.0, "reflected": ([0.0, 0.4][random.below(2)]), "transmitted": ([0.0, 0.6][random.below(2)])},
    });
    if random.below(3) == 0 {
        material["transmission"] = color(random);
        material["transmission_exponent"] = json!([1.0, 50.0][random.below(2)]);
    }
    if random.below(5) == 0 {
        material["gloss_exponent"] = json!(60.0);
        material["translucency_exponent"] = json!(40.0);
        material["samples"] = json!([1, 4][random.below(2)]);
    }
    if random.below(4) == 0 {
        material["pattern"] = json!({"checker": {"a": color(random), "b": color(random), "size": 0.5}});
    }
    material
}

fn light(random: &mut Random, number: usize) -> Value {
    let above = json!([4.0 * random.part() - 2.0, 3.0 + random.part(), 4.0 * random.part() - 1.0]);
    let mut light = json!({"name": format!("L{number}"), "color": color(random)});
    match random.below(5) {
        0 => light["directional"] = json!({"direction": [0.3, -1.0, -0.4]}),
        1 => {
            light["rectangle"] = json!({"corner": above, "edge_u": [0.5, 0.0, 0.0], "edge_v": [0.0, 0.0, 0.5]});
            light["samples"] = json!(2);
        }
        2 => {
            light["disk"] = json!({"center": above, "normal": [0.1, -1.0, 0.2], "radius": 0.4});
            light["profile"] = json!({"cosine_power": 2.0});
        }
        3 => light["sphere"] = json!({"center": above, "radius": 0.3}),
        _ => {
            light["point"] = json!({"position": above});
            light["attenuation"] = json!([0.5, 0.1, 0.02]);
        }
    }
    light
}

fn object(random: &mut Random, number: usize) -> Value {
    let radius = 0.3 + 0.6 * random.part();
    let shape = match random.below(9) {
        0 => json!({"plane": {"coefficients": [0.05, 1.0, 0.1, 1.2]}}),
        1 => json!({"sphere": {"center": point(random), "radius": radius}}),
        2 => json!({"ellipsoid": {"center": point(random), "radii": [radius, 0.2, 2.5 * radius]}}),
        3 => json!({"triangle": {"vertices": [point(random), point(random), point(random)]}}),
        4 => {
            let [x, y, z] = (random.point() * 1.5).to_array();
            let corners = [[x, y, z], [x + 1.0, y, z], [x + 1.0, y + 1.0, z], [x + 0.3, y + 0.4, z], [x, y + 1.0, z]];
            json!({"polygon": {"vertices": corners}})
        }
        5 => {
            let [x, y, z] = (random.point() * 1.5).to_array();
            json!({"box": {"min": [x, y, z], "max": [x + radius, y + 0.5, z + 2.0 * radius]}})
        }
        6 => {
            json!({"cylinder": {"base": point(random), "apex": point(random), "radius": 0.3, "caps": random.below(2) == 0}})
        }
        7 => {
            let caps = random.below(2) == 0;
            json!({"cone": {"base": point(random), "base_radius": radius, "apex": point(random), "apex_radius": 0.1, "caps": caps}})
        }
        _ => json!({"disk": {"center": point(random), "normal": point(random), "radius": radius}}),
    };
    let mut object = json!({"name": format!("O{number}"), "shape": shape, "material": format!("m{}", random.below(4))});
    if random.below(5) == 0 {
        let turn = json!({"axis": [0.2, 1.0, 0.1], "point": [0.0, 0.0, 0.0], "degrees": 40.0});
        object["motion"] = json!({"translation": [0.2, 0.1, 0.0], "rotation": turn});
    }
    object
}
