//! From the records of an NFF file to a scene file.

use super::places::Places;
use super::records::{Fill, Light, Primitive, Records, View};
use super::{Angle, Import};
use crate::scene::file::converted::converted;
use crate::scene::file::names::fill_in_names;
use crate::scene::file::schema::{
    self, Aim, Camera, FORMAT, LightKind, Material, Materials, Object, Output, PointLight, Sampling, SceneFile, Shape,
    Tracing, Weight, Weights,
};
use compact_str::{CompactString, format_compact};
use std::convert::Infallible;

/// The scene: one material a fill, one object a primitive; and where all of them are in the file.
pub fn scene(records: Records, file_name: &str, import: &Import) -> (SceneFile, Places) {
    let places = Places::of(&records);
    let mut materials = Materials::default();
    for (index, fill) in records.fills.into_iter().enumerate() {
        materials.insert(&fill_name(index as u32), material(&fill));
    }
    let shared_light = 1.0 / (records.lights.len() as f64).sqrt();
    let mut numbers = Numbers::default();
    let Ok(objects) = converted(records.primitives, |_, each| Ok::<_, Infallible>(object(each, &mut numbers)));
    let mut scene = SceneFile {
        format: FORMAT.to_string(),
        name: String::new(),
        camera: camera(&records.view, import),
        ambient: [0.0; 3],
        background: records.background.map_or([0.0; 3], |(color, _)| color),
        lights: records.lights.iter().map(|each| light(each, shared_light)).collect(),
        materials,
        objects,
        tracing: Tracing { two_sided: false, ..Tracing::default() },
        sampling: Sampling::default(),
        seed: 0,
        frames: None,
        output: Output::default(),
    };
    fill_in_names(&mut scene, file_name);
    (scene, places)
}

fn camera(view: &View, import: &Import) -> Camera {
    let resolution = import.resolution.unwrap_or(view.resolution.value);
    Camera {
        position: view.from.value,
        aim: Aim::LookAt(view.at.value),
        up: view.up.value,
        vertical_fov: vertical_fov(view.angle.value, import.angle, resolution[1]),
        resolution,
        lens: None,
        shutter: [0.0; 2],
    }
}

/// The angle from the picture's top edge to its bottom edge, in degrees.
///
/// Between the centres of the first and the last of Y rows there are Y − 1 pixels, between the edges Y, so that
/// tan(fov/2) = tan(angle/2)·Y/(Y − 1). A single row has no two centres; its angle is taken between the edges.
fn vertical_fov(angle: f64, between: Angle, rows: u32) -> f64 {
    if between == Angle::Edges || rows < 2 {
        return angle;
    }
    let rows = f64::from(rows);
    let half = libm::tan(angle.to_radians() / 2.0) * rows / (rows - 1.0);
    2.0 * libm::atan(half).to_degrees()
}

fn light(light: &Light, shared_light: f64) -> schema::Light {
    schema::Light {
        name: CompactString::default(),
        kind: LightKind::Point(PointLight { position: light.position }),
        color: light.color.unwrap_or([shared_light; 3]),
        attenuation: [1.0, 0.0, 0.0],
        profile: None,
        samples: None,
        by: None,
    }
}

fn material(fill: &Fill) -> Material {
    Material {
        diffuse: fill.color.map(|channel| channel * fill.diffuse),
        specular: [fill.specular; 3],
        shininess: fill.shine,
        ior: fill.ior,
        weights: Weights {
            local: Weight::Scalar(1.0),
            reflected: Weight::Scalar(fill.specular),
            transmitted: Weight::Scalar(fill.transmittance),
        },
        ..Material::default()
    }
}

fn object(primitive: Primitive, numbers: &mut Numbers) -> Object {
    Object {
        name: numbers.name(&primitive.shape),
        shape: primitive.shape,
        material: Some(fill_name(primitive.fill)),
        motion: None,
    }
}

fn fill_name(index: u32) -> CompactString {
    format_compact!("fill-{}", index + 1)
}

/// Numbers the objects of each shape from 1.
#[derive(Default)]
struct Numbers {
    spheres: u32,
    cylinders: u32,
    cones: u32,
    triangles: u32,
    polygons: u32,
}

impl Numbers {
    fn name(&mut self, shape: &Shape) -> CompactString {
        let number = match shape {
            Shape::Sphere(_) => &mut self.spheres,
            Shape::Cylinder(_) => &mut self.cylinders,
            Shape::Cone(_) => &mut self.cones,
            Shape::Triangle(_) => &mut self.triangles,
            _ => &mut self.polygons,
        };
        *number += 1;
        format_compact!("{}-{number}", shape.key())
    }
}
