//! Scenes of coincident surfaces, made at random in frames of any place and tilt.

use crate::random::Random;
use glam::DVec3;
use raywalk::geometry::Mesh;
use raywalk::record::Arithmetic;
use raywalk::render::{Settings, render};
use raywalk::scene::file::{self, mesh::Meshes};
use raywalk::scene::{Color, Scene, build};
use serde_json::{Value, json};
use std::sync::atomic::AtomicBool;

/// Where a scene is: its own coordinates are scaled, turned and moved to the world's, which f64 rounds.
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    axes: [DVec3; 3],
    origin: DVec3,
    scale: f64,
}

impl Frame {
    /// Along the world's axes.
    pub fn upright(origin: DVec3, scale: f64) -> Frame {
        Frame { axes: [DVec3::X, DVec3::Y, DVec3::Z], origin, scale }
    }

    /// Turned at random, `far` sizes from the world's origin.
    pub fn turned(random: &mut Random, far: f64, scale: f64) -> Frame {
        let z = random.unit();
        let x = loop {
            let across = random.unit().cross(z);
            if across.length() > 0.1 {
                break across / across.length();
            }
        };
        Frame { axes: [x, z.cross(x), z], origin: random.point() * (far * scale), scale }
    }

    pub fn vector(&self, [x, y, z]: [f64; 3]) -> DVec3 {
        self.axes[0] * x + self.axes[1] * y + self.axes[2] * z
    }

    /// A point of the world in the frame's coordinates.
    pub fn own(&self, point: DVec3) -> DVec3 {
        DVec3::from(self.axes.map(|axis| axis.dot(point - self.origin))) / self.scale
    }

    pub fn point(&self, own: [f64; 3]) -> DVec3 {
        self.origin + self.vector(own) * self.scale
    }

    /// A point as it is in a scene file.
    pub fn at(&self, own: [f64; 3]) -> Value {
        json!(self.point(own).to_array())
    }

    /// A direction as it is in a scene file.
    pub fn way(&self, own: [f64; 3]) -> Value {
        json!(self.vector(own).to_array())
    }

    /// A way of its own length as it is in a scene file.
    pub fn span(&self, own: [f64; 3]) -> Value {
        json!((self.vector(own) * self.scale).to_array())
    }

    pub fn length(&self, own: f64) -> f64 {
        own * self.scale
    }

    /// The rows of the matrix that turns the world's axes to the frame's.
    pub fn rows(&self) -> Value {
        json!([0, 1, 2].map(|row| self.axes.map(|axis| axis[row])))
    }

    /// The plane through a point across a direction, by its coefficients.
    pub fn plane(&self, through: [f64; 3], normal: [f64; 3]) -> Value {
        let normal = self.vector(normal);
        json!({"plane": {"coefficients": [normal.x, normal.y, normal.z, -normal.dot(self.point(through))]}})
    }

    pub fn polygon(&self, corners: &[[f64; 3]]) -> Value {
        json!({"polygon": {"vertices": corners.iter().map(|corner| self.at(*corner)).collect::<Vec<_>>()}})
    }

    pub fn mesh(&self, corners: &[[f64; 3]], faces: &[[u32; 3]]) -> Mesh {
        let positions = corners.iter().map(|corner| self.point(*corner)).collect();
        Mesh { positions, normals: None, faces: faces.to_vec() }
    }
}

/// A scene in the making.
#[derive(Clone, Debug)]
pub struct World {
    pub text: Value,
    pub meshes: Meshes,
}

impl World {
    /// Seen from a point of the frame toward another, without lights.
    pub fn seen(frame: &Frame, from: [f64; 3], toward: [f64; 3], vertical_fov: f64, resolution: [u32; 2]) -> World {
        let text = json!({
            "format": "raywalk-scene/1",
            "camera": {"position": frame.at(from), "look_at": frame.at(toward), "up": frame.way([0.1, 0.2, 1.0]),
                "vertical_fov": vertical_fov, "resolution": resolution},
            "background": [0.2, 0.3, 0.5], "lights": [], "materials": {}, "objects": [],
        });
        World { text, meshes: Meshes::default() }
    }

    pub fn set(mut self, path: &str, value: Value) -> World {
        let (parent, key) = path.rsplit_once('/').expect("a path");
        let parent = if parent.is_empty() { Some(&mut self.text) } else { self.text.pointer_mut(parent) };
        parent.expect("what the path leads to")[key] = value;
        self
    }

    pub fn light(mut self, light: Value) -> World {
        let lights = self.text["lights"].as_array_mut().expect("lights");
        let mut light = light;
        light["name"] = json!(format!("light {}", lights.len()));
        lights.push(light);
        self
    }

    pub fn material(self, name: &str, material: Value) -> World {
        self.set(&format!("/materials/{name}"), material)
    }

    /// Adds an object, the last in the scene's order.
    pub fn object(mut self, material: &str, shape: Value) -> World {
        let objects = self.text["objects"].as_array_mut().expect("objects");
        objects.push(json!({"name": objects.len().to_string(), "material": material, "shape": shape}));
        self
    }

    pub fn mesh(mut self, material: &str, mesh: Mesh) -> World {
        let path = format!("{}.obj", self.text["objects"].as_array().expect("objects").len());
        self.meshes.insert(&path, mesh, blake3::hash(b""));
        self.object(material, json!({"mesh": {"path": path}}))
    }

    /// The last object moves.
    pub fn moving(mut self, motion: &Value) -> World {
        let objects = self.text["objects"].as_array_mut().expect("objects");
        objects.last_mut().expect("an object")["motion"] = motion.clone();
        self
    }

    #[track_caller]
    pub fn scene(&self) -> Scene {
        let text = self.text.to_string();
        let loaded = file::check(text.as_bytes(), "touching.json");
        let loaded = loaded.unwrap_or_else(|error| panic!("{}", error.report(false)));
        build(&loaded.scene, &self.meshes).unwrap_or_else(|unsupported| panic!("{unsupported}"))
    }

    #[track_caller]
    pub fn picture(&self) -> Vec<Color> {
        self.picture_in(Arithmetic::F64)
    }

    #[track_caller]
    pub fn picture_in(&self, arithmetic: Arithmetic) -> Vec<Color> {
        picture_of(&self.scene(), arithmetic)
    }
}

#[track_caller]
pub fn picture_of(scene: &Scene, arithmetic: Arithmetic) -> Vec<Color> {
    let [width, height] = scene.camera.resolution;
    let crop = [0, 0, width, height];
    let settings = Settings { crop, arithmetic, threads: 1, counts_rays: false, order: Default::default() };
    let rendered = render(scene, &settings, |_| (), &AtomicBool::new(false)).expect("a picture");
    rendered.film.into_pixels()
}

/// How far a colour is from the right one, as a part of it.
pub fn difference(found: Color, right: Color) -> f64 {
    (found - right).abs().max_element() / right.abs().max_element().max(1e-3)
}

/// How many pixels are off by more than a part `tolerance`, with the worst of them.
pub fn wrong(found: &[Color], right: &[Color], tolerance: f64) -> (usize, f64) {
    assert_eq!(found.len(), right.len());
    let differences: Vec<_> = found.iter().zip(right).map(|(found, right)| difference(*found, *right)).collect();
    let wrong = differences.iter().filter(|difference| difference.is_nan() || **difference > tolerance).count();
    (wrong, differences.into_iter().fold(0.0, f64::max))
}
