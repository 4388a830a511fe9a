//! Scenes nobody would think of: everything that a scene file can say, at random.

use crate::random::Random;
use serde_json::{Map, Value, json};

/// The text of a random scene. Most are in order; what isn't is refused.
pub fn scene(random: &mut Random) -> Vec<u8> {
    let materials: Vec<String> = (0..1 + random.below(4)).map(|number| format!("m{number}")).collect();
    let named: Map<String, Value> = materials.iter().map(|name| (name.clone(), material(random))).collect();
    let objects: Vec<Value> =
        (0..1 + random.below(12)).map(|number| object(random, &format!("o{number}"), &materials)).collect();
    let lights: Vec<Value> = (0..random.below(4)).map(|number| light(random, &format!("l{number}"))).collect();
    let mut scene = json!({
        "format": "raywalk-scene/1",
        "name": "soak",
        "camera": camera(random),
        "ambient": color(random, 0.5),
        "background": color(random, 1.0),
        "lights": lights,
        "materials": named,
        "objects": objects,
        "tracing": tracing(random),
        "sampling": sampling(random),
        "seed": random.below(1000),
        "output": {"white": 0.1 + 3.0 * random.part(), "transfer": one(random, &["linear", "srgb"]), "exposure": random.part()},
    });
    if chance(random, 0.2) {
        scene["frames"] = json!({"count": 4, "duration": 1.0});
    }
    scene.to_string().into_bytes()
}

fn chance(random: &mut Random, part: f64) -> bool {
    random.part() < part
}

fn one<'w>(random: &mut Random, words: &[&'w str]) -> &'w str {
    words[random.below(words.len())]
}

/// Mostly of ordinary size, now and then whole, tiny, far away or huge: where rounding shows.
fn number(random: &mut Random) -> f64 {
    let x = 10.0 * (2.0 * random.part() - 1.0);
    match random.below(20) {
        0..3 => x.round(),
        3 => x * 1e-9,
        4 => x * 1e6,
        _ => x,
    }
}

fn point(random: &mut Random) -> [f64; 3] {
    [0; 3].map(|_| number(random))
}

/// Sometimes along an axis.
fn direction(random: &mut Random) -> [f64; 3] {
    let unit = random.unit();
    match random.below(4) {
        0 => [0.0, -1.0, 0.0],
        1 => [0.0, 0.0, 1.0],
        _ => [unit.x, unit.y, unit.z],
    }
}

fn size(random: &mut Random) -> f64 {
    0.05 + 4.0 * random.part()
}

fn color(random: &mut Random, most: f64) -> [f64; 3] {
    [0; 3].map(|_| if chance(random, 0.2) { 0.0 } else { most * random.part() })
}

fn yes(random: &mut Random) -> bool {
    chance(random, 0.5)
}

fn camera(random: &mut Random) -> Value {
    let mut camera = json!({
        "position": point(random),
        "vertical_fov": 5.0 + 150.0 * random.part(),
        "resolution": [1 + random.below(40), 1 + random.below(30)],
    });
    if yes(random) {
        camera["look_at"] = json!([0, 0, 0]);
    } else {
        camera["direction"] = json!(direction(random));
    }
    if yes(random) {
        camera["up"] = json!(direction(random));
    }
    if chance(random, 0.2) {
        camera["lens"] = json!({"radius": size(random) / 10.0, "focus_distance": size(random)});
    }
    if chance(random, 0.3) {
        camera["shutter"] = json!([0.0, random.part()]);
    }
    camera
}

fn light(random: &mut Random, name: &str) -> Value {
    let kind = match random.below(5) {
        0 => json!({"position": point(random)}),
        1 => json!({"direction": direction(random)}),
        2 => json!({"corner": point(random), "edge_u": [size(random), 0, 0], "edge_v": [0, 0.5, size(random)]}),
        3 => json!({"center": point(random), "normal": direction(random), "radius": size(random)}),
        _ => json!({"center": point(random), "radius": size(random)}),
    };
    let word = match &kind {
        kind if kind.get("position").is_some() => "point",
        kind if kind.get("direction").is_some() => "directional",
        kind if kind.get("corner").is_some() => "rectangle",
        kind if kind.get("normal").is_some() => "disk",
        _ => "sphere",
    };
    let mut light = json!({"name": name, "color": color(random, 2.0), word: kind});
    if chance(random, 0.3) && word != "directional" {
        light["attenuation"] = json!([1.0, 0.1 * random.part(), 0.01]);
    }
    if matches!(word, "rectangle" | "disk" | "sphere") {
        let most = 1 + random.below(4);
        light["samples"] = if chance(random, 0.5) { json!({"min": 1, "max": most}) } else { json!(most) };
    }
    light
}

