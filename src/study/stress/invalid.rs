//! Cases of input that is no input: what the readers of the program say to it, and what comes out.

use super::question::{ShapeInput, Triple, any, any_number, field, fields};
use super::stage;
use super::watch::Watch;
use super::way::Way;
use crate::geometry::{Ray, Shape};
use crate::log::Name;
use crate::probe::{Erased, Silent};
use crate::scene::file;
use crate::scene::{Color, Formulas, Light, LightKind};
use crate::trace::query::Query;
use crate::trace::{refract, transmitted_half};
use glam::DVec3;
use serde_json::{Map, Value, json};

/// `invalid`: whether the input is refused (`invalid`), or what becomes of it (`miss`, `hit`, `finite`).
pub(super) fn verdict(case: &Map<String, Value>) -> Result<Value, String> {
    let op = case.get("op").and_then(Value::as_str).ok_or("in.op: expected the name of an operation")?;
    let expect = match op {
        "sphere" | "plane" | "triangle" | "ellipsoid" => shape(case),
        "camera" => camera(case),
        "refract" => refraction(case)?,
        "power" => power(case)?,
        "half" | "hprime" => half(case)?,
        "light_at_point" => light_at_point(case)?,
        other => return Err(format!("in.op: unknown operation `{other}`")),
    };
    Ok(json!({"expect": expect}))
}

const INVALID: &str = "invalid";
const FINITE: &str = "finite";
const NOT_FINITE: &str = "not finite";

/// A ray at a shape. Spheres and planes go through the reader of scene files, rays through that of ray queries.
fn shape(case: &Map<String, Value>) -> &'static str {
    let Some(shape) = checked_shape(case) else { return INVALID };
    let [Some(origin), Some(direction)] = ["o", "d"].map(|key| triple(case, key)) else { return INVALID };
    let query = Query::new(origin, direction);
    if query.check().is_err() {
        return INVALID;
    }
    match query.nearest(&stage::scene_of(&Way::OWN, vec![shape])) {
        None => "miss",
        Some(answer) if answer.t.is_finite() && answer.point.is_finite() && answer.normal.is_finite() => "hit",
        Some(_) => NOT_FINITE,
    }
}

fn checked_shape(case: &Map<String, Value>) -> Option<Shape> {
    let (in_file, shape) = if let Some(center) = case.get("c") {
        let center = numbers(center)?;
        let radius = any(case.get("r")?)?;
        let shape = ShapeInput::Sphere { c: center.try_into().ok()?, r: radius };
        (Some(json!({"sphere": {"center": case.get("c"), "radius": case.get("r")}})), shape)
    } else if let Some(coefficients) = case.get("abcd") {
        let shape = ShapeInput::Plane { abcd: numbers(coefficients)?.try_into().ok()? };
        (Some(json!({"plane": {"coefficients": coefficients}})), shape)
    } else if let Some(corners) = case.get("v") {
        let corners: Vec<Triple> =
            corners.as_array()?.iter().map(|corner| numbers(corner)?.try_into().ok()).collect::<Option<_>>()?;
        let [v0, v1, v2] = corners.try_into().ok()?;
        (None, ShapeInput::Triangle { v0, v1, v2 })
    } else {
        let rows = case.get("m")?.as_array()?.iter().map(|row| numbers(row)?.try_into().ok());
        let rows: Vec<[f64; 4]> = rows.collect::<Option<_>>()?;
        (None, ShapeInput::Ellipsoid { m: rows.try_into().ok()? })
    };
    if let Some(shape) = in_file {
        is_accepted("objects", json!([{"shape": shape}])).then_some(())?;
    }
    let is_finite = match &shape {
        ShapeInput::Triangle { v0, v1, v2 } => [v0, v1, v2].into_iter().flatten().all(|x| x.is_finite()),
        ShapeInput::Ellipsoid { m } => m.iter().flatten().all(|x| x.is_finite()),
        _ => true,
    };
    is_finite.then(|| stage::shape(&Way::OWN, &shape).ok()).flatten()
}

