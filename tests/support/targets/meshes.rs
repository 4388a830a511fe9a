//! Meshes: read, and met by rays.

use super::is_a_message;
use glam::DVec3;
use raywalk::record::{self, Arithmetic, Part};
use raywalk::scene::file::mesh::{self, Meshes};
use raywalk::scene::{build, file};

/// A mesh in OBJ.
pub fn obj(bytes: &[u8]) {
    read(bytes, "a.obj");
}

/// A mesh in PLY.
pub fn ply(bytes: &[u8]) {
    read(bytes, "a.ply");
}

/// A scene of nothing but the mesh, in light from where the eye is.
const SCENE: &[u8] = br#"{"format": "raywalk-scene/1",
    "camera": {"position": [0.3, 0.2, 9], "direction": [0, 0, -1]},
    "lights": [{"name": "l", "point": {"position": [3, 5, 9]}}],
    "tracing": {"max_depth": 1},
    "objects": [{"name": "m", "shape": {"mesh": {"path": "a.obj"}}}]}"#;

fn read(bytes: &[u8], name: &str) {
    let read = match mesh::parse(bytes, name) {
        Ok(read) => read,
        Err(error) => return is_a_message(&error),
    };
    let mesh = read.mesh;
    let count = mesh.positions.len() as u32;
    assert!(mesh.faces.iter().flatten().all(|corner| *corner < count));
    assert!(mesh.positions.iter().all(|position| position.is_finite()));
    for triangle in 0..mesh.faces.len() as u32 {
        let _ = mesh.corner_normals(triangle);
    }
    // From the eye to the middle of the first triangles, and past them.
    let middle = |face: &[u32; 3]| face.iter().map(|corner| mesh.positions[*corner as usize] / 3.0).sum::<DVec3>();
    let aims: Vec<_> = mesh.faces.iter().take(3).map(middle).chain([DVec3::new(0.5, 0.25, 0.0)]).collect();
    let loaded = file::check(SCENE, "a.json").unwrap_or_else(|error| panic!("{}", error.report(false)));
    let mut meshes = Meshes::default();
    meshes.insert("a.obj", mesh, blake3::hash(bytes));
    let scene = build(&loaded.scene, &meshes).expect("the mesh is there");
    for aim in aims {
        let origin = DVec3::new(0.3, 0.2, 9.0);
        let part = Part::Ray { origin, direction: aim - origin };
        for arithmetic in [Arithmetic::F64, Arithmetic::F32] {
            let log = record::bounded(&scene, part, arithmetic).expect("a short log");
            assert!(!log.events.is_empty());
        }
    }
}