fn material(random: &mut Random) -> Value {
    let mut material = json!({
        "ambient": color(random, 0.5),
        "diffuse": color(random, 0.8),
        "specular": color(random, 0.8),
        "shininess": 1.0 + 200.0 * random.part() * random.part(),
        "ior": one_of(random, &[1.0, 1.33, 1.5, 2.4, 0.7]),
        "weights": {"local": random.part(), "reflected": random.part() * 0.7, "transmitted": color(random, 0.9)},
    });
    if chance(random, 0.3) {
        material["transmission"] = json!(color(random, 0.7));
        material["transmission_exponent"] = json!(1.0 + 20.0 * random.part());
    }
    if chance(random, 0.15) {
        material["gloss_exponent"] = json!(1.0 + 500.0 * random.part());
        material["samples"] = json!(1 + random.below(3));
    }
    if chance(random, 0.15) {
        material["translucency_exponent"] = json!(1.0 + 500.0 * random.part());
    }
    if chance(random, 0.2) {
        material["pattern"] =
            json!({"checker": {"a": color(random, 1.0), "b": color(random, 1.0), "size": size(random)}});
    }
    material
}

fn one_of(random: &mut Random, numbers: &[f64]) -> f64 {
    numbers[random.below(numbers.len())]
}

fn object(random: &mut Random, name: &str, materials: &[String]) -> Value {
    let mut object =
        json!({"name": name, "shape": shape(random), "material": materials[random.below(materials.len())]});
    if chance(random, 0.2) {
        object["motion"] = json!({"translation": point(random)});
        if yes(random) {
            object["motion"]["rotation"] =
                json!({"axis": direction(random), "point": point(random), "degrees": 360.0 * random.part()});
        }
    }
    object
}

fn shape(random: &mut Random) -> Value {
    let (a, b) = (point(random), point(random));
    match random.below(9) {
        0 => {
            let [x, y, z] = direction(random);
            json!({"plane": {"coefficients": [x, y, z, number(random)]}})
        }
        1 => json!({"sphere": {"center": a, "radius": size(random), "inward": chance(random, 0.1)}}),
        2 => json!({"ellipsoid": {"center": a, "radii": [size(random), size(random), size(random)]}}),
        3 => json!({"triangle": {"vertices": [a, b, point(random)]}}),
        4 => {
            let [x, y, z] = a;
            let (w, h) = (size(random), size(random));
            json!({"polygon": {"vertices": [[x, y, z], [x + w, y, z], [x + w, y + h, z], [x + w / 2.0, y + h / 3.0, z], [x, y + h, z]]}})
        }
        5 => {
            let max: Vec<f64> = a.iter().map(|low| low + size(random)).collect();
            json!({"box": {"min": a, "max": max}})
        }
        6 => json!({"cylinder": {"base": a, "apex": b, "radius": size(random), "caps": yes(random)}}),
        7 => {
            json!({"cone": {"base": a, "base_radius": size(random), "apex": b, "apex_radius": if yes(random) { 0.0 } else { size(random) }, "caps": yes(random)}})
        }
        _ => json!({"disk": {"center": a, "normal": direction(random), "radius": size(random)}}),
    }
}

fn tracing(random: &mut Random) -> Value {
    json!({
        "algorithm": one(random, &["recursive", "whitted", "foley"]),
        "max_depth": random.below(5),
        "specular": one(random, &["half_vector", "reflection_vector"]),
        "sphere_method": one(random, &["robust", "geometric"]),
        "cutoff": if chance(random, 0.2) { 0.01 } else { 0.0 },
        "two_sided": yes(random),
    })
}

fn sampling(random: &mut Random) -> Value {
    let n = 1 + random.below(3);
    match random.below(9) {
        0 => json!({"regular": {"n": n}}),
        1 => json!({"shared": {"n": n}}),
        2 => json!({"adaptive": {"threshold": 0.01 + 0.2 * random.part(), "depth": n}}),
        3 => json!({"stochastic": {"n": n}}),
        4 => json!({"random": {"n": n}}),
        5 => json!({"sobol": {"n": n}}),
        6 => json!({"statistical": {"confidence": 0.9, "tolerance": 0.1, "min": 4, "max": 16}}),
        7 => json!({"guided": {"tolerance": 0.001 + 0.1 * random.part(), "min": n, "max": 16}}),
        _ => json!({"none": {}}),
    }
}
