//! Cases of light at a surface: refraction, the local model, whole scenes, means.

use super::question::{MaterialInput, RayInput, Triple, field, fields, input};
use super::stage;
use super::watch::Watch;
use super::way::Way;
use crate::geometry::{Ray, Side, Surface};
use crate::log::Name;
use crate::probe::Probe;
use crate::random::{Arrangement, Draws};
use crate::sampling::mean::Sum;
use crate::scene::{Color, Formulas, Light, LightKind, Scene, Specular};
use crate::trace::{
    Layer, Media, Meeting, Path, camera_ray, local_intensity, power, power_between, printed_cosine, refract,
    transmitted_cosine, transmitted_half,
};
use glam::DVec3;
use serde::Deserialize;
use serde_json::{Map, Value, json};

/// A ray along a vector of any length.
fn along(vector: Triple) -> Ray {
    Ray::along(DVec3::ZERO, vector.into())
}

/// `refract`: cos φ₂ and T, or a total internal reflection.
pub(super) fn refraction(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    let [d, n]: [Triple; 2] = fields(case, ["d", "n"])?;
    let eta = field(case, "eta")?;
    let (ray, normal) = (along(d), DVec3::from(n));
    let ray = way.ray(ray);
    let k = way.computed(|probe| {
        let cos_1 = -normal.dot(ray.direction);
        match way.formulas() {
            Formulas::Robust => transmitted_cosine(&ray, normal, eta, cos_1, probe).squared,
            Formulas::Notes => printed_cosine(eta, cos_1, probe).squared,
        }
    });
    let (direction, watch) = way.watched(|probe| refract(&ray, normal, [1.0, eta], way.formulas(), probe));
    Ok(match direction {
        Some(direction) => {
            json!({"tir": false, "cos2": watch.number(Name::RefractCos2), "T": direction.to_array(), "k": k})
        }
        None => json!({"tir": true, "k": k}),
    })
}

/// `refract_hprime`: T, and H′ for two directions.
pub(super) fn refraction_and_half(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    let [d, n, light, view]: [Triple; 4] = fields(case, ["d", "n", "L", "V"])?;
    let eta = field(case, "eta")?;
    let (ray, normal) = (along(d), DVec3::from(n));
    let ray = way.ray(ray);
    let (direction, refracted) = way.watched(|probe| refract(&ray, normal, [1.0, eta], way.formulas(), probe));
    let (light, view) = (DVec3::from(light), DVec3::from(view));
    // Without an interface the lobe is the straight line from the light.
    let (half, watch) = match eta {
        1.0 => (Some(light), Watch::default()),
        _ => way.watched(|probe| transmitted_half(light, view, eta, way.formulas(), probe)),
    };
    Ok(json!({
        "T": direction.map(|direction| direction.to_array()),
        "cos2": refracted.number(Name::RefractCos2),
        "deviation": direction.map(|direction| (direction - ray.direction).length()),
        "hraw_len": watch.number(Name::TransmitLength),
        "h": half.map(|half| half.to_array()),
        "ndoth": half.map(|half| normal.dot(half)),
    }))
}

/// `power`: x^n, or the n-th power of the cosine between two vectors.
pub(super) fn power_of(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    #[allow(non_snake_case)]
    enum Power {
        Given { x: f64, n: f64 },
        Between { N: Triple, H: Triple, n: f64 },
    }
    Ok(match input(case)? {
        Power::Given { x, n } => json!({"y": noted(way, power(x, n))}),
        Power::Between { N: normal, H: half, n } => {
            let (normal, half) = (DVec3::from(normal), DVec3::from(half));
            // As a lobe does it: an arithmetic of its own has but its own cosine.
            let is_certain = way.computed(|probe| probe.certifies()) && way.formulas() == Formulas::Robust;
            json!({"y": match is_certain {
                true => power_between(normal, half, n),
                false => noted(way, power(way.computed(|probe| probe.note(Name::ShadeNDotH, normal.dot(half))), n)),
            }})
        }
    })
}

/// A power as the arithmetic goes on with it.
fn noted(way: &Way, power: f64) -> f64 {
    way.computed(|probe| probe.note(Name::ShadeSpecularPower, power))
}

/// `stack`: the direction of a ray behind many refracting surfaces.
pub(super) fn stack(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    #[derive(Deserialize)]
    #[serde(tag = "kind", rename_all = "snake_case")]
    enum Stack {
        Planes { d: Triple, n: Triple, iors: Vec<f64> },
        Spheres { radii: Vec<f64>, iors: Vec<f64> },
    }
    match input(case)? {
        Stack::Planes { d, n, iors } => Ok(through_planes(way, d, n, &iors)),
        Stack::Spheres { radii, iors } => {
            if iors.len() != radii.len() + 1 {
                return Err("in.iors: expected one more than `radii`".to_owned());
            }
            Ok(through_spheres(way, &input(case)?, &radii, &iors))
        }
    }
}

