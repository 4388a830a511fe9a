//! The right values of scenes that others keep beside the repository.

use super::doubled::{CUBE, QUADS, halves};
use super::eye::immersed;
use super::stacks::{Meeting, meetings};
use super::world::{World, picture_of, wrong};
use crate::shared::shared;
use glam::DVec3;
use raywalk::geometry::Mesh;
use raywalk::record::{self, Arithmetic};
use raywalk::scene::Scene;
use raywalk::scene::file::mesh::Meshes;
use std::path::PathBuf;

fn folder() -> Option<PathBuf> {
    shared("cases/touching")
}

#[track_caller]
fn opened(folder: &std::path::Path, name: &str) -> Scene {
    Scene::open(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The scene as a text whose objects a test replaces.
#[track_caller]
fn world(folder: &std::path::Path, name: &str) -> World {
    let text = std::fs::read_to_string(folder.join(name)).expect("a scene");
    World { text: serde_json::from_str(&text).expect("a scene"), meshes: Meshes::default() }
}

/// The world with one mesh of its own as its only object.
fn with_mesh(mut world: World, material: &str, corners: &[[f64; 3]], faces: &[[u32; 3]]) -> World {
    world.text["objects"] = serde_json::json!([]);
    let positions = corners.iter().copied().map(DVec3::from).collect();
    world.mesh(material, Mesh { positions, normals: None, faces: faces.to_vec() })
}

fn along(scene: &Scene, origin: [f64; 3], direction: [f64; 3]) -> (Vec<u32>, Vec<Meeting>) {
    let log = record::ray(scene, origin.into(), direction.into(), Arithmetic::F64);
    (immersed(&log), meetings(&log))
}

#[test]
fn a_mesh_that_repeats_its_faces() {
    let Some(folder) = folder() else { return };
    let corners = [[-5.0, 0.3, -5.0], [-5.0, 0.3, 5.0], [5.0, 0.3, 5.0], [5.0, 0.3, -5.0]];
    let once = with_mesh(world(&folder, "double.json"), "m", &corners, &[[0, 1, 2], [0, 2, 3]]).picture();
    let found = picture_of(&opened(&folder, "double.json"), Arithmetic::F64);
    assert_eq!(wrong(&found, &once, 1e-12), (0, 0.0));
    assert!(once.iter().all(|color| color.min_element() > 0.1));
}

#[test]
fn a_rug_on_the_floor() {
    let Some(folder) = folder() else { return };
    let mut bare = world(&folder, "rug.json");
    bare.text["objects"].as_array_mut().expect("objects").remove(0);
    let found = picture_of(&opened(&folder, "rug.json"), Arithmetic::F64);
    let (count, worst) = wrong(&found, &bare.picture(), 1e-12);
    assert_eq!(count, 0, "off by {worst:e}");
    assert!(found.iter().all(|color| color.min_element() > 0.1));
}

#[test]
fn glass_on_water() {
    let Some(folder) = folder() else { return };
    for name in ["touching.json", "touching-reversed.json"] {
        let scene = opened(&folder, name);
        let (eye, met) = along(&scene, [0.0, 0.0, 1.0], [0.5, 0.0, -libm::sqrt(0.75)]);
        assert!(eye.is_empty(), "{eye:?}");
        let sines: Vec<_> = met.iter().map(|meeting| meeting.refracted.expect("a refracted ray").x).collect();
        let right = [1.0 / 3.0, 0.5 / 1.33, 0.5];
        assert_eq!(sines.len(), right.len(), "{name}: {sines:?}");
        let is_right = sines.iter().zip(right).all(|(sine, right)| (sine - right).abs() < 1e-12);
        assert!(is_right, "{name}: {sines:?}");
    }
}

#[test]
fn an_eye_under_water() {
    let Some(folder) = folder() else { return };
    let scene = opened(&folder, "underwater.json");
    let (eye, met) = along(&scene, [0.0, -2.0, 0.0], [0.5, libm::sqrt(0.75), 0.0]);
    assert_eq!(eye, [0]);
    let refracted = met[0].refracted.expect("a refracted ray");
    let right = DVec3::new(0.6665, libm::sqrt(1.0 - 0.6665 * 0.6665), 0.0);
    assert!((refracted - right).length() < 1e-12, "{refracted}");
    let (eye, met) = along(&scene, [0.0, -2.0, 0.0], [libm::sqrt(0.75), 0.5, 0.0]);
    assert_eq!(eye, [0]);
    assert!(met[0].is_total && met[0].refracted.is_none());
    // The middle pixel looks straight up.
    assert_eq!(immersed(&record::pixel(&scene, [4, 4], Arithmetic::F64)), [0]);
}

#[test]
fn a_cube_wound_inside_out() {
    let Some(folder) = folder() else { return };
    let flipped = opened(&folder, "cubeflip.json");
    let signs = CUBE.map(|corner| corner.map(f64::signum));
    let outward = with_mesh(world(&folder, "cubeflip.json"), "glass", &signs, &halves(&QUADS)).scene();
    for (origin, direction) in [
        ([0.2, 0.3, 9.0], [0.03, -0.04, -1.0]),
        ([5.0, 4.0, 3.0], [-5.1, -4.2, -2.7]),
        ([0.1, 0.2, 0.3], [0.2, 0.3, 1.0]),
    ] {
        let [(eye, met), (right_eye, right)] = [&flipped, &outward].map(|scene| along(scene, origin, direction));
        assert_eq!((eye.len(), met.len()), (right_eye.len(), right.len()));
        assert_eq!(met[0].iors, if eye.is_empty() { Some([1.0, 1.5]) } else { Some([1.5, 1.0]) });
        for (found, right) in met.iter().zip(&right) {
            assert_eq!((found.iors, found.is_total), (right.iors, right.is_total));
            assert_eq!(found.refracted.is_some(), right.refracted.is_some());
            let off = found.refracted.unwrap_or_default() - right.refracted.unwrap_or_default();
            assert!(off.length() < 1e-12, "{off}");
        }
    }
}
