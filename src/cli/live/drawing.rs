//! The scene as lines, for the viewer's schematic.

use glam::DVec3;
use raywalk::geometry::shape::circle;
use raywalk::geometry::{Bounds, Intersect};
use raywalk::scene::{LightKind, LightSurface, Scene};
use raywalk::tui::{Drawing, Wireframe};
use std::sync::Arc;

/// The most objects that are drawn.
const MOST_OBJECTS: usize = 400;

/// The drawing of a scene.
pub fn of(scene: &Arc<Scene>) -> Drawing {
    let eye = scene.camera.position();
    let lights: Vec<Wireframe> = scene
        .lights
        .iter()
        .map(|light| Wireframe { name: light.name.to_string(), lines: light_lines(&light.kind) })
        .collect();
    let seen_by = Arc::clone(scene);
    Drawing {
        objects: objects(scene),
        lights,
        eye: eye.to_array(),
        place_of: Arc::new(move |point| seen_by.camera.place_of(point.into())),
        size: scene.camera.resolution,
    }
}

/// The objects of a scene as lines.
pub fn objects(scene: &Scene) -> Vec<Wireframe> {
    let around = around(scene, scene.camera.position());
    let objects = scene.objects.iter().take(MOST_OBJECTS).map(|object| {
        let lines = object.shape.outline(&around);
        Wireframe { name: object.name.to_string(), lines: lines.into_iter().map(arrays).collect() }
    });
    objects.collect()
}

/// A box around all that has an end, with the eye and the lights at places.
fn around(scene: &Scene, eye: DVec3) -> Bounds {
    let shapes = scene.objects.iter().filter_map(|object| object.shape.bounds());
    let lights = scene.lights.iter().filter_map(|light| match &light.kind {
        LightKind::Point { position } => Some(*position),
        LightKind::Area(area) => Some(area.surface.center()),
        LightKind::Directional { .. } => None,
    });
    let tight = shapes.fold(Bounds::around(lights.chain([eye])), Bounds::union);
    // Planes pass beside what is on them.
    let margin = (tight.max - tight.min) * 0.5;
    Bounds { min: tight.min - margin, max: tight.max + margin }
}

fn light_lines(kind: &LightKind) -> Vec<Vec<[f64; 3]>> {
    match kind {
        LightKind::Point { position } => vec![vec![position.to_array()]],
        LightKind::Directional { .. } => Vec::new(),
        LightKind::Area(area) => vec![arrays(rim(&area.surface))],
    }
}

fn rim(surface: &LightSurface) -> Vec<DVec3> {
    match *surface {
        LightSurface::Rectangle { center, edges: [u, v] } => {
            [u + v, u - v, -u - v, v - u, u + v].map(|corner| center + corner).to_vec()
        }
        LightSurface::Disk { center, edges: [u, v] } => circle(center, u, v),
        LightSurface::Sphere { center, radius } => circle(center, DVec3::X * radius, DVec3::Y * radius),
    }
}

fn arrays(line: Vec<DVec3>) -> Vec<[f64; 3]> {
    line.into_iter().map(|point| point.to_array()).collect()
}