/// Planes have no distance here: only the directions matter.
fn through_planes(way: &Way, d: Triple, n: Triple, iors: &[f64]) -> Value {
    let mut ray = way.ray(along(d));
    let normal = DVec3::from(n);
    let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
    for media in iors.windows(2) {
        match way.computed(|probe| refract(&ray, normal, [media[0], media[1]], way.formulas(), probe)) {
            Some(direction) => ray = Ray::new(DVec3::ZERO, direction),
            None => return json!({"T": null}),
        }
    }
    json!({"T": ray.direction.to_array()})
}

/// Spheres one in the other, all about the origin, traced as a scene.
fn through_spheres(way: &Way, input: &RayInput, radii: &[f64], iors: &[f64]) -> Value {
    let mut scene = stage::scene_of(way, radii.iter().map(|radius| stage::sphere(way, [0.0; 3], *radius)).collect());
    let glass = |ior: &f64| stage::material(&MaterialInput { ior: *ior, wl: 0.0, wt: 1.0, ..MaterialInput::default() });
    scene.materials = iors[1..].iter().map(glass).collect();
    for (number, object) in scene.objects.iter_mut().enumerate() {
        object.material = number;
    }
    scene.tracing.max_depth = 2 * radii.len() as u32 + 2;
    let ray = stage::ray(way, &scene, input);
    let (_, watch) = way.watched(|probe| camera_ray(&scene, |_| Some(ray), probe));
    json!({
        "T": watch.triple(Name::RefractDirection),
        "p": watch.triple(Name::HitPoint),
        "interfaces": watch.transmitted_rays,
    })
}

/// `local`: the three parts of the local model, in the channels of one colour.
pub(super) fn local(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    let [normal, light, view]: [Triple; 3] = fields(case, ["N", "L", "V"])?;
    let [kd, ke, kt, n, nt, eta] = fields(case, ["kd", "ke", "kt", "n", "nt", "eta"])?;
    let none = MaterialInput::default();
    let parts = MaterialInput { kd: [kd, 0.0, 0.0], ke: [0.0, ke, 0.0], kt: [0.0, 0.0, kt], n, nt, ior: 1.0, ..none };
    let mut scene = stage::scene_of(way, vec![stage::sphere(way, [0.0; 3], 1.0)]);
    scene.materials = vec![stage::material(&parts)];
    let kind = LightKind::Directional { travel: -DVec3::from(light) };
    scene.lights = vec![Light { name: "light".into(), kind, color: Color::ONE, attenuation: None }];
    // The viewer's side has the index η, the light's side 1.
    let media = Media::around(vec![(u32::MAX, eta)]);
    let mut parts_with = |specular: Specular| {
        scene.tracing.specular = specular;
        let [diffuse, specular, transmitted] = local_parts(way, &scene, normal, view, &media).to_array();
        json!({"diffuse": diffuse, "specular": specular, "transmitted": transmitted})
    };
    Ok(json!({"H": parts_with(Specular::HalfVector), "R": parts_with(Specular::ReflectionVector)}))
}

fn local_parts(way: &Way, scene: &Scene, normal: Triple, view: Triple, media: &Media) -> Color {
    let ray = Ray::new(DVec3::from(view), -DVec3::from(view));
    let draws = Draws::of_pixel(0, [0; 2], 0, Arrangement::Independent);
    let meeting = Meeting {
        layer: Layer { object: 0, primitive: 0, side: Side::Front },
        place: None,
        ray: &ray,
        surface: Surface::plain(DVec3::ZERO, normal.into(), Side::Front),
        material: &scene.materials[0],
        weights: &scene.materials[0].weights,
        path: &Path::of_camera(media, &draws),
        slack: 0.0,
    };
    way.computed(|probe| local_intensity(scene, &meeting, probe))
}

/// `scene`: the colours that single rays bring.
pub(super) fn colors(way: &Way, case: &Map<String, Value>) -> Result<Value, String> {
    let rays: Vec<RayInput> = field(case, "rays")?;
    let scene = stage::whole_scene(way, &field(case, "scene")?)?;
    let color = |input: &RayInput| {
        let ray = stage::ray(way, &scene, input);
        json!({"rgb": way.computed(|probe| camera_ray(&scene, |_| Some(ray), probe)).to_array()})
    };
    Ok(json!({"rays": rays.iter().map(color).collect::<Vec<_>>()}))
}

/// `mean`: the mean of values, or of one value many times.
pub(super) fn mean(case: &Map<String, Value>) -> Result<Value, String> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Values {
        Listed { v: Vec<f64> },
        Repeated { repeat: usize, value: f64 },
    }
    /// More samples than a pixel has.
    const MOST: usize = 1 << 24;
    let values = match input(case)? {
        Values::Listed { v } => v,
        Values::Repeated { repeat, value } if repeat <= MOST => vec![value; repeat],
        Values::Repeated { .. } => return Err(format!("in.repeat: expected at most {MOST}")),
    };
    let mut sum = Sum::ZERO;
    values.iter().for_each(|value| sum.add(Color::splat(*value)));
    Ok(json!({"mean": sum.over(values.len() as f64).x}))
}