/// A camera, by the reader of scene files.
fn camera(case: &Map<String, Value>) -> &'static str {
    let camera = json!({
        "position": case.get("eye"), "look_at": case.get("at"), "up": case.get("up"),
        "vertical_fov": case.get("fov"),
    });
    if is_accepted("camera", camera) { FINITE } else { INVALID }
}

/// Whether a scene file with this part is accepted. What JSON has no number for is there as a text.
fn is_accepted(key: &str, part: Value) -> bool {
    let camera = json!({"position": [0, 0, 0], "direction": [0, 0, 1]});
    let mut scene = json!({"format": "raywalk-scene/1", "camera": camera, "objects": []});
    scene[key] = part;
    file::check(scene.to_string().as_bytes(), "case.json").is_ok()
}

fn refraction(case: &Map<String, Value>) -> Result<&'static str, String> {
    let [d, n]: [Triple; 2] = fields(case, ["d", "n"])?;
    let eta = any_number(case, "eta")?;
    let normal = DVec3::from(n);
    // Materials are refused by scene files unless their index is positive, and shapes have unit normals.
    let material = json!({"ior": if eta.is_finite() { json!(eta) } else { Value::Null }});
    if !is_material(&material) || normal == DVec3::ZERO {
        return Ok(INVALID);
    }
    let direction = refract(&Ray::along(DVec3::ZERO, d.into()), normal, [1.0, eta], Formulas::Robust, &mut Silent);
    Ok(if direction.is_none_or(DVec3::is_finite) { FINITE } else { NOT_FINITE })
}

fn power(case: &Map<String, Value>) -> Result<&'static str, String> {
    let (x, n) = (any_number(case, "x")?, any_number(case, "n")?);
    let material = json!({"shininess": if n.is_finite() { json!(n) } else { Value::Null }});
    if !is_material(&material) || x.is_nan() {
        return Ok(INVALID);
    }
    Ok(if crate::trace::power(x, n).is_finite() { FINITE } else { NOT_FINITE })
}

fn is_material(material: &Value) -> bool {
    is_accepted("materials", json!({"m": material}))
}

/// The half vectors of a light straight behind the surface.
fn half(case: &Map<String, Value>) -> Result<&'static str, String> {
    let [light, view]: [Triple; 2] = fields(case, ["L", "V"])?;
    let eta = field::<Option<f64>>(case, "eta")?.unwrap_or(1.0);
    let mut case = case.clone();
    for (key, value) in [("N", json!(view)), ("kd", json!(1)), ("ke", json!(1)), ("kt", json!(1))] {
        case.insert(key.to_owned(), value);
    }
    for (key, value) in [("n", json!(10)), ("nt", json!(10)), ("eta", json!(eta))] {
        case.insert(key.to_owned(), value);
    }
    let mut watch = Watch::default();
    let half = if eta == 1.0 {
        None
    } else {
        transmitted_half(light.into(), view.into(), eta, Formulas::Robust, &mut Erased::of(&mut watch))
    };
    let length = watch.number(Name::TransmitLength);
    let parts = super::optics::local(&Way::OWN, &case)?;
    let is_finite = half.is_none_or(DVec3::is_finite) && length.is_none_or(f64::is_finite) && has_numbers(&parts);
    Ok(if is_finite { FINITE } else { NOT_FINITE })
}

/// Whether every part is a number: JSON writes what is none as null.
fn has_numbers(value: &Value) -> bool {
    match value {
        Value::Object(parts) => parts.values().all(has_numbers),
        value => value.is_number(),
    }
}

fn light_at_point(case: &Map<String, Value>) -> Result<&'static str, String> {
    let [p, light]: [Triple; 2] = fields(case, ["p", "light"])?;
    let kind = LightKind::Point { position: light.into() };
    let light = Light { name: "light".into(), kind, color: Color::ONE, attenuation: None };
    let arrival = light.seen_from(p.into(), &mut Silent);
    let is_finite = arrival.is_none_or(|arrival| arrival.direction.is_finite() && arrival.distance.is_finite());
    Ok(if is_finite { FINITE } else { NOT_FINITE })
}

fn triple(case: &Map<String, Value>, key: &str) -> Option<DVec3> {
    let numbers: Triple = numbers(case.get(key)?)?.try_into().ok()?;
    Some(numbers.into())
}

fn numbers(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(any).collect()
}
