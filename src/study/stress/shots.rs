//! Cases that shoot rays at shapes.

use super::question::{MeshData, ObjectInput, RayInput, ShapeInput, Triple, field, fields, input};
use super::stage;
use super::watch::Watch;
use super::way::Way;
use crate::geometry::{Ray, Shape};
use crate::log::Name;
use crate::scene::{Color, Light, LightKind, Scene};
use crate::trace::{all_crossings, closest_hit, segment_to_light, transmittance};
use glam::DVec3;
use serde::Deserialize;
use serde_json::{Map, Value, json};

#[derive(Deserialize)]
struct Ball {
    c: Triple,
    r: f64,
}

/// `sphere`, `plane`, `triangle`, `ellipsoid`: one ray at one shape.
pub(super) fn one_shape(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum One {
        Sphere { c: Triple, r: f64 },
        Plane { abcd: [f64; 4] },
        Triangle { v: [Triple; 3] },
        Ellipsoid { m: [[f64; 4]; 3] },
    }
    let shape = match input(case)? {
        One::Sphere { c, r } => ShapeInput::Sphere { c, r },
        One::Plane { abcd } => ShapeInput::Plane { abcd },
        One::Triangle { v: [v0, v1, v2] } => ShapeInput::Triangle { v0, v1, v2 },
        One::Ellipsoid { m } => ShapeInput::Ellipsoid { m },
    };
    let scene = stage::scene_of(way, vec![stage::shape(way, &shape)?]);
    let ray = stage::ray(way, &scene, &input(case)?);
    let (found, watch) = stage::meet(way, &scene, &ray);
    let gap = match shape {
        ShapeInput::Sphere { r, .. } => relative_gap(&watch, r),
        _ => Value::Null,
    };
    let Some((hit, surface)) = found else { return Ok(json!({"hit": false, "gap": gap})) };
    let mut answer = json!({
        "hit": true, "t": hit.crossing.t, "n": stage::outward(&surface).to_array(), "gap": gap,
    });
    if let (Shape::Triangle(triangle), Some(answer)) = (&scene.objects[0].shape, answer.as_object_mut()) {
        let weights = triangle.weights(surface.point);
        let least = (0..3).min_by(|a, b| weights[*a].total_cmp(&weights[*b])).unwrap_or_default();
        answer.insert("u".to_owned(), json!(weights[1]));
        answer.insert("v".to_owned(), json!(weights[2]));
        answer.insert("edge".to_owned(), json!((least + 1) % 3));
    }
    Ok(answer)
}

/// How far beside a sphere of this radius the line passes that was last noted, in radii less one: from r² − T2_A.
fn relative_gap(watch: &Watch, radius: f64) -> Value {
    let half_chord = watch.number(Name::SphereT2a).map(|t2_a| t2_a / radius / radius);
    half_chord.map_or(Value::Null, |part| json!(-part / (1.0 + (1.0 - part).max(0.0).sqrt())))
}

/// `spheres`: all crossings with several spheres, in order.
pub(super) fn spheres(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    let s: Vec<Ball> = field(case, "s")?;
    let scene = stage::scene_of(way, s.iter().map(|ball| stage::sphere(way, ball.c, ball.r)).collect());
    let ray = stage::ray(way, &scene, &input(case)?);
    let crossings = way.computed(|probe| all_crossings(&scene, &ray, probe));
    let order: Vec<_> = crossings.iter().map(|hit| hit.object).collect();
    let t: Vec<_> = crossings.iter().map(|hit| hit.crossing.t).collect();
    Ok(json!({"order": order, "t": t}))
}

/// `nearest`: what a ray hits first among several shapes.
pub(super) fn nearest(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    let scene = objects(way, case)?;
    let ray = stage::ray(way, &scene, &input(case)?);
    Ok(match stage::meet(way, &scene, &ray).0 {
        None => json!({"hit": false, "t": null, "id": null}),
        Some((hit, surface)) => {
            let normal = stage::outward(&surface).to_array();
            json!({"hit": true, "t": hit.crossing.t, "id": hit.object, "n": normal})
        }
    })
}

/// `mesh`: which triangle a ray hits. The mesh belongs to the whole family.
pub(super) fn mesh(way: &Way, case: &Map<String, Value>, scene: &Scene) -> Result<Value, String> {
    let ray = stage::ray(way, scene, &input(case)?);
    Ok(match way.computed(|probe| closest_hit(scene, &ray, probe)) {
        None => json!({"hit": false, "t": null, "id": null}),
        Some(hit) => json!({"hit": true, "t": hit.crossing.t, "id": hit.crossing.primitive}),
    })
}

/// The scene of a family's mesh.
pub(super) fn mesh_scene(way: &Way, data: &MeshData) -> Result<Scene, String> {
    Ok(stage::scene_of(way, vec![stage::shape(way, &ShapeInput::Mesh(data.clone()))?]))
}

/// `visible`: whether a light is seen from a point.
pub(super) fn visible(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    let [p, light]: [Triple; 2] = fields(case, ["p", "light"])?;
    let scene = objects(way, case)?;
    let kind = LightKind::Point { position: light.into() };
    let light = Light { name: "light".into(), kind, color: Color::ONE, attenuation: None };
    let point = DVec3::from(p);
    let is_visible = way.computed(|probe| {
        let arrival = light.seen_from(point, probe);
        arrival.is_some_and(|arrival| transmittance(&scene, &segment_to_light(point, &arrival), probe) == Color::ONE)
    });
    Ok(json!({"visible": is_visible}))
}

/// `spawn`: rays that leave the point where a first ray has met a shape.
pub(super) fn spawn(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    let shape = match (field(case, "sphere")?, field(case, "plane")?, field::<Option<[Triple; 3]>>(case, "triangle")?) {
        (Some(Ball { c, r }), None, None) => ShapeInput::Sphere { c, r },
        (None, Some(abcd), None) => ShapeInput::Plane { abcd },
        (None, None, Some([v0, v1, v2])) => ShapeInput::Triangle { v0, v1, v2 },
        _ => return Err("in: expected one of `sphere`, `plane`, `triangle`".to_owned()),
    };
    let directions: Vec<Triple> = field(case, "w")?;
    let scene = stage::scene_of(way, vec![stage::shape(way, &shape)?]);
    let ray = stage::ray(way, &scene, &input(case)?);
    let Some((hit, surface)) = stage::meet(way, &scene, &ray).0 else {
        return Ok(json!({"t": null, "exit": vec![Value::Null; directions.len()]}));
    };
    let exit = |w: &Triple| {
        let ray = stage::ray(way, &scene, &RayInput { o: surface.point.to_array(), d: *w });
        let on_this_side = surface.normal.dot(ray.direction) >= 0.0;
        let ray = Ray { leaving: Some(stage::leaving(&hit, &surface, on_this_side)), ..ray };
        way.computed(|probe| closest_hit(&scene, &ray, probe)).map(|hit| hit.crossing.t)
    };
    let exits: Vec<_> = directions.iter().map(exit).collect();
    Ok(json!({"t": hit.crossing.t, "exit": exits}))
}

fn objects(way: &Way, case: &Map<String, Value>) -> Result<Scene, String> {
    let objects: Vec<ObjectInput> = field(case, "objects")?;
    Ok(stage::scene_of(way, stage::shapes(way, &objects)?))
}
